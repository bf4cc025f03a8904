/**
 * Numbers as people write them: a decimal point or comma, digits in groups of three, a power of
 * ten, a unit behind.
 */

import { inJobUnits } from './units.js';

/** @typedef {import('./units.js').Quantity} Quantity */
/** @typedef {import('./units.js').Units} Units */
/** @typedef {{value: number} | {problem: string}} Reading */

const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;
const COMMA = /^[+-]?\d*,\d+(e[+-]?\d+)?$/i;
/** One comma and three digits behind it: a decimal comma or a thousand. */
const AMBIGUOUS = /^[+-]?[1-9]\d{0,2},\d{3}$/;

/** The same with a point: none that this page writes ends in 0. */
const EITHER = /^[+-]?[1-9]\d{0,2}\.\d{2}0$/;

/**
 * What is to be asked of a number that one types: a point may group thousands.
 * @param {string} text
 * @returns {string} nothing where it is clear
 */
export function doubtOf(text) {
  const plain = tidy(parted(text).digits);
  return EITHER.test(plain)
    ? `${quoted(text)} can be read as ${Number(plain)} or as ${plain.replace('.', '')}: write one of these`
    : '';
}

/** Whether a text is a number with a comma that cannot group thousands. @param {string} text */
export function hasDecimalComma(text) {
  const plain = tidy(text);
  return COMMA.test(plain) && !AMBIGUOUS.test(plain);
}

/**
 * @param {string} text
 * @param {boolean} [commas] whether numbers beside it have decimal commas
 * @returns {Reading}
 */
export function readNumber(text, commas = false) {
  const plain = text.length > LONGEST ? '' : tidy(text);
  const refuse = (/** @type {string} */ words) => ({ problem: `${quoted(text)} ${words}` });
  if (commas && NUMBER.test(plain) && plain.includes('.'))
    return refuse('has a decimal point, and others have a decimal comma: write one of them');
  if (!commas && AMBIGUOUS.test(plain))
    return refuse(
      `can be read as ${plain.replace(',', '.')} or as ${plain.replace(',', '')}: write one of these`,
    );
  const point = COMMA.test(plain) ? plain.replace(',', '.') : plain;
  const thousands = /^[+-]?\d+[.,]\d+[.,]/.test(plain)
    ? ': write its thousands without a sign between them'
    : '';
  if (!NUMBER.test(point)) return refuse(`is not a number${thousands}`);
  const value = Number(point);
  if (!Number.isFinite(value)) return refuse('is too large for a number');
  const vanishes = value === 0 && /[1-9]/.test(point.replace(/e.*/i, ''));
  return vanishes ? refuse('is too close to 0 for a number') : { value };
}

/**
 * Splits a text into digits and unit.
 * @param {string} text
 * @returns {{digits: string, name: string}}
 */
export function parted(text) {
  const plain = withExponents(text);
  const [, digits = plain.trim(), name = ''] =
    /^\s*([+-]?[\d.,\s'’]*\d[.,]?(?:e[+-]?\d+)?)\s*([^\d\s].*?)?\s*$/i.exec(plain) ?? [];
  return { digits, name };
}

/**
 * A number with or without a unit, in the units of the job.
 * @param {string} text
 * @param {Quantity | undefined} quantity
 * @param {Units} units
 * @param {{unit?: string, commas?: boolean}} [given] a unit where none stands behind the number;
 *   whether commas are decimal
 * @returns {Reading}
 */
export function readQuantity(text, quantity, units, { unit = '', commas } = {}) {
  if (text.length > LONGEST) return readNumber(text);
  const { digits, name } = parted(text);
  // Neither is the x of 0x10 a unit.
  if (/^x\d/i.test(name) || !(name || unit) || !quantity) return readNumber(text, commas);
  const reading = readNumber(digits, commas);
  if ('problem' in reading) return reading;
  const value = inJobUnits(reading.value, name || unit, quantity, units);
  return value === undefined
    ? { problem: `${quoted(name || unit)} is no unit known here for this figure` }
    : { value };
}

/**
 * A figure of what is shown, in the units of the job: with a unit of its own behind it, or else in
 * those that are shown.
 * @param {string} text
 * @param {Quantity} quantity
 * @param {Units} units of the job
 * @param {number} times from these to the units shown
 * @returns {Reading}
 */
export function readShown(text, quantity, units, times) {
  if (parted(text).name) return readQuantity(text, quantity, units);
  const reading = readNumber(text);
  return 'problem' in reading ? reading : { value: reading.value / times };
}

/**
 * A figure of a job that is one: what is typed and is no number stands in the job as text.
 * @param {unknown} value
 * @returns {number}
 */
export const numberOf = (value) => (typeof value === 'number' ? value : NaN);

/**
 * Dashes that stand for a minus where a keyboard has none, or a program has put them: hyphens,
 * short dashes, the sign itself.
 */
const MINUS = /[\u2010-\u2013\u2212\ufe63\uff0d]/g;

/** The same with plain minus signs. @param {string} text */
export const withMinus = (text) => text.replace(MINUS, '-');

/** Powers of ten as this page and people write them: 4.5·10⁸, 4.5×10^8, 10⁻⁵. */
const POWER = /(?:([\d.,])\s*[·⋅×*]\s*|(?<![\d.,]))10(?:\^([+-]?\d+)|([⁺⁻]?[⁰¹²³⁴⁵⁶⁷⁸⁹]+))/g;
const RAISED = '⁰¹²³⁴⁵⁶⁷⁸⁹';

/** The same with powers of ten as exponents. @param {string} text */
const withExponents = (text) =>
  withMinus(text).replace(POWER, (_, digit = '1', level, raised = '') => {
    const lowered = [...raised]
      .map((sign) => (sign === '⁻' ? '-' : sign === '⁺' ? '' : RAISED.indexOf(sign)))
      .join('');
    return `${digit}e${level ?? lowered}`;
  });

/** Digits before the decimal sign in groups of three. */
const GROUPED = /^[+-]?\d{1,3}(?:[\s'’]\d{3})+(?=$|[.,e])/i;

/**
 * Removes signs that group digits; writes a plain minus, and a power of ten as exponent.
 * @param {string} text
 */
const tidy = (text) =>
  withExponents(text)
    .trim()
    .replace(GROUPED, (whole) => whole.replace(/[\s'’]/g, ''));

/** Most characters of a text quoted in a message, and of a text that may be a number. */
const [SAID, LONGEST] = [40, 200];

/** Quotes a typed text for a message. @param {string} text */
export function quoted(text) {
  const plain = text.trim();
  return `“${plain.length > SAID ? `${plain.slice(0, SAID)}…` : plain}”`;
}

/** @param {number} columns */
export const columnsInWords = (columns) =>
  ['no', 'one', 'two', 'three'][columns] ?? String(columns);
