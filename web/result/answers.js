/**
 * The answers of a step as the service gives them: for the cards of the page and for the report.
 * All that is worked out here is the ratio to elastic theory and the difference of jobs.
 */

import { figure, percent, plain, unit } from '../lib/units.js';
import { figureOf } from '../lib/digits.js';
import { axesOf } from './axes.js';

/** @typedef {import('../types.js').Step} Step */
/** @typedef {import('../types.js').Report} Report */
/** @typedef {import('../wire.js').Answer} Answer */
/** @typedef {import('../wire.js').Verdict} Verdict */

/** @param {Step} step @returns {Answer[]} none of results that 0.2 has stored */
export const answersOf = ({ answers }) => answers ?? [];

/** @param {Step} step @returns {Verdict | undefined} */
export const verdictOf = ({ verdict }) => verdict;

/**
 * The sentence of a step. A figure that is an answer has the digits of its tile, which its error
 * leaves; the service writes three or five.
 * @param {Step} step @returns {string}
 */
export function sentenceOf({ verdict, answers = [] }) {
  const isOf = (/** @type {Answer} */ { value, ...one }, /** @type {number} */ said) =>
    value !== null &&
    [3, 5].some((digits) => Number((value * shareOf(one)).toPrecision(digits)) === said);
  return (verdict?.text ?? '').replace(FIGURE, (_, said, unit) => {
    const figure = Number(said);
    const answer = answers.find((one) => unitOf(one) === unit && isOf(one, figure));
    return `${answer ? valueOf(answer) : plain(figure)} ${unit}`;
  });
}

/** A figure of a sentence and the word behind it, which may be its unit. */
const FIGURE = /(?<![\d.])(\d[\d.]*(?:e-?\d+)?) ([^\s,;)]*[^\s,;).])/g;

/** Answers that a sentence is about, the one that decides before the others. */
const GOVERNING = ['residual_tension', 'max_plastic_strain', 'utilization', 'peak_pressure'];

/**
 * The answer whose place pictures open at: what the load has left, else where bodies yield, else
 * where they come nearest to it.
 * @param {Step} step @returns {Answer | undefined}
 */
export const governing = ({ answers = [] }) =>
  GOVERNING.map((name) => answers.find((one) => one.name === name && one.place && one.value)).find(
    (one) => one !== undefined,
  );

/** Part of a semi-axis within which a place is the middle. */
const MIDDLE = 0.1;

/** Where sections go that show the governing answer, in the axes of the contact. @param {Step} step @returns {{x: number, y: number}} */
export function through(step) {
  const place = governing(step)?.place;
  const { a = 0, b = 0 } = step.three_dimensional ?? {};
  const at = (/** @type {number | undefined} */ value = 0, /** @type {number} */ semi) =>
    Math.abs(value) < MIDDLE * semi ? 0 : value;
  return { x: at(place?.x, a), y: at(place?.y, b) };
}

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

/** Whether it is a strain or a share, which is shown in per cent. @param {Pick<Answer, 'quantity'>} answer */
const isShare = ({ quantity }) => quantity === 'strain' || quantity === 'ratio';

/** By what it is multiplied before its unit stands behind it. @param {Pick<Answer, 'quantity'>} answer */
export const shareOf = (answer) => (isShare(answer) ? 100 : 1);

/** The unit that stands behind it. @param {Answer} answer @returns {string} */
export const unitOf = (answer) =>
  answer.value === null ? '' : isShare(answer) ? '%' : answer.unit;

/** What an answer says, with the digits that its error leaves. @param {Answer} answer @returns {string} */
export const valueOf = (answer) =>
  answer.value === null
    ? '—'
    : isNoise(answer)
      ? '0'
      : figureOf(answer.value * shareOf(answer), answer.error);

/** Whether the error is larger than the figure. @param {Answer} answer */
const isNoise = ({ error }) => error !== null && error > 1;

/** How well it is known: of a share as one, else as a part of it. @param {Answer} answer @returns {number | null} */
export const errorOf = (answer) =>
  answer.error === null || answer.value === null
    ? null
    : isShare(answer)
      ? answer.error * Math.abs(answer.value)
      : answer.error;

/** @param {Answer} answer @returns {string} */
export function errorWords(answer) {
  const { value, error, quantity } = answer;
  if (value === null) return '';
  if (error === null) return 'error not known';
  if (error === 0) return quantity === 'number' ? '' : 'as given';
  if (isNoise(answer))
    return `± ${figure(error * Math.abs(value) * shareOf(answer), 1)} ${unitOf(answer)}`;
  return `± ${percent(errorOf(answer) ?? 0)}`;
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
  const others = answersOf(report.steps[at]);
  return others.filter(same)[before] ?? others.filter(({ name }) => name === all[k].name)[before];
}

/** Parts by which figures of two jobs differ that are the same: what rounding leaves. */
const NOISE = 1e-9;

/** How far another figure is from the first: of a share by how much. @param {Answer} first @param {Answer} other @returns {string} */
export function differenceWords(first, { value: to }) {
  const { value: from } = first;
  if (from === null || to === null) return '';
  if (Math.abs(to - from) <= NOISE * Math.max(Math.abs(from), Math.abs(to))) return '=';
  if (from === 0) return '';
  const part = isShare(first) ? to - from : to / from - 1;
  return `${part < 0 ? '−' : '+'}${percent(Math.abs(part), 3)}`;
}
