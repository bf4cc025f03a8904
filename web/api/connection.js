/** Whether the service answers. While it does not, it is asked again and again, and who waits is told when it is back. */

import { byId } from '../lib/dom.js';

/** Time [ms] between two questions: the first, and the longest. */
const [SOON, LATE] = [500, 5000];

let lost = false;
const waiting = /** @type {Set<() => void>} */ (new Set());
const listeners = /** @type {Set<() => void>} */ (new Set());

/** @param {() => void} listener called whenever the service answers again */
export const onReconnect = (listener) => listeners.add(listener);

/** To be called where a question got no answer. */
export function reportLost() {
  if (lost) return;
  lost = true;
  byId('connection').hidden = false;
  probe(SOON);
}

/** @returns {Promise<void>} kept when the service answers */
export const reconnected = () => (lost ? new Promise((resolve) => waiting.add(resolve)) : Promise.resolve());

/** @param {number} pause */
async function probe(pause) {
  await new Promise((resolve) => setTimeout(resolve, pause));
  const answer = await fetch('livez', { cache: 'no-store' }).catch(() => undefined);
  if (!answer?.ok) return probe(Math.min(LATE, 1.5 * pause));
  lost = false;
  byId('connection').hidden = true;
  for (const resolve of waiting) resolve();
  waiting.clear();
  for (const listener of listeners) listener();
}
