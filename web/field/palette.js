/** Colours for bands of values, and round figures between them. */

import { plain } from '../lib/units.js';

/** @typedef {[number, number, number]} Rgb each from 0 to 1 */

/** Dark to light, even to the eye and safe for colour-blind readers (viridis). */
const SEQUENTIAL = [
  '#440154',
  '#482878',
  '#3e4989',
  '#31688e',
  '#26828e',
  '#1f9e89',
  '#35b779',
  '#6ece58',
  '#b5de2b',
  '#fde725',
];
/** Blue is pressed, red is pulled. */
const DIVERGING = [
  '#053061',
  '#2166ac',
  '#4393c3',
  '#92c5de',
  '#d1e5f0',
  '#f7f7f7',
  '#fddbc7',
  '#f4a582',
  '#d6604d',
  '#b2182b',
  '#67001f',
];

/** As many as the shader holds. */
export const MOST_BANDS = 16;

/** @param {string} hex @returns {Rgb} */
export const rgb = (hex) =>
  /** @type {Rgb} */ ([1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16) / 255));

/**
 * @typedef {object} Bands
 * @property {number} low
 * @property {number} step
 * @property {Rgb[]} colours one for each band
 */

/**
 * Bands with round limits over a range.
 * @param {number} low
 * @param {number} high
 * @returns {Bands}
 */
export function bands(low, high) {
  const signed = low < 0 && high > 0.02 * (high - low);
  const step = roundStep((high - low) / 14 || 1);
  const first = Math.floor(low / step + 1e-9);
  const count = Math.min(MOST_BANDS, Math.max(1, Math.ceil(high / step - 1e-9) - first));
  const most = Math.max(-first, first + count);
  const place = (/** @type {number} */ k) =>
    signed ? 0.5 + (first + k + 0.5) / (2 * most) : count > 1 ? k / (count - 1) : 0.5;
  const stops = (signed ? DIVERGING : SEQUENTIAL).map(rgb);
  return {
    low: first * step,
    step,
    colours: Array.from({ length: count }, (_, k) => between(stops, place(k))),
  };
}

/**
 * The same on both sides of 0.
 * @param {number} low
 * @param {number} high
 */
export function symmetricBands(low, high) {
  const most = Math.max(Math.abs(low), Math.abs(high));
  const step = roundStep(most / 7 || 1);
  const end = step * Math.ceil(most / step - 1e-9);
  return bands(-end, end);
}

/**
 * Bands from one limit to the other, whatever these are.
 * @param {number} low
 * @param {number} high
 * @returns {Bands}
 */
export function bandsWithin(low, high) {
  const round = bands(low, high);
  const slack = 1e-9 * round.step;
  const end = round.low + round.step * round.colours.length;
  if (Math.abs(round.low - low) <= slack && Math.abs(end - high) <= slack) return round;
  return { ...round, low, step: (high - low) / round.colours.length };
}

/** What stands at the limit below a band, counted from 0; behind the last one, its upper limit. @param {Bands} bands @param {number} k */
export function limitOf({ low, step, colours }, k) {
  const value = low + k * step;
  // Within a hair of 0 is 0, and between limits that are not round four figures tell enough.
  if (Math.abs(value) < 1e-6 * step) return plain(0);
  return plain(k === 0 || k === colours.length ? value : Number(value.toPrecision(4)));
}

/** @param {number} rough @returns {number} 1, 2, 2.5 or 5 times a power of ten, not less */
export function roundStep(rough) {
  const power = 10 ** Math.floor(Math.log10(rough));
  return power * ([1, 2, 2.5, 5].find((step) => step * power >= rough * (1 - 1e-9)) ?? 10);
}

/** @param {Rgb[]} stops @param {number} t @returns {Rgb} */
function between(stops, t) {
  const at = Math.min(1, Math.max(0, t)) * (stops.length - 1);
  const k = Math.min(stops.length - 2, Math.floor(at));
  return /** @type {Rgb} */ (stops[k].map((c, j) => c + (at - k) * (stops[k + 1][j] - c)));
}

/** Whether white is read better on a colour than black. @param {Rgb} colour */
export const isDark = ([r, g, b]) => 0.3 * r + 0.59 * g + 0.11 * b < 0.5;
