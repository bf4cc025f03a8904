/** The charts of a load that rolls: what each pass does, the groove, and what the track bears. */

import { figure, unit } from '../lib/units.js';
import { Chart } from './chart.js';
import { Panel } from './panel.js';

/** @typedef {import('../shown.js').Shown} Shown */
/** @typedef {import('../types.js').Step} Step */
/** @typedef {NonNullable<Step['rolling']>} Rolling */
/** @typedef {NonNullable<Rolling['passes'][number]['bodies']['lower']>} Body */
/** @typedef {{of: (body: Body) => number, name: string, dash?: number[]}} Line of every body */

const COLOURS = { upper: '--curve-2', lower: '--curve-1' };
const DASH = [7, 3];

/** Figures of each body over passes; logarithms have no place for 0. @param {Rolling} rolling @param {Line[]} lines @param {boolean} log @returns {import('./chart-svg.js').Curve[]} */
const overPasses = ({ passes }, lines, log) =>
  /** @type {const} */ (['lower', 'upper']).flatMap((side) =>
    lines.flatMap(({ of, name, dash }) => {
      const y = passes.map(({ bodies: { [side]: body } }) => (body ? of(body) : null));
      const seen = log ? y.map((value) => value || null) : y;
      return seen.some((value) => value !== null)
        ? [
            {
              label: `${side}, ${name}`,
              colour: COLOURS[side],
              dash,
              points: true,
              x: passes.map(({ number }) => number),
              y: seen,
            },
          ]
        : [];
    }),
  );

/** The last values of curves in words. @param {Rolling} rolling @param {import('./chart-svg.js').Curve[]} curves @param {string} of their unit */
const lastWords = ({ passes }, curves, of) =>
  `${passes.length} passes: ${curves
    .map(({ label, y }) => `${figure(y.at(-1) ?? 0, 3)} ${of} (${label})`)
    .join(', ')}.`;

/** Strains of every pass. @param {Rolling} rolling @returns {import('./chart-svg.js').Plot} */
function strains(rolling) {
  const curves = overPasses(
    rolling,
    [
      { name: 'accumulated', of: ({ largest_strain }) => 100 * largest_strain },
      { name: 'net', of: ({ net_strain }) => 100 * net_strain, dash: DASH },
    ],
    true,
  );
  const words = lastWords(rolling, curves, '%');
  return { x: 'pass', y: 'strain of a pass  [%]', log: true, curves, words };
}

/** The groove and what rises beside it. @param {Rolling} rolling @param {Shown['report']} report @returns {import('./chart-svg.js').Plot} */
function groove(rolling, { units }) {
  const length = unit('length', units);
  const beside = { name: 'pile-up', of: (/** @type {Body} */ body) => body.pile_up, dash: DASH };
  const curves = overPasses(
    rolling,
    [
      { name: 'groove', of: ({ groove_depth }) => groove_depth },
      ...(rolling.rows > 1 ? [beside] : []),
    ],
    false,
  );
  const words = lastWords(rolling, curves, length);
  return { x: 'pass', y: `depth of the track  [${length}]`, curves, words };
}

/** Names of the limits over friction. */
const LIMITS = /** @type {const} */ ({
  elastic_pressure: ['first yield', '--curve-3', [2, 3]],
  perfect_pressure: ['shakedown, perfectly plastic', '--curve-1', undefined],
  kinematic_pressure: ['shakedown, kinematic hardening', '--curve-4', DASH],
});

/** Limits over friction, and where this job is. @param {Rolling} rolling @param {Shown['report']} report @returns {import('./chart-svg.js').Plot} */
function map(
  { limits: { over_friction = [], shear_yield_stress }, friction = 0 },
  { steps: [{ hertz }] },
) {
  const k = shear_yield_stress ?? NaN;
  const here = (hertz?.peak_pressure ?? NaN) / k;
  const x = over_friction.map((one) => one.friction);
  const curves = /** @type {(keyof typeof LIMITS)[]} */ (Object.keys(LIMITS)).map((key) => {
    const [label, colour, dash] = LIMITS[key];
    const y = over_friction.map(({ [key]: pressure }) => pressure && pressure / k);
    return {
      label,
      colour,
      dash: dash && [...dash],
      x,
      y,
      points: y.filter(Boolean).length === 1,
    };
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
    const { rolling } = report.steps[at];
    const seen =
      rolling && (this.kind === 'shakedown' ? rolling.limits.over_friction : rolling.passes);
    this.panel.show(Boolean(seen?.length));
    if (rolling && seen?.length) this.chart.show(CHARTS[this.kind](rolling, report));
  }
}

/** A panel for each chart. */
export const passesPanels = () =>
  /** @type {(keyof typeof CHARTS)[]} */ (Object.keys(CHARTS)).map(
    (kind) => new PassesPanel(kind),
  );
