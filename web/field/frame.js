/**
 * How results describe places in a body, and where these are in the section: positions along the
 * surface and depths below it. Along a pin and the hole around it positions are arc lengths, each
 * on its own circle, and depths are along the radius.
 */

import { outline } from '../setup/outline.js';

/** @typedef {import('../types.js').Mesh} Mesh */
/** @typedef {[number, number]} Point */
/**
 * @typedef {object} Frame
 * @property {(along: number, depth: number) => Point} point in the section, without load
 * @property {(x: number, y: number) => Point} place along the surface and below it, of a point of the section
 * @property {(along: number) => Point} outward unit normal of the surface
 */

/**
 * @param {import('../types.js').Job} job
 * @param {'upper' | 'lower'} name of the body
 * @param {Mesh} mesh of it
 * @returns {Frame}
 */
export function frameOf(job, name, mesh) {
  const up = name === 'lower' ? 1 : -1;
  const [own, other] = name === 'lower' ? [job.lower, job.upper] : [job.upper, job.lower];
  // A hardness test has no upper body of its own.
  const [shape, beside] = [own?.shape ?? {}, other?.shape ?? {}];
  if (shape.type === 'hole') return circle(-shape.radius, up);
  if (beside.type === 'hole') return circle(shape.radius, up);
  return level(name === 'lower' ? 0 : raised(shape, mesh), up);
}

/** How far the upper body has been moved so that the bodies just touch: its base is where its shape ends. @param {Record<string, any>} shape @param {Mesh} mesh */
function raised(shape, { nodes }) {
  let top = -Infinity;
  for (let k = 1; k < nodes.length; k += 2) top = Math.max(top, nodes[k]);
  // Heights of results count from the highest place of a profile.
  const highest =
    shape.type === 'profile'
      ? Math.max(...shape.points.map((/** @type {Point} */ [, height]) => height))
      : 0;
  return top + (outline(shape)?.base ?? -top) - highest;
}

/** @param {number} height of depth 0 @param {1 | -1} up @returns {Frame} */
const level = (height, up) => ({
  point: (along, depth) => [along, height - up * depth],
  place: (x, y) => [x, up * (height - y)],
  outward: () => [0, up],
});

/** @param {number} radius negative of a hole @param {1 | -1} up @returns {Frame} around a centre that is one radius below the surface */
function circle(radius, up) {
  const size = Math.abs(radius);
  const sense = Math.sign(radius);
  return {
    point: (along, depth) => {
      const far = size - sense * depth;
      return [far * Math.sin(along / size), up * (sense * far * Math.cos(along / size) - radius)];
    },
    place: (x, y) => {
      const height = up * y + radius;
      return [size * Math.atan2(x, sense * height), sense * (size - Math.hypot(x, height))];
    },
    outward: (along) => [sense * Math.sin(along / size), up * Math.cos(along / size)],
  };
}
