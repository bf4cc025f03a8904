/**
 * The answer in a few figures, each with its error bar and Hertz's beside it, and what to keep in
 * mind about it.
 */

import { byId, h } from '../lib/dom.js';
import { symbol } from '../setup/entry.js';
import { help } from '../setup/help.js';
import { remarkOf } from './remarks.js';
import { barOf } from './step-figures.js';
import { figure, grouped, duration, percent } from '../lib/units.js';
import { answersOf } from './answers.js';
import { endedEarly } from './loads.js';

/** @typedef {import('../types.js').Shown} Shown */
/** @typedef {import('../types.js').Step} Step */

/** @param {Shown} shown @param {number} at */
export function showHeadline({ job, report }, at) {
  const step = report.steps[at];
  const cards = h('dl', { class: 'figures' }, answersOf(job, report, step).map(card));
  byId('headline').replaceChildren(cards, remarks(job, report, step));
  rows.disconnect();
  rows.observe(cards);
}

/** Letters of a figure for which a card has room. */
const SHORT = 9;

/** Least width of a card: lines below its figure have room for five words. */
const CARD = 190;

/** Cards in rows of about the same length, so that none stands alone. */
const rows = new ResizeObserver(([{ target, contentRect }]) => {
  const many = target.children.length;
  const fit = Math.max(2, Math.floor(contentRect.width / CARD));
  const columns = Math.ceil(many / Math.ceil(many / fit));
  /** @type {HTMLElement} */ (target).style.setProperty('--columns', String(columns));
});

/** @param {import('./answers.js').Answer} answer */
function card({ name, value, unit, error, elastic, undented, note, long = '' }) {
  const text = figure(value);
  const key = name.toLowerCase().replaceAll(' ', '-');
  const bar =
    error === undefined
      ? null
      : h(
          'span',
          { class: 'bar-of-error', id: `bar-of-${key}` },
          `± ${percent(error)}`,
          help('error_bar', 'Error bar', `bar-of-${key}`),
        );
  const words = [
    elastic
      ? `Hertz${undented ? ', undented' : ''} ${figure(elastic, 4)}, ratio ${figure(value / elastic, 3)}`
      : '',
    note,
  ]
    .filter(Boolean)
    .join('; ');
  return h(
    'div',
    {},
    h('dt', {}, name),
    h(
      'dd',
      {},
      h(
        'span',
        { class: `figure${text.length > SHORT ? ' long' : ''}` },
        text,
        h('span', { class: 'unit' }, unit),
      ),
      bar,
      long ? h('details', {}, h('summary', {}, long), note) : h('small', {}, words),
    ),
  );
}

/** How well the figures are known. @param {Step} step */
function known(step) {
  const names = /** @type {const} */ (['peak_pressure', 'half_width', 'approach', 'force']);
  const bars = names.flatMap((name) => {
    const bar = barOf(step, name);
    return bar
      ? [
          `${percent(bar)} for the ${name === 'half_width' ? 'half-width' : name.replace('_', ' ')}`,
        ]
      : [];
  });
  return bars.join(', ');
}

/**
 * @param {import('../types.js').Job} job
 * @param {import('../types.js').Report} report
 * @param {Step} step
 */
function remarks(job, report, step) {
  const ended = endedEarly(job, report);
  const early = ended
    ? h('li', { 'data-code': 'ended_early' }, h('b', {}, 'Ended early'), ` ${ended}`)
    : null;
  const notes = step.validity.map((note) => {
    const [short, ...rest] = remarkOf(job, report, step, note);
    return h(
      'li',
      { 'data-code': note.code },
      h('b', {}, title(note.code)),
      ' ',
      symbol(short),
      rest.length ? h('details', {}, h('summary', {}, 'more'), symbol(rest.join(' '))) : null,
    );
  });
  const bars =
    step.estimated_error && step.status === 'converged'
      ? h(
          'li',
          {},
          h('b', {}, 'Mesh error'),
          ` By a second mesh of half the density, within ± ${known(step)}. The bars held in at least 95 of 100 tested cases.`,
        )
      : null;
  const { mesh, timings_ms: timings } = report;
  const made = h(
    'li',
    {},
    h('b', {}, 'Made with'),
    ` ${grouped(mesh.elements)} elements${mesh.symmetric ? ' on one half' : ''}, ${grouped(mesh.equations)} equations, ${
      step.history.length
    } iteration${step.history.length === 1 ? '' : 's'}${report.steps.length > 1 ? ' in this step' : ''}; ${duration(timings.total)}${report.steps.length > 1 ? ' for all steps' : ''}.`,
  );
  const many = step.validity.length + (early ? 1 : 0);
  return h(
    'details',
    {
      class: 'remarks',
      open: Boolean(early) || step.validity.some(({ code }) => code !== 'deformation_theory'),
    },
    h(
      'summary',
      {},
      many ? `${many} ${many === 1 ? 'remark' : 'remarks'} on validity` : 'No remarks on validity',
      ', error bars, mesh',
    ),
    h('ul', {}, early, notes, bars, made),
  );
}

/** @param {string} code */
const title = (code) => code.replaceAll('_', ' ').replace(/^./, (letter) => letter.toUpperCase());
