/**
 * What the engineer may do, in one sentence of the service; below it the answers, each a line with
 * how well it is known; folded away, all of them with their places, what is to be kept in mind and
 * how it was made.
 */

import { button, byId, h } from '../lib/dom.js';
import { fold } from '../lib/fold.js';
import { symbol } from '../setup/entry.js';
import { help } from '../setup/help.js';
import { inWords } from '../setup/words.js';
import { duration, grouped } from '../lib/units.js';
import {
  alike,
  answersOf,
  differenceWords,
  errorWords,
  unitOf,
  valueOf,
  wholeOf,
} from './answers.js';
import { answersTable, swatch, verdict } from './answers-table.js';
import { beside, endedEarly } from './loads.js';

/** @typedef {import('../shown.js').Shown} Shown */
/** @typedef {import('./answers.js').Answer} Answer */
/** @typedef {import('./loads.js').Beside} Beside */

/**
 * @param {Shown[]} shown
 * @param {number} at step of the first
 * @param {import('./next.js').Next[]} next what may be solved where there is no answer
 * @param {(job: import('../types.js').Job) => void} solve
 */
export function showHeadline(shown, at, next, solve) {
  const sides = beside(shown, at);
  const [{ report }] = shown;
  const all = answersOf(report, at);
  const tiles = h(
    'dl',
    { class: 'figures' },
    all.slice(0, TILES).map((answer, k) => tile(answer, all, k, sides)),
  );
  byId('headline').replaceChildren(
    h(
      'div',
      { class: 'verdicts' },
      sides.map((side) => verdict(side, sides.length > 1)),
      next.length > 0 &&
        h(
          'p',
          { class: 'bar next' },
          next.map(({ words, job }) => button(words, () => solve(job))),
        ),
    ),
    ...(all.length
      ? [tiles, h('div', { class: 'rest' }, allFigures(sides))]
      : [h('p', { class: 'quiet' }, 'This step is not an answer.')]),
    remarks(sides),
  );
}

/** The table of all answers, made when it is looked at. @param {Beside[]} sides */
function allFigures(sides) {
  const [{ one, at }] = sides;
  const { length: many } = answersOf(one.report, at, true);
  const place = h('div', {
    class: 'scroll',
    tabindex: 0,
    role: 'region',
    'aria-label': 'All figures',
  });
  const words = [`All ${many} figures, where they are and how they are counted`];
  const element = fold('answers', false, words, place);
  const look = () => element.open && place.replaceChildren(answersTable(sides, true));
  element.addEventListener('toggle', look);
  look();
  return element;
}

/** Answers that are tiles; the table has all. */
const TILES = 8;

/** Letters of a figure for which a tile has room. */
const SHORT = 9;

/** @param {Answer} answer @param {Answer[]} all @param {number} k @param {Beside[]} sides */
function tile(answer, all, k, sides) {
  const text = valueOf(answer);
  return h(
    'div',
    { 'data-answer': answer.name },
    h('dt', {}, symbol(answer.label)),
    h(
      'dd',
      {},
      h(
        'span',
        { class: `figure${text.length > SHORT ? ' long' : ''}` },
        text,
        h('span', { class: 'unit' }, unitOf(answer)),
      ),
      ' ',
      h('span', { class: 'bar-of-error' }, errorWords(answer)),
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
        h('span', {}, other ? wholeOf(other) : '—'),
        other ? h('b', {}, differenceWords(answer, other)) : null,
      );
    }),
  );

/** The first sentence of a remark, then the others. @param {string} message */
export const sentencesOf = (message) => inWords(message).split(/(?<=[a-z)%]\.)\s+(?=\p{Lu})/u);

/** What to keep in mind of a job and of a step. @param {import('../types.js').Report} report @param {number} at */
export const remarksOf = ({ validity = [], steps }, at) => [...validity, ...steps[at].validity];

/** What to keep in mind of every job, and how the first was made. @param {Beside[]} sides */
function remarks(sides) {
  const [{ one, at }] = sides;
  const { job, report } = one;
  const step = report.steps[at];
  const ended = endedEarly(job, report);
  const early = ended
    ? h('li', { 'data-code': 'ended_early' }, h('b', {}, 'Ended early'), ` ${ended}`)
    : null;
  const all = sides.flatMap(({ one, at, label }) =>
    remarksOf(one.report, at).map((remark) => ({ ...remark, of: sides.length > 1 ? label : '' })),
  );
  const notes = all.map(({ code, message, of }) => {
    const [short, ...rest] = sentencesOf(message);
    return h(
      'li',
      { 'data-code': code },
      h('b', {}, of ? `${of}: ${title(code)}` : title(code)),
      ' ',
      symbol(short),
      rest.length ? fold(`remark-${of}${code}`, false, ['more'], symbol(rest.join(' '))) : null,
    );
  });
  const bars = step.answers.some(({ error }) => typeof error === 'number')
    ? h(
        'li',
        {},
        h('b', { id: 'bars-of-error' }, 'Error bars'),
        help('error_bar', 'Error bar', 'bars-of-error'),
        step.passes
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
  const titles = [...new Set(all.map(({ code }) => title(code).toLowerCase()))];
  const names = [...(early ? ['ended early'] : []), ...titles, 'mesh and time'];
  const element = fold(
    'remarks',
    Boolean(early),
    [`${titles.length ? 'Keep in mind' : 'How it was made'}: ${names.join(', ')}`],
    h('ul', {}, early, notes, bars, made),
  );
  element.classList.add('remarks');
  return element;
}

/** @param {string} code */
const title = (code) => code.replaceAll('_', ' ').replace(/^./, (letter) => letter.toUpperCase());
