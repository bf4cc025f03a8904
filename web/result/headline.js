/**
 * What the engineer may do, in one sentence of the service; below it the answers on cards, each
 * with how well it is known; folded away, what is to be kept in mind and how it was made.
 */

import { byId, h, svg } from '../lib/dom.js';
import { fold } from '../lib/fold.js';
import { symbol } from '../setup/entry.js';
import { help } from '../setup/help.js';
import { inWords } from '../setup/words.js';
import { duration, grouped } from '../lib/units.js';
import {
  alike,
  answersOf,
  differenceWords,
  elasticWords,
  errorWords,
  markOf,
  placeWords,
  unitOf,
  valueOf,
  verdictOf,
} from './answers.js';
import { beside, endedEarly } from './loads.js';

/** @typedef {import('../shown.js').Shown} Shown */
/** @typedef {import('./answers.js').Answer} Answer */
/** @typedef {import('./loads.js').Beside} Beside */

/** @param {Shown[]} shown @param {number} at step of the first */
export function showHeadline(shown, at) {
  const sides = beside(shown, at);
  const [{ report }] = shown;
  const all = answersOf(report.steps[at], report);
  const cards = all.map((answer, k) => card(answer, all, k, sides));
  const first = h('dl', { class: 'figures' }, cards.slice(0, CARDS));
  const rest = h('dl', { class: 'figures' }, cards.slice(CARDS));
  byId('headline').replaceChildren(
    h(
      'div',
      { class: 'verdicts' },
      sides.map((side) => verdict(side, sides.length > 1)),
    ),
    ...(all.length ? [first] : [h('p', { class: 'quiet older' }, 'This step is not an answer.')]),
    ...(cards.length > CARDS
      ? [
          h(
            'div',
            { class: 'rest' },
            fold('answers', false, [`${cards.length - CARDS} more figures`], rest),
          ),
        ]
      : []),
    remarks(shown[0], at),
  );
  rows.disconnect();
  for (const one of [first, rest]) rows.observe(one);
}

/** Cards that are seen; the others are folded. */
const CARDS = 8;

/** Letters of a figure for which a card has room. */
const SHORT = 9;
/** Letters of a note that a card shows whole. */
const NOTE = 90;

/** Least width of a card: lines below its figure have room for five words. */
const CARD = 190;

/** Cards in rows of about the same length, so that none stands alone. */
const rows = new ResizeObserver((entries) => {
  for (const { target, contentRect } of entries) {
    const many = target.children.length;
    const fit = Math.max(2, Math.floor(contentRect.width / CARD));
    const lines = Math.ceil(many / fit);
    const [long, short, longer] = [
      Math.ceil(many / lines),
      Math.floor(many / lines),
      many % lines,
    ];
    // Where the last row would lack two, the rows behind the first ones have one card less each.
    const shared = long * lines - many > 1;
    const columns = shared ? long * short : long;
    /** @type {HTMLElement} */ (target).style.setProperty('--columns', String(columns));
    [...target.children].forEach((one, k) => {
      const span = shared ? columns / (k < longer * long ? long : short) : 1;
      /** @type {HTMLElement} */ (one).style.gridColumn = `span ${span}`;
    });
  }
});

/** @param {Beside} side @param {boolean} named whether jobs are compared */
function verdict({ one, at, label }, named) {
  const found = verdictOf(one.report.steps[at]);
  if (!found) return null;
  const { kind, mark } = markOf(found);
  return h(
    'p',
    { class: `verdict-text ${kind}`, 'data-level': found.level },
    h('span', { class: 'mark', 'aria-hidden': 'true' }, mark),
    h('span', {}, named ? [swatch(one), h('b', {}, `${label}: `)] : null, symbol(found.text)),
  );
}

/** @param {Shown} one */
function swatch({ colour, dash }) {
  const line = svg('path', {
    d: 'M0 4h24',
    'stroke-width': 3,
    'stroke-dasharray': dash?.join(' '),
  });
  line.style.stroke = `var(${colour})`;
  return svg('svg', { class: 'swatch', viewBox: '0 0 24 8', 'aria-hidden': 'true' }, line);
}

