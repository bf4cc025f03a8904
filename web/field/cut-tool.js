/** The cut through the field: a line drawn on it or given in figures, and the curve along it. */

import { h } from '../lib/dom.js';
import { readShown } from '../lib/number.js';
import { figure, plain, unit } from '../lib/units.js';
import { Chart } from '../result/chart.js';
import { cut, curveOf } from './cut.js';
import { nameOf, parityOf, valuesOf } from './quantities.js';
import { scaleOf } from './read.js';

/** @typedef {[number, number]} Point */
/** @typedef {{quantity: import('./quantities.js').Quantity, mirrored: boolean, scales: import('./read.js').Scales}} Shown */

const COLOURS = { upper: '--curve-2', lower: '--curve-1' };

export class CutTool {
  /** Its ends in the bodies without load, in units of the job. @type {[Point, Point] | null} */
  line = null;
  /** What is seen of it in the picture. @type {[Point, Point][]} */
  path = [];
  on = false;
  /** Whether the curve is of another line. */
  stale = false;
  /** @type {import('./read.js').Scales | undefined} */
  #scales;

  /** @param {() => void} changed */
  constructor(changed) {
    this.changed = changed;
    this.chart = new Chart(180);
    const box = (/** @type {number} */ k, /** @type {string} */ name) =>
      h('input', {
        type: 'text',
        inputmode: 'decimal',
        size: 7,
        'aria-label': name,
        onchange: () => this.#typed(),
      });
    this.boxes = ['from x', 'from y', 'to x', 'to y'].map((name, k) => box(k, `Cut ${name}`));
    this.unit = h('span', { class: 'unit' });
    this.words = h('p', { class: 'quiet', role: 'status' });
    const [x0, y0, x1, y1] = this.boxes;
    this.element = h(
      'div',
      { class: 'cut', hidden: true },
      h(
        'p',
        { class: 'bar' },
        'Cut from ',
        x0,
        y0,
        ' to ',
        x1,
        y1,
        this.unit,
        h('span', { class: 'quiet' }, 'of the bodies without load; drag on the field to draw it'),
      ),
      this.words,
      this.chart.element,
    );
  }

  /** @param {boolean} on @param {Point} middle of the contact in the bodies without load @param {number} half width of it */
  show(on, [x, y], half) {
    this.on = on;
    this.element.hidden = !on;
    this.path = [];
    if (!on) this.line = null;
    else this.draw([x, y + 1.2 * half], [x, y - 1.2 * half]);
    this.changed();
  }

  /** @param {Point} from @param {Point} to */
  draw(from, to) {
    if (!this.on) return;
    this.line = [from, to];
    this.stale = true;
    this.changed();
  }

  #typed() {
    if (!this.#scales) return;
    const { own, length } = this.#scales;
    const readings = this.boxes.map(({ value }) => readShown(value, 'length', own, length));
    readings.forEach((reading, k) =>
      this.boxes[k].setAttribute('aria-invalid', String('problem' in reading)),
    );
    const fault = readings.find((reading) => 'problem' in reading);
    if (fault && 'problem' in fault) {
      this.#say(`${fault.problem}. The cut stays where it was.`);
      return;
    }
    const [a, b, c, d] = readings.map((reading) => ('value' in reading ? reading.value : 0));
    this.draw([a, b], [c, d]);
  }

  /** @param {string} words instead of a curve, or beside one */
  #say(words) {
    this.words.textContent = words;
    this.words.hidden = !words;
  }

  /** Draws the curve along the line. @param {import('./read.js').Body[]} bodies @param {number} deformation @param {Shown} shown */
  read(bodies, deformation, { quantity, mirrored, scales }) {
    this.stale = false;
    this.#scales = scales;
    if (!this.line) return;
    const [from, to] = this.line;
    this.unit.textContent = unit('length', scales.units);
    [...from, ...to].forEach((value, k) => {
      const box = this.boxes[k];
      box.removeAttribute('aria-invalid');
      if (document.activeElement !== box)
        box.value = plain(Number((value * scales.length).toPrecision(4))).replace('−', '-');
    });
    const { factor, unit: name } = scaleOf(quantity, scales);
    const pieces = bodies.map((body) => {
      const values = valuesOf(body.mesh, quantity, body.moved);
      const sides = /** @type {(1 | -1)[]} */ (mirrored ? [1, -1] : [1]);
      return sides.flatMap((side) =>
        cut(body, values, deformation, side, parityOf(quantity, scales.analysis, side), from, to),
      );
    });
    this.path = pieces.flat().map(({ path }) => path);
    const there = bodies.flatMap((body, k) => {
      const { x, y } = curveOf(pieces[k]);
      return x.length === 0
        ? []
        : [
            {
              label: `${body.name} body`,
              colour: COLOURS[body.name],
              x: x.map((at) => at * scales.length),
              y: y.map((value) => (value === null ? null : value * factor)),
            },
          ];
    });
    const place = (/** @type {Point} */ point) =>
      point.map((value) => plain(Number((value * scales.length).toPrecision(3)))).join(', ');
    const none = there.length
      ? ''
      : from.every((value, k) => value === to[k])
        ? 'The cut has no length: its ends are at the same place.'
        : 'The cut misses the bodies.';
    this.#say(none);
    this.chart.element.hidden = Boolean(none);
    const highest = Math.max(...there.flatMap(({ y }) => y.map((value) => value ?? -Infinity)));
    this.chart.show({
      x: `distance from ${scales.analysis === 'axisymmetric' ? 'r, z' : 'x, y'} = ${place(from)} to ${place(to)}  [${unit('length', scales.units)}]`,
      y: `${nameOf(quantity, scales.analysis)}${name ? `  [${name}]` : ''}`,
      curves: there,
      words:
        none ||
        `${nameOf(quantity, scales.analysis)} along the cut, at most ${figure(highest, 4)} ${name}.`,
    });
  }
}
