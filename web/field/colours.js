/** Which values the colours of a field stand for: those of the step, those of all steps, or limits that are held. */

import { h } from '../lib/dom.js';
import { readNumber } from '../lib/number.js';
import { plain } from '../lib/units.js';
import { bands } from './palette.js';

const RANGES = { step: 'this step', steps: 'all steps', fixed: 'fixed' };

/** @typedef {[number, number]} Limits least and largest value */

export class ColourRange {
  /** @type {keyof typeof RANGES} */
  #of = 'steps';
  /** Limits that are held, in the units of the job. @type {Limits} */
  #fixed = [0, 1];
  /** From these to the units shown. */
  #factor = 1;
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
      Object.entries(RANGES).map(([value, text]) => h('option', { value, selected: value === this.#of }, text)),
    );
    const limit = (/** @type {0 | 1} */ end, /** @type {string} */ name) => {
      const box = h('input', {
        type: 'text',
        inputmode: 'decimal',
        size: 7,
        'aria-label': name,
        onchange: () => {
          const reading = readNumber(box.value);
          if ('value' in reading) this.#fixed[end] = reading.value / this.#factor;
          this.#fixed.sort((a, b) => a - b);
          this.#of = 'fixed';
          this.choice.value = 'fixed';
          changed();
        },
      });
      return box;
    };
    this.boxes = [limit(0, 'Least value coloured'), limit(1, 'Largest value coloured')];
    this.unit = h('span', { class: 'unit' });
    this.element = h(
      'span',
      { class: 'range' },
      'Colours ',
      this.choice,
      this.boxes[0],
      ' – ',
      this.boxes[1],
      this.unit,
    );
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
   * @param {number} of.factor to the units shown
   * @param {string} of.unit of these
   * @returns {import('./palette.js').Bands}
   */
  bands({ quantity, steps, limits, own, signed, factor, unit }) {
    const all = this.#of === 'steps' && !this.#single ? this.#overAll(quantity, steps, limits) : own;
    const held = this.#of === 'fixed';
    const [low, high] = (held ? this.#fixed : all).map((value) => value * factor);
    const made = bands(signed || held ? low : 0, high > low ? high : low + 1);
    const ends = held ? [low, high] : [made.low, made.low + made.step * made.colours.length];
    this.#factor = factor;
    this.#fixed = /** @type {Limits} */ (ends.map((end) => end / factor));
    this.boxes.forEach((box, k) => {
      box.value = plain(ends[k]).replace('−', '-');
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
