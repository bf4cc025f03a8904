/**
 * Stresses over depth below the middle of the contact or below the peak pressure, of the
 * components one chooses, with the yield stress marked.
 */

import { h } from '../lib/dom.js';
import { nameOf as nameOfQuantity } from '../field/quantities.js';
import { factor, figure, percent, unit, unitsOf } from '../lib/units.js';
import { hasInitialStress, overDepthOf, yieldName, yieldStress } from '../setup/fields.js';
import { symbol } from '../setup/entry.js';
import { governing, orMiddle } from './answers.js';
import { axesOf } from './axes.js';
import { Chart } from './chart.js';
import { elasticStresses } from './elastic.js';
import { abscissaOf } from './extent.js';
import { beside, isDented, isResidual } from './loads.js';
import { Panel, segments } from './panel.js';
import { hertzIn, peakIn, valueIn, widthIn } from './rows.js';

/** @typedef {import('../shown.js').Shown} Shown */
/**
 * @typedef {'von_mises' | 'tau_max' | 'sigma_x' | 'sigma_y' | 'sigma_z' |
 *   'equivalent_plastic_strain' | 'utilization'} Component
 */

/**
 * `name`: where the field calls it otherwise.
 * @type {Record<Component, {name?: string, colour: string}>}
 */
const COMPONENTS = {
  von_mises: { name: 'von Mises', colour: '--curve-1' },
  tau_max: { name: 'τmax', colour: '--curve-2' },
  sigma_x: { colour: '--curve-3' },
  sigma_y: { colour: '--curve-4' },
  sigma_z: { colour: '--curve-5' },
  equivalent_plastic_strain: { colour: '--curve-6' },
  utilization: { name: 'utilization', colour: '--curve-6' },
};
/** Those that are no stresses: of them one has the second ordinate. @type {Component[]} */
const RIGHT = ['equivalent_plastic_strain', 'utilization'];
/**
 * What is shown unless one chooses: under a load, where strength varies over depth, and when the
 * load is gone.
 * @type {Record<string, Component[]>}
 */
const USUAL = {
  loaded: ['von_mises', 'tau_max', 'equivalent_plastic_strain'],
  graded: ['von_mises', 'tau_max', 'utilization'],
  unloaded: ['sigma_x', 'sigma_z', 'equivalent_plastic_strain'],
};

/** Lines of components, where colours and dashes tell jobs apart. */
const WIDTHS = [1.75, 0.9, 2.75, 0.5, 3.5, 1.3];

/**
 * Depth of the hardened case of a body.
 * @param {import('../types.js').Job} job
 * @param {'upper' | 'lower'} body
 * @param {import('../types.js').Report['units']} units shown
 * @returns {number | undefined}
 */
function caseDepth(job, body, units) {
  const depth = job[body]?.material?.plasticity?.over_depth?.hardness?.case_depth;
  return typeof depth === 'number' ? depth * factor('length', unitsOf(job), units) : undefined;
}

/**
 * Where a profile over depth lies.
 * @param {import('../types.js').Step} step
 * @param {import('../types.js').Report} report
 * @param {import('../types.js').Profile | null | undefined} profile
 */
function belowWords(step, report, profile) {
  const [at, aside] = profile?.position ?? [peakIn(step)];
  if (aside !== undefined) {
    const axes = axesOf(step);
    const [x, y] = [
      orMiddle(at, widthIn(step)),
      orMiddle(aside, valueIn(step, 'semi_axis_b') ?? 0),
    ];
    const places = [`${axes.x.name} = ${figure(axes.x.sign * x || 0, 3)}`];
    if (y) places.push(`${axes.y.name} = ${figure(axes.y.sign * y, 3)}`);
    return `at ${places.join(', ')}${x || y ? ` ${unit('length', report.units)}` : ''}`;
  }
  const name = abscissaOf(step, report.analysis === 'axisymmetric');
  const where = figure(at, 3);
  return name === 'along the arc'
    ? `at ${where} ${unit('length', report.units)} along the arc`
    : `at ${name} = ${where}${at === 0 ? '' : ` ${unit('length', report.units)}`}`;
}

/** Largest half-width of all steps. @param {Shown} shown */
const widest = ({ report }) => Math.max(...report.steps.map(widthIn));

/** @param {Component} component @param {string} analysis */
const nameOf = (component, analysis) =>
  COMPONENTS[component].name ??
  nameOfQuantity(/** @type {import('../field/quantities.js').Quantity} */ (component), analysis);

/**
 * The same with its index below the line.
 * @param {Component} component
 * @param {string} analysis
 */
const labelOf = (component, analysis) =>
  symbol(nameOf(component, analysis).replace(/^([στ])(\w+)$/u, '$1_$2'));

