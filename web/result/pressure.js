/** Contact pressure over x, Hertz's beside it, half-widths marked. */

import { figure, unit } from '../lib/units.js';
import { Chart } from './chart.js';
import { beside, hertzName } from './loads.js';
import { Panel } from './panel.js';

/** @typedef {import('../types.js').Shown} Shown */

export class PressurePanel {
  constructor() {
    this.chart = new Chart(290);
    this.panel = new Panel('pressure', 'Contact pressure', [this.chart.element], {
      picture: (title) => this.chart.picture(title),
      drawing: (title) => this.chart.drawing(title),
    });
  }

  /** Before there is a result. @param {{half_width: number, peak_pressure: number}} hertz @param {import('../lib/units.js').Units | import('../lib/units.js').UnitSet} units @param {boolean} round */
  preview(hertz, units, round) {
    this.panel.show(true);
    this.panel.element.classList.add('preview');
    this.chart.show({
      x: `${round ? 'r' : 'x'}  [${unit('length', units)}]`,
      y: `p  [${unit('stress', units)}]`,
      curves: [hertzCurve(hertz, round)],
      range: [round ? 0 : -1.3 * hertz.half_width, 1.3 * hertz.half_width],
      words: `Hertz, elastic: peak pressure ${figure(hertz.peak_pressure)} ${unit('stress', units)}, half-width ${figure(hertz.half_width)} ${unit('length', units)}.`,
    });
  }

  /** @param {Shown[]} shown @param {number} at step of the first */
  show(shown, at) {
    this.panel.show(true);
    this.panel.element.classList.remove('preview');
    const [first] = shown;
    const step = first.report.steps[at];
    // Where the load is taken away there is no pressure to be seen.
    if (shown.length === 1 && !(step.contact.peak_pressure > 0)) return this.panel.show(false);
    const { units } = first.report;
    const round = first.report.analysis === 'axisymmetric';
    const sides = beside(shown, at);
    /** @type {import('./chart.js').Curve[]} */
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
    const { hertz, contact } = step;
    const name = hertzName(first.report, at);
    if (hertz) curves.push({ ...hertzCurve(hertz, round, name), filled: false });
    const marks = contact.patches
      .flatMap(({ left, right }) => [left, right])
      .filter((x) => x !== 0 || !round)
      .map((x) => mark(x, units, contact.half_width));
    const reach =
      Math.max(
        contact.half_width,
        hertz?.half_width ?? 0,
        ...sides.map(({ one, at }) => one.report.steps[at].contact.half_width),
      ) * 1.3;
    this.chart.show({
      x: `${contact.half_angle === undefined ? (round ? 'r' : 'x') : 'along the arc'}  [${unit('length', units)}]`,
      y: `p  [${unit('stress', units)}]`,
      curves,
      marks,
      range: reach > 0 && contact.patches.length < 2 ? [round ? 0 : -reach, reach] : undefined,
      words: `Contact pressure over x: highest ${figure(contact.peak_pressure)} ${unit('stress', units)}, half-width ${figure(contact.half_width)} ${unit('length', units)}${
        hertz ? `; ${name}: ${figure(hertz.peak_pressure)} and ${figure(hertz.half_width)}` : ''
      }.`,
    });
  }
}

/** @param {number} x @param {import('../lib/units.js').Units | import('../lib/units.js').UnitSet} units @param {number} half */
const mark = (x, units, half) => ({
  across: /** @type {const} */ ('x'),
  at: x,
  text: Math.abs(x - half) < 1e-9 * half ? `a ${figure(half, 4)} ${unit('length', units)}` : '',
});

/** p = p_0 √(1 − (x/a)²). @param {{half_width: number, peak_pressure: number}} hertz @param {boolean} round over the radius only @param {string} [label] */
function hertzCurve({ half_width, peak_pressure }, round, label = 'Hertz, elastic') {
  const angles = Array.from({ length: 121 }, (_, k) => (round ? (Math.PI * k) / 240 : Math.PI * (k / 120 - 0.5)));
  return {
    label,
    colour: '--hertz',
    dashed: true,
    x: angles.map((angle) => half_width * Math.sin(angle)),
    y: angles.map((angle) => peak_pressure * Math.cos(angle)),
  };
}
