/** The job being set up: one document that the form, the JSON and the sketch show and change. */

import { readGrid } from '../api/npz.js';
import { convert, forceOf, unitsOf } from '../lib/units.js';
import { isObject } from '../lib/kept.js';
import * as pointer from '../lib/pointer.js';
import {
  BACKSTRESS,
  ELASTIC,
  INITIAL_STRESS,
  LAWS,
  LOADS,
  OVER_DEPTH,
  SHAPES,
  SURFACE,
  TARGETS,
  lawOf,
  loadOf,
  overDepthOf,
  shapeFor,
  targetOf,
} from './fields.js';

/** @typedef {import('../types.js').Job} Job */
/** @typedef {import('../lib/units.js').Units} Units */
/** @typedef {import('../lib/units.js').Quantity} Quantity */

/** Most states that can be gone back to. */
const UNDOABLE = 200;
/** Most letters of all of them: grids of heights are long. */
const KEPT = 2e7;

/** Tells of every change by an event `change`, whose detail is who made it. */
export class Draft extends EventTarget {
  /** @type {Job} */
  job = {};
  /** States before this one and after it, as text. @type {string[]} */
  #past = [];
  /** @type {string[]} */
  #future = [];
  /** What was changed last: typing in one place is one change. */
  #place = '';

  /** @param {string} place a JSON pointer @param {unknown} value `undefined` removes @param {string} source */
  set(place, value, source) {
    if (pointer.same(pointer.get(this.job, place), value)) return;
    this.#keep(place + source);
    const [, material] = /^(\/(?:upper|lower)\/material)(?!\/name$)/.exec(place) ?? [];
    const name = material && pointer.get(this.job, `${material}/name`);
    pointer.set(this.job, place, value);
    // A figure that is changed makes another material of one that is known by its name.
    if (material && this.known(name) && pointer.get(this.job, `${material}/name`) === name)
      pointer.set(this.job, `${material}/name`, undefined);
    this.#changed(source);
  }

  /** Whether a material of this name has figures of its own. @type {(name: unknown) => boolean} */
  known = () => false;

  /** @param {Job} job @param {string} source */
  replace(job, source) {
    if (!pointer.same(job, this.job)) this.#keep(source === 'json' ? source : '');
    this.job = listed(structuredClone(job));
    this.#changed(source);
  }

  /** @returns {boolean} */
  get undoable() {
    return this.#past.length > 0;
  }

  /** @returns {boolean} */
  get redoable() {
    return this.#future.length > 0;
  }

  undo() {
    this.#go(this.#past, this.#future);
  }

  redo() {
    this.#go(this.#future, this.#past);
  }

  /** Ends what counts as one change. */
  settle() {
    this.#place = '';
  }

  /** @param {string[]} from @param {string[]} to */
  #go(from, to) {
    const job = from.pop();
    if (job === undefined) return;
    to.push(JSON.stringify(this.job));
    this.#place = '';
    this.job = JSON.parse(job);
    this.#changed('undo');
  }

  /** @param {string} place */
  #keep(place) {
    const empty = Object.keys(this.job).length === 0;
    if (!empty && (place === '' || place !== this.#place)) {
      this.#past.push(JSON.stringify(this.job));
      const letters = () => this.#past.reduce((sum, text) => sum + text.length, 0);
      while (this.#past.length > UNDOABLE || (this.#past.length > 1 && letters() > KEPT))
        this.#past.shift();
    }
    this.#future.length = 0;
    this.#place = place;
  }

  /** Puts what was typed before in the form that it has now; goes with the change before. @param {string} place @param {unknown} value @param {string} source */
  amend(place, value, source) {
    pointer.set(this.job, place, value);
    this.#changed(source);
  }

  /** The same physics in other units. @param {Units} units @param {string} source */
  changeUnits(units, source) {
    this.replace(jobIn(this.job, units), source);
  }

  /** @param {string} source */
  #changed(source) {
    this.dispatchEvent(new CustomEvent('change', { detail: source }));
  }
}

/** Heights of numpy as lists, which are drawn and converted; what is no array stays to be told. @param {Job} job */
function listed(job) {
  for (const body of [job.upper, job.lower]) {
    const text = body?.surface?.heights?.npy_base64;
    if (typeof text !== 'string') continue;
    try {
      const bytes = Uint8Array.from(atob(text), (one) => one.charCodeAt(0));
      body.surface.heights = readGrid(bytes.buffer);
    } catch {
      continue;
    }
  }
  return job;
}

/** @param {Job} given @param {Units} units @returns {Job} the same physics in other units */
export function jobIn(given, units) {
  const job = structuredClone(given);
  convertAll(job, unitsOf(given), units);
  job.units = units;
  return job;
}