export class DepthPanel {
  /** @type {'upper' | 'lower'} */
  #body = 'lower';
  /**
   * Which line is shown where the peak pressure is beside the middle.
   * @type {'subsurface' | 'subsurface_below_peak'}
   */
  #line = 'subsurface';
  #chosen = new Set(USUAL.loaded);
  /** Whether somebody has chosen the components. */
  #touched = false;
  /** The job at whose governing place the panel has opened. */
  #aimed = '';
  /** @type {[Shown[], number] | undefined} */
  #shown;

  constructor() {
    this.chart = new Chart(290);
    this.bodies = segments('Body', { lower: 'Lower', upper: 'Upper' }, (body) => {
      this.#body = /** @type {'upper' | 'lower'} */ (body);
      this.#again();
    });
    this.lines = segments(
      'Line',
      { subsurface: 'Middle', subsurface_below_peak: 'Peak' },
      (line) => {
        this.#line = /** @type {'subsurface' | 'subsurface_below_peak'} */ (line);
        this.#again();
      },
    );
    this.chips = h('div', { class: 'chips', role: 'group', 'aria-label': 'Components' });
    this.panel = new Panel('depth', 'Stress over depth', [this.chips, this.chart.element], {
      controls: [this.lines, this.bodies],
      chart: this.chart,
    });
  }

