/** Every step, and every job compared, in figures: to be read, and to be taken into a report. */

import { copy, h, plainButton } from '../lib/dom.js';
import { browser } from '../lib/kept.js';
import { endingAtErrors, toCsv, toLatex, toMarkdown, toTsv } from '../lib/tabular.js';
import { save } from './downloads.js';
import { Panel } from './panel.js';
import { lowered } from '../setup/field.js';
import { errorOf, shareOf, unitOf } from './answers.js';
import { APPROACH, WIDTH, rowOf } from './rows.js';

/** @typedef {import('../shown.js').Shown} Shown */
/** @typedef {import('../types.js').Step} Step */
/** @param {Step} step */
const stateOf = ({ status }) => status.replaceAll('_', ' ');

/** Names of the columns. */
const COLUMNS = [
  ['force'],
  APPROACH,
  ['peak_pressure'],
  WIDTH,
  ['mean_pressure'],
  ['max_plastic_strain'],
  ['contact_stiffness'],
];

/** What its curve and its column are called. @param {import('../wire.js').Answer} row */
export const titleOf = ({ label }) => lowered(label.split(',')[0]);

/**
 * @param {Shown[]} shown in the same units
 * @returns {import('../lib/tabular.js').Table}
 */
export function figuresTable(shown) {
  const several = shown.length > 1;
  const all = shown.flatMap(({ report }) => report.steps);
  const figures = COLUMNS.flatMap((names) => {
    const rows = all
      .map((step) => rowOf(step, ...names))
      .filter((row) => row && row.value !== null);
    const errors = rows.map((row) => row && errorOf(row));
    const [row] = rows;
    const [barred, exact] = [errors.some(Boolean), errors.every((error) => error === 0)];
    return row ? [{ names, row, barred, exact }] : [];
  });
  // A state that is not the usual one stands where it is seen.
  const amiss = all.some(({ status }) => status !== 'converged');
  const columns = [
    ...(several ? [{ title: 'job' }] : []),
    { title: 'step' },
    ...(amiss ? [{ title: 'state' }] : []),
    ...figures.flatMap(({ row, barred, exact }) => {
      const title = titleOf(row);
      return [
        { title, unit: unitOf(row), exact },
        ...(barred ? [{ title: '±', of: title, unit: '%' }] : []),
      ];
    }),
    ...(amiss ? [] : [{ title: 'state' }]),
  ];
  const rows = shown.flatMap(({ report, label }) =>
    report.steps.map((step, k) => [
      ...(several ? [label] : []),
      k + 1,
      ...(amiss ? [stateOf(step)] : []),
      ...figures.flatMap(({ names, barred }) => cellsOf(rowOf(step, ...names), barred)),
      ...(amiss ? [] : [stateOf(step)]),
    ]),
  );
  const errors = endingAtErrors(columns);
  /** @type {import('../lib/tabular.js').Table['write']} */
  const write = (cell, k, row) =>
    columns[k].title === 'step' ? String(cell) : errors(cell, k, row);
  return { columns, rows, write };
}

/**
 * A figure and its error in a table: of a share as one, of others as a part of them.
 * @param {import('../wire.js').Answer | undefined} row @param {boolean} barred
 */
export function cellsOf(row, barred) {
  const value = row?.value == null ? null : row.value * shareOf(row);
  const error = row ? errorOf(row) : null;
  return [value, ...(barred ? [error === null ? null : 100 * error] : [])];
}

const KEPT = 'csv';

/** Whether files have semicolons and decimal commas, as spreadsheets of many countries read them. */
export const hasCommas = () => browser.get(KEPT) === 'comma';

/** @param {boolean} commas */
export const setCommas = (commas) => browser.set(KEPT, commas ? 'comma' : 'point');

/** @param {import('../lib/tabular.js').Table} table @returns {string} */
function csvOf(table) {
  if (!hasCommas()) return toCsv(table);
  const cell = (/** @type {string} */ text) =>
    /^-?\d+(\.\d+)?(e[+-]?\d+)?$/.test(text)
      ? text.replace('.', ',')
      : text.includes(';') && !text.startsWith('"')
        ? `"${text}"`
        : text;
  return toTsv(table)
    .split('\n')
    .map((line) => line.split('\t').map(cell).join(';'))
    .join('\n');
}

