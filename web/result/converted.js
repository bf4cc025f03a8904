/**
 * A result in other units: what each of its figures is, and the same figure in the units that are
 * shown.
 */

import { energyOf, factor, forceOf, setOf, stiffnessOf, unit } from '../lib/units.js';
import { FIGURES } from '../setup/tables.js';

/** @typedef {import('../lib/units.js').Quantity} Quantity */
/** @typedef {import('../lib/units.js').UnitSet} UnitSet */
/**
 * @typedef {'load' | 'slope' | 'energy'} OfAnalysis quantities whose units depend on the analysis
 */

/**
 * What each figure of a result is. Keys that are not listed have no unit.
 * @type {Record<string, Quantity | OfAnalysis>}
 */
export const QUANTITIES = Object.fromEntries(
  Object.entries(FIGURES).flatMap(([quantity, keys]) =>
    keys.map((key) => [key, /** @type {Quantity | OfAnalysis} */ (quantity)]),
  ),
);
/**
 * Parts without units: relative errors, times, meshes whose figures are converted where they are
 * read.
 */
export const LEFT = new Set([
  'estimated_error',
  'timings_ms',
  'fields',
  'tags',
  'validity',
  'verdict',
]);

/**
 * A result in other units.
 * @template T
 * @param {T} value a result or a part of it
 * @param {{analysis: string, units: import('../lib/units.js').Units}} of
 * @param {UnitSet} set
 * @returns {T}
 */
export function inUnits(value, of, set) {
  const dependent = { load: forceOf(of), slope: stiffnessOf(of), energy: energyOf(of) };
  const factors = /** @type {Map<string, number>} */ (new Map());
  const times = (/** @type {string} */ key) => {
    if (!factors.has(key)) {
      const named = QUANTITIES[key];
      const quantity = /** @type {Record<string, Quantity>} */ (dependent)[named] ?? named;
      factors.set(key, quantity ? factor(quantity, of.units, set) : 1);
    }
    return factors.get(key) ?? 1;
  };
  /** @param {any} part @param {string} key @returns {any} */
  const walk = (part, key) => {
    if (typeof part === 'number') return part * times(key);
    if (Array.isArray(part)) return part.map((one) => walk(one, key));
    if (part === null || typeof part !== 'object') return part;
    // An answer says what it is.
    if (key === 'answers') {
      const { quantity, value, elastic, place } = part;
      // What has no unit that is chosen stays as it is.
      const times =
        quantity === 'ratio' || quantity === 'angle' ? 1 : factor(quantity, of.units, set);
      const [shown, beside] = [value, elastic].map((one) => (one === null ? null : one * times));
      const length = factor('length', of.units, set);
      const moved =
        place &&
        Object.fromEntries(
          Object.entries(place).map(([name, at]) => [
            name,
            typeof at === 'number' ? at * length : at,
          ]),
        );
      const name = unit(quantity, set) || part.unit;
      return { ...part, value: shown, elastic: beside, place: moved, unit: name };
    }
    // The figure that a force was looked for: its name says what it is.
    if (key === 'target') {
      const [wanted, reached] = [part.wanted, part.reached].map(
        (value) => value * times(part.figure),
      );
      return { ...part, wanted, reached, force: part.force * times('force') };
    }
    return Object.fromEntries(
      Object.entries(part).map(([name, one]) => [name, LEFT.has(name) ? one : walk(one, name)]),
    );
  };
  return ['length', 'stress', 'force', 'per'].every(
    (key) =>
      setOf(of.units)[/** @type {keyof UnitSet} */ (key)] ===
      set[/** @type {keyof UnitSet} */ (key)],
  )
    ? value
    : walk(value, '');
}
