/** A sweep in curves: force over approach, and every figure over the load. */

import { h } from '../lib/dom.js';
import { figure, forceOf, stiffnessOf, unit } from '../lib/units.js';
import { shareOf, unitOf } from './answers.js';
import { Chart } from './chart.js';
import { titleOf } from './figures.js';
import { Panel, segments } from './panel.js';
import { WIDTH, approachIn, forceIn, hasYielded, rowOf } from './rows.js';

/** @typedef {import('../shown.js').Shown} Shown */
/** @typedef {import('../types.js').Step} Step */
/** @typedef {import('../types.js').Report} Report */

/**
 * What is shown over the load. `along`: the same at every increment of a step, where results have
 * it.
 * @typedef {object} OverLoad
 * @property {string} text
 * @property {string[]} names of its row
 * @property {(step: Step, report: Report) => (number | undefined)[] | undefined} [along]
 * @property {number} [rest] before the first load, where that is known
 */

/** @type {Record<string, OverLoad>} */
const OVER_LOAD = {
  peak: {
    text: 'Peak',
    names: ['peak_pressure'],
    along: ({ increments }) => increments?.peak_pressure,
    rest: 0,
  },
  width: {
    text: 'Half-width',
    names: WIDTH,
    along: ({ increments }) => increments?.half_width,
    rest: 0,
  },
  strain: { text: 'Strain', names: ['max_plastic_strain'], rest: 0 },
  stiffness: { text: 'dP/dα', names: ['contact_stiffness'], along: slopesAlong },
};

/**
 * dP/dα at the increments of a step or at its load, from the curve of all of them.
 * @param {Step} step
 * @param {Report} report
 */
function slopesAlong(step, { load_approach: curve }) {
  const ends = step.increments ?? { approach: [approachIn(step)], force: [forceIn(step)] };
  const placeOf = (/** @type {number} */ approach, /** @type {number} */ force) =>
    curve?.approach.findIndex((at, j) => at === approach && curve.force[j] === force) ?? -1;
  return ends.approach.map((approach, k) => curve?.stiffness[placeOf(approach, ends.force[k])]);
}

/**
 * A figure of a step or, where it has none of its own, of the curve there.
 * @param {OverLoad} figures
 * @param {Step} step
 * @param {Report} report
 */
function valueAt({ names, along }, step, report) {
  const row = rowOf(step, ...names);
  return row?.value == null ? along?.(step, report)?.at(-1) : row.value * shareOf(row);
}

export class SweepPanel {
  #kind = 'approach';
  /** @type {[Shown[], number] | undefined} */
  #shown;

