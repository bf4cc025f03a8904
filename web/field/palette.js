/** Colours for bands of values, and round figures between them. */

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
export const rgb = (hex) => /** @type {Rgb} */ ([1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16) / 255));

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
  return { low: first * step, step, colours: Array.from({ length: count }, (_, k) => between(stops, place(k))) };
}

/** @param {number} rough @returns {number} 1, 2, 2.5 or 5 times a power of ten, not less */
function roundStep(rough) {
  const power = 10 ** Math.floor(Math.log10(rough));
  return power * ([1, 2, 2.5, 5].find((step) => step * power >= rough * (1 - 1e-9)) ?? 10);
}

/** @param {Rgb[]} stops @param {number} t @returns {Rgb} */
function between(stops, t) {
  const at = Math.min(1, Math.max(0, t)) * (stops.length - 1);
  const k = Math.min(stops.length - 2, Math.floor(at));
  return /** @type {Rgb} */ (stops[k].map((c, j) => c + (at - k) * (stops[k + 1][j] - c)));
}
