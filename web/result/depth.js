/** Stresses over depth under the peak pressure, of the components one chooses, with the yield stress marked. */

import { h } from '../lib/dom.js';
import { factor, figure, unit, unitsOf } from '../lib/units.js';
import { hasInitialStress, overDepthOf, yieldName, yieldStress } from '../setup/fields.js';
import { symbol } from '../setup/entry.js';
import { Chart } from './chart.js';
import { elasticStresses } from './elastic.js';
import { beside, isDented } from './loads.js';
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

/** Lines of components, where colours and dashes tell jobs apart. */
const WIDTHS = [1.75, 0.9, 2.75, 0.5, 3.5, 1.3];

/** Stresses in axisymmetry have the directions r, z, θ, in this order. */
const ROUND = /** @type {Partial<Record<Component, string>>} */ ({ sigma_x: 'σr', sigma_y: 'σz', sigma_z: 'σθ' });

/** Largest half-width of all steps. @param {Shown} shown */
const widest = ({ report }) => Math.max(...report.steps.map(({ contact }) => contact.half_width));

/** @param {Component} component @param {string} analysis */
const nameOf = (component, analysis) =>
  (analysis === 'axisymmetric' ? ROUND[component] : undefined) ?? COMPONENTS[component].name;

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
      picture: (title) => this.chart.picture(title),
      drawing: (title) => this.chart.drawing(title),
    });
  }

  /** @param {Component} component @param {string} label */
  #chip(component, label) {
    const text = h('span', { 'data-component': component }, symbol(label));
    const input = h('input', {
      type: 'checkbox',
      checked: this.#chosen.has(component),
      onchange: () => {
        if (input.checked) this.#chosen.add(component);
        else this.#chosen.delete(component);
        this.#again();
      },
    });
    return h('label', {}, input, text);
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
    for (const [component, name] of Object.entries(ROUND))
      this.panel.element
        .querySelector(`[data-component=${component}]`)
        ?.replaceChildren(
          ...symbol(
            first.report.analysis === 'axisymmetric'
              ? `${name[0]}_${name[1]}`
              : COMPONENTS[/** @type {Component} */ (component)].label,
          ),
        );
    this.panel.show(step.subsurface !== undefined);
    if (!step.subsurface) return;
    const sides = beside(shown, at);
    const curves = sides.flatMap((side) => this.#curves(side, shown.length > 1));
    for (const { one, at, label } of sides) {
      const graded = one.report.steps[at].subsurface?.[this.#body];
      if (!graded?.yield_stress) continue;
      curves.push({
        label: shown.length > 1 ? `${label}: yield stress` : 'yield stress',
        colour: shown.length > 1 ? one.colour : '--yield',
        dash: [6, 3],
        dashed: true,
        x: graded.depth,
        y: graded.yield_stress,
      });
    }
    if (profile?.initial_sigma_x && shown.length === 1)
      curves.push({
        label: `${nameOf('sigma_x', first.report.analysis)} before the load`,
        colour: COMPONENTS.sigma_x.colour,
        dash: [8, 3, 2, 3],
        dashed: true,
        x: profile.depth,
        y: profile.initial_sigma_x,
      });
    const [stress, length] = [unit('stress', units), unit('length', units)];
    if (shown.length === 1 && profile && step.hertz && step.hertz.half_width > 0)
      curves.push(...this.#elastic(first, at, profile.depth));
    this.chart.show({
      x: `depth  [${length}]`,
      y: `stress  [${stress}]`,
      right: curves.some(({ right }) => right) ? 'plastic strain' : undefined,
      curves,
      // Where the load is taken away, the zone is as wide as under the largest one.
      range: [0, 4 * (step.contact.half_width || widest(first)) || 1],
      marks: this.#strengths(shown),
      words: profile
        ? `Under the peak of the ${this.#body} body: highest von Mises stress ${figure(Math.max(...profile.von_mises))} ${stress}, at a depth of ${figure(
            profile.depth[profile.von_mises.indexOf(Math.max(...profile.von_mises))],
            3,
          )} ${length}.`
        : `The ${this.#body} body is rigid.`,
    });
  }

  /**
   * The yield stress of the body in every job, each once; where it is not that of all, in the colours of the jobs. One that varies over depth
   * is a curve of its own.
   * @param {Shown[]} shown @returns {import('./chart.js').Mark[]}
   */
  #strengths(shown) {
    const all = shown.flatMap(({ job, report, colour }) => {
      const material = job[this.#body]?.material;
      const at = (yieldStress(material) ?? 0) * factor('stress', unitsOf(job), report.units);
      const text = `${yieldName(material)} ${figure(at, 4)} ${unit('stress', report.units)}`;
      return at && overDepthOf(material) === 'uniform'
        ? [{ across: /** @type {const} */ ('y'), at, text, colour }]
        : [];
    });
    const distinct = all.filter(({ text }, k) => all.findIndex((one) => one.text === text) === k);
    const common = distinct.length === 1 && all.length === shown.length;
    return common ? distinct.map((one) => ({ ...one, colour: '--yield' })) : distinct;
  }

  /** What the stresses would be without yield. @param {Shown} shown @param {number} at @param {number[]} depths @returns {import('./chart.js').Curve[]} */
  #elastic({ job, report }, at, depths) {
    const { hertz } = report.steps[at];
    if (!hertz) return [];
    const ratio = Number(job[this.#body]?.material?.poisson_ratio);
    const before = hasInitialStress(job[this.#body]?.material);
    const stresses = elasticStresses(depths, hertz, ratio, report.analysis);
    return [...this.#chosen].flatMap((component) =>
      component === 'equivalent_plastic_strain'
        ? []
        : [
            {
              label: `${nameOf(component, report.analysis)}, ${before ? 'Hertz alone' : 'elastic'}${isDented(report, at) ? ', undented' : ''}`,
              colour: COMPONENTS[component].colour,
              dash: [2, 3],
              dashed: true,
              x: depths,
              y: stresses[component],
            },
          ],
    );
  }

  /** @param {import('./loads.js').Beside} side @param {boolean} named @returns {import('./chart.js').Curve[]} */
  #curves({ one, at, label }, named) {
    const profile = one.report.steps[at].subsurface?.[this.#body];
    if (!profile) return [];
    // Without plastic strain there is nothing to scale an axis by.
    const there = [...this.#chosen].filter(
      (component) => component !== 'equivalent_plastic_strain' || profile[component].some((value) => value > 0),
    );
    return there.map((component, k) => {
      const { colour } = COMPONENTS[component];
      const name = nameOf(component, one.report.analysis);
      return {
        label: named ? `${label}: ${name}` : name,
        colour: named ? one.colour : colour,
        dash: named ? one.dash : undefined,
        width: named ? WIDTHS[k] : undefined,
        x: profile.depth,
        y: profile[component],
        right: component === 'equivalent_plastic_strain',
      };
    });
  }
}
