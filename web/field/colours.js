/**
 * Which values the colours of a field stand for: those of the step, those of all steps, or limits
 * that are held.
 */

import { h } from '../lib/dom.js';
import { readShown } from '../lib/number.js';
import { factor as between, plain } from '../lib/units.js';
import { bands, bandsWithin, symmetricBands } from './palette.js';

const RANGES = { step: 'this step', steps: 'all steps', fixed: 'fixed' };

/** @typedef {[number, number]} Limits least and largest value */

export class ColourRange {
  /** @type {keyof typeof RANGES} */
  #of = 'steps';
  /** Limits that are held, in the units of the job. @type {Limits} */
  #fixed = [0, 1];
  /** Limits that were typed and are beyond the other one, which may be typed next. @type {(number | undefined)[]} */
  #waiting = [];
  /** What they are of. @type {{kind: import('../lib/units.js').Quantity, units: import('../lib/units.js').Units, factor: number}} */
  #measure = { kind: 'number', units: 'mm_N_MPa', factor: 1 };
  /** Whether there is one step alone. */
  #single = false;
  /** Limits of steps that were here, by quantity and step, in the units of the job. @type {Map<string, Limits>} */
  #known = new Map();

  /** @param {() => void} changed */
  constructor(changed) {
    this.choice = h(
      'select',
      {
        'aria-label': 'Colours',
        onchange: () => {
          this.#of = /** @type {keyof typeof RANGES} */ (this.choice.value);
          changed();
        },
      },
      Object.entries(RANGES).map(([value, text]) =>
        h('option', { value, selected: value === this.#of }, text),
      ),
    );
    const limit = (/** @type {0 | 1} */ end, /** @type {string} */ name) => {
      const box = h('input', {
        type: 'text',
        inputmode: 'decimal',
        size: 7,
        'aria-label': name,
        onchange: () => this.#typed(end, changed),
      });
      return box;
    };
    this.boxes = [limit(0, 'Least value coloured'), limit(1, 'Largest value coloured')];
    this.unit = h('span', { class: 'unit' });
    this.fault = h('span', { class: 'fault', role: 'status' });
    this.element = h(
      'span',
      { class: 'range' },
      'Colours ',
      this.choice,
      this.boxes[0],
      ' – ',
      this.boxes[1],
      this.unit,
      this.fault,
    );
  }

  /** Takes a limit, or says what is wrong with it; a box that is emptied lets go of both. @param {0 | 1} end @param {() => void} changed */
  #typed(end, changed) {
    const box = this.boxes[end];
    if (!box.value.trim()) {
      this.release();
      return changed();
    }
    const { kind, units, factor } = this.#measure;
    const reading = readShown(box.value, kind, units, factor);
    const limits = /** @type {Limits} */ (
      this.#fixed.map((limit, k) => this.#waiting[k] ?? limit)
    );
    if ('value' in reading) limits[end] = reading.value;
    const [low, high] = limits.map((limit) => limit * factor);
    const problem =
      'problem' in reading
        ? reading.problem
        : !Number.isFinite(high - low)
          ? 'the limits are too far apart'
          : high - low > 1e-6 * Math.max(Math.abs(low), Math.abs(high))
            ? ''
            : low > high
              ? `${plain(low)} is above ${plain(high)}: the other limit is wanted too`
              : 'the least value is the largest one too';
    this.#waiting = [];
    if (low > high && !('problem' in reading)) this.#waiting[end] = limits[end];
    this.fault.textContent = problem && `${problem}. The colours stay as they were.`;
    box.setAttribute('aria-invalid', String(Boolean(problem)));
    if (problem) return;
    this.#fixed = limits;
    this.#of = 'fixed';
    this.choice.value = 'fixed';
    changed();
  }

  /** Forgets the steps of another job. */
  forget() {
    this.#known.clear();
  }

  /** @param {boolean} single whether there is one step alone, which is all steps */
  set single(single) {
    this.#single = single;
    /** @type {HTMLOptionElement} */ (this.choice.options[1]).hidden = single;
    if (this.#of !== 'fixed') this.choice.value = single ? 'step' : this.#of;
  }

  /** Lets go of limits that were held for another quantity. */
  release() {
    if (this.#of !== 'fixed') return;
    this.#of = this.#single ? 'step' : 'steps';
    this.choice.value = this.#of;
  }

  /**
   * @param {object} of
   * @param {string} of.quantity
   * @param {number} of.steps
   * @param {(step: number) => Limits | undefined} of.limits of a step whose field is here, in the units of the job
   * @param {Limits} of.own of the step that is shown
   * @param {boolean} of.signed whether the colours need not begin at 0
   * @param {boolean} of.beside whether another field has the same scale
   * @param {boolean} of.residual whether it is what a load has left: it has a scale of its own
   * @param {number} of.factor to the units shown
   * @param {string} of.unit of these
   * @param {import('../lib/units.js').Quantity} of.kind
   * @param {import('../lib/units.js').Units} of.units of the job
   * @param {boolean} of.whole whether the fields of all steps are kept
   * @returns {import('./palette.js').Bands}
   */
  bands({
    quantity,
    steps,
    limits,
    own,
    signed,
    beside,
    residual,
    factor,
    unit,
    kind,
    units,
    whole,
  }) {
    /** @type {HTMLOptionElement} */ (this.choice.options[1]).text = whole
      ? RANGES.steps
      : 'the steps seen';
    const held = this.#of === 'fixed';
    const alone = this.#of === 'step' || this.#single || residual || beside;
    if (!held) this.choice.value = alone ? 'step' : 'steps';
    const all = alone ? own : this.#overAll(quantity, steps, limits);
    if (held && units !== this.#measure.units) {
      // Held for another job, they are the same stresses in the units of this one.
      const times = between(kind, this.#measure.units, units);
      this.#fixed = /** @type {Limits} */ (this.#fixed.map((limit) => limit * times));
    }
    const [low, high] = (held ? this.#fixed : all).map((value) => value * factor);
    const made = held
      ? bandsWithin(low, high)
      : residual && signed
        ? symmetricBands(low, high)
        : bands(signed ? low : 0, high > low ? high : low + 1);
    const ends = held ? [low, high] : [made.low, made.low + made.step * made.colours.length];
    this.#measure = { kind, units, factor };
    this.#fixed = /** @type {Limits} */ (ends.map((end) => end / factor));
    this.fault.textContent = '';
    this.#waiting = [];
    this.boxes.forEach((box, k) => {
      box.value = plain(ends[k]).replace('−', '-');
      box.removeAttribute('aria-invalid');
    });
    this.unit.textContent = unit;
    return made;
  }

  /** Over all steps whose fields are or were here. @param {string} quantity @param {number} steps @param {(step: number) => Limits | undefined} limits @returns {Limits} */
  #overAll(quantity, steps, limits) {
    let [low, high] = [Infinity, -Infinity];
    for (let step = 0; step < steps; step++) {
      const key = `${quantity} ${step}`;
      const found = this.#known.get(key) ?? limits(step);
      if (!found) continue;
      this.#known.set(key, found);
      low = Math.min(low, found[0]);
      high = Math.max(high, found[1]);
    }
    return [low, high];
  }
}
