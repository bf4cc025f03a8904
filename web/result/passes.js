/** The chart of a load that rolls. */

import { figure } from '../lib/units.js';
import { Chart } from './chart.js';
import { Panel } from './panel.js';

/** @typedef {import('../types.js').Shown} Shown */

const COLOURS = { upper: '--curve-2', lower: '--curve-1' };

export class PassesPanel {
  constructor() {
    this.chart = new Chart(260);
    this.panel = new Panel('passes', 'Passes', [this.chart.element], {
      picture: (title) => this.chart.picture(title),
      drawing: (title) => this.chart.drawing(title),
    });
  }

  /** @param {Shown[]} shown @param {number} at step of the first */
  show(shown, at) {
    const [{ report }] = shown;
    const { rolling } = report.steps[at];
    this.panel.show(Boolean(rolling?.passes.length));
    if (!rolling?.passes.length) return;
    const { passes } = rolling;
    const x = passes.map(({ number }) => number);
    const curves = /** @type {const} */ (['lower', 'upper']).flatMap((name) => {
      const bodies = passes.map((pass) => pass.bodies[name]);
      if (bodies.every((body) => body === null)) return [];
      const of = (/** @type {'largest_strain' | 'net_strain'} */ key) =>
        bodies.map((body) => (body?.[key] ? 100 * body[key] : null));
      const curve = { colour: COLOURS[name], x, points: true };
      return [
        { ...curve, label: `${name}, accumulated`, y: of('largest_strain') },
        { ...curve, label: `${name}, net`, y: of('net_strain'), dash: [7, 3] },
      ];
    });
    this.chart.show({
      x: 'pass',
      y: 'strain of a pass  [%]',
      log: true,
      curves: curves.filter(({ y }) => y.some((value) => value !== null)),
      marks: [],
      words: `${passes.length} passes: ${curves
        .map(({ label, y }) => `${figure(y.at(-1) ?? 0, 3)} % (${label})`)
        .join(', ')}.`,
    });
  }
}
