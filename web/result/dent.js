/** The chart of both surfaces: a dent where the force is zero. */

import { figure, unit } from '../lib/units.js';
import { Chart } from './chart.js';
import { abscissaOf } from './extent.js';
import { Panel } from './panel.js';

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
    const { flow } = step;
    this.panel.show(Boolean(flow));
    if (!flow) return;
    const length = unit('length', report.units);
    const round = report.analysis === 'axisymmetric';
    const bodies = /** @type {const} */ (['lower', 'upper']).flatMap((name) => {
      const surface = flow.surfaces[name];
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
      words: `${step.contact.force === 0 ? 'Residual' : 'Loaded'} height of the surfaces: ${bodies
        .map(({ name, surface }) => `${name} body ${figure(surface.depth, 4)} ${length} deep`)
        .join(', ')}.`,
    });
  }
}
