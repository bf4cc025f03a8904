/** The chart of both surfaces: a dent where the force is zero. */

import { unit } from '../lib/units.js';
import { toldOf } from './answers.js';
import { Chart } from './chart.js';
import { abscissaOf } from './extent.js';
import { Panel } from './panel.js';
import { forceIn } from './rows.js';

/** @typedef {import('../shown.js').Shown} Shown */

const COLOURS = { upper: '--curve-2', lower: '--curve-1' };

export class DentPanel {
  constructor() {
    this.chart = new Chart(220);
    this.panel = new Panel('dent', 'Surfaces', [this.chart.element], {
      chart: this.chart,
    });
  }

  /** @param {Shown[]} shown @param {number} at step of the first */
  show(shown, at) {
    const [{ report }] = shown;
    const step = report.steps[at];
    const { surfaces } = step;
    this.panel.show(Boolean(surfaces));
    if (!surfaces) return;
    const length = unit('length', report.units);
    const round = report.analysis === 'axisymmetric';
    const bodies = /** @type {const} */ (['lower', 'upper']).flatMap((name) => {
      const surface = surfaces[name];
      return surface ? [{ name, surface }] : [];
    });
    this.chart.show({
      x: `${abscissaOf(step, round)}  [${length}]`,
      y: `height  [${length}]`,
      curves: bodies.map(({ name, surface }) => ({
        label: `${name} body, outward`,
        colour: COLOURS[name],
        // A radius begins at the axis.
        x: surface.x.filter((x) => !round || x >= 0),
        y: surface.height.filter((_, k) => !round || surface.x[k] >= 0),
        dash: name === 'upper' ? [7, 3] : undefined,
      })),
      marks: [{ across: 'y', at: 0, text: 'undeformed' }],
      words: `${forceIn(step) === 0 ? 'Residual' : 'Loaded'} height of the surfaces: ${step.answers
        .filter(({ name }) => name === 'dent_depth' || name === 'surface_depth')
        .map((row) => `${row.label} ${toldOf(row)}`)
        .join('; ')}.`,
    });
  }
}
