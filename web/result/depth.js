/** Stresses over depth under the peak pressure, of the components one chooses, with the yield stress marked. */

import { h } from '../lib/dom.js';
import { figure, unit } from '../lib/units.js';
import { yieldStress } from '../setup/fields.js';
import { symbol } from '../setup/entry.js';
import { Chart } from './chart.js';
import { Panel, segments } from './panel.js';

/** @typedef {import('../types.js').Shown} Shown */
/** @typedef {'von_mises' | 'tau_max' | 'sigma_x' | 'sigma_y' | 'sigma_z' | 'equivalent_plastic_strain'} Component */

/** @type {Record<Component, {label: string, name: string, colour: string}>} */
const COMPONENTS = {
  von_mises: { label: 'von Mises', name: 'von Mises', colour: '--curve-1' },
  tau_max: { label: 'τ_max', name: 'τ max', colour: '--curve-2' },
  sigma_x: { label: 'σ_x', name: 'σx', colour: '--curve-3' },
  sigma_y: { label: 'σ_y', name: 'σy', colour: '--curve-4' },
  sigma_z: { label: 'σ_z', name: 'σz', colour: '--curve-5' },
  equivalent_plastic_strain: { label: 'ε_p', name: 'plastic strain', colour: '--curve-6' },
};

export class DepthPanel {
  /** @type {'upper' | 'lower'} */
  #body = 'lower';
  #chosen = /** @type {Set<Component>} */ (new Set(['von_mises', 'tau_max', 'equivalent_plastic_strain']));
  /** @type {[Shown[], number] | undefined} */
  #shown;

  constructor() {
    this.chart = new Chart(290);
    const bodies = segments('Body', { lower: 'Lower', upper: 'Upper' }, (body) => {
      this.#body = /** @type {'upper' | 'lower'} */ (body);
      this.#again();
    });
    const components = h(
      'div',
      { class: 'chips', role: 'group', 'aria-label': 'Components' },
      Object.entries(COMPONENTS).map(([key, { label }]) => this.#chip(/** @type {Component} */ (key), label)),
    );
    this.panel = new Panel('depth', 'Stress over depth', [components, this.chart.element], {
      controls: [bodies],
      picture: () => this.chart.picture(),
    });
  }

  /** @param {Component} component @param {string} label */
  #chip(component, label) {
    const input = h('input', {
      type: 'checkbox',
      checked: this.#chosen.has(component),
      onchange: () => {
        if (input.checked) this.#chosen.add(component);
        else this.#chosen.delete(component);
        this.#again();
      },
    });
    return h('label', {}, input, h('span', {}, symbol(label)));
  }

  #again() {
    if (this.#shown) this.show(...this.#shown);
  }

  /** @param {Shown[]} shown @param {number} at step of the first */
  show(shown, at) {
    this.#shown = [shown, at];
    const [first] = shown;
    const step = first.report.steps[at];
    const { units } = first.report;
    const profile = step.subsurface?.[this.#body];
    this.panel.show(step.subsurface !== undefined);
    if (!step.subsurface) return;
    const curves = shown.flatMap((one, k) =>
      this.#curves(one, k === 0 ? at : one.report.steps.length - 1, shown.length > 1),
    );
    const strength = yieldStress(first.job[this.#body]?.material);
    const [stress, length] = [unit('stress', units), unit('length', units)];
    this.chart.show({
      x: `depth  [${length}]`,
      y: `stress  [${stress}]`,
      right: curves.some(({ right }) => right) ? 'plastic strain' : undefined,
      curves,
      range: [0, 4 * step.contact.half_width || 1],
      marks: strength
        ? [{ across: 'y', at: strength, text: `yield ${figure(strength, 4)} ${stress}`, colour: '--yield' }]
        : [],
      words: profile
        ? `Under the peak of the ${this.#body} body: highest von Mises stress ${figure(Math.max(...profile.von_mises))} ${stress}, at a depth of ${figure(
            profile.depth[profile.von_mises.indexOf(Math.max(...profile.von_mises))],
            3,
          )} ${length}.`
        : `The ${this.#body} body is rigid.`,
    });
  }

  /** @param {Shown} one @param {number} at @param {boolean} named @returns {import('./chart.js').Curve[]} */
  #curves(one, at, named) {
    const profile = one.report.steps[at].subsurface?.[this.#body];
    if (!profile) return [];
    // Without plastic strain there is nothing to scale an axis by.
    const there = [...this.#chosen].filter(
      (component) => component !== 'equivalent_plastic_strain' || profile[component].some((value) => value > 0),
    );
    return there.map((component, k) => {
      const { name, colour } = COMPONENTS[component];
      return {
        label: named ? `${one.label}: ${name}` : name,
        colour: named ? one.colour : colour,
        dashed: named && k > 0,
        x: profile.depth,
        y: profile[component],
        right: component === 'equivalent_plastic_strain',
      };
    });
  }
}
