/** Units that results are shown in, apart from those of the job. */

import { h } from '../lib/dom.js';
import { kept } from '../lib/kept.js';
import { factor, forceOf, setOf, stiffnessOf } from '../lib/units.js';

/** @typedef {import('../lib/units.js').UnitSet} UnitSet */
/** @typedef {import('../lib/units.js').Quantity} Quantity */

const KEPT = 'display-units';
/** @type {Record<'length' | 'stress' | 'force', string[]>} */
const CHOICES = {
  length: ['mm', 'µm', 'nm', 'm', 'in'],
  stress: ['MPa', 'GPa', 'Pa', 'ksi'],
  force: ['N', 'kN', 'mN', 'lbf'],
};

/** What each figure of a result is. Keys that are not listed have no unit. @type {Record<string, Quantity | 'load' | 'slope'>} */
const QUANTITIES = {
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
    'tau_max',
    'tau_xy',
    'von_mises',
    'yield_stress',
    'shakedown_pressure',
  ]),
  ...named('load', ['force', 'yield_onset_force']),
  ...named('slope', ['contact_stiffness', 'stiffness', 'unloading_stiffness']),
  area: 'area',
};
/** Parts without units: relative errors, times, meshes whose figures are converted where they are read. */
const LEFT = new Set(['estimated_error', 'timings_ms', 'fields', 'tags', 'validity']);

/** @param {Quantity | 'load' | 'slope'} quantity @param {string[]} keys */
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
  const factors = /** @type {Map<string, number>} */ (new Map());
  const times = (/** @type {string} */ key) => {
    if (!factors.has(key)) {
      const named = QUANTITIES[key];
      const quantity = named === 'load' ? forceOf(of) : named === 'slope' ? stiffnessOf(of) : named;
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

/** @param {any} given @returns {Partial<Record<'length' | 'stress' | 'force', string>>} those of it that there are */
const chosen = (given) =>
  Object.fromEntries(
    Object.entries(CHOICES).flatMap(([key, names]) => (names.includes(given?.[key]) ? [[key, given[key]]] : [])),
  );

/** The choice of units: what is not chosen is as in the job. */
export class DisplayUnits {
  /** @type {Partial<Record<'length' | 'stress' | 'force', string>>} */
  #chosen = kept(localStorage, KEPT, chosen) ?? {};

  /** @param {() => void} changed */
  constructor(changed) {
    const choice = (/** @type {'length' | 'stress' | 'force'} */ key, /** @type {string} */ label) => {
      const select = h(
        'select',
        {
          'aria-label': `Unit of ${key}`,
          onchange: () => {
            if (select.value) this.#chosen[key] = select.value;
            else delete this.#chosen[key];
            localStorage.setItem(KEPT, JSON.stringify(this.#chosen));
            changed();
          },
        },
        h('option', { value: '' }, 'as in the job'),
        CHOICES[key].map((name) => h('option', { selected: this.#chosen[key] === name }, name)),
      );
      return h('li', {}, h('label', {}, label, select));
    };
    this.element = h(
      'details',
      { class: 'menu' },
      h('summary', {}, 'Units shown'),
      h(
        'ul',
        { class: 'choices' },
        choice('length', 'Lengths '),
        choice('stress', 'Stresses '),
        choice('force', 'Forces '),
      ),
    );
  }

  /** @param {import('../lib/units.js').Units | import('../lib/units.js').UnitSet} units of the job @returns {UnitSet} */
  set(units) {
    const own = setOf(units);
    const { length = own.length, stress = own.stress, force = own.force } = this.#chosen;
    return { length, stress, force, per: length === 'µm' || length === 'nm' ? 'mm' : length };
  }
}
