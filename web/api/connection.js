/**
 * State of the connection. While the service does not answer, the page probes it repeatedly.
 * Waiting requests continue when it is back. A slow request is shown before it counts as lost.
 */

import { byId } from '../lib/dom.js';

/** Time [ms] between two probes: the first, and the longest. */
const [SOON, LATE] = [500, 5000];
/** Time [ms] after which the page says that it waits for an answer. */
const SLOW = 2500;

let lost = false;
/** Number of slow requests. */
let slow = 0;
const waiting = /** @type {Set<() => void>} */ (new Set());
const listeners = /** @type {Set<() => void>} */ (new Set());

/** @param {() => void} listener called whenever the service answers again */
export const onReconnect = (listener) => listeners.add(listener);

function show() {
  const place = byId('connection');
  place.hidden = !lost && slow === 0;
  place.textContent = lost ? 'Connection lost, retrying…' : 'Waiting for the service…';
}

/** Reports a request without an answer. */
export function reportLost() {
  if (lost) return;
  lost = true;
  show();
  probe(SOON);
}

/** Reports a request. @returns {() => void} reports its answer */
export function awaited() {
  let counted = 0;
  const timer = setTimeout(() => {
    slow += counted = 1;
    show();
  }, SLOW);
  return () => {
    clearTimeout(timer);
    slow -= counted;
    counted = 0;
    show();
  };
}

/** @returns {Promise<void>} kept when the service answers */
export const reconnected = () =>
  lost ? new Promise((resolve) => waiting.add(resolve)) : Promise.resolve();

/** Asks all parts of the page to load their data again. */
export function announce() {
  for (const listener of listeners) listener();
}

/** @param {number} pause */
async function probe(pause) {
  await new Promise((resolve) => setTimeout(resolve, pause));
  const limit = AbortSignal.timeout(LATE);
  const answer = await fetch('livez', { cache: 'no-store', signal: limit }).catch(() => undefined);
  if (!answer?.ok) return probe(Math.min(LATE, 1.5 * pause));
  lost = false;
  show();
  for (const resolve of waiting) resolve();
  waiting.clear();
  announce();
}
