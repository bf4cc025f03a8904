/**
 * What is special to a contact in three dimensions: load along a roller, or how the pressure of a
 * rough contact is distributed.
 */

import { stiffnessOf, unit } from '../lib/units.js';
import { lowered } from '../setup/field.js';
import { toldOf } from './answers.js';
import { alongJob, axesOf } from './axes.js';
import { Chart } from './chart.js';
import { beside } from './loads.js';
import { Panel } from './panel.js';
import { forceIn, rowOf } from './rows.js';

/** @typedef {import('../shown.js').Shown} Shown */

/** Rows of a step in words. @param {import('../types.js').Step} step @param {...string} names */
const wordsOf = (step, ...names) =>
  `${names
    .flatMap((name) => rowOf(step, name) ?? [])
    .map((row) => `${lowered(row.label)} ${toldOf(row)}`)
    .join(', ')}.`;

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
    const step = report.steps[at];
    const { along, quantiles } = step.contact;
    const loaded = forceIn(step) > 0 && (along ?? quantiles) !== undefined;
    this.panel.show(loaded);
    if (!loaded) return;
    this.panel.rename(along ? 'Along the roller' : 'Pressure distribution');
    if (along) this.#along(shown, at);
    else this.#distribution(shown, at);
  }

  /** @param {Shown[]} shown @param {number} at */
  #along(shown, at) {
    const { report } = shown[0];
    const [length, stress] = [unit('length', report.units), unit('stress', report.units)];
    const slope = unit(stiffnessOf(report), report.units);
    const along = axesOf(report.steps[at]).y;
    const sides = beside(shown, at).flatMap(({ one, at, label }) => {
      const roller = one.report.steps[at].contact.along;
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
    const words = wordsOf(report.steps[at], 'edge_pressure', 'middle_pressure', 'moment', 'tilt');
    this.chart.show({
      x: `${along.name}  [${length}]`,
      y: `line load  [${slope}]`,
      right: alone ? `p  [${stress}]` : undefined,
      curves: alone ? [...curves, alone] : curves,
      words: `Load along the roller: ${words}`,
    });
  }

  /** @param {Shown[]} shown @param {number} at */
  #distribution(shown, at) {
    const { units, steps } = shown[0].report;
    const stress = unit('stress', units);
    const curves = beside(shown, at).flatMap(({ one, at, label }) => {
      const { quantiles } = one.report.steps[at].contact;
      if (!quantiles) return [];
      const name = shown.length > 1 ? label : 'pressure';
      const x = quantiles.part.map((part) => 100 * part);
      return [{ label: name, colour: one.colour, dash: one.dash, x, y: quantiles.pressure }];
    });
    const words = wordsOf(steps[at], 'contact_ratio', 'nominal_pressure', 'yielded_part');
    this.chart.show({
      x: 'part of the real area below p  [%]',
      y: `p  [${stress}]`,
      curves,
      words: `Distribution of the pressure: ${words}`,
    });
  }
}
