/** Every iteration in figures. */

import { h } from '../lib/dom.js';
import { duration, figure, unit } from '../lib/units.js';
import { Panel } from './panel.js';
import { scrolled, tableElements, takeAlong } from './figures.js';

/** @typedef {import('../types.js').Iteration} Iteration */

/**
 * @typedef {{title: string, key: import('../types.js').IterationFigure, write: (value: number) =>
 *   string, quantity?: import('../lib/units.js').Quantity, unit?: string, beyond?: boolean}}
 *   Figure `beyond`: in files alone
 */

const brief = (/** @type {number} */ value) => figure(value, 3);
const six = (/** @type {number} */ value) => figure(value, 6);

/** @type {Figure[]} */
const FIGURES = [
  { title: 'no.', key: 'iteration', write: String },
  { title: 'out of balance', key: 'equilibrium_residual', write: brief },
  { title: 'displacement change', key: 'displacement_change', write: brief },
  { title: 'force change', key: 'force_change', write: brief, beyond: true },
  { title: 'approach', key: 'approach', write: six, quantity: 'length' },
  { title: 'peak pressure', key: 'peak_pressure', write: six, quantity: 'stress' },
  { title: 'contact pairs', key: 'contact_pairs', write: String },
  { title: 'plastic points', key: 'plastic_points', write: String },
  { title: 'pivots', key: 'contact_pivots', write: String },
  { title: 'factorizations', key: 'factorizations', write: String, beyond: true },
  { title: 'stress updates', key: 'initial_stress_updates', write: String, beyond: true },
  { title: 'time', key: 'elapsed_ms', write: duration, unit: 'ms' },
];

/**
 * @param {Iteration[]} history
 * @param {import('../lib/units.js').Units | import('../lib/units.js').UnitSet} units
 * @param {boolean} [whole] with what only files have
 * @returns {import('../lib/tabular.js').Table}
 */
function tableOf(history, units, whole = false) {
  const figures = FIGURES.filter(({ beyond }) => whole || !beyond);
  return {
    // On the page every time has its unit.
    columns: figures.map(({ title, quantity, unit: own }) => ({
      title,
      unit: quantity ? unit(quantity, units) : whole ? own : undefined,
    })),
    rows: history.map((record) => figures.map(({ key }) => record[key])),
    write: (cell, k) => (typeof cell === 'number' ? figures[k].write(cell) : (cell ?? '')),
  };
}

export class HistoryPanel {
  /** @type {Parameters<typeof tableOf>} */
  #shown = [[], 'mm_N_MPa'];

  constructor() {
    this.table = h('table');
    /** @type {Panel} */
    this.panel = new Panel('iterations', 'Iterations', [scrolled(this.table, 'iterations')], {
      controls: takeAlong(
        () => tableOf(...this.#shown),
        'iterations',
        () => this.panel.fileName('csv'),
        () => tableOf(this.#shown[0], this.#shown[1], true),
      ),
    });
  }

  /**
   * @param {Iteration[]} history of one step
   * @param {import('../lib/units.js').Units | import('../lib/units.js').UnitSet} units
   */
  show(history, units) {
    this.#shown = [history, units];
    this.panel.show(history.length > 0);
    this.table.replaceChildren(...tableElements(tableOf(history, units)));
  }
}
