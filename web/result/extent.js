/** Where a contact lies along the surface. */

import { rowOf } from './rows.js';

/** @typedef {import('../types.js').Step} Step */
/** @typedef {{left: number, right: number}} Extent */

/**
 * From the first to the last place that touches; of a body of revolution the whole diameter.
 * @param {Pick<Step, 'contact'>} step
 * @param {boolean} round
 * @returns {Extent | undefined} nothing where the bodies are apart
 */
export function extentOf({ contact: { patches } }, round) {
  if (patches.length === 0) return undefined;
  const [left, right] = [patches[0].left, patches[patches.length - 1].right];
  return round ? { left: -right, right } : { left, right };
}

/** @param {Extent} extent */
const widthOf = ({ left, right }) => right - left;

/**
 * Of one of the steps; where its load is taken away, that of the widest contact, whose traces are
 * to be seen.
 * @param {Pick<Step, 'contact'>[]} steps @param {number} at @param {boolean} round
 * @returns {Extent | undefined}
 */
export function extentSeen(steps, at, round) {
  const [own, ...all] = [steps[at], ...steps].map(
    (step) => extentOf(step, round) ?? { left: 0, right: 0 },
  );
  const seen = widthOf(own) > 0 ? own : all.reduce((a, b) => (widthOf(b) > widthOf(a) ? b : a));
  return widthOf(seen) > 0 ? seen : undefined;
}

/**
 * The range of an abscissa that shows all of them, with room on both sides.
 * @param {Extent[]} extents @param {boolean} round over the radius only
 * @returns {[number, number] | undefined}
 */
export function rangeAround(extents, round) {
  const [left, right] = [
    Math.min(...extents.map(({ left }) => left)),
    Math.max(...extents.map(({ right }) => right)),
  ];
  if (!(right > left)) return undefined;
  const room = 0.15 * (right - left);
  return [round ? 0 : left - room, right + room];
}

/** What places along the surface are called. @param {Step} step @param {boolean} round */
export const abscissaOf = (step, round) =>
  rowOf(step, 'half_angle') ? 'along the arc' : round ? 'r' : 'x';
