/**
 * Jobs that ask for an input or have tolerances, and what they answer, for the panel “What if”.
 */

import { plain } from '../lib/units.js';
import { oneMesh } from '../setup/accuracy.js';
import { lowered } from '../setup/field.js';

/** @typedef {import('../types.js').Job} Job */
/** @typedef {import('../wire.js').Answer} Answer */
/** @typedef {import('../jobs/numbers.js').Numeric} Numeric */

/** Most inputs of a job with tolerances, and the tolerance of each. */
const [MOST, TOLERANCE] = [12, 0.05];
/** Inputs whose parts say nothing: they are counted, or have a zero of their own. */
const LEFT = /\/(passes|history|tilt|moment|points|profile|heights)(\/|$)/;

/** The job itself on one mesh, without a question. @param {Job} job @returns {Job} */
const bare = ({ find: _found, tolerances: _told, ...job }) => ({ ...job, mesh: oneMesh(job) });

/**
 * The job that looks for a number with which an answer has a value.
 * @param {Job} job @param {Numeric} number @param {Answer} asked
 * @param {[number, number]} between @param {number} wanted @returns {Job}
 */
export function searchOf(job, { pointers }, { name, body }, between, wanted) {
  const until = { [name]: wanted, ...(body === 'upper' || body === 'lower' ? { body } : {}) };
  return { ...bare(job), find: { vary: pointers, between, until } };
}

/**
 * The looks of a search as values of the answer.
 * @param {import('../wire.js').Found} found @param {Answer} asked @param {string} id
 */
export const looksOf = ({ looks }, asked, id) =>
  looks.value.map((at, k) => ({
    at,
    id,
    answers: [
      {
        ...asked,
        value: looks.figure[k],
        error: looks.error[k] ?? /** @type {const} */ ('not_bounded'),
      },
    ],
  }));

/** A sentence with the names of numbers in place of their pointers. @param {string} text @param {Numeric[]} numbers */
export const named = (text, numbers) =>
  numbers
    .map(({ pointers, label }) => ({ pointer: pointers.join(' and '), label: lowered(label) }))
    .sort((a, b) => b.pointer.length - a.pointer.length)
    .reduce((words, { pointer, label }) => words.replaceAll(pointer, label), text);

/** The job with 5 % of its inputs as tolerances. @param {Job} job @param {Numeric[]} numbers @returns {Job} */
export function tolerancesOf(job, numbers) {
  const inputs = numbers
    .filter(({ key, pointers, value }) => pointers.length === 1 && value !== 0 && !LEFT.test(key))
    .slice(0, MOST);
  return {
    ...bare(job),
    tolerances: Object.fromEntries(inputs.map(({ key }) => [key, TOLERANCE])),
  };
}

/**
 * A row for each figure: its change by all tolerances, and by those of each input.
 * @param {import('../wire.js').Tolerances} told @param {Numeric[]} numbers
 * @returns {import('../lib/tabular.js').Table}
 */
export function tolerancesTable(told, numbers) {
  const { inputs, relative } = told;
  const labels = inputs.map((input) => numbers.find(({ key }) => key === input)?.label ?? input);
  const part = (/** @type {number | null} */ one) => (one === null ? null : 100 * Math.abs(one));
  return {
    columns: [
      { title: 'figure' },
      { title: '± of the mesh', unit: '%' },
      { title: 'root of squares', unit: '%' },
      { title: 'at worst', unit: '%' },
      ...labels.map((title, k) => ({
        title: `${title} ± ${plain(100 * relative[k], 3)} %`,
        unit: '%',
      })),
    ],
    rows: told.label.map((label, row) => [
      label,
      part(told.error[row]),
      part(told.root_of_squares[row]),
      part(told.at_worst[row]),
      ...told.elasticities[row].map((one, k) => part(one === null ? null : one * relative[k])),
    ]),
    write: (cell, k) => (k === 0 || cell === null ? String(cell ?? '—') : plain(Number(cell), 3)),
  };
}
