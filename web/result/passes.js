/** The chart of a load that rolls: what each pass moves and what it adds. */

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
        // 0 has no place on the axis.
        bodies.map((body) => (body?.[key] ? 100 * body[key] : null));
      const curve = { colour: COLOURS[name], x, points: true };
      return [
        { ...curve, label: `${name} body, accumulated`, y: of('largest_strain') },
        { ...curve, label: `${name} body, net`, y: of('net_strain'), dash: [7, 3] },
      ];
    });
    const [last] = passes.slice(-1);
    this.chart.show({
      x: 'pass',
      y: 'plastic strain of the pass  [%]',
      log: true,
      curves: curves.filter(({ y }) => y.some((value) => value !== null)),
      marks: [],
      words: `Plastic strain of ${passes.length} passes: ${['lower', 'upper']
        .map((name) => ({ name, body: last.bodies[/** @type {'lower' | 'upper'} */ (name)] }))
        .filter(({ body }) => body)
        .map(
          ({ name, body }) =>
            `in the last one ${figure(100 * (body?.largest_strain ?? 0), 3)} %, of which ${figure(100 * (body?.net_strain ?? 0), 3)} % stay in the ${name} body`,
        )
        .join(', ')}.`,
    });
  }
}
