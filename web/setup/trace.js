/** Work on traces of a stylus: level, Gaussian filter of ISO 16610-21, fewer points. */

import { figure, grouped, percent } from '../lib/units.js';

/** @typedef {[x: number, height: number][]} Trace x rising */

/** Figures that programs put where nothing was measured, in the unit of their file. */
const KNOWN = [-9999, 9999, -99999, 99999, -32768, 32767, 65535, -1e30, 1e30];
/** How many times as far as all others reach a height is away that is none. */
const FAR = 1e4;

/** sqrt(ln 2 / π): the Gaussian of ISO 16610-21 lets half of a wave of the cut-off pass. */
const ALPHA = Math.sqrt(Math.LN2 / Math.PI);
/** Steps of a filtered trace that lie within its cut-off. */
const STEPS = 8;
/** Cut-offs of ISO 3274 [mm]. */
export const CUT_OFFS = [0.08, 0.25, 0.8, 2.5, 8];

/** @param {Trace} trace @returns {{slope: number, line: (x: number) => number}} of least squares */
function lineOf(trace) {
  const mean = (/** @type {0 | 1} */ k) =>
    trace.reduce((sum, point) => sum + point[k], 0) / trace.length;
  const [x0, z0] = [mean(0), mean(1)];
  let [product, square] = [0, 0];
  for (const [x, z] of trace) {
    product += (x - x0) * (z - z0);
    square += (x - x0) ** 2;
  }
  const slope = product / square;
  return { slope, line: (x) => z0 + slope * (x - x0) };
}

/** @param {Trace} trace @returns {{points: Trace, note: string}} less its least-squares line */
export function levelled(trace) {
  const { slope, line } = lineOf(trace);
  return {
    points: trace.map(([x, z]) => [x, Number((z - line(x)).toPrecision(10))]),
    note: `levelled: a slope of ${figure(slope, 3)} is taken away`,
  };
}

/** Rq: root mean square above the mean line. @param {number[]} heights */
const rms = (heights) =>
  Math.sqrt(heights.reduce((sum, one) => sum + one * one, 0) / heights.length);

/** Root mean square of the slope. @param {Trace} trace */
const slopeOf = (trace) =>
  rms(trace.slice(1).map(([x, z], k) => (z - trace[k][1]) / (x - trace[k][0])));

/** At equal steps, straight between the points. @param {Trace} trace @returns {Trace} */
function even(trace) {
  const steps = Float64Array.from(trace.slice(1), ([x], k) => x - trace[k][0]).sort();
  const [first, last] = [trace[0][0], trace[trace.length - 1][0]];
  const count = Math.max(2, Math.round((last - first) / steps[Math.floor(steps.length / 2)]) + 1);
  let at = 0;
  return Array.from({ length: count }, (_, k) => {
    const x = first + ((last - first) * k) / (count - 1);
    while (at < trace.length - 2 && trace[at + 1][0] < x) at++;
    const [[x0, z0], [x1, z1]] = [trace[at], trace[at + 1]];
    return [x, z0 + ((z1 - z0) * (x - x0)) / (x1 - x0)];
  });
}

/**
 * The long waves of a trace: its mean line by the Gaussian filter of ISO 16610-21. Near the ends
 * the weights are those of what is there.
 * @param {Trace} trace
 * @param {number} cutoff λ_c
 * @param {string} unit of lengths
 * @returns {{points: Trace, note: string} | {problem: string}}
 */
export function longWaves(trace, cutoff, unit) {
  const steps = even(trace);
  const step = steps[1][0] - steps[0][0];
  const length = steps[steps.length - 1][0] - steps[0][0];
  if (!(cutoff >= 2 * step && cutoff <= length))
    return {
      problem: `λ_c has to be between ${figure(2 * step, 3)}, two steps of the trace, and its length ${figure(length, 3)} ${unit}`,
    };
  const reach = Math.ceil(cutoff / step);
  const weights = Float64Array.from({ length: reach + 1 }, (_, k) =>
    Math.exp(-Math.PI * ((k * step) / (ALPHA * cutoff)) ** 2),
  );
  const { line } = lineOf(steps);
  const above = Float64Array.from(steps, ([x, z]) => z - line(x));
  const every = Math.max(1, Math.floor(cutoff / STEPS / step));
  const long = (/** @type {number} */ at) => {
    let [sum, total] = [0, 0];
    for (let k = Math.max(0, at - reach); k <= Math.min(above.length - 1, at + reach); k++) {
      const weight = weights[Math.abs(k - at)];
      sum += weight * above[k];
      total += weight;
    }
    return sum / total;
  };
  const kept = steps.map((_, k) => k).filter((k) => k % every === 0 || k === steps.length - 1);
  const points = /** @type {Trace} */ (
    kept.map((k) => [
      Number(steps[k][0].toPrecision(10)),
      Number((long(k) + line(steps[k][0])).toPrecision(10)),
    ])
  );
  const rough = rms(kept.map((k) => above[k] - long(k)));
  return {
    points,
    note: `Gaussian filter of ISO 16610-21, λ_c ${figure(cutoff, 3)} ${unit}: shorter waves are taken away, a roughness Rq of ${figure(rough, 3)} of ${figure(rms([...above]), 3)} ${unit}; ${grouped(points.length)} points are left. The contact has to be several λ_c wide for an answer without them`,
  };
}

/**
 * Every n-th point.
 * @param {Trace} trace
 * @param {number} most points
 * @returns {{points: Trace, note: string}}
 */
export function thinnedTrace(trace, most) {
  const every = Math.ceil((trace.length - 1) / (most - 1));
  const points = trace.filter((_, k) => k % every === 0 || k === trace.length - 1);
  const lost = Math.max(0, 1 - slopeOf(points) / slopeOf(trace));
  return {
    points,
    note: `${grouped(trace.length)} points thinned to ${grouped(points.length)}; ${percent(lost)} of the slope is lost`,
  };
}

/**
 * What is to be said of heights that stand apart from all others and look like no data.
 * @param {number[][]} trace in mm or m, of a file in these or in smaller units
 * @returns {string[]}
 */
export function noData(trace) {
  const heights = trace.map(([, height]) => height);
  const order = Float64Array.from(heights).sort();
  const ends = order.length > 2 ? [order[0], order[order.length - 1]] : [];
  return ends.flatMap((end) => {
    const rest = order.filter((one) => one !== end);
    if (!rest.length) return [];
    const [low, high] = [rest[0], rest[rest.length - 1]];
    const [gap, reach] = [end < low ? low - end : end - high, high - low];
    const isKnown = [1, 1e3, 1e6, 1e9].some((unit) =>
      KNOWN.includes(Number((end * unit).toPrecision(12))),
    );
    if (!((isKnown && gap > reach / 2) || (reach > 0 && gap > FAR * reach))) return [];
    const count = heights.length - rest.length;
    return [
      `${grouped(count)} of ${grouped(heights.length)} heights ${count === 1 ? 'is' : 'are'} ${figure(end, 4)}, the first at point ${heights.indexOf(end) + 1}, and the others reach over ${figure(reach, 3)}: no data? Leave ${count === 1 ? 'its line' : 'their lines'} out`,
    ];
  });
}
