/** The cut through the field: a line drawn on it or given in figures, and the curve along it. */

import { h } from '../lib/dom.js';
import { readNumber } from '../lib/number.js';
import { figure, plain, unit } from '../lib/units.js';
import { Chart } from '../result/chart.js';
import { cut } from './cut.js';
import { QUANTITIES, nameOf, valuesOf } from './quantities.js';
import { scaleOf } from './read.js';

/** @typedef {[number, number]} Point */
/** @typedef {{quantity: import('./quantities.js').Quantity, mirrored: boolean, scales: import('./read.js').Scales}} Shown */

const COLOURS = { upper: '--curve-2', lower: '--curve-1' };

export class CutTool {
  /** Its ends in the picture, in units of the job. @type {[Point, Point] | null} */
  line = null;
  on = false;
  /** Whether the curve is of another line. */
  stale = false;
  #factor = 1;

  /** @param {() => void} changed */
  constructor(changed) {
    this.changed = changed;
    this.chart = new Chart(180);
    const box = (/** @type {number} */ k, /** @type {string} */ name) =>
      h('input', { type: 'text', inputmode: 'decimal', size: 7, 'aria-label': name, onchange: () => this.#typed() });
    this.boxes = ['from x', 'from y', 'to x', 'to y'].map((name, k) => box(k, `Cut ${name}`));
    this.unit = h('span', { class: 'unit' });
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
        h('span', { class: 'quiet' }, 'drag on the field to draw it'),
      ),
      this.chart.element,
    );
  }

  /** @param {boolean} on @param {import('./camera.js').Camera} camera @param {number} half width of the contact */
  show(on, camera, half) {
    this.on = on;
    this.element.hidden = !on;
    if (!on) this.line = null;
    else {
      const y = camera.y;
      this.draw([0, y + 1.2 * half], [0, y - 1.2 * half]);
    }
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
    const readings = this.boxes.map(({ value }) => readNumber(value));
    if (readings.some((reading) => 'problem' in reading)) return;
    const [a, b, c, d] = readings.map((reading) => ('value' in reading ? reading.value / this.#factor : 0));
    this.draw([a, b], [c, d]);
  }

  /** Draws the curve along the line. @param {import('./read.js').Body[]} bodies @param {number} deformation @param {Shown} shown */
  read(bodies, deformation, { quantity, mirrored, scales }) {
    this.stale = false;
    if (!this.line) return;
    const [from, to] = this.line;
    this.#factor = scales.length;
    this.unit.textContent = unit('length', scales.units);
    [...from, ...to].forEach((value, k) => {
      const box = this.boxes[k];
      if (document.activeElement !== box)
        box.value = plain(Number((value * scales.length).toPrecision(4))).replace('−', '-');
    });
    const { factor, unit: name } = scaleOf(quantity, scales);
    const curves = bodies.map((body) => {
      const values = valuesOf(body.mesh, quantity, body.moved);
      const sides = /** @type {(1 | -1)[]} */ (mirrored ? [1, -1] : [1]);
      const points = sides
        .flatMap((side) => cut(body, values, deformation, side, QUANTITIES[quantity].odd ? side : 1, from, to))
        .sort((a, b) => a[0] - b[0]);
      return {
        label: `${body.name} body`,
        colour: COLOURS[body.name],
        x: points.map(([at]) => at * scales.length),
        y: points.map(([, value]) => value * factor),
      };
    });
    const there = curves.filter(({ x }) => x.length > 1);
    const highest = Math.max(...there.flatMap(({ y }) => y));
    this.chart.show({
      x: `distance along the cut  [${unit('length', scales.units)}]`,
      y: `${nameOf(quantity, scales.analysis)}${name ? `  [${name}]` : ''}`,
      curves: there,
      words: there.length
        ? `${nameOf(quantity, scales.analysis)} along the cut, at most ${figure(highest, 4)} ${name}.`
        : 'The cut misses the bodies.',
    });
  }
}
