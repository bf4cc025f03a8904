/** A slider beside a figure, that solves as it moves. */

import { h } from '../lib/dom.js';
import { numberOf } from '../lib/number.js';

/** Steps from one end to the other. */
const STEPS = 200;
/** Largest value over the one it began with. */
const REACH = 3;

/** @param {number} figure @param {number} typical @returns {[number, number]} */
const endsOf = (figure, typical) =>
  figure > 0 ? [figure / REACH, figure * REACH] : figure < 0 ? [REACH * figure, 0] : [0, typical];

/**
 * @param {object} of
 * @param {string} of.name
 * @param {() => unknown} of.value in the job
 * @param {[number, number]} [of.bounds] of figures that have some
 * @param {() => number | undefined} of.typical figure, for those that are 0
 * @param {(value: number, moving: boolean) => void} of.move
 * @returns {{button: HTMLElement, element: HTMLElement}}
 */
export function slider({ name, value, bounds, typical, move }) {
  /** @type {[number, number]} */
  let ends = [0, 1];
  const range = h('input', { type: 'range', min: 0, max: STEPS, 'aria-label': `${name}, solved as it moves` });
  const element = h('div', { class: 'slider' });
  // Figures without bounds go in equal ratios, and land on three digits; from 0 on, and in bounds, in equal steps.
  const even = () => bounds !== undefined || ends[0] <= 0;
  const at = (/** @type {number} */ t) =>
    even() ? ends[0] + t * (ends[1] - ends[0]) : ends[0] * (ends[1] / ends[0]) ** t;
  const read = () => Number(at(Number(range.value) / STEPS).toPrecision(3));
  const place = (/** @type {number} */ figure) =>
    even() ? (figure - ends[0]) / (ends[1] - ends[0]) : Math.log(figure / ends[0]) / Math.log(ends[1] / ends[0]);
  range.addEventListener('input', () => move(read(), true));
  range.addEventListener('change', () => move(read(), false));
  const button = h(
    'button',
    {
      type: 'button',
      class: 'plain slide',
      'aria-label': 'Slider',
      'aria-pressed': 'false',
      title: `Move ${name.toLowerCase()} by a slider and see it solved at once`,
      onclick: () => {
        const figure = numberOf(value() ?? 0);
        const open = !element.firstChild && Number.isFinite(figure);
        button.setAttribute('aria-pressed', String(open));
        if (!open) return element.replaceChildren();
        element.replaceChildren(range);
        ends = bounds ?? endsOf(figure, typical() ?? 1);
        range.value = String(Math.round(STEPS * Math.min(1, Math.max(0, place(figure)))));
        range.focus();
      },
    },
    '⟷',
  );
  return { button, element };
}
