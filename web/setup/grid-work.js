/** Work on grids of heights: figures that are none, holes, fewer heights. */

import { figure, grouped, percent } from '../lib/units.js';
import { rangeOf } from './grid-text.js';

/** @typedef {number[][]} Heights `[i][j]`, NaN where there is none */

/** Figures that programs put where nothing was measured. */
const KNOWN = [-9999, 9999, -99999, 99999, -32768, 32767, 65535, -1e30, 1e30];
/** How many times as far as all others reach a figure is away that is no height. */
const FAR = 1e4;
/** How often one figure stands apart that may be no height. */
const SEVERAL = 3;

/** @param {Heights} heights */
export const missing = (heights) =>
  heights.reduce((sum, row) => sum + row.filter((one) => !Number.isFinite(one)).length, 0);

/** @param {Heights} heights @param {(one: number, i: number, j: number) => number} work @returns {Heights} */
export const each = (heights, work) =>
  heights.map((row, i) => row.map((one, j) => work(one, i, j)));

/**
 * Figures that look like no heights.
 * @param {Heights} heights
 * @returns {{words: string, count: number, holes: Heights} | undefined} the heights with holes in their place
 */
export function suspects(heights) {
  return farOff(heights) ?? apart(heights) ?? islands(heights);
}

/** @param {Heights} heights */
function farOff(heights) {
  const all = heights.flat().filter(Number.isFinite);
  if (all.length < 2) return undefined;
  const [low, high] = rangeOf(all);
  const far = [...new Set([low, high])].filter((end) => {
    const rest = all.filter((one) => one !== end);
    if (!rest.length) return false;
    const [from, to] = rangeOf(rest);
    const gap = end < from ? from - end : end - to;
    return (
      (KNOWN.includes(end) && gap > (to - from) / 2) || (to > from && gap > FAR * (to - from))
    );
  });
  const order = Float64Array.from(all).sort();
  const at = (/** @type {number} */ part) => order[Math.floor(part * (order.length - 1))];
  const spread = at(0.8) - at(0.2);
  const isFar = (/** @type {number} */ one) =>
    far.length ? far.includes(one) : spread > 0 && Math.abs(one - at(0.5)) > FAR * spread;
  const bad = [...new Set(all.filter(isFar))];
  if (!bad.length) return undefined;
  const [least, most] = rangeOf(bad);
  const rest = rangeOf(all.filter((one) => !isFar(one)));
  const said = least === most ? `${least}` : `${least} to ${most}`;
  return named(heights, isFar, `${said}; the others reach over ${figure(rest[1] - rest[0], 3)}`);
}

/** One value, several times, further from all others than these reach. @param {Heights} heights */
function apart(heights) {
  const all = heights.flat().filter(Number.isFinite);
  const end = rangeOf(all).find((one) => {
    const rest = all.filter((other) => other !== one);
    const [low, high] = rangeOf(rest);
    const gap = one < low ? low - one : one - high;
    return rest.length && all.length - rest.length >= SEVERAL && high > low && gap > high - low;
  });
  return end === undefined
    ? undefined
    : named(heights, (one) => one === end, `${end}, further from all others than these reach`);
}

/** Blocks of one value in a map that else has none. @param {Heights} heights */
function islands(heights) {
  /** @type {Map<number, number>} */
  const blocks = new Map();
  for (let i = 1; i < heights.length; i++)
    for (let j = 1; j < heights[0].length; j++) {
      const one = heights[i][j];
      if (one === heights[i - 1][j] && one === heights[i][j - 1] && one === heights[i - 1][j - 1])
        blocks.set(one, (blocks.get(one) ?? 0) + 1);
    }
  const order = [...blocks].sort(([, a], [, b]) => b - a);
  if (!order.length) return undefined;
  const [[value, most]] = order;
  const others = order.slice(1).reduce((sum, [, count]) => sum + count, 0);
  const count = heights.flat().filter((one) => one === value).length;
  if (most < 4 || others > 0.1 * most || count > 0.5 * heights.length * heights[0].length)
    return undefined;
  return named(heights, (one) => one === value, `${value} in blocks`);
}

/** @param {Heights} heights @param {(one: number) => boolean} isBad @param {string} said */
function named(heights, isBad, said) {
  let count = 0;
  let first = '';
  const holes = each(heights, (one, i, j) => {
    if (!isBad(one)) return one;
    first ||= `[${i}, ${j}]`;
    count += 1;
    return NaN;
  });
  const all = grouped(heights.length * heights[0].length);
  return {
    words: `${grouped(count)} of ${all} heights are ${said}. The first stands at ${first}. Is it no data?`,
    count,
    holes,
  };
}

/**
 * The same with each missing height the mean of its neighbours, as of a skin stretched over a hole
 * from its rim: conjugate gradients on the missing ones.
 * @param {Heights} heights
 * @returns {Heights}
 */
