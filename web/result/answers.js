/**
 * The answers of a step as the service gives them: for the cards of the page and for the report.
 * All that is worked out here is the ratio to elastic theory and the difference of jobs. Results of
 * 0.2 have no answers: of them the plain figures are shown.
 */

import { figure, percent, unit } from '../lib/units.js';
import { figureOf } from '../lib/digits.js';
import { axesOf } from './axes.js';
import { isUnloaded } from './loads.js';
import { STEP_FIGURES, barOf, titleOf } from './step-figures.js';

/** @typedef {import('../types.js').Step} Step */
/** @typedef {import('../types.js').Report} Report */
/** @typedef {import('../wire.js').Answer} Answer */
/** @typedef {import('../wire.js').Verdict} Verdict */

/** @param {Step} step @param {Report} report @returns {Answer[]} */
export const answersOf = (step, report) =>
  step.verdict ? step.answers : plainAnswers(step, report);

/** @param {Step} step @returns {Verdict | undefined} */
export const verdictOf = ({ verdict }) => verdict;

/** The plain figures of a result that has no answers. @param {Step} step @param {Report} report @returns {Answer[]} */
function plainAnswers(step, report) {
  const { peak, width, approach, force, mean, strain, stiffness } = STEP_FIGURES;
  const plain = /** @type {import('./step-figures.js').StepFigure[]} */ ([
    peak,
    width,
    approach,
    force,
    mean,
    strain,
    stiffness,
  ]).flatMap((one) => {
    const value = one.value(step);
    const title = titleOf(one, report);
    return value == null
      ? []
      : [
          {
            name: one.title.replaceAll(' ', '_').replaceAll('-', '_'),
            label: title[0].toUpperCase() + title.slice(1),
            body: null,
            value,
            quantity: /** @type {const} */ ('number'),
            unit: one.unit(report),
            // A force without a bar is the one that the job gives.
            error: (one.bar && barOf(step, one.bar)) ?? (one === force ? 0 : null),
            elastic: null,
            place: null,
            text: '',
          },
        ];
  });
  return [...dents(step, report), ...plain];
}

/** What a load has left in both surfaces. @param {Step} step @param {Report} report @returns {Answer[]} */
const dents = (step, { units }) =>
  isUnloaded(step)
    ? /** @type {const} */ (['upper', 'lower']).flatMap((body) => {
        const surface = step.flow?.surfaces[body];
        return surface
          ? [
              {
                name: 'dent_depth',
                label: `Dent, ${body} body`,
                body,
                value: surface.depth,
                quantity: /** @type {const} */ ('length'),
                unit: unit('length', units),
                error: null,
                elastic: null,
                place: null,
                text: '',
              },
            ]
          : [];
      })
    : [];

/** Marks of verdicts, and what they are beside their colour. @type {Record<string, {kind: 'good' | 'warning' | 'bad', mark: string}>} */
const LEVELS = {
  elastic: { kind: 'good', mark: '✓' },
  yields: { kind: 'warning', mark: '!' },
  dented: { kind: 'warning', mark: '!' },
  above_shakedown_limit: { kind: 'warning', mark: '!' },
  shakes_down: { kind: 'good', mark: '✓' },
  closed_cycle: { kind: 'warning', mark: '!' },
  ratchets: { kind: 'bad', mark: '✕' },
  collapse: { kind: 'bad', mark: '✕' },
  not_converged: { kind: 'bad', mark: '✕' },
};

/** @param {Verdict} verdict @returns {{kind: string, mark: string}} those of a level that is not known here are neutral */
export const markOf = ({ level }) =>
  (Object.hasOwn(LEVELS, level) && LEVELS[level]) || { kind: 'neutral', mark: 'i' };

/** Whether it is a strain or a share, which is shown in per cent. @param {Answer} answer */
const isShare = ({ quantity }) => quantity === 'strain' || quantity === 'ratio';

/** By what it is multiplied before its unit stands behind it. @param {Answer} answer */
export const shareOf = (answer) => (isShare(answer) ? 100 : 1);

/** The unit that stands behind it. @param {Answer} answer @returns {string} */
export const unitOf = (answer) =>
  answer.value === null ? '' : isShare(answer) ? '%' : answer.unit;

/** What an answer says, with the digits that its error leaves. @param {Answer} answer @returns {string} */
export const valueOf = (answer) =>
  answer.value === null ? '—' : figureOf(answer.value * shareOf(answer), answer.error);

/** The bound of the error of its mesh. @param {Answer} answer @returns {string} */
export function errorWords({ value, error, quantity }) {
  if (value === null) return '';
  if (error === null) return 'error not known';
  if (error > 0) return `± ${percent(error)}`;
  return quantity === 'number' ? '' : 'as given';
}

/** The same figure by elastic theory. @param {Answer} answer @returns {string} */
export const elasticWords = (answer) =>
  answer.elastic && answer.value !== null
    ? `${figure(answer.value / answer.elastic, 3)} of elastic ${figure(answer.elastic * shareOf(answer), 4)} ${unitOf(answer)}`.trim()
    : '';

/**
 * Where it is, in the axes of the sketch.
 * @param {Answer} answer
 * @param {Report} report
 * @param {Step} step
 * @returns {string}
 */
export function placeWords({ place, label }, { units, analysis }, { three_dimensional: ellipse }) {
  if (!place) return '';
  const length = unit('length', units);
  const round = analysis === 'axisymmetric' ? 'r' : 'x';
  const axes = ellipse
    ? axesOf(ellipse)
    : { x: { name: round, sign: 1 }, y: { name: 'y', sign: 1 } };
  const at = /** @type {const} */ (['x', 'y'])
    .flatMap((axis) => {
      const value = axes[axis].sign * (place[axis] ?? 0);
      return value === 0 ? [] : [`${axes[axis].name} ${figure(value, 3)} ${length}`];
    })
    .sort();
  const named = label.toLowerCase().includes(place.body) || place.depth === 0;
  return [
    named ? '' : place.body === 'both' ? 'both bodies' : `${place.body} body`,
    place.depth > 0 ? `${figure(place.depth, 3)} ${length} deep` : '',
    at.length ? `at ${at.join(', ')}` : '',
  ]
    .filter(Boolean)
    .join(', ');
}

/**
 * The same answer of another job, in the order in which both have them.
 * @param {Report} report of the other
 * @param {number} at its step
 * @param {Answer[]} all of the first job
 * @param {number} k which of them
 * @returns {Answer | undefined}
 */
export function alike(report, at, all, k) {
  const same = (/** @type {Answer} */ one) => one.name === all[k].name && one.body === all[k].body;
  const before = all.slice(0, k).filter(same).length;
  const others = answersOf(report.steps[at], report);
  return others.filter(same)[before] ?? others.filter(({ name }) => name === all[k].name)[before];
}

/** How far another figure is from the first. @param {Answer} first @param {Answer} other @returns {string} */
export function differenceWords({ value: from }, { value: to }) {
  if (from === null || to === null || from === 0 || from === to) return from === to ? '=' : '';
  const part = to / from - 1;
  return `${part < 0 ? '−' : '+'}${percent(Math.abs(part), 3)}`;
}