/**
 * The job in another analysis. A wedge is a cone in axisymmetry, a cylinder a sphere in three
 * dimensions; a load for each millimetre becomes that many newtons, in either system of units, and
 * the other way round.
 * @param {Job} given
 * @param {string} analysis
 * @returns {Job}
 */
export function jobFor(given, analysis) {
  const units = unitsOf(given);
  const { load } = jobIn({ ...jobIn(given, 'mm_N_MPa'), analysis }, units);
  const job = /** @type {Job} */ ({ ...given, analysis, ...(load !== undefined && { load }) });
  for (const body of /** @type {const} */ (['upper', 'lower'])) {
    const shape = given[body]?.shape;
    if (isObject(shape)) job[body] = { ...given[body], shape: shapeFor(shape, analysis, units) };
    else if (isObject(given[body])) job[body] = { ...given[body] };
    // A half-space has no far boundary, and what has one no measured heights.
    if (job[body]) delete job[body][analysis === 'three_dimensional' ? 'support' : 'surface'];
  }
  return job;
}

/** @param {Job} job whose figures are changed @param {Units} from @param {Units} to */
function convertAll(job, from, to) {
  for (const [place, quantity] of dimensional(job)) {
    const value = pointer.get(job, place);
    if (typeof value === 'number') pointer.set(job, place, convert(value, quantity, from, to));
  }
  for (const body of [job.upper, job.lower])
    if (Array.isArray(body?.surface?.heights))
      body.surface.heights = body.surface.heights.map((/** @type {unknown} */ row) =>
        Array.isArray(row)
          ? row.map((one) => (typeof one === 'number' ? convert(one, 'length', from, to) : one))
          : row,
      );
}

/** @param {Record<string, any>} material @param {Units} from @param {Units} to @returns {Record<string, any>} the same in other units */
export function materialIn(material, from, to) {
  const job = { upper: { material: structuredClone(material) } };
  if (from !== to) convertAll(job, from, to);
  return job.upper.material;
}

/**
 * Every figure of a job that has a unit.
 * @param {Job} job
 * @returns {Generator<[string, Quantity]>} pointer and quantity
 */
function* dimensional(job) {
  for (const body of ['/upper', '/lower']) {
    const shape = pointer.get(job, `${body}/shape`);
    const material = pointer.get(job, `${body}/material`);
    yield* within(job, `${body}/shape`, SHAPES[shape?.type]?.fields ?? []);
    yield* within(job, body, SURFACE.slice(1));
    yield* within(job, `${body}/material`, [...ELASTIC, INITIAL_STRESS]);
    yield* within(job, `${body}/material/plasticity`, LAWS[lawOf(material)]?.fields ?? []);
    yield* within(
      job,
      `${body}/material/plasticity`,
      OVER_DEPTH[overDepthOf(material)]?.fields ?? [],
    );
    yield* within(job, `${body}/material/plasticity`, [BACKSTRESS]);
  }
  const kind = loadOf(job.load);
  if (kind === 'target') yield* within(job, '/load', [TARGETS[targetOf(job.load)]]);
  const ofLoad = (/** @type {import('./field.js').Field} */ field) => ({
    ...field,
    quantity: field.quantity === 'load' ? forceOf(job) : field.quantity,
  });
  yield* within(job, '/load', LOADS[kind].fields.map(ofLoad));
}

/**
 * @param {Job} job
 * @param {string} parent
 * @param {import('./field.js').Field[]} fields
 * @returns {Generator<[string, Quantity]>}
 */
function* within(job, parent, fields) {
  for (const field of fields) {
    const place = `${parent}/${field.key}`;
    const value = pointer.get(job, place);
    if (field.columns && Array.isArray(value)) {
      for (const k of value.keys())
        yield* /** @type {[string, Quantity][]} */ (
          field.columns.map((quantity, j) => [
            `${place}/${k}/${field.members?.[j] ?? j}`,
            quantity,
          ])
        );
    } else if (field.kind === 'history' && Array.isArray(value)) {
      for (const [k, load] of value.entries())
        for (const key of Object.keys(load ?? {}))
          yield [
            `${place}/${k}/${key}`,
            key === 'approach' ? 'length' : /** @type {Quantity} */ (field.quantity),
          ];
    } else if (Array.isArray(value)) {
      for (const k of value.keys())
        yield [`${place}/${k}`, /** @type {Quantity} */ (field.quantity)];
    } else if (field.quantity) {
      yield [place, /** @type {Quantity} */ (field.quantity)];
    }
  }
}
