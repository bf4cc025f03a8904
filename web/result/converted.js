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
 * read. A search tells its looks in the units of the job.
 */
export const LEFT = new Set(['timings_ms', 'fields', 'tags', 'validity', 'verdict', 'found']);

/** What a row has in its unit. */
const AMOUNTS = ['value', 'elastic', 'at_least', 'at_most'];

/** Members that are numbers, multiplied. @param {Record<string, any>} of @param {string[]} names @param {number} times */
const scaled = (of, names, times) =>
  Object.fromEntries(
    names.flatMap((name) => (typeof of[name] === 'number' ? [[name, of[name] * times]] : [])),
  );

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
    // A row says what it is.
    if (key === 'answers')
      return {
        ...part,
        ...scaled(part, AMOUNTS, factor(part.quantity, of.units, set)),
        place: part.place && {
          ...part.place,
          ...scaled(part.place, ['x', 'y', 'depth'], factor('length', of.units, set)),
        },
        unit: unit(part.quantity, set) || part.unit,
      };
    return Object.fromEntries(
      Object.entries(part).map(([name, one]) => [
        name,
        LEFT.has(name)
          ? one
          : name === 'passes' && part.answers
            ? coursesOf(one, part.answers)
            : walk(one, name),
      ]),
    );
  };
  /** The figures of a pass are those of rows. @param {any} passes @param {import('../wire.js').Answer[]} rows @returns {any} */
  const coursesOf = (passes, rows) =>
    Object.fromEntries(
      Object.entries(passes).map(([name, courses]) => {
        const row = rows.find((one) => one.name === name);
        if (Array.isArray(courses)) return [name, courses];
        if (!row) return [name, coursesOf(courses, rows)];
        const times = factor(/** @type {Quantity} */ (row.quantity), of.units, set);
        return [
          name,
          { ...courses, value: courses.value.map((/** @type {number} */ one) => one * times) },
        ];
      }),
    );
  return ['length', 'stress', 'force', 'per'].every(
    (key) =>
      setOf(of.units)[/** @type {keyof UnitSet} */ (key)] ===
      set[/** @type {keyof UnitSet} */ (key)],
  )
    ? value
    : walk(value, '');
}
