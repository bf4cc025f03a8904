/** Differences of jobs, and names of the jobs by them. */

import { jobIn } from '../setup/draft.js';
import { DEFAULTS, LAWS, allFields, lawOf, shapeLabel } from '../setup/fields.js';
import { exact, forceOf, unit, unitsOf } from '../lib/units.js';
import { lowered } from '../setup/field.js';
import { historyFigures } from '../setup/history.js';
import { sweepWords } from '../setup/list.js';
import { same } from '../lib/pointer.js';
import { loadWords } from './load.js';

/** @typedef {import('../types.js').Job} Job */
/**
 * @typedef {{pointer: string, label: string, symbol: string, unit: string, values: unknown[],
 *   texts: string[]}} Difference `texts`: the values as they are written, whole where they would
 *   look alike
 */

const FIELDS = new Map(
  allFields().map((field) => [field.key.slice(field.key.lastIndexOf('/') + 1), field]),
);
const BODIES = /** @type {Record<string, string>} */ ({ upper: 'upper', lower: 'lower' });
/** Defaults of members that a job leaves out. */
const USUAL = /** @type {Record<string, unknown>} */ (DEFAULTS);
/** Members that change no answer. */
const LEFT = new Set(['tags', 'title', 'output', 'units']);

/**
 * Lists every figure and word of a job.
 * @param {any} part
 * @param {string} pointer
 * @returns {Generator<[string, unknown]>}
 */
export function* leaves(part, pointer = '') {
  if (part === null || typeof part !== 'object' || Array.isArray(part)) yield [pointer, part];
  else
    for (const [key, one] of Object.entries(part))
      if (pointer !== '' || !LEFT.has(key)) yield* leaves(one, `${pointer}/${key}`);
}

/** @param {Job[]} jobs @returns {Difference[]} with figures in the units of the first */
export function differences(jobs) {
  const [first] = jobs;
  const units = unitsOf(first);
  const alike = jobs.map((job) => (unitsOf(job) === units ? job : jobIn(job, units)));
  const maps = alike.map((job) => new Map(leaves(job)));
  const all = [...new Set(maps.flatMap((map) => [...map.keys()]))];
  // A force and a sweep of forces are both the load of their job; a history has loads of two
  // kinds.
  const loads = all.filter((pointer) => pointer.startsWith('/load/'));
  const pointers =
    loads.length > 1 || loads.includes('/load/history')
      ? ['/load', ...all.filter((pointer) => !loads.includes(pointer))]
      : all;
  for (const [k, map] of maps.entries()) map.set('/load', loadWords(alike[k]));
  return pointers
    .map((pointer) => ({
      pointer,
      ...nameOf(pointer, first),
      values: maps.map((map) => map.get(pointer) ?? USUAL[pointer]),
    }))
    .filter(({ values }) => distinct(values) > 1)
    .map((one) => {
      const short = one.values.map(writeValue);
      const alike = distinct(short) < distinct(one.values);
      return { ...one, texts: alike ? one.values.map(writeWhole) : short };
    })
    .sort((a, b) => rank(a.pointer) - rank(b.pointer));
}

/** What is in contact with what. @param {Job} job */
export function pairOf({ analysis, upper, lower }) {
  const [above, below] = [upper, lower].map((body) => body?.shape?.type);
  if (above === 'hole' || below === 'hole')
    return analysis === 'axisymmetric' ? 'ball in socket' : 'pin in hole';
  return `${shapeLabel(above, analysis)} on ${shapeLabel(below, analysis)}`.toLowerCase();
}

/**
 * What the body is made of: the name that the job gives its material, or its hardening.
 * @param {Job} job
 * @param {'upper' | 'lower'} body
 * @returns {string}
 */
export function materialName(job, body) {
  const material = job[body]?.material;
  return material?.name ? String(material.name) : lowered(LAWS[lawOf(material)]?.label ?? '');
}

/** Tags by which the page knows its jobs, which say nothing to people. */
const OWN = new Set(['run', 'slider']);

/** The tags of a job in words. @param {Record<string, string> | null} [tags] */
export const tagWords = (tags) =>
  Object.entries(tags ?? {}).flatMap(([name, text]) =>
    OWN.has(name) ? [] : [`${name}: ${text}`],
  );

/** The title that a job is given, or else the first of its tags. @param {{title?: string | null, tags?: Record<string, string> | null}} job @returns {string} */
export function titleOf({ title, tags }) {
  const [, tag] = Object.entries(tags ?? {}).find(([name]) => !OWN.has(name)) ?? [];
  return String(title || (tag ?? '')).slice(0, 80);
}

/** The same as a part of the names of files. @param {Job} job @param {string} id @returns {string} */
export const stemOf = (job, id) =>
  [
    titleOf(job)
      .normalize('NFC')
      .replace(/[^\p{L}\p{N}.-]+/gu, '-')
      .replace(/^-+|-+$/g, '')
      .slice(0, 60),
    id.slice(-8) || 'live',
  ]
    .filter(Boolean)
    .join('-');

