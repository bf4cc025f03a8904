/** Contact pressure over x, Hertz's beside it, half-widths marked. */

import { figure, unit } from '../lib/units.js';
import { toldOf } from './answers.js';
import { alongJob, axesOf } from './axes.js';
import { Chart } from './chart.js';
import { abscissaOf, extentOf, rangeAround } from './extent.js';
import { beside, hertzName } from './loads.js';
import { Panel } from './panel.js';
import { WIDTH, hertzIn, rowOf } from './rows.js';

/** @typedef {import('../shown.js').Shown} Shown */

export class PressurePanel {
  constructor() {
    this.chart = new Chart(290);
    this.panel = new Panel('pressure', 'Contact pressure', [this.chart.element], {
      chart: this.chart,
    });
  }

  /**
   * Before there is a result.
   * @param {{half_width: number, peak_pressure: number}} hertz
   * @param {import('../lib/units.js').Units | import('../lib/units.js').UnitSet} units
   * @param {boolean} round
   */
  preview(hertz, units, round) {
    this.panel.show(true);
    this.panel.element.classList.add('preview');
    this.chart.show({
      x: `${round ? 'r' : 'x'}  [${unit('length', units)}]`,
      y: `p  [${unit('stress', units)}]`,
      curves: [hertzCurve(hertz, round)],
      range: rangeAround([hertzExtent(hertz)], round),
      words: `Hertz, elastic: peak pressure ${figure(hertz.peak_pressure)} ${unit('stress', units)}, half-width ${figure(hertz.half_width)} ${unit('length', units)}.`,
    });
  }

  /** @param {Shown[]} shown @param {number} at step of the first */
  show(shown, at) {
    this.panel.show(true);
    this.panel.element.classList.remove('preview');
    const [first] = shown;
    const step = first.report.steps[at];
    const sides = beside(shown, at);
    // Where every load is taken away there is no pressure to be seen.
    if (
      !sides.some(({ one, at }) =>
        one.report.steps[at].contact.nodes.pressure.some((pressure) => pressure > 0),
      )
    )
      return this.panel.show(false);
    const { units } = first.report;
    const round = first.report.analysis === 'axisymmetric';
    /** @type {import('./chart-svg.js').Curve[]} */
    const curves = sides.map(({ one, at, label }) => {
      const { nodes } = one.report.steps[at].contact;
      return {
        label: shown.length > 1 ? label : 'this contact',
        colour: one.colour,
        dash: one.dash,
        x: nodes.x,
        y: nodes.pressure,
        filled: shown.length === 1,
      };
    });
    const spread = sides.slice(1);
    if (spread.length === 2 && spread.every(({ one }) => one.job.tags?.varied))
      curves.unshift(band(curves[1], curves[2]));
    const { section } = step.contact;
    const axes = section && axesOf(step);
    if (axes && shown.length === 1) {
      const { nodes } = step.contact;
      const { y, pressure } = section;
      const name = (/** @type {'x' | 'y'} */ axis) => `along ${axes[axis].name}`;
      Object.assign(curves[0], { label: name('x') }, alongJob(nodes.x, nodes.pressure, axes.x));
      const across = alongJob(y, pressure, axes.y);
      curves.push({ label: name('y'), colour: '--curve-2', dash: [7, 3], ...across });
    }
    const { contact } = step;
    const hertz = hertzIn(step);
    const name = hertzName(first.report, at);
    if (hertz) curves.push({ ...hertzCurve(hertz, round, name), filled: false });
    const last = contact.patches[contact.patches.length - 1];
    const width = toldOf(rowOf(step, ...WIDTH));
    const marks = contact.patches
      .flatMap((patch) => [
        mark(patch.left, ''),
        mark(patch.right, patch === last ? `a ${width}` : ''),
      ])
      .filter(({ at }) => at !== 0 || !round);
    const extents = sides.flatMap(({ one, at }) => extentOf(one.report.steps[at], round) ?? []);
    if (hertz) extents.push(hertzExtent(hertz));
    if (section && shown.length === 1) extents.push(...curves.slice(0, 2).flatMap(touchedBy));
    this.chart.show({
      x: `${axes ? (shown.length > 1 ? axes.x.name : `${axes.x.name}, ${axes.y.name}`) : abscissaOf(step, round)}  [${unit('length', units)}]`,
      y: `p  [${unit('stress', units)}]`,
      curves,
      marks,
      range: rangeAround(extents, round),
      words: `Contact pressure over x: highest ${toldOf(rowOf(step, 'peak_pressure'))}, half-width ${width}${
        hertz ? `; ${name}: ${figure(hertz.peak_pressure)} and ${figure(hertz.half_width)}` : ''
      }.`,
    });
  }
}

/**
 * What lies between two curves, each taken as 0 beyond its ends.
 * @param {import('./chart-svg.js').Curve} one
 * @param {import('./chart-svg.js').Curve} other
 * @returns {import('./chart-svg.js').Curve}
 */
function band(one, other) {
  const x = [...new Set([...one.x, ...other.x])].sort((a, b) => a - b);
  const along = (/** @type {import('./chart-svg.js').Curve} */ curve) => {
    let k = 0;
    return x.map((at) => {
      while (k + 1 < curve.x.length && curve.x[k + 1] < at) k += 1;
      const [x0, x1] = [curve.x[k], curve.x[k + 1] ?? curve.x[k]];
      if (at < x0 || at > x1) return at === x0 ? (curve.y[k] ?? 0) : 0;
      const [y0, y1] = [curve.y[k] ?? 0, curve.y[k + 1] ?? curve.y[k] ?? 0];
      return x1 > x0 ? y0 + ((y1 - y0) * (at - x0)) / (x1 - x0) : y0;
    });
  };
  return { label: 'between both', colour: '--curve-1', x, y: along(one), to: along(other) };
}

/** Where a curve is above 0. @param {import('./chart-svg.js').Curve} curve @returns {import('./extent.js').Extent[]} */
function touchedBy({ x, y }) {
  const pressed = x.filter((_, k) => (y[k] ?? 0) > 0);
  return pressed.length ? [{ left: pressed[0], right: pressed[pressed.length - 1] }] : [];
}

/**
 * @param {number} at end of a part of the contact
 * @param {string} text
 * @returns {import('./chart-svg.js').Mark}
 */
const mark = (at, text) => ({ across: 'x', at, text });

/** @param {{half_width: number}} hertz @returns {import('./extent.js').Extent} */
const hertzExtent = ({ half_width }) => ({ left: -half_width, right: half_width });

/**
 * p = p_0 √(1 − (x/a)²).
 * @param {{half_width: number, peak_pressure: number}} hertz
 * @param {boolean} round over the radius only
 * @param {string} [label]
 */
function hertzCurve({ half_width, peak_pressure }, round, label = 'Hertz, elastic') {
  const angles = Array.from({ length: 121 }, (_, k) =>
    round ? (Math.PI * k) / 240 : Math.PI * (k / 120 - 0.5),
  );
  return {
    label,
    colour: '--hertz',
    dashed: true,
    x: angles.map((angle) => half_width * Math.sin(angle)),
    y: angles.map((angle) => peak_pressure * Math.cos(angle)),
  };
}
