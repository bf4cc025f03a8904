/** The answers of a step in sentence and table, on the page and in the report. */

import { h, svg } from '../lib/dom.js';
import { symbol } from '../setup/entry.js';
import { inWords } from '../setup/words.js';
import {
  MARKS,
  alike,
  answersOf,
  differenceWords,
  elasticWords,
  errorWords,
  placeWords,
  unitOf,
  valueOf,
} from './answers.js';

/** @typedef {import('../shown.js').Shown} Shown */
/** @typedef {import('./loads.js').Beside} Beside */

/** @param {Shown} one @returns {SVGSVGElement} its line in the charts */
export function swatch({ colour, dash }) {
  const line = svg('path', {
    d: 'M0 4h24',
    'stroke-width': 3,
    'stroke-dasharray': dash?.join(' '),
  });
  line.style.stroke = `var(${colour})`;
  return svg('svg', { class: 'swatch', viewBox: '0 0 24 8', 'aria-hidden': 'true' }, line);
}

/** @param {Beside} side @param {boolean} named whether jobs are compared */
export function verdict({ one, at, label }, named) {
  const { level, mark, text } = one.report.steps[at].verdict;
  return h(
    'p',
    { class: `verdict-text ${mark}`, 'data-level': level },
    h('span', { class: 'mark', 'aria-hidden': 'true' }, MARKS[mark]),
    h('span', {}, named ? [swatch(one), h('b', {}, `${label}: `)] : null, symbol(text)),
  );
}

/** Why it is not known; of `whole` tables why its error is not bounded, where nothing else is said of it. @param {import('./answers.js').Answer} answer @param {boolean} whole */
const whyOf = ({ value, reason, at_least: least, at_most: most }, whole) => {
  if (value === null) return `not known: ${inWords(reason ?? '')}`;
  const isSaid = !whole || !reason || least !== undefined || most !== undefined;
  return isSaid ? '' : `no bound: ${inWords(reason)}`;
};

/**
 * The answers of one step: how well each is known, what elastic theory says, where it is, and those
 * of the other jobs with their error and difference.
 * @param {Beside[]} sides
 * @param {boolean} whole whether details are among them
 */
export function answersTable(sides, whole) {
  const [{ one, at }, ...others] = sides;
  const step = one.report.steps[at];
  const all = answersOf(one.report, at, whole);
  const notes = others.length === 0;
  const hasElastic = notes && all.some((answer) => elasticWords(answer));
  const rows = all.map((answer, k) =>
    h(
      'tr',
      { 'data-row': answer.name },
      h('th', { scope: 'row' }, symbol(answer.label)),
      h('td', {}, valueOf(answer)),
      h('td', { class: 'unit' }, unitOf(answer)),
      h('td', {}, errorWords(answer)),
      hasElastic && h('td', {}, elasticWords(answer)),
      notes &&
        h(
          'td',
          { class: 'text' },
          symbol(
            [placeWords(answer, one.report, step), inWords(answer.text), whyOf(answer, whole)]
              .filter((text) => text && text !== errorWords(answer))
              .join('; '),
          ),
        ),
      others.flatMap(({ one, at }) => {
        const other = alike(one.report, at, all, k);
        return other
          ? [valueOf(other), errorWords(other), differenceWords(answer, other)].map((text) =>
              h('td', {}, text),
            )
          : [h('td', {}, '—'), h('td'), h('td')];
      }),
    ),
  );
  const head = [
    '',
    notes ? '' : sides[0].label,
    '',
    'error',
    ...(hasElastic ? ['beside elastic theory'] : []),
    ...(notes ? [''] : []),
    ...others.flatMap(({ label }) => [label, 'error', 'difference']),
  ];
  const cells = head.map((text) => (text ? h('th', { scope: 'col' }, text) : h('td')));
  return h(
    'table',
    { class: 'answers' },
    h('thead', {}, h('tr', {}, cells)),
    h('tbody', {}, rows),
  );
}
