/** Units that results are shown in, apart from those of the job. */

import { h } from '../lib/dom.js';
import { browser, kept } from '../lib/kept.js';
import { setOf } from '../lib/units.js';
import { hasCommas, setCommas } from './figures.js';

const KEPT = 'display-units';
/** @type {Record<'length' | 'stress' | 'force', string[]>} */
const CHOICES = {
  length: ['mm', 'µm', 'nm', 'm', 'in'],
  stress: ['MPa', 'GPa', 'Pa', 'ksi'],
  force: ['N', 'kN', 'mN', 'lbf'],
};

/**
 * @param {any} given
 * @returns {Partial<Record<'length' | 'stress' | 'force', string>>} those of it that there are
 */
const chosen = (given) =>
  Object.fromEntries(
    Object.entries(CHOICES).flatMap(([key, names]) =>
      names.includes(given?.[key]) ? [[key, given[key]]] : [],
    ),
  );

/** The choice of units; by default the units of the job. */
export class DisplayUnits {
  /** @type {Partial<Record<'length' | 'stress' | 'force', string>>} */
  #chosen = kept(browser, KEPT, chosen) ?? {};

  /** @param {() => void} changed */
  constructor(changed) {
    const choice = (
      /** @type {'length' | 'stress' | 'force'} */ key,
      /** @type {string} */ label,
    ) => {
      const select = h(
        'select',
        {
          'aria-label': `Unit of ${key}`,
          onchange: () => {
            if (select.value) this.#chosen[key] = select.value;
            else delete this.#chosen[key];
            browser.set(KEPT, JSON.stringify(this.#chosen));
            changed();
          },
        },
        h('option', { value: '' }, 'as in the job'),
        CHOICES[key].map((name) => h('option', { selected: this.#chosen[key] === name }, name)),
      );
      return h('li', {}, h('label', {}, label, select));
    };
    const csv = h(
      'select',
      { 'aria-label': 'CSV files', onchange: () => setCommas(csv.value === 'comma') },
      h('option', { value: 'point' }, 'comma, 1.5'),
      h('option', { value: 'comma', selected: hasCommas() }, 'semicolon, 1,5'),
    );
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
        h('li', {}, h('label', {}, 'CSV files ', csv)),
      ),
    );
  }

  /**
   * @param {import('../lib/units.js').Units | import('../lib/units.js').UnitSet} units of the job
   * @returns {import('../lib/units.js').UnitSet}
   */
  set(units) {
    const own = setOf(units);
    const { length = own.length, stress = own.stress, force = own.force } = this.#chosen;
    return { length, stress, force, per: length === 'µm' || length === 'nm' ? 'mm' : length };
  }
}
