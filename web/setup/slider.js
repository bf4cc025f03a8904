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
 * @param {() => boolean} of.refused whether the figure is at fault
 * @param {() => number} of.typical figure in the units of the job, for those that are 0
 * @param {(value: number, moving: boolean) => void} of.move
 * @returns {{button: HTMLElement, element: HTMLElement, follow: () => void}} `follow` is called when the job has changed
 */
export function slider({ name, value, bounds, refused, typical, move }) {
  /** @type {[number, number]} */
  let ends = [0, 1];
  const range = h('input', {
    type: 'range',
    min: 0,
    max: STEPS,
    'aria-label': `${name}, solved as it moves`,
  });
  const element = h('div', { class: 'slider' });
  // Figures without bounds go in equal ratios, and land on three digits; from 0 on, and in bounds,
  // in equal steps.
  const even = () => bounds !== undefined || ends[0] <= 0;
  const at = (/** @type {number} */ t) =>
    even() ? ends[0] + t * (ends[1] - ends[0]) : ends[0] * (ends[1] / ends[0]) ** t;
  const read = () => Number(at(Number(range.value) / STEPS).toPrecision(3));
  const place = (/** @type {number} */ figure) =>
    even()
      ? (figure - ends[0]) / (ends[1] - ends[0])
      : Math.log(figure / ends[0]) / Math.log(ends[1] / ends[0]);
  /** The figure that the thumb stands for, and the typical one beside it. */
  let [shown, beside] = [NaN, NaN];
  const slide = (/** @type {boolean} */ moving) => {
    shown = read();
    say();
    move(shown, moving);
  };
  const say = () => range.setAttribute('aria-valuetext', String(shown));
  range.addEventListener('input', () => slide(true));
  range.addEventListener('change', () => slide(false));
  const close = () => {
    element.replaceChildren();
    button.setAttribute('aria-pressed', 'false');
  };
  /** Ends and thumb from the figure of the job, which may have other units now. */
  const set = (/** @type {number} */ figure) => {
    [shown, beside] = [figure, typical()];
    // About the usual size where the figure itself is none that is taken.
    ends = bounds ?? endsOf(refused() ? beside : figure, beside);
    range.value = String(Math.round(STEPS * Math.min(1, Math.max(0, place(figure)))));
    say();
  };
  const figureNow = () => numberOf(value() ?? 0);
  const button = h(
    'button',
    {
      type: 'button',
      class: 'plain slide',
      tabindex: -1,
      'aria-label': 'Slider',
      'aria-pressed': 'false',
      title: `Move ${name.toLowerCase()} by a slider and see it solved at once`,
      onclick: () => {
        const figure = figureNow();
        if (element.firstChild || !Number.isFinite(figure)) return close();
        button.setAttribute('aria-pressed', 'true');
        element.replaceChildren(range);
        set(figure);
        range.focus();
      },
    },
    '⟷',
  );
  const follow = () => {
    const figure = figureNow();
    if (!element.firstChild || (figure === shown && beside === typical())) return;
    if (Number.isFinite(figure)) set(figure);
    else close();
  };
  return { button, element, follow };
}
