/**
 * How the axes of a contact in three dimensions lie in those of its job: results have x along the
 * shorter semi-axis, and every picture has the x and y of the sketch.
 */

import { valueIn } from './rows.js';

/** @typedef {{name: string, sign: 1 | -1}} Along an axis of the job, and whether it runs the same way */
/** @typedef {{x: Along, y: Along, words: string}} Axes of the contact; `words`: how they lie where they are none of the job's */

/** Degrees by which an axis may be off. */
const SLACK = 0.5;

/** @param {import('./rows.js').Rows} step @returns {Axes} those of the job but in three dimensions */
export const axesOf = (step) => axesAt(valueIn(step, 'orientation') ?? 0);

/** @param {number} orientation angle from the job's x to the contact's [degree] @returns {Axes} */
export function axesAt(orientation) {
  const angle = ((((orientation + 180) % 360) + 360) % 360) - 180;
  const near = (/** @type {number} */ other) => Math.abs(angle - other) < SLACK;
  /** @param {string} x @param {1 | -1} one @param {string} y @param {1 | -1} other @returns {Axes} */
  const made = (x, one, y, other) => ({
    x: { name: x, sign: one },
    y: { name: y, sign: other },
    words: '',
  });
  if (near(0)) return made('x', 1, 'y', 1);
  if (near(90)) return made('y', 1, 'x', -1);
  if (near(-90)) return made('y', -1, 'x', 1);
  if (near(180) || near(-180)) return made('x', -1, 'y', -1);
  const words = `x′ lies along the shorter semi-axis, ${angle.toFixed(1).replace('-', '−')}° from x of the sketch.`;
  return { ...made('x′', 1, 'y′', 1), words };
}

/**
 * Values along an axis of the contact, along that of the job.
 * @param {number[]} places
 * @param {number[]} values
 * @param {Along} along
 * @returns {{x: number[], y: number[]}}
 */
export const alongJob = (places, values, { sign }) =>
  sign > 0
    ? { x: places, y: values }
    : { x: places.map((place) => -place || 0).reverse(), y: [...values].reverse() };

/**
 * A map over both axes of the contact, over those of the job.
 * @template {{x: number[], y: number[]}} T
 * @param {T} maps arrays are `values[i · y.length + j]`
 * @param {Axes} axes
 * @returns {T}
 */
export function mapInJob(maps, { x, y }) {
  const turned = x.name === 'y';
  if (!turned && x.sign > 0 && y.sign > 0) return maps;
  const flipped = (/** @type {number[]} */ places, /** @type {Along} */ { sign }) =>
    sign > 0 ? places : places.map((place) => -place || 0).reverse();
  const [first, second] = [flipped(maps.x, x), flipped(maps.y, y)];
  const [own, other] = [maps.x.length, maps.y.length];
  const valueOf = (
    /** @type {number[]} */ values,
    /** @type {number} */ i,
    /** @type {number} */ j,
  ) => values[(x.sign > 0 ? i : own - 1 - i) * other + (y.sign > 0 ? j : other - 1 - j)];
  const moved = (/** @type {number[]} */ values) =>
    turned
      ? Array.from({ length: own * other }, (_, k) =>
          valueOf(values, k % own, Math.floor(k / own)),
        )
      : values.map((_, k) => valueOf(values, Math.floor(k / other), k % other));
  return /** @type {T} */ (
    Object.fromEntries(
      Object.entries(maps).map(([key, values]) => [
        key,
        key === 'x'
          ? turned
            ? second
            : first
          : key === 'y'
            ? turned
              ? first
              : second
            : Array.isArray(values)
              ? moved(values)
              : values,
      ]),
    )
  );
}
