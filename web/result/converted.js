/** A result in other units: what each of its figures is, and the same figure in the units that are shown. */

import { energyOf, factor, forceOf, setOf, stiffnessOf } from '../lib/units.js';

/** @typedef {import('../lib/units.js').Quantity} Quantity */
/** @typedef {import('../lib/units.js').UnitSet} UnitSet */
/** @typedef {'load' | 'slope' | 'energy'} OfAnalysis quantities whose units depend on the analysis */

/** What each figure of a result is. Keys that are not listed have no unit. @type {Record<string, Quantity | OfAnalysis>} */
export const QUANTITIES = {
  ...named('length', [
    'approach',
    'half_width',
    'peak_position',
    'left',
    'right',
    'x',
    'gap',
    'depth',
    'position',
    'outline',
    'spacing',
    'yield_onset_depth',
    'shakedown_depth',
    'height',
    'pile_up',
    'pile_up_position',
    'permanent_approach',
    'dent_depth',
  ]),
  ...named('stress', [
    'peak_pressure',
    'mean_pressure',
    'pressure',
    'sigma_x',
    'sigma_y',
    'sigma_z',
    'initial_sigma_x',
    'initial_sigma_y',
    'initial_sigma_z',
    'tau_max',
    'tau_xy',
    'von_mises',
    'yield_stress',
    'shakedown_pressure',
  ]),
  ...named('load', ['force', 'yield_onset_force']),
  ...named('slope', ['contact_stiffness', 'stiffness', 'unloading_stiffness']),
  ...named('area', ['area', 'reverse_area']),
  ...named('energy', ['work', 'elastic', 'plastic', 'stored', 'dissipated']),
};
/** Parts without units: relative errors, times, meshes whose figures are converted where they are read. */
export const LEFT = new Set(['estimated_error', 'timings_ms', 'fields', 'tags', 'validity']);

/** @param {Quantity | OfAnalysis} quantity @param {string[]} keys */
function named(quantity, keys) {
  return Object.fromEntries(keys.map((key) => [key, quantity]));
}

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
    // The figure that a force was looked for: its name says what it is.
    if (key === 'target') {
      const [wanted, reached] = [part.wanted, part.reached].map((value) => value * times(part.figure));
      return { ...part, wanted, reached, force: part.force * times('force') };
    }
    return Object.fromEntries(
      Object.entries(part).map(([name, one]) => [name, LEFT.has(name) ? one : walk(one, name)]),
    );
  };
  return ['length', 'stress', 'force', 'per'].every(
    (key) => setOf(of.units)[/** @type {keyof UnitSet} */ (key)] === set[/** @type {keyof UnitSet} */ (key)],
  )
    ? value
    : walk(value, '');
}
