/** The answer in a few figures, each with its error bar and Hertz's beside it, and what to keep in mind about it. */

import { byId, h } from '../lib/dom.js';
import { TARGETS } from '../setup/fields.js';
import { symbol } from '../setup/entry.js';
import { help } from '../setup/help.js';
import { inWords } from '../setup/words.js';
import { figure, forceOf, grouped, duration, percent, stiffnessOf, unit } from '../lib/units.js';
import { barOf } from './figures.js';

/** @typedef {import('../types.js').Shown} Shown */
/** @typedef {import('../types.js').Step} Step */

/** Why a stiffness is 0. */
const APART = 'without load the bodies are apart, and nothing resists';

/** @param {Shown} shown @param {number} at */
export function showHeadline({ job, report }, at) {
  const step = report.steps[at];
  const cards = h('dl', { class: 'figures' }, figures(job, report, step));
  byId('headline').replaceChildren(cards, remarks(report, step));
  rows.disconnect();
  rows.observe(cards);
}

/** Letters of a figure for which a card has room. */
const SHORT = 9;

/** Least width of a card. */
const CARD = 150;

/** Cards in rows of about the same length, so that none stands alone. */
const rows = new ResizeObserver(([{ target, contentRect }]) => {
  const many = target.children.length;
  const fit = Math.max(2, Math.floor(contentRect.width / CARD));
  const columns = Math.ceil(many / Math.ceil(many / fit));
  /** @type {HTMLElement} */ (target).style.setProperty('--columns', String(columns));
});

/** @param {import('../types.js').Job} job @param {import('../types.js').Report} report @param {Step} step */
function figures(job, report, step) {
  const { units } = report;
  const { contact, hertz, plasticity } = step;
  const [length, stress, force] = [unit('length', units), unit('stress', units), unit(forceOf(report), units)];
  const strain = Math.max(
    plasticity.upper?.max_equivalent_plastic_strain ?? 0,
    plasticity.lower?.max_equivalent_plastic_strain ?? 0,
  );
  const beside = (/** @type {number} */ value, /** @type {number | undefined} */ elastic) =>
    elastic ? `Hertz ${figure(elastic, 4)}, ratio ${figure(value / elastic, 3)}` : '';
  const onset = hertz?.yield_onset_force;
  const round = report.analysis === 'axisymmetric';
  return [
    card(
      'Peak pressure',
      contact.peak_pressure,
      stress,
      barOf(step, 'peak_pressure'),
      beside(contact.peak_pressure, hertz?.peak_pressure),
    ),
    card(
      round ? 'Contact radius' : 'Half-width',
      contact.half_width,
      length,
      barOf(step, 'half_width'),
      beside(contact.half_width, hertz?.half_width),
    ),
    card('Approach', step.approach, length, barOf(step, 'approach'), step.approach_datum, true),
    card(
      'Force',
      contact.force,
      force,
      barOf(step, 'force'),
      onset ? `${figure(contact.force / onset, 3)} × first yield by elastic theory, ${figure(onset, 4)}` : '',
    ),
    card(
      'Mean pressure',
      contact.mean_pressure,
      stress,
      undefined,
      beside(contact.mean_pressure, hertz ? meanOf(hertz, round) : undefined),
    ),
    ...(report.target
      ? [
          card(
            'Force found',
            report.target.force,
            force,
            report.target.relative_error ?? undefined,
            targetWords(report),
          ),
        ]
      : []),
    card('Plastic strain', 100 * strain, '%', undefined, zoneWords(step, length)),
    card(
      'Contact stiffness',
      step.contact_stiffness,
      unit(stiffnessOf(report), units),
      barOf(step, 'contact_stiffness'),
      contact.force > 0 ? 'dP/dα, slope of load over approach' : APART,
    ),
    ...(step.flow
      ? [
          card(
            'Unloading stiffness',
            step.flow.unloading_stiffness,
            unit(stiffnessOf(report), units),
            undefined,
            contact.force > 0 ? 'dP/dα where the load begins to fall' : APART,
          ),
        ]
      : []),
    ...(step.yield_onset
      ? [
          card(
            'First yield',
            step.yield_onset.force,
            force,
            undefined,
            `on this mesh, in the ${step.yield_onset.body} body, ${figure(step.yield_onset.depth, 3)} ${length} deep`,
          ),
        ]
      : []),
  ];
}

/** For what a force was looked for, and what came of it. @param {import('../types.js').Report} report */
export function targetWords({ target, units }) {
  if (!target) return '';
  const { label, quantity } = TARGETS[target.figure] ?? {
    label: target.figure.replaceAll('_', ' '),
    quantity: 'number',
  };
  const name = quantity && quantity !== 'load' ? unit(quantity, units) : '';
  return `for a ${label.toLowerCase()} of ${figure(target.wanted, 4)} ${name}, reached ${figure(target.reached)}`;
}

/** @param {{peak_pressure: number}} hertz @param {boolean} round */
const meanOf = ({ peak_pressure }, round) => (round ? (2 / 3) * peak_pressure : (Math.PI / 4) * peak_pressure);

/** @param {Step} step @param {string} length */
function zoneWords({ plasticity }, length) {
  const zones = Object.entries(plasticity).filter(([, zone]) => zone?.yielded);
  if (zones.length === 0) return 'neither body yields';
  const [name, zone] = zones.reduce((a, b) =>
    (b[1]?.max_equivalent_plastic_strain ?? 0) > (a[1]?.max_equivalent_plastic_strain ?? 0) ? b : a,
  );
  const where = zones.length === 2 ? 'both bodies' : `${name} body`;
  return `${where}, most at ${figure(zone?.depth, 3)} ${length} deep, ${zone?.reached_surface ? 'up to the surface' : 'below the surface'}`;
}

/** @param {string} name @param {number} value @param {string} unit @param {number | undefined} error @param {string} note @param {boolean} [long] */
function card(name, value, unit, error, note, long = false) {
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
  return h(
    'div',
    {},
    h('dt', {}, name),
    h(
      'dd',
      {},
      h('span', { class: `figure${text.length > SHORT ? ' long' : ''}` }, text, h('span', { class: 'unit' }, unit)),
      bar,
      long ? h('details', {}, h('summary', {}, 'between the supports'), note) : h('small', {}, note),
    ),
  );
}

/** How well the figures are known. @param {Step} step */
function known(step) {
  const names = /** @type {const} */ (['peak_pressure', 'half_width', 'approach', 'force']);
  const bars = names.flatMap((name) => {
    const bar = barOf(step, name);
    return bar ? [`${percent(bar)} for the ${name === 'half_width' ? 'half-width' : name.replace('_', ' ')}`] : [];
  });
  return bars.join(', ');
}

/** @param {import('../types.js').Report} report @param {Step} step */
function remarks(report, step) {
  const notes = step.validity.map(({ code, message }) =>
    h('li', { 'data-code': code }, h('b', {}, title(code)), ' ', symbol(inWords(message))),
  );
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
    } iterations; ${duration(timings.total)}.`,
  );
  return h(
    'details',
    { class: 'remarks', open: step.validity.some(({ code }) => code !== 'deformation_theory') },
    h(
      'summary',
      {},
      step.validity.length
        ? `${step.validity.length} ${step.validity.length === 1 ? 'remark' : 'remarks'} on validity`
        : 'No remarks on validity',
      ', error bars, mesh',
    ),
    h('ul', {}, notes, bars, made),
  );
}

/** @param {string} code */
const title = (code) => code.replaceAll('_', ' ').replace(/^./, (letter) => letter.toUpperCase());
