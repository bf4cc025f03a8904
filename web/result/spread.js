/**
 * What is special to a contact in three dimensions: load along a roller, or how the pressure of a
 * rough contact is distributed.
 */

import { figure, stiffnessOf, unit } from '../lib/units.js';
import { alongJob, axesOf } from './axes.js';
import { Chart } from './chart.js';
import { beside } from './loads.js';
import { Panel } from './panel.js';

/** @typedef {import('../shown.js').Shown} Shown */

export class SpreadPanel {
  constructor() {
    this.chart = new Chart(220);
    this.panel = new Panel('spread', 'Along the roller', [this.chart.element], {
      chart: this.chart,
    });
  }

  /** @param {Shown[]} shown @param {number} at step of the first */
  show(shown, at) {
    const { report } = shown[0];
    const { contact, three_dimensional: { roller, surface } = {} } = report.steps[at];
    const loaded = contact.force > 0 && (roller ?? surface) !== undefined;
    this.panel.show(loaded);
    if (!loaded) return;
    this.panel.rename(roller ? 'Along the roller' : 'Pressure distribution');
    if (roller) this.#along(shown, at, roller);
    else if (surface) this.#distribution(shown, at, surface);
  }

  /**
   * @param {Shown[]} shown
   * @param {number} at
   * @param {import('../wire.js').RollerContact} roller
   */
  #along(shown, at, { end_pressure: ends, middle_pressure: middle, moment, tilt }) {
    const { report } = shown[0];
    const [length, stress] = [unit('length', report.units), unit('stress', report.units)];
    const slope = unit(stiffnessOf(report), report.units);
    const along = axesOf(report.steps[at].three_dimensional ?? { orientation: 0 }).y;
    const sides = beside(shown, at).flatMap(({ one, at, label }) => {
      const roller = one.report.steps[at].three_dimensional?.roller;
      return roller ? [{ one, roller, label }] : [];
    });
    const curves = sides.map(({ one, roller, label }) => ({
      label: sides.length > 1 ? label : 'line load',
      colour: one.colour,
      dash: one.dash,
      ...alongJob(roller.y, roller.line_load, along),
    }));
    const alone = sides.length === 1 && {
      label: 'largest pressure',
      colour: '--curve-2',
      dash: [7, 3],
      ...alongJob(sides[0].roller.y, sides[0].roller.pressure, along),
      right: true,
    };
    const words = `Edge pressure ${ends.map((one) => figure(one, 4)).join(' and ')} ${stress} at the ends, ${figure(middle, 4)} ${stress} in the middle; moment ${figure(moment, 3)} ${unit('energy', report.units)}, tilt ${figure(tilt, 3)} mrad.`;
    this.chart.show({
      x: `${along.name}  [${length}]`,
      y: `line load  [${slope}]`,
      right: alone ? `p  [${stress}]` : undefined,
      curves: alone ? [...curves, alone] : curves,
      words: `Load along the roller. ${words}`,
    });
  }

  /** @param {Shown[]} shown @param {number} at @param {import('../wire.js').RoughContact} rough */
  #distribution(
    shown,
    at,
    { contact_ratio: ratio, nominal_pressure: nominal, plastic_part: plastic },
  ) {
    const { units } = shown[0].report;
    const stress = unit('stress', units);
    const curves = beside(shown, at).flatMap(({ one, at, label }) => {
      const rough = one.report.steps[at].three_dimensional?.surface;
      if (!rough) return [];
      const name = shown.length > 1 ? label : 'pressure';
      const x = rough.parts.map((part) => 100 * part);
      return [{ label: name, colour: one.colour, dash: one.dash, x, y: rough.pressure_quantiles }];
    });
    const words = `Real contact area ${figure(100 * ratio, 3)} % of that of the heights, nominal pressure ${figure(nominal, 3)} ${stress}${plastic === undefined ? '' : `; below ${figure(100 * plastic, 3)} % of it a body has yielded`}.`;
    this.chart.show({
      x: 'part of the real area below p  [%]',
      y: `p  [${stress}]`,
      curves,
      words: `Distribution of the pressure. ${words}`,
    });
  }
}
