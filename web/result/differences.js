/** The differences of the compared jobs. */

import { h } from '../lib/dom.js';
import { differences } from '../jobs/names.js';
import { scrolled, tableElements, takeAlong } from './figures.js';
import { Panel } from './panel.js';

/** @typedef {import('../shown.js').Shown} Shown */

/** @param {Shown[]} shown @returns {import('../lib/tabular.js').Table} */
export function differencesTable(shown) {
  const found = differences(shown.map(({ job }) => job));
  return {
    columns: [{ title: 'in the set-up' }, ...shown.map(({ label }) => ({ title: label }))],
    rows: found.length
      ? found.map(({ label, unit, texts }) => [unit ? `${label} [${unit}]` : label, ...texts])
      : [['nothing: the jobs ask the same', ...shown.map(() => '')]],
    write: String,
  };
}

export class DifferencesPanel {
  /** @type {import('../lib/tabular.js').Table} */
  #content = { columns: [], rows: [], write: String };

  constructor() {
    this.table = h('table');
    this.panel = new Panel('differences', 'Differences', [scrolled(this.table, 'differences')]);
    takeAlong(this.panel, 'differences', () => this.#content);
  }

  /** @param {Shown[]} shown */
  show(shown) {
    this.panel.show(shown.length > 1);
    if (shown.length < 2) return;
    this.#content = differencesTable(shown);
    this.table.replaceChildren(...tableElements(this.#content));
  }
}