  /** @param {string} analysis @param {boolean} graded */
  #offer(analysis, graded) {
    const all = /** @type {Component[]} */ (Object.keys(COMPONENTS)).filter(
      (one) => graded || one !== 'utilization',
    );
    const made = `${analysis} ${graded} ${[...this.#chosen].sort()}`;
    if (this.chips.dataset.made === made) return;
    this.chips.dataset.made = made;
    const had = document.activeElement
      ?.closest('[data-component]')
      ?.getAttribute('data-component');
    this.chips.replaceChildren(
      ...all.map((component) =>
        h(
          'label',
          { 'data-component': component },
          h('input', {
            type: 'checkbox',
            checked: this.#chosen.has(component),
            onchange: () => this.#choose(component),
          }),
          h('span', {}, labelOf(component, analysis)),
        ),
      ),
    );
    /** @type {HTMLElement | null} */ (
      this.chips.querySelector(`[data-component="${had}"] input`)
    )?.focus();
  }

  /** @param {Component} component */
  #choose(component) {
    this.#touched = true;
    if (!this.#chosen.delete(component)) {
      if (RIGHT.includes(component)) for (const one of RIGHT) this.#chosen.delete(one);
      this.#chosen.add(component);
    }
    this.#again();
  }

  /** Whether the line beside the middle is shown. @param {import('../types.js').Step} step */
  #isBeside(step) {
    return this.#line === 'subsurface_below_peak' && step.subsurface_below_peak !== undefined;
  }

  /** The line that is shown. @param {import('../types.js').Step} step */
  #profile(step) {
    return (this.#isBeside(step) ? step.subsurface_below_peak : step.subsurface)?.[this.#body];
  }

  #again() {
    if (this.#shown) this.show(...this.#shown);
  }

  /** Opens at the body and the line that are nearest to what the sentence is about. @param {import('../types.js').Step} step */
  #aim(step) {
    const { subsurface: middle, subsurface_below_peak: peak } = step;
    const place = governing(step)?.place;
    if (!place) return;
    this.#body = place.body === 'upper' ? 'upper' : 'lower';
    const far = (/** @type {import('../types.js').Profile | null | undefined} */ line) => {
      const [x = 0, y = 0] = line?.position ?? [];
      return Math.hypot(place.x - x, (place.y ?? 0) - y);
    };
    const nearer = peak && far(peak[this.#body]) < far(middle?.[this.#body]);
    this.#line = nearer ? 'subsurface_below_peak' : 'subsurface';
    for (const [choice, value] of /** @type {const} */ ([
      [this.bodies, this.#body],
      [this.lines, this.#line],
    ]))
      for (const input of choice.querySelectorAll('input')) input.checked = input.value === value;
  }

  /** @param {Shown[]} shown @param {number} at step of the first */
  show(shown, at) {
    this.#shown = [shown, at];
    const [first] = shown;
    const step = first.report.steps[at];
    const { units } = first.report;
    if (this.#aimed !== first.id) this.#aim(step);
    this.#aimed = first.id;
    const profile = this.#profile(step);
    this.lines.hidden = step.subsurface_below_peak === undefined;
    const graded = shown.some(({ report }) =>
      report.steps.some(
        ({ subsurface }) => subsurface?.upper?.utilization || subsurface?.lower?.utilization,
      ),
    );
    if (!this.#touched)
      this.#chosen = new Set(USUAL[isResidual(step) ? 'unloaded' : graded ? 'graded' : 'loaded']);
    if (!graded && this.#chosen.delete('utilization'))
      this.#chosen.add('equivalent_plastic_strain');
    this.#offer(first.report.analysis, graded);
    this.panel.show(step.subsurface !== undefined);
    if (!step.subsurface) return;
    const sides = beside(shown, at);
    const belowOf = (/** @type {Shown} */ { report }, /** @type {number} */ at) =>
      belowWords(report.steps[at], report, this.#profile(report.steps[at]));
    const below = belowOf(first, at);
    const alike = sides.every(({ one, at }) => belowOf(one, at) === below);
    const curves = sides.flatMap((side) => this.#curves(side, shown.length > 1));
    for (const { one, at, label } of sides) {
      const graded = this.#profile(one.report.steps[at]);
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
    for (const component of /** @type {const} */ (['sigma_x', 'sigma_z'])) {
      const before = profile?.[`initial_${component}`];
      // Under a load σ_z is seldom what one looks at.
      const isSeen = component === 'sigma_x' || isResidual(step);
      if (profile && before && isSeen && shown.length === 1)
        curves.push({
          label: `${nameOf(component, first.report.analysis)} before the load`,
          colour: COMPONENTS[component].colour,
          dash: [8, 3, 2, 3],
          dashed: true,
          x: profile.depth,
          y: before,
        });
    }
    const [stress, length] = [unit('stress', units), unit('length', units)];
    // Ellipses have no closed form here.
    const isClosed = first.report.analysis !== 'three_dimensional' && !this.#isBeside(step);
    if (shown.length === 1 && profile && hertzIn(step) && isClosed && !step.passes)
      curves.push(...this.#elastic(first, at, profile.depth));
    this.chart.show({
      x: `depth ${alike ? below : 'at places of their own'}  [${length}]`,
      y: `stress  [${stress}]`,
      right: curves.some(({ right }) => right)
        ? this.#chosen.has('utilization')
          ? 'von Mises over yield stress'
          : 'plastic strain'
        : undefined,
      curves,
      // Where the load is taken away, the zone is as wide as under the largest one.
      range: [0, 4 * (widthIn(step) || widest(first)) || 1],
      marks: [
        ...this.#strengths(shown),
        ...(shown.length === 1 ? this.#case(first, profile) : []),
      ],
      words: profile
        ? `In the ${this.#body} body, ${below}: highest von Mises stress ${figure(Math.max(...profile.von_mises))} ${stress}, at a depth of ${figure(
            profile.depth[profile.von_mises.indexOf(Math.max(...profile.von_mises))],
            3,
          )} ${length}.`
        : `The ${this.#body} body is rigid.`,
    });
  }

  /**
   * The yield stress of the body in every job, each once; where it is not that of all, in the
   * colours of the jobs. One that varies over depth is a curve of its own.
   * @param {Shown[]} shown @returns {import('./chart-svg.js').Mark[]}
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

  /**
   * How deep the case is, and where the strength is used most.
   * @param {Shown} one
   * @param {import('../types.js').Profile | null | undefined} profile
   * @returns {import('./chart-svg.js').Mark[]}
   */
  #case({ job, report }, profile) {
    const [at, used] = [caseDepth(job, this.#body, report.units), profile?.utilization];
    const most = used ? Math.max(...used) : 0;
    return [
      ...(at === undefined
        ? []
        : [{ across: /** @type {const} */ ('x'), at, text: 'case depth' }]),
      ...(profile && used && this.#chosen.has('utilization')
        ? [
            {
              across: /** @type {const} */ ('x'),
              at: profile.depth[used.indexOf(most)],
              text: `utilization ${percent(most, 3)}`,
            },
          ]
        : []),
    ];
  }

  /**
   * What the stresses would be without yield.
   * @param {Shown} shown
   * @param {number} at
   * @param {number[]} depths
   * @returns {import('./chart-svg.js').Curve[]}
   */
  #elastic({ job, report }, at, depths) {
    const hertz = hertzIn(report.steps[at]);
    if (!hertz) return [];
    const ratio = Number(job[this.#body]?.material?.poisson_ratio);
    const before = hasInitialStress(job[this.#body]?.material);
    const stresses = elasticStresses(depths, hertz, ratio, report.analysis);
    return [...this.#chosen].flatMap((component) =>
      component === 'equivalent_plastic_strain' || component === 'utilization'
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

  /**
   * @param {import('./loads.js').Beside} side
   * @param {boolean} named
   * @returns {import('./chart-svg.js').Curve[]}
   */
  #curves({ one, at, label }, named) {
    const profile = this.#profile(one.report.steps[at]);
    if (!profile) return [];
    // Without plastic strain there is nothing to scale an axis by.
    const there = [...this.#chosen].filter(
      (component) => !RIGHT.includes(component) || profile[component]?.some((value) => value > 0),
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
        y: profile[component] ?? [],
        right: RIGHT.includes(component),
      };
    });
  }
}
