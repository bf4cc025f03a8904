/**
 * The answers of a step as the service gives them: for the cards of the page and for the report.
 * All that is worked out here is the ratio to elastic theory and the difference of jobs.
 */

import { figure, percent, plain, unit } from '../lib/units.js';
import { digitsOf, figureOf } from '../lib/digits.js';
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
 * leaves; the service writes three or five. Behind a depth stands where it is along the surface.
 * @param {Step} step @param {Report} report @returns {string}
 */
export function sentenceOf(step, report) {
  const { verdict, answers = [] } = step;
  const isOf = (/** @type {Answer} */ { value, ...one }, /** @type {number} */ said) =>
    value !== null &&
    [3, 5].some((digits) => Number((value * shareOf(one)).toPrecision(digits)) === said);
  const place = answers.find(({ name }) => name === 'max_plastic_strain')?.place;
  const along = place ? alongWords(place, report, step) : '';
  return (verdict?.text ?? '')
    .replace(FIGURE, (_, said, error, unit) => {
      const figure = Number(said);
      const answer = answers.find((one) => unitOf(one) === unit && isOf(one, figure));
      if (answer && error) return `${valueOf(answer)} ${errorWords(answer)}`;
      return `${answer ? valueOf(answer) : plain(figure)} ${error ?? ''}${unit}`;
    })
    .replace(/ deep\b/, (deep) => (along ? `${deep} at ${along}` : deep));
}

/** A figure of a sentence, its error where it has one, and the word behind it, which may be its unit. */
const FIGURE = /(?<![\d.])(\d[\d.]*(?:e-?\d+)?) (± \S+ )?([^\s,;)]*[^\s,;).])/g;

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

/** @param {number} value @param {number} semi @returns {number} 0 near the middle */
export const orMiddle = (value, semi) => (Math.abs(value) < MIDDLE * semi ? 0 : value);

/** Where sections go that show the governing answer, in the axes of the contact. @param {Step} step */
export const through = (step) => alongOf(governing(step)?.place, step);

/**
 * A place along the surface, in the axes of the contact; near the middle it is 0.
 * @param {Answer['place'] | undefined} place @param {Step} step @returns {{x: number, y: number}}
 */
function alongOf(place, { contact, three_dimensional: whole }) {
  return {
    x: orMiddle(place?.x ?? 0, whole?.a ?? contact.half_width),
    y: orMiddle(place?.y ?? 0, whole?.b ?? 0),
  };
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

/**
 * A figure of a step as its tile has it, with its unit.
 * @param {Step} step @param {string} name @param {number} value of results without answers @param {string} unit
 */
export function toldOf({ answers = [] }, name, value, unit) {
  const found = answers.find((one) => one.name === name);
  return found ? `${valueOf(found)} ${unitOf(found)}` : `${figure(value, 3)} ${unit}`;
}

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
  if (error === 0) return quantity === 'number' || value === 0 ? '' : 'as given';
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
 * Where along the surface a place is, in the axes of the sketch.
 * @param {NonNullable<Answer['place']>} place @param {Report} report @param {Step} step
 * @returns {string} empty in the middle
 */
function alongWords(place, { units, analysis }, step) {
  const round = analysis === 'axisymmetric' ? 'r' : 'x';
  const { three_dimensional: ellipse } = step;
  const axes = ellipse
    ? axesOf(ellipse)
    : { x: { name: round, sign: 1 }, y: { name: 'y', sign: 1 } };
  const along = alongOf(place, step);
  return /** @type {const} */ (['x', 'y'])
    .filter((axis) => along[axis] !== 0)
    .map((axis) => {
      const { name, sign } = axes[axis];
      return `${name} ${figure(sign * along[axis], 3)} ${unit('length', units)}`;
    })
    .sort()
    .join(', ');
}

/**
 * Where it is, in the axes of the sketch.
 * @param {Answer} answer
 * @param {Report} report
 * @param {Step} step
 * @returns {string}
 */
export function placeWords({ place, label }, report, step) {
  if (!place) return '';
  const at = alongWords(place, report, step);
  const named = label.toLowerCase().includes(place.body) || place.depth === 0;
  return [
    named ? '' : place.body === 'both' ? 'both bodies' : `${place.body} body`,
    place.depth > 0 ? `${figure(place.depth, 3)} ${unit('length', report.units)} deep` : '',
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
  const others = answersOf(report.steps[at]);
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
