/**
 * The answers of a step as the service gives them: for the cards of the page and for the report.
 * All that is worked out here is the ratio to elastic theory and the difference of jobs.
 */

import { figure, percent, plain, unit } from '../lib/units.js';
import { digitsOf, figureOf } from '../lib/digits.js';
import { axesOf } from './axes.js';
import { boundOf, valueIn, widthIn } from './rows.js';

/** @typedef {import('../types.js').Step} Step */
/** @typedef {import('../types.js').Report} Report */
/** @typedef {import('../wire.js').Answer} Answer */

/** Those of the whole job, then those of a step. @param {Report} report @param {number} at step @param {boolean} [whole] whether details are behind them @returns {Answer[]} */
export function answersOf({ answers = [], steps }, at, whole = false) {
  const all = [...answers, ...steps[at].answers];
  const first = all.filter(({ detail }) => !detail);
  return whole ? [...first, ...all.filter(({ detail }) => detail)] : first;
}

/** Marks of verdicts. @type {Record<import('../wire.js').Mark, string>} */
export const MARKS = { good: '✓', attention: '!', bad: '✕', unknown: 'i' };

/** The answer that decides, at whose place pictures open. @param {Step} step @returns {Answer | undefined} */
export const governing = ({ verdict, answers }) =>
  answers.find(({ name, body }) => name === verdict.figure && body === verdict.body);

/** Part of a semi-axis within which a place is the middle. */
const MIDDLE = 0.1;

/** @param {number} value @param {number} semi @returns {number} 0 near the middle */
export const orMiddle = (value, semi) => (Math.abs(value) < MIDDLE * semi ? 0 : value);

/** Where sections go that show the governing answer, in the axes of the contact. @param {Step} step */
export const through = (step) => alongOf(governing(step)?.place, step);

/**
 * A place along the surface, in the axes of the contact; near the middle it is 0.
 * @param {Answer['place'] | undefined} place @param {Step} step @returns {{x: number, y: number}}
 */
const alongOf = (place, step) => ({
  x: orMiddle(place?.x ?? 0, widthIn(step)),
  y: orMiddle(place?.y ?? 0, valueIn(step, 'semi_axis_b') ?? 0),
});

/** Whether it is a strain or a share, which is shown in per cent. @param {Pick<Answer, 'quantity'>} answer */
const isShare = ({ quantity }) => quantity === 'strain' || quantity === 'ratio';

/** By what it is multiplied before its unit stands behind it. @param {Pick<Answer, 'quantity'>} answer */
export const shareOf = (answer) => (isShare(answer) ? 100 : 1);

/** The unit that stands behind it. @param {Answer} answer @returns {string} */
export const unitOf = (answer) =>
  answer.value === null ? '' : isShare(answer) ? '%' : answer.unit;

/** What an answer says, with the digits that its error leaves; of one that is bounded alone its bound. @param {Answer} answer @returns {string} */
export function valueOf(answer) {
  const { value, at_least: least, at_most: most } = answer;
  if (value === null) return '—';
  const [share, error] = [shareOf(answer), boundOf(answer)];
  return most !== undefined && least === undefined
    ? `${value < 0 ? '±' : '≤'} ${figure(most * share, 2)}`
    : figureOf(value * share, error);
}

/** How well it is known: of a share as one, else as a part of it. @param {Answer} answer @returns {number | null} */
export function errorOf(answer) {
  const bound = answer.value === null ? null : boundOf(answer);
  return bound !== null && isShare(answer) ? bound * Math.abs(answer.value ?? 0) : bound;
}

/** @param {Answer} answer @returns {string} */
export function errorWords(answer) {
  const { value, error, at_least: least, at_most: most } = answer;
  if (value === null) return '';
  if (typeof error === 'number') return `± ${percent(errorOf(answer) ?? 0)}`;
  if (least === undefined) return error.replace('_', ' ');
  return most === undefined
    ? `at least ${plain(least * shareOf(answer), 4)} ${unitOf(answer)}`.trim()
    : `± ${figure(((most - least) / 2) * shareOf(answer), 2)} ${unitOf(answer)}`.trim();
}

/** A figure with its unit. @param {Answer | undefined} answer */
export const toldOf = (answer) => (answer ? `${valueOf(answer)} ${unitOf(answer)}`.trim() : '—');

/** A figure with its unit and its error. @param {Answer} answer */
export const wholeOf = (answer) => [toldOf(answer), errorWords(answer)].filter(Boolean).join(' ');

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
export function placeWords({ place, label }, { units, analysis }, step) {
  if (!place) return '';
  const length = unit('length', units);
  const [axes, along] = [axesOf(step), alongOf(place, step)];
  const at = /** @type {const} */ (['x', 'y'])
    .filter((axis) => along[axis] !== 0)
    .map((axis) => {
      const { name, sign } = axes[axis];
      return `${analysis === 'axisymmetric' ? 'r' : name} ${figure(sign * along[axis], 3)} ${length}`;
    })
    .sort()
    .join(', ');
  const named = label.toLowerCase().includes(place.body) || place.depth === 0;
  return [
    named ? '' : place.body === 'both' ? 'both bodies' : `${place.body} body`,
    place.depth > 0 ? `${figure(place.depth, 3)} ${length} deep` : '',
    at && `at ${at}`,
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
  const others = answersOf(report, at, true);
  return others.filter(same)[before] ?? others.filter(({ name }) => name === all[k].name)[before];
}

/** Parts by which figures of two jobs differ that are the same: what rounding leaves. */
const NOISE = 1e-9;

/** How far another figure is from the first, to where their errors end: of a share by how much. @param {Answer} first @param {Answer} other @returns {string} */
export function differenceWords(first, other) {
  const [from, to] = [first.value, other.value];
  if (from === null || to === null) return '';
  if (Math.abs(to - from) <= NOISE * Math.max(Math.abs(from), Math.abs(to))) return '=';
  if (from === 0) return '';
  const part = isShare(first) ? to - from : to / from - 1;
  const error = (errorOf(first) ?? 0) + (errorOf(other) ?? 0);
  const digits = Math.min(3, digitsOf(error / Math.abs(part)));
  return `${part < 0 ? '−' : '+'}${percent(Math.abs(part), digits)}`;
}