/** A job of the list by words that no other has: as it is called, or else by what it is about and its id. @param {import('../types.js').JobDocument} job */
export const labelOf = ({ id, title, description, tags }) =>
  titleOf({ title: title === description ? '' : title, tags }) ||
  [title, id.slice(-8)].filter(Boolean).join(', ');

/** Counts the values that differ as JSON. @param {unknown[]} values */
const distinct = (values) =>
  values.filter((value, k) => values.findIndex((one) => same(one, value)) === k).length;

/**
 * Loads tell most, then what bodies are, their shapes before all; settings of the solver least.
 * @param {string} pointer
 */
const rank = (pointer) =>
  pointer.startsWith('/load')
    ? 0
    : /shape\/type$/.test(pointer)
      ? 1
      : /^\/(upper|lower)/.test(pointer)
        ? 2
        : 3;

/** @param {string} text */
const sentence = (text) => text[0].toUpperCase() + text.slice(1);

/** @param {string} pointer @param {Job} job of whose units it is */
export function nameOf(pointer, job) {
  if (pointer === '/load') return { label: 'Load', symbol: '', unit: '' };
  const parts = pointer.split('/').slice(1);
  const key = parts[parts.length - 1];
  const field = FIELDS.get(key);
  const body = BODIES[parts[0]];
  // What a shape is called needs no word before it.
  if (body && key === 'type') return { label: `${sentence(body)} shape`, symbol: '', unit: '' };
  if (body && key === 'name') return { label: `${sentence(body)} material`, symbol: '', unit: '' };
  const label = field?.label ?? sentence(key.replaceAll('_', ' '));
  const quantity = field?.quantity === 'load' ? forceOf(job) : field?.quantity;
  return {
    label: body ? `${sentence(body)} ${lowered(label)}` : label,
    symbol: field?.symbol ?? lowered(label),
    unit: quantity ? unit(quantity, unitsOf(job)) : '',
  };
}

/** @param {unknown} value */
export function writeValue(value) {
  if (value === undefined) return '—';
  if (typeof value === 'number') return exact(value);
  if (!Array.isArray(value)) return String(value).replaceAll('_', ' ');
  if (value.every(isNumber)) return sweepWords(value);
  if (isGrid(value)) return `${value.length} × ${value[0].length} heights`;
  return isTerms(value)
    ? writeWhole(value)
    : `${value.length} ${isHistory(value) ? 'loads' : 'points'}`;
}

/** Numbers, loads or rows that are written out in a report. */
const MOST = 60;

/**
 * The same with every number of a list, a history or a table that is not too long for a sheet.
 * @param {unknown} value
 * @returns {string}
 */
export function writeWhole(value) {
  if (!Array.isArray(value) || isGrid(value)) return writeValue(value);
  if (value.length > MOST)
    return value.every(isNumber)
      ? `${writeValue(value)}, ${value.length} in all`
      : writeValue(value);
  if (value.every(isNumber)) return value.map(exact).join(' ');
  if (isHistory(value)) return historyFigures(value);
  const members = MEMBERS.find(([first]) => value[0]?.[first] !== undefined);
  const figures = (/** @type {any} */ row) => members?.map((name) => row[name]) ?? row;
  return value
    .map((row) =>
      figures(row)
        .map(exact)
        .join(isTerms(value) ? ', ' : ' '),
    )
    .join('; ');
}

/** Names of the figures of rows, in the order of their columns. */
const MEMBERS = allFields().flatMap(({ members }) => (members ? [members] : []));

/** Rows of points are short. @param {any[]} value */
const isGrid = ([first]) => Array.isArray(first) && first.length > 3;

/** @param {unknown} value */
const isNumber = (value) => typeof value === 'number';

/** @param {any[]} value terms of a sum, of which there are few */
const isTerms = ([first]) => first?.modulus !== undefined;

/** @param {any[]} value */
const isHistory = ([first]) => first?.force !== undefined || first?.approach !== undefined;

/**
 * A short name for each of the jobs: its title if titles tell them apart, else by what they differ
 * in.
 * @param {{id: string, job: Job}[]} jobs
 * @returns {string[]}
 */
export function names(jobs) {
  const last = (/** @type {string} */ id) => id.slice(-8) || 'live';
  const titles = jobs.map(({ job }) => titleOf(job));
  if (jobs.length === 1) return [titles[0] || last(jobs[0].id)];
  if (titles.every(Boolean) && new Set(titles).size === titles.length) return titles;
  const found = differences(jobs.map(({ job }) => job));
  for (let count = 1; count <= Math.min(3, found.length); count++) {
    const made = jobs.map((_, k) =>
      found
        .slice(0, count)
        .map(({ symbol, values, unit }) =>
          [symbol.replaceAll('_', ''), writeValue(values[k]), values[k] === undefined ? '' : unit]
            .filter(Boolean)
            .join(' '),
        )
        .join(', '),
    );
    if (new Set(made).size === made.length || count === Math.min(3, found.length))
      return made.map((name, k) =>
        made.indexOf(name) === made.lastIndexOf(name) ? name : `${name} (${last(jobs[k].id)})`,
      );
  }
  return jobs.map(({ id }) => last(id));
}
