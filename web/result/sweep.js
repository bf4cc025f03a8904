/** Force over approach of a sweep. */

import { figure, forceOf, unit } from '../lib/units.js';
import { Chart } from './chart.js';
import { Panel } from './panel.js';

export class SweepPanel {
  constructor() {
    this.chart = new Chart();
    this.panel = new Panel('sweep', 'Load over approach', [this.chart.element], {
      picture: () => this.chart.picture(),
    });
  }

  /** @param {import('../types.js').Shown[]} shown @param {number} at step of the first */
  show(shown, at) {
    const swept = shown.filter(({ report }) => report.load_approach);
    this.panel.show(swept.length > 0);
    if (swept.length === 0) return;
    const [{ report }] = swept;
    const step = shown[0].report.steps[at];
    const [force, length] = [unit(forceOf(report), report.units), unit('length', report.units)];
    const onset = shown[0].report.steps[0].hertz?.yield_onset_force;
    this.chart.show({
      x: `α  [${length}]`,
      y: `P  [${force}]`,
      curves: swept.map((one) => ({
        label: swept.length > 1 ? one.label : 'force',
        colour: one.colour,
        points: true,
        x: one.report.load_approach?.approach ?? [],
        y: one.report.load_approach?.force ?? [],
      })),
      marks: [
        ...(onset
          ? [
              {
                across: /** @type {const} */ ('y'),
                at: onset,
                text: `first yield ${figure(onset, 4)} ${force}`,
                colour: '--yield',
              },
            ]
          : []),
        { across: 'x', at: step.approach, text: 'shown' },
      ],
      words: `Force over approach, ${report.load_approach?.force.length} points up to ${figure(Math.max(...(report.load_approach?.force ?? [0])))} ${force}.`,
    });
  }
}