export function filled(heights) {
  const [nx, ny] = [heights.length, heights[0].length];
  const number = new Int32Array(nx * ny).fill(-1);
  const holes = /** @type {number[]} */ ([]);
  const flat = Float64Array.from(heights.flat());
  flat.forEach((one, k) => {
    if (Number.isFinite(one)) return;
    number[k] = holes.length;
    holes.push(k);
  });
  const many = holes.length;
  if (many === 0 || many === flat.length) return heights;
  const known = flat.filter(Number.isFinite);
  const middle = known.reduce((sum, one) => sum + one, 0) / known.length;
  const neighbours = new Int32Array(4 * many).fill(-1);
  const count = new Float64Array(many);
  const right = new Float64Array(many);
  holes.forEach((k, at) => {
    const [i, j] = [Math.floor(k / ny), k % ny];
    const around = [i > 0 ? k - ny : -1, i < nx - 1 ? k + ny : -1, j > 0 ? k - 1 : -1, j < ny - 1 ? k + 1 : -1]; // prettier-ignore
    around.forEach((other, side) => {
      if (other < 0) return;
      count[at] += 1;
      if (number[other] < 0) right[at] += flat[other] - middle;
      else neighbours[4 * at + side] = number[other];
    });
  });
  const solved = conjugateGradients(count, neighbours, right);
  holes.forEach((k, at) => (flat[k] = solved[at] + middle));
  return Array.from({ length: nx }, (_, i) => Array.from(flat.subarray(i * ny, (i + 1) * ny)));
}

/** @param {Float64Array} count on the diagonal @param {Int32Array} neighbours four of each, or -1 @param {Float64Array} right */
function conjugateGradients(count, neighbours, right) {
  const many = right.length;
  const solved = new Float64Array(many);
  const rest = right.slice();
  const along = rest.map((one, k) => one / count[k]);
  const applied = new Float64Array(many);
  let square = rest.reduce((sum, one, k) => sum + (one * one) / count[k], 0);
  const enough = 1e-20 * square;
  for (let turn = 0; turn < 20 * Math.sqrt(many) + 100 && square > enough; turn++) {
    let bent = 0;
    for (let k = 0; k < many; k++) {
      let sum = count[k] * along[k];
      for (let side = 4 * k; side < 4 * k + 4; side++)
        if (neighbours[side] >= 0) sum -= along[neighbours[side]];
      applied[k] = sum;
      bent += sum * along[k];
    }
    const step = square / bent;
    let next = 0;
    for (let k = 0; k < many; k++) {
      solved[k] += step * along[k];
      rest[k] -= step * applied[k];
      next += (rest[k] * rest[k]) / count[k];
    }
    for (let k = 0; k < many; k++) along[k] = rest[k] / count[k] + (next / square) * along[k];
    square = next;
  }
  return solved;
}

/**
 * Fewer heights, each the mean over its new cell.
 * @param {Heights} heights
 * @param {number} most heights along the longer side
 * @returns {{heights: Heights, times: [number, number]} } how much longer its cells are along x and y
 */
export function thinned(heights, most) {
  const sides = [heights.length, heights[0].length];
  const times = Math.max(Math.max(...sides) / most, 1);
  const counts = sides.map((one) => Math.max(Math.round(one / times), 1));
  const along = means(heights, counts[0]);
  const across = transposed(means(transposed(along), counts[1]));
  return { heights: across, times: [sides[0] / counts[0], sides[1] / counts[1]] };
}

/** @param {Heights} heights @returns {Heights} */
export const transposed = (heights) => heights[0].map((_, j) => heights.map((row) => row[j]));

/** Means of the known of lines, over `count` equal cells. @param {Heights} heights @param {number} count @returns {Heights} */
function means(heights, count) {
  const times = heights.length / count;
  return Array.from({ length: count }, (_, at) => {
    const [from, to] = [at * times, (at + 1) * times];
    const sums = new Float64Array(heights[0].length);
    const weights = new Float64Array(heights[0].length);
    for (let i = Math.floor(from); i < Math.min(Math.ceil(to), heights.length); i++) {
      const weight = Math.min(to, i + 1) - Math.max(from, i);
      if (weight <= 1e-9) continue;
      heights[i].forEach((one, j) => {
        if (!Number.isFinite(one)) return;
        sums[j] += weight * one;
        weights[j] += weight;
      });
    }
    return Array.from(sums, (sum, j) => (weights[j] > 1e-6 ? sum / weights[j] : NaN));
  });
}

/** The middle of a map. @param {Heights} heights @param {number} most heights along a side @returns {Heights} */
export function cropped(heights, most) {
  const cut = (/** @type {any[]} */ row) => {
    const count = Math.min(row.length, most);
    const start = Math.floor((row.length - count) / 2);
    return row.slice(start, start + count);
  };
  return cut(heights).map(cut);
}

/** Root mean square of the slope, by differences of neighbours. @param {Heights} heights @param {[number, number]} spacing in the unit of the heights */
export function slopeOf(heights, [dx, dy]) {
  let [squares, count] = [0, 0];
  let [others, beside] = [0, 0];
  heights.forEach((row, i) =>
    row.forEach((one, j) => {
      const [x, y] = [heights[i + 1]?.[j] - one, row[j + 1] - one];
      if (Number.isFinite(x)) [squares, count] = [squares + (x / dx) ** 2, count + 1];
      if (Number.isFinite(y)) [others, beside] = [others + (y / dy) ** 2, beside + 1];
    }),
  );
  return Math.sqrt(squares / Math.max(count, 1) + others / Math.max(beside, 1));
}

/**
 * What thinning does, in words.
 * @param {Heights} before @param {Heights} after
 * @param {[number, number]} times how much longer the cells are
 */
export function lossWords(before, after, times) {
  const [a, b] = [slopeOf(before, [1, 1]), slopeOf(after, times)];
  return `thinned from ${sizeOf(before)} to ${sizeOf(after)}, each height the mean of its cell; ${percent(a > 0 ? Math.max(0, 1 - b / a) : 0)} of the slope (Sdq) is lost`;
}

/** @param {Heights} heights */
export const sizeOf = (heights) => `${heights.length} × ${heights[0]?.length ?? 0}`;
