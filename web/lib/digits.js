/** How many digits of a figure are worth writing. */

import { figure } from './units.js';

/** Least and most digits that are written, and those of a figure whose error is not known. */
const [FEW, MANY, UNKNOWN] = [2, 5, 3];

/**
 * So many digits that the last one is about a tenth of the error.
 * @param {number | null | undefined} error relative; 0 of what is exact
 * @returns {number}
 */
export function digitsOf(error) {
  if (error === null || error === undefined) return UNKNOWN;
  if (!(error > 0)) return MANY;
  return Math.min(MANY, Math.max(FEW, Math.ceil(-Math.log10(error)) + 1));
}

/**
 * Digits before the point that the error leaves open are 0.
 * @param {number} value @param {number | null | undefined} error relative @returns {string}
 */
export const figureOf = (value, error) => {
  const digits = digitsOf(error);
  return figure(error ? Number(value.toPrecision(digits)) : value, digits);
};
