/** The charts of a load that rolls: what each pass does, the groove, and what the track bears. */

import { figure, unit } from '../lib/units.js';
import { Chart } from './chart.js';
import { Panel } from './panel.js';
import { rowOf, valueIn } from './rows.js';

/** @typedef {import('../shown.js').Shown} Shown */
/** @typedef {import('../types.js').Step} Step */
/** @typedef {NonNullable<Step['passes']>} Passes */
/** @typedef {{of: string, name: string, dash?: number[]}} Line of every body: the name of a row */

const COLOURS = { upper: '--curve-2', lower: '--curve-1' };
const DASH = [7, 3];

/** Figures of each body over passes. @param {Passes} passes @param {Line[]} lines @param {number} share by which they are multiplied @returns {import('./chart-svg.js').Curve[]} */
const overPasses = (passes, lines, share) =>
  /** @type {const} */ (['lower', 'upper']).flatMap((side) =>
    lines.flatMap(({ of, name, dash }) => {
      const y = passes[side][of]?.value.map((value) => value * share);
      return y
        ? [
            {
              label: `${side}, ${name}`,
              colour: COLOURS[side],
              dash,
              points: true,
              x: passes.number,
              y,
            },
          ]
        : [];
    }),
  );

/** The last values of curves in words. @param {Passes} passes @param {import('./chart-svg.js').Curve[]} curves @param {string} of their unit */
const lastWords = ({ number }, curves, of) =>
  `${number.length} passes: ${curves
    .map(({ label, y }) => `${figure(y.at(-1) ?? 0, 3)} ${of} (${label})`)
    .join(', ')}.`;

/** Strains of every pass; logarithms have no place for 0. @param {Passes} passes @returns {import('./chart-svg.js').Plot} */
function strains(passes) {
  const lines = [
    { name: 'accumulated', of: 'pass_strain' },
    { name: 'net', of: 'net_strain', dash: DASH },
  ];
  const curves = overPasses(passes, lines, 100).flatMap((curve) => {
    const y = curve.y.map((value) => value || null);
    return y.some(Boolean) ? [{ ...curve, y }] : [];
  });
  const words = lastWords(passes, curves, '%');
  return { x: 'pass', y: 'strain of a pass  [%]', log: true, curves, words };
}

/** The groove and what rises beside it. @param {Passes} passes @param {Shown['report']} report @returns {import('./chart-svg.js').Plot} */
function groove(passes, { units, mesh }) {
  const length = unit('length', units);
  const lines = [
    { name: 'groove', of: 'track_depth' },
    ...(mesh.cells?.[1] === 1 ? [] : [{ name: 'pile-up', of: 'pile_up', dash: DASH }]),
  ];
  const curves = overPasses(passes, lines, 1);
  const words = lastWords(passes, curves, length);
  return { x: 'pass', y: `depth of the track  [${length}]`, curves, words };
}

/** Names of the limits over friction. */
const LIMITS = /** @type {const} */ ({
  elastic: ['first yield', '--curve-3', [2, 3]],
  perfect: ['shakedown, perfectly plastic', '--curve-1', undefined],
  kinematic: ['shakedown, kinematic hardening', '--curve-4', DASH],
});

/** Limits over friction, and where this job is. @param {Passes} _passes @param {Shown['report']} _report @param {Step} step @returns {import('./chart-svg.js').Plot} */
function map(_passes, _report, step) {
  const { shakedown } = step;
  const [k, friction] = [
    valueIn(step, 'shear_yield_stress') ?? NaN,
    valueIn(step, 'friction') ?? 0,
  ];
  const here = (rowOf(step, 'peak_pressure')?.elastic ?? NaN) / k;
  const x = shakedown?.friction ?? [];
  const curves = /** @type {(keyof typeof LIMITS)[]} */ (Object.keys(LIMITS)).map((key) => {
    const [label, colour, dash] = LIMITS[key];
    const y = (shakedown?.[key] ?? []).map((pressure) => pressure && pressure / k);
    const points = y.filter(Boolean).length === 1;
    return { label, colour, dash: dash && [...dash], x, y, points };
  });
  return {
    x: 'friction |μ|',
    y: 'Hertz’s peak over k',
    curves: [
      ...curves,
      { label: 'this job', colour: '--curve-2', x: [Math.abs(friction)], y: [here], points: true },
    ],
    words: `This job is at μ ${friction} and ${figure(here, 3)} k.`,
  };
}

const CHARTS = { passes: strains, groove, shakedown: map };
/** @type {Record<keyof typeof CHARTS, string>} */
const TITLES = { passes: 'Passes', groove: 'Groove', shakedown: 'Shakedown map' };

class PassesPanel {
  /** @param {keyof typeof CHARTS} kind */
  constructor(kind) {
    this.kind = kind;
    this.chart = new Chart(260);
    this.panel = new Panel(kind, TITLES[kind], [this.chart.element], {
      chart: this.chart,
    });
  }

  /** @param {Shown[]} shown @param {number} at step of the first */
  show([{ report }], at) {
    const step = report.steps[at];
    const { passes, shakedown } = step;
    const seen = this.kind === 'shakedown' ? shakedown?.friction : passes?.number;
    this.panel.show(Boolean(passes && seen?.length));
    if (passes && seen?.length) this.chart.show(CHARTS[this.kind](passes, report, step));
  }
}

/** A panel for each chart. */
export const passesPanels = () =>
  /** @type {(keyof typeof CHARTS)[]} */ (Object.keys(CHARTS)).map(
    (kind) => new PassesPanel(kind),
  );