/** Byte-order mark, by which spreadsheets read a file as UTF-8. */
const MARK = '\ufeff';

/**
 * Adds buttons to a panel that take its table along.
 * @param {Panel} panel
 * @param {string} of what it is a table
 * @param {() => import('../lib/tabular.js').Table} table
 */
export function takeAlong(panel, of, table) {
  const button = (
    /** @type {string} */ text,
    /** @type {string} */ title,
    /** @type {() => void} */ work,
  ) => plainButton(text, work, { title, 'aria-label': `${text}: ${of}` });
  panel.exports.push(
    button('Copy', 'Copy for a spreadsheet (tab-separated)', () => copy(toTsv(table()), 'Table')),
    button('Markdown', 'Copy as a Markdown table', () => copy(toMarkdown(table()), 'Markdown')),
    button('LaTeX', 'Copy as a LaTeX table (booktabs)', () => copy(toLatex(table()), 'LaTeX')),
    button('CSV', 'Save as a file', () =>
      save(new Blob([MARK, csvOf(table())], { type: 'text/csv' }), panel.fileName('csv')),
    ),
  );
}

/**
 * @param {import('../lib/tabular.js').Table} table
 * @param {(row: number) => Record<string, any>} [properties] of its rows
 */
export const tableElements = ({ columns, rows, write }, properties = () => ({})) => [
  h(
    'thead',
    {},
    h(
      'tr',
      {},
      columns.map(({ title, unit }, k) =>
        h(
          'th',
          { scope: 'col', class: rows.every((row) => typeof row[k] === 'string') ? 'text' : null },
          title,
          unit ? h('span', { class: 'unit' }, ` ${unit}`) : null,
        ),
      ),
    ),
  ),
  h(
    'tbody',
    {},
    rows.map((row, k) =>
      h(
        'tr',
        properties(k),
        row.map((cell, j) =>
          h('td', { class: typeof cell === 'string' ? 'text' : null }, write(cell, j, row)),
        ),
      ),
    ),
  ),
];

/**
 * A table that scrolls within its panel, and says so where columns are out of sight.
 * @param {HTMLTableElement} table
 * @param {string} id of the panel
 */
export function scrolled(table, id) {
  const region = h(
    'div',
    { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': `Table of ${id}` },
    table,
  );
  const more = h('p', { class: 'quiet more' }, 'more columns →');
  const look = () => {
    more.hidden = region.scrollLeft + region.clientWidth >= region.scrollWidth - 1;
  };
  region.addEventListener('scroll', look);
  const size = new ResizeObserver(look);
  for (const one of [region, table]) size.observe(one);
  return h('div', {}, region, more);
}

export class FiguresPanel {
  /** @type {Shown[]} */
  #shown = [];

  /**
   * @param {(step: number) => void} choose called with the step of the first job that is to be
   *   shown
   */
  constructor(choose) {
    this.choose = choose;
    this.table = h('table');
    this.panel = new Panel('figures', 'Figures', [scrolled(this.table, 'figures')]);
    takeAlong(this.panel, 'figures', () => figuresTable(this.#shown));
  }

  /** @param {Shown[]} shown @param {number} at step of the first */
  show(shown, at) {
    const steps = shown[0].report.steps.length;
    this.panel.show(true);
    // Of a long sweep only the mark moves from step to step.
    if (shown !== this.#shown)
      this.table.replaceChildren(
        ...tableElements(figuresTable(shown), (row) =>
          row < steps && steps > 1 ? { class: 'choice', onclick: () => this.choose(row) } : {},
        ),
      );
    this.#shown = shown;
    this.table.querySelector('[aria-current]')?.removeAttribute('aria-current');
    if (steps > 1 || shown.length > 1)
      this.table.tBodies[0].rows[at].setAttribute('aria-current', 'step');
  }
}
