/** Every iteration in figures. */

import { h } from '../lib/dom.js';
import { duration, figure, unit } from '../lib/units.js';
import { Panel } from './panel.js';
import { save } from './downloads.js';
import { scrolled } from './figures.js';

/** @typedef {import('../types.js').Iteration} Iteration */

/** @type {[string, import('../types.js').IterationFigure, (value: number) => string, import('../lib/units.js').Quantity?][]} */
const COLUMNS = [
  ['no.', 'iteration', String],
  ['out of balance', 'equilibrium_residual', (value) => figure(value, 3)],
  ['displacement change', 'displacement_change', (value) => figure(value, 3)],
  ['approach', 'approach', (value) => figure(value, 6), 'length'],
  ['peak pressure', 'peak_pressure', (value) => figure(value, 6), 'stress'],
  ['contact pairs', 'contact_pairs', String],
  ['plastic points', 'plastic_points', String],
  ['pivots', 'contact_pivots', String],
  ['time', 'elapsed_ms', duration],
];

export class HistoryPanel {
  /** @type {Iteration[]} */
  #history = [];

  constructor() {
    this.table = h('table');
    const csv = h('button', { type: 'button', class: 'plain', onclick: () => this.#save() }, 'CSV');
    this.panel = new Panel('history', 'Iterations', [scrolled(this.table, 'iterations')], { controls: [csv] });
  }

  /** @param {Iteration[]} history of one step @param {import('../lib/units.js').Units | import('../lib/units.js').UnitSet} units */
  show(history, units) {
    this.#history = history;
    this.panel.show(history.length > 0);
    const head = h(
      'thead',
      {},
      h(
        'tr',
        {},
        COLUMNS.map(([title, , , quantity]) =>
          h('th', { scope: 'col' }, title, quantity && h('span', { class: 'unit' }, ` ${unit(quantity, units)}`)),
        ),
      ),
    );
    const rows = history.map((record) =>
      h(
        'tr',
        {},
        COLUMNS.map(([, key, write]) => h('td', {}, write(record[key]))),
      ),
    );
    this.table.replaceChildren(head, h('tbody', {}, rows));
  }

  #save() {
    const figures = Object.entries(this.#history[0] ?? {}).filter(([, value]) => typeof value === 'number');
    const keys = /** @type {import('../types.js').IterationFigure[]} */ (figures.map(([key]) => key));
    const lines = [keys.join(','), ...this.#history.map((record) => keys.map((key) => record[key]).join(','))];
    save(new Blob([`${lines.join('\n')}\n`], { type: 'text/csv' }), 'history.csv');
  }
}
