/** Every step, and every job compared, in figures: to be read, and to be taken into a report. */

import { copy, h, plainButton } from '../lib/dom.js';
import { browser } from '../lib/kept.js';
import { endingAtErrors, toCsv, toLatex, toMarkdown, toTsv } from '../lib/tabular.js';
import { save } from './downloads.js';
import { Panel } from './panel.js';
import { STEP_FIGURES, errorOf, titleOf, valueOf } from './step-figures.js';

/** @typedef {import('../shown.js').Shown} Shown */
/** @typedef {import('../types.js').Step} Step */
/** @param {Step} step */
const stateOf = ({ status }) => status.replaceAll('_', ' ');

/**
 * @param {Shown[]} shown in the same units
 * @returns {import('../lib/tabular.js').Table}
 */
export function figuresTable(shown) {
  const [{ report }] = shown;
  const several = shown.length > 1;
  const all = shown.flatMap(({ report }) => report.steps);
  const figures = /** @type {import('./step-figures.js').StepFigure[]} */ (
    Object.values(STEP_FIGURES)
  )
    .filter((one) => all.some((step) => valueOf(step, one) !== null))
    .map((one) => {
      const errors = all.map((step) => errorOf(step, one));
      return { ...one, barred: errors.some(Boolean), exact: errors.every((error) => error === 0) };
    });
  // A state that is not the usual one stands where it is seen.
  const amiss = all.some(({ status }) => status !== 'converged');
  const columns = [
    ...(several ? [{ title: 'job' }] : []),
    { title: 'step' },
    ...(amiss ? [{ title: 'state' }] : []),
    ...figures.flatMap((one) => {
      const title = one.short ?? titleOf(one, report);
      return [
        { title, unit: one.unit(report), exact: one.exact },
        ...(one.barred ? [{ title: '±', of: title, unit: '%' }] : []),
      ];
    }),
    ...(amiss ? [] : [{ title: 'state' }]),
  ];
  const rows = shown.flatMap(({ report, label }) =>
    report.steps.map((step, k) => [
      ...(several ? [label] : []),
      k + 1,
      ...(amiss ? [stateOf(step)] : []),
      ...figures.flatMap((one) => {
        const cell = valueOf(step, one);
        const error = errorOf(step, one);
        // Of a share as one, of others as a part of them.
        const whole = one.unit(report) === '%' ? Math.abs(cell ?? 0) : 100;
        return [cell, ...(one.barred ? [error == null ? null : whole * error] : [])];
      }),
      ...(amiss ? [] : [stateOf(step)]),
    ]),
  );
  const errors = endingAtErrors(columns);
  /** @type {import('../lib/tabular.js').Table['write']} */
  const write = (cell, k, row) =>
    columns[k].title === 'step' ? String(cell) : errors(cell, k, row);
  return { columns, rows, write };
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
