/** Every step, and every job compared, in figures: to be read, and to be taken into a report. */

import { copy, h } from '../lib/dom.js';
import { toCsv, toLatex, toMarkdown, toTsv } from '../lib/tabular.js';
import { figure, forceOf, stiffnessOf, unit } from '../lib/units.js';
import { save } from './downloads.js';
import { Panel } from './panel.js';

/** @typedef {import('../types.js').Shown} Shown */
/** @typedef {import('../types.js').Step} Step */
/** @typedef {import('../types.js').Report} Report */
/** @typedef {import('../lib/units.js').Quantity} Quantity */

/** `round`: its title in axisymmetry. @type {{title: string, round?: string, quantity: (report: Report) => Quantity | 'percent', value: (step: Step) => number | null | undefined, error?: keyof NonNullable<Step['estimated_error']>}[]} */
const FIGURES = [
  { title: 'force', quantity: forceOf, value: ({ contact }) => contact.force, error: 'force' },
  { title: 'approach', quantity: () => 'length', value: ({ approach }) => approach, error: 'approach' },
  {
    title: 'peak pressure',
    quantity: () => 'stress',
    value: ({ contact }) => contact.peak_pressure,
    error: 'peak_pressure',
  },
  {
    title: 'half-width',
    round: 'contact radius',
    quantity: () => 'length',
    value: ({ contact }) => contact.half_width,
    error: 'half_width',
  },
  { title: 'mean pressure', quantity: () => 'stress', value: ({ contact }) => contact.mean_pressure },
  { title: 'plastic strain', quantity: () => 'percent', value: (step) => 100 * strainOf(step) },
  { title: 'dP/dα', quantity: stiffnessOf, value: ({ contact_stiffness: slope }) => slope, error: 'contact_stiffness' },
  { title: 'Hertz peak', quantity: () => 'stress', value: ({ hertz }) => hertz?.peak_pressure },
];

/**
 * The bound of the error of a figure: none of what the job prescribes, and none of a state that is not the answer.
 * @param {Step} step @param {keyof NonNullable<Step['estimated_error']>} name
 */
export const barOf = ({ status, estimated_error: bars }, name) => (status === 'converged' && bars?.[name]) || undefined;

/** Largest equivalent plastic strain of both bodies. @param {Step} step */
export const strainOf = ({ plasticity }) =>
  Math.max(plasticity.upper?.max_equivalent_plastic_strain ?? 0, plasticity.lower?.max_equivalent_plastic_strain ?? 0);

/** @param {Step} step */
const stateOf = ({ status }) => status.replaceAll('_', ' ');

/**
 * @param {Shown[]} shown in the same units
 * @returns {import('../lib/tabular.js').Table}
 */
export function figuresTable(shown) {
  const [{ report }] = shown;
  const several = shown.length > 1;
  const figures = FIGURES.filter(({ value }) =>
    shown.some(({ report }) => report.steps.some((step) => value(step) != null)),
  ).map(({ error, round, ...figure }) => {
    const title = report.analysis === 'axisymmetric' && round ? round : figure.title;
    const hasBars = error && shown.some(({ report }) => report.steps.some((step) => barOf(step, error)));
    return { ...figure, title, error: hasBars ? error : undefined };
  });
  // A state that is not the usual one stands where it is seen.
  const amiss = shown.some(({ report }) => report.steps.some(({ status }) => status !== 'converged'));
  const columns = [
    ...(several ? [{ title: 'job' }] : []),
    { title: 'step' },
    ...(amiss ? [{ title: 'state' }] : []),
    ...figures.flatMap(({ title, quantity, error }) => {
      const kind = quantity(report);
      return [
        { title, unit: kind === 'percent' ? '%' : unit(kind, report.units) },
        ...(error ? [{ title: '±', of: title, unit: '%' }] : []),
      ];
    }),
    ...(amiss ? [] : [{ title: 'state' }]),
  ];
  const rows = shown.flatMap(({ report, label }) =>
    report.steps.map((step, k) => [
      ...(several ? [label] : []),
      k + 1,
      ...(amiss ? [stateOf(step)] : []),
      ...figures.flatMap(({ value, error }) => {
        const bar = error && barOf(step, error);
        return [value(step) ?? null, ...(error ? [bar === undefined ? null : 100 * bar] : [])];
      }),
      ...(amiss ? [] : [stateOf(step)]),
    ]),
  );
  const write = (/** @type {import('../lib/tabular.js').Cell} */ cell, /** @type {number} */ k) =>
    typeof cell !== 'number'
      ? (cell ?? '')
      : columns[k].title === 'step'
        ? String(cell)
        : figure(cell, columns[k].title === '±' ? 2 : 5);
  return { columns, rows, write };
}

/**
 * Buttons that take a table along.
 * @param {() => import('../lib/tabular.js').Table} table
 * @param {string} of what it is a table
 * @param {() => string} name of the file
 * @param {() => import('../lib/tabular.js').Table} [whole] with what only a file has
 */
export function takeAlong(table, of, name, whole = table) {
  const button = (/** @type {string} */ text, /** @type {string} */ title, /** @type {() => void} */ work) =>
    h('button', { type: 'button', class: 'plain', title, 'aria-label': `${text}: ${of}`, onclick: work }, text);
  return [
    button('Copy', 'Copy for a spreadsheet (tab-separated)', () => copy(toTsv(table()), 'Table')),
    button('Markdown', 'Copy as a Markdown table', () => copy(toMarkdown(table()), 'Markdown')),
    button('LaTeX', 'Copy as a LaTeX table (booktabs)', () => copy(toLatex(table()), 'LaTeX')),
    button('CSV', 'Save as a file', () => save(new Blob([toCsv(whole())], { type: 'text/csv' }), name())),
  ];
}

/** @param {import('../lib/tabular.js').Table} table @param {(row: number) => Record<string, any>} [properties] of its rows */
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
        row.map((cell, j) => h('td', { class: typeof cell === 'string' ? 'text' : null }, write(cell, j))),
      ),
    ),
  ),
];

/** A table that scrolls within its panel. @param {HTMLTableElement} table @param {string} id of the panel */
export const scrolled = (table, id) =>
  h('div', { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': `Table of ${id}` }, table);

export class FiguresPanel {
  /** @type {Shown[]} */
  #shown = [];

  /** @param {(step: number) => void} choose called with the step of the first job that is to be shown */
  constructor(choose) {
    this.choose = choose;
    this.table = h('table');
    /** @type {Panel} */
    this.panel = new Panel('figures', 'Figures', [scrolled(this.table, 'figures')], {
      controls: takeAlong(
        () => figuresTable(this.#shown),
        'figures',
        () => this.panel.fileName('csv'),
      ),
    });
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
    if (steps > 1 || shown.length > 1) this.table.tBodies[0].rows[at].setAttribute('aria-current', 'step');
  }
}
