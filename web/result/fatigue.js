/** The chart of high-cycle fatigue: utilization over depth by each criterion. */

import { figure, unit } from '../lib/units.js';
import { Chart } from './chart.js';
import { Panel, segments } from './panel.js';

/** @typedef {import('../shown.js').Shown} Shown */
/** @typedef {import('../types.js').Step} Step */
/** @typedef {'upper' | 'lower'} Side */

const CRITERIA = /** @type {const} */ ({
  dang_van: ['Dang Van', '--curve-1'],
  crossland: ['Crossland', '--curve-2'],
  orthogonal_shear: ['orthogonal shear', '--curve-3'],
});

/** Hertz's peak at which the first criterion is at its limit in elastic bodies, over the peak of this job. @param {Step} step @returns {number | undefined} */
export function elasticLimit({ answers }) {
  const used = answers
    .filter((row) => row.name === 'fatigue_utilization')
    .map((row) => row.elastic ?? 0);
  const most = Math.max(0, ...used);
  return most > 0 ? 1 / most : undefined;
}

export class FatiguePanel {
  /** @type {Side} */
  #body = 'lower';
  /** @type {[Shown[], number] | undefined} */
  #shown;

  constructor() {
    this.chart = new Chart(260);
    this.bodies = segments('Body', { lower: 'Lower', upper: 'Upper' }, (body) => {
      this.#body = /** @type {Side} */ (body);
      if (this.#shown) this.show(...this.#shown);
    });
    this.panel = new Panel('fatigue', 'Fatigue over depth', [this.chart.element], {
      controls: [this.bodies],
      chart: this.chart,
    });
  }

  /** @param {Shown[]} shown @param {number} at step of the first */
  show(shown, at) {
    this.#shown = [shown, at];
    const [{ report }] = shown;
    const { fatigue } = report.steps[at];
    const side = fatigue?.[this.#body] ? this.#body : fatigue?.lower ? 'lower' : 'upper';
    const body = fatigue?.[side];
    this.panel.show(Boolean(body));
    if (!body) return;
    const curves = /** @type {(keyof typeof CRITERIA)[]} */ (Object.keys(CRITERIA)).flatMap(
      (key) => {
        const [label, colour] = CRITERIA[key];
        const y = body[key];
        return y ? [{ label, colour, x: body.depth, y }] : [];
      },
    );
    const most = curves.map(({ label, y }) => `${figure(Math.max(...y), 3)} (${label})`);
    this.chart.show({
      x: `depth  [${unit('length', report.units)}]`,
      y: 'utilization',
      curves,
      words: `${side} body: largest utilization ${most.join(', ')}; 1 is the limit.`,
    });
  }
}