/** @param {Answer} answer @param {Answer[]} all @param {number} k @param {Beside[]} sides */
function card(answer, all, k, sides) {
  const key = `${answer.name}-${answer.body ?? ''}-${k}`;
  const text = valueOf(answer);
  const known = errorWords(answer);
  const bar = known
    ? h(
        'span',
        { class: 'bar-of-error', id: `bar-of-${key}` },
        known,
        known.includes('±') ? help('error_bar', 'Error bar', `bar-of-${key}`) : null,
      )
    : null;
  const note = inWords(answer.text);
  const short = [
    elasticWords(answer),
    placeWords(answer, sides[0].one.report, sides[0].one.report.steps[sides[0].at]),
  ].filter(Boolean);
  return h(
    'div',
    { 'data-answer': answer.name },
    h('dt', {}, answer.label),
    h(
      'dd',
      {},
      h(
        'span',
        { class: `figure${text.length > SHORT ? ' long' : ''}` },
        text,
        h('span', { class: 'unit' }, unitOf(answer)),
      ),
      bar,
      short.length ? h('small', {}, short.join('; ')) : null,
      note && note.length <= NOTE ? h('small', {}, symbol(note)) : null,
      note.length > NOTE
        ? fold(`note-${answer.name}`, false, ['how it is counted'], h('small', {}, symbol(note)))
        : null,
      ...(sides.length > 1 ? [compared(answer, all, k, sides)] : []),
    ),
  );
}

/** One line for each of the other jobs. @param {Answer} answer @param {Answer[]} all @param {number} k @param {Beside[]} sides */
const compared = (answer, all, k, sides) =>
  h(
    'ul',
    { class: 'others' },
    sides.slice(1).map(({ one, at, label }) => {
      const other = alike(one.report, at, all, k);
      return h(
        'li',
        { title: label },
        swatch(one),
        h('span', {}, other ? `${valueOf(other)} ${unitOf(other)}` : '—'),
        other ? h('b', {}, differenceWords(answer, other)) : null,
      );
    }),
  );

/** The first sentence of a remark, then the others. @param {string} message */
export const sentencesOf = (message) => inWords(message).split(/(?<=[a-z)%]\.)\s+(?=\p{Lu})/u);

/** What to keep in mind, and how it was made. @param {Shown} shown @param {number} at */
function remarks({ job, report }, at) {
  const step = report.steps[at];
  const ended = endedEarly(job, report);
  const early = ended
    ? h('li', { 'data-code': 'ended_early' }, h('b', {}, 'Ended early'), ` ${ended}`)
    : null;
  const notes = step.validity.map(({ code, message }) => {
    const [short, ...rest] = sentencesOf(message);
    return h(
      'li',
      { 'data-code': code },
      h('b', {}, title(code)),
      ' ',
      symbol(short),
      rest.length ? fold(`remark-${code}`, false, ['more'], symbol(rest.join(' '))) : null,
    );
  });
  const bars =
    step.estimated_error && step.status === 'converged'
      ? h(
          'li',
          {},
          h('b', {}, 'Error bars'),
          step.rolling
            ? ' Bounds of the error of the columns, not of the theory.'
            : ' Bounds of the error of the mesh, by a second mesh of half the density; they held in at least 95 of 100 tested cases and say nothing of the figures put in.',
        )
      : null;
  const { mesh, timings_ms: timings } = report;
  const many = report.steps.length > 1;
  const made = h(
    'li',
    {},
    h('b', {}, 'Made with'),
    ` ${grouped(mesh.elements)} elements${mesh.symmetric ? ' on one half' : ''}, ${grouped(mesh.equations)} equations, ${
      step.history.length
    } iteration${step.history.length === 1 ? '' : 's'}${many ? ' in this step' : ''}; ${duration(timings.total)}${many ? ' for all steps' : ''}.`,
  );
  const count = step.validity.length + (early ? 1 : 0);
  const open = Boolean(early) || step.validity.some(({ code }) => code !== 'deformation_theory');
  const element = fold(
    'remarks',
    open,
    [
      count
        ? `${count} ${count === 1 ? 'remark' : 'remarks'} on validity`
        : 'No remarks on validity',
      ', error bars, mesh',
    ],
    h('ul', {}, early, notes, bars, made),
  );
  element.classList.add('remarks');
  return element;
}

/** @param {string} code */
const title = (code) => code.replaceAll('_', ' ').replace(/^./, (letter) => letter.toUpperCase());