  constructor() {
    this.chart = new Chart();
    const kinds = {
      approach: 'Approach',
      ...Object.fromEntries(Object.entries(OVER_LOAD).map(([key, { text }]) => [key, text])),
    };
    const choice = segments('Shown over the load', kinds, (kind) => {
      this.#kind = kind;
      if (this.#shown) this.show(...this.#shown);
    });
    this.words = h('p', { class: 'quiet', role: 'status' });
    this.panel = new Panel('sweep', 'Sweep', [this.chart.element, this.words], {
      controls: [choice],
      chart: this.chart,
    });
  }

  /** @param {Shown[]} shown @param {number} at step of the first */
  show(shown, at) {
    this.#shown = [shown, at];
    const swept = shown.filter(
      ({ report }) => answered(report).length > 1 || (report.load_approach?.force.length ?? 0) > 2,
    );
    this.panel.show(swept.length > 0);
    if (swept.length === 0) return;
    this.words.textContent = leftOut(swept);
    this.chart.show(
      this.#kind === 'approach'
        ? overApproach(swept, shown, at)
        : overLoad(swept, shown, at, OVER_LOAD[this.#kind]),
    );
  }
}

/**
 * Whether the load falls again on a body that has yielded: the curve has a way back of its own.
 * @param {Shown} shown
 */
const turnsBack = ({ job, report: { steps, theory } }) =>
  job.load?.history != null &&
  theory !== 'deformation' &&
  steps.some((step, k) => k > 0 && approachIn(step) < approachIn(steps[k - 1])) &&
  steps.some(hasYielded);

/**
 * Part of the range of forces from which on a piece of a loop has nothing solved that is worth the
 * name.
 */
const FAR = 0.25;

/** Dots, farther apart than those of any job's curve. */
const BETWEEN = { points: false, dash: [1, 6], width: 1.2 };

/**
 * A loop without its long pieces, and these by themselves: unloading is often one increment, and a
 * straight line between its ends is no answer.
 * @param {import('./chart-svg.js').Curve} curve @param {number[]} forces of its points
 * @param {string} why the long pieces are no answers
 * @returns {import('./chart-svg.js').Curve[]}
 */
function apart(curve, forces, why = 'straight between solved loads') {
  const range = Math.max(...forces) - Math.min(...forces);
  const isFar = (/** @type {number} */ k) =>
    k > 0 && Math.abs(forces[k] - forces[k - 1]) > FAR * range;
  const [near, far] = [0, 1].map(() => ({
    x: /** @type {number[]} */ ([]),
    y: /** @type {(number | null)[]} */ ([]),
  }));
  curve.x.forEach((x, k) => {
    if (isFar(k)) {
      near.x.push(x);
      near.y.push(null);
      // Each begins at its lower force: on the way there and on the way back dots lie on dots.
      const [from, to] = forces[k] < forces[k - 1] ? [k, k - 1] : [k - 1, k];
      far.x.push(curve.x[from], curve.x[to], curve.x[to]);
      far.y.push(curve.y[from], curve.y[to], null);
    }
    near.x.push(x);
    near.y.push(curve.y[k]);
  });
  if (far.x.length === 0) return [curve];
  return [
    { ...curve, ...near },
    { ...curve, ...far, ...BETWEEN, label: `${curve.label}, ${why}` },
  ];
}

/** Steps that are answers: others have no place on a curve. @param {Report} report */
const answered = ({ steps }) => steps.filter(({ status }) => status === 'converged');

/** Names the steps that the curves leave out. @param {Shown[]} swept */
const leftOut = (swept) => {
  const many = swept.reduce(
    (sum, { report: { steps } }) =>
      sum + steps.filter(({ status }) => status !== 'converged').length,
    0,
  );
  return many
    ? ` ${many} step${many === 1 ? '' : 's'} that did not converge ${many === 1 ? 'is' : 'are'} left out.`
    : '';
};

/**
 * Where the jobs begin to yield, each once; where that is not the same for all, in the colours of
 * the jobs.
 * @param {Shown[]} swept @param {'x' | 'y'} across @param {string} words of the mark @returns
 *   {import('./chart-svg.js').Mark[]}
 */
function onsets(swept, across, words) {
  const { report } = swept[0];
  const all = swept.flatMap(({ report: { steps }, colour }) => {
    const first = steps.map((step) => rowOf(step, 'first_yield_force')).find(Boolean);
    const at = first?.elastic ?? first?.value;
    return at ? [{ at, colour, figure: figure(at, 4) }] : [];
  });
  const distinct = all.filter(
    ({ figure }, k) => all.findIndex((one) => one.figure === figure) === k,
  );
  const common = distinct.length === 1 && all.length === swept.length;
  return distinct.map(({ at, colour, figure }) => ({
    across,
    at,
    text:
      across === 'y' || !common
        ? `${words} ${figure} ${unit(forceOf(report), report.units)}`
        : words,
    colour: common ? '--yield' : colour,
  }));
}

/**
 * Force over approach in the order of the steps, so that a history shows its loops.
 * @param {Shown[]} swept
 * @param {Shown[]} shown
 * @param {number} at
 * @returns {import('./chart-svg.js').Plot}
 */
function overApproach(swept, shown, at) {
  const [{ report }] = shown;
  const force = unit(forceOf(report), report.units);
  const turns = swept.some(turnsBack);
  const rising = (/** @type {Report} */ report) =>
    answered(report).sort((a, b) => approachIn(a) - approachIn(b));
  return {
    turns,
    x: `α  [${unit('length', report.units)}]`,
    y: `P  [${force}]`,
    curves: swept.flatMap((one) => {
      const { approach, force } = one.report.load_approach ?? { approach: [], force: [] };
      const steps = rising(one.report);
      // Of a history, and of one load, every increment.
      const whole = turns || steps.length < 2;
      const curve = {
        label: shown.length > 1 ? one.label : 'force',
        colour: one.colour,
        dash: one.dash,
        points: true,
        x: whole ? approach : steps.map(approachIn),
        y: whole ? force : steps.map(forceIn),
      };
      return turns ? apart(curve, force) : [curve];
    }),
    marks: [
      ...onsets(swept, 'y', 'first yield, elastic theory'),
      { across: 'x', at: approachIn(report.steps[at]), text: 'shown' },
    ],
    words: `Force over approach, ${report.steps.length} points up to ${figure(Math.max(...report.steps.map(forceIn)))} ${force}.`,
  };
}

/**
 * A figure over the force: of a history at every increment, from the bodies at rest on; else at
 * its loads.
 * @param {Report} report @param {OverLoad} figures @param {boolean} inTurn whether loads have an
 *   order
 * @returns {{x: number[], y: number[]}}
 */
function overForce(report, figures, inTurn) {
  const { along, rest } = figures;
  const value = (/** @type {Step} */ step) => valueAt(figures, step, report) ?? 0;
  const steps = answered(report);
  if ((!inTurn && steps.length > 1) || !steps.every(({ increments }) => increments)) {
    steps.sort((a, b) => forceIn(a) - forceIn(b));
    return { x: steps.map(forceIn), y: steps.map(value) };
  }
  const points = steps.flatMap((step) => {
    const between = along?.(step, report)?.slice(0, -1) ?? [];
    const forces = step.increments?.force ?? [];
    return [
      ...between.flatMap((figure, k) =>
        figure === undefined ? [] : [{ x: forces[k], y: figure }],
      ),
      { x: forceIn(step), y: value(step) },
    ];
  });
  if (rest !== undefined) points.unshift({ x: 0, y: rest });
  return { x: points.map(({ x }) => x), y: points.map(({ y }) => y) };
}

/**
 * @param {Shown[]} swept
 * @param {Shown[]} shown
 * @param {number} at
 * @param {OverLoad} figures
 * @returns {import('./chart-svg.js').Plot}
 */
function overLoad(swept, shown, at, figures) {
  const [{ report }] = shown;
  const { names, along, text } = figures;
  const row = swept
    .flatMap(({ report }) => report.steps.map((step) => rowOf(step, ...names)))
    .find((row) => row?.value != null);
  // Of a history slopes are known at increments alone.
  const [label, name] = row
    ? [titleOf(row), unitOf(row)]
    : [text, unit(stiffnessOf(report), report.units)];
  const force = unit(forceOf(report), report.units);
  // A load that falls on a body that has yielded has a way back of its own.
  const turns = swept.some(turnsBack);
  return {
    turns,
    x: `P  [${force}]`,
    y: `${label}  [${name}]`,
    curves: swept.flatMap((one) => {
      const curve = {
        label: shown.length > 1 ? one.label : label,
        colour: one.colour,
        dash: one.dash,
        points: true,
        ...overForce(one.report, figures, turns),
      };
      return turns
        ? apart(curve, curve.x, along ? undefined : 'known at the ends of loads alone')
        : [curve];
    }),
    marks: [
      ...onsets(swept, 'x', 'first yield'),
      { across: 'x', at: forceIn(report.steps[at]), text: 'shown' },
    ],
    words: `${label} over force, ${report.steps.length} points, at the step shown ${figure(valueAt(figures, report.steps[at], report))} ${name}.`,
  };
}
