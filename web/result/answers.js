/**
 * The figures that answer a job at one step, with error bar and elastic theory: for the cards of
 * the page and for the report.
 */

import { nameOf } from '../field/quantities.js';
import { exact, factor, figure, forceOf, percent, unit, unitsOf } from '../lib/units.js';
import { same } from '../lib/pointer.js';
import { abscissaOf } from './extent.js';
import { TARGETS } from '../setup/fields.js';
import { isDented, workPutIn } from './loads.js';
import { STEP_FIGURES, barOf, strainOf, titleOf } from './step-figures.js';

/** @typedef {import('../types.js').Step} Step */
/** @typedef {import('../types.js').Report} Report */
/** @typedef {import('../types.js').Job} Job */
/**
 * @typedef {object} Answer
 * @property {string} name
 * @property {number} value
 * @property {string} unit
 * @property {number} [error] relative bound of the error of the mesh
 * @property {number} [elastic] the same by elastic theory
 * @property {boolean} [undented] whether that is of bodies that have not been dented before
 * @property {string} note
 * @property {string} [long] what stands on a card that has no room for the note
 */

/**
 * The figures of a step in the order of what was asked: the force that was looked for, the onset
 * of yield, what a load has left that is taken away, the strength that is used up; then those of
 * the contact, of which the ones that are 0 come last.
 * @param {Job} job @param {Report} report @param {Step} step @returns {Answer[]}
 */
export function answersOf(job, report, step) {
  const asked = [...forceFound(report), ...firstYield(job, report, step)];
  const used = utilizations(job, report, step);
  if (isUnloaded(step)) {
    const left = [...leftBehind(job, report, step), ...residualStress(job, report, step), ...used];
    const contact = contactFigures(report, step).filter(({ value }) => value !== 0);
    return [...asked, ...zerosLast([...left, ...contact])];
  }
  const contact = [...contactFigures(report, step), ...shakedown(report, step)];
  return [...asked, ...used, ...zerosLast(contact)];
}

/** @param {Answer[]} answers */
const zerosLast = (answers) => [
  ...answers.filter(({ value }) => value !== 0),
  ...answers.filter(({ value }) => value === 0),
];

/** Whether the load is taken away. @param {Step} step */
export const isUnloaded = ({ contact, flow }) => contact.force === 0 && flow !== undefined;

/**
 * In place of the largest plastic strain, where that has no limit.
 * @type {import('./step-figures.js').StepFigure}
 */
const MEAN_STRAIN = {
  title: 'mean plastic strain',
  unit: () => '%',
  value: ({ plasticity: { upper, lower } }) =>
    100 *
    Math.max(
      upper?.mean_equivalent_plastic_strain ?? 0,
      lower?.mean_equivalent_plastic_strain ?? 0,
    ),
};

/** Figures of the contact. @param {Report} report @param {Step} step @returns {Answer[]} */
function contactFigures(report, step) {
  const { contact, hertz } = step;
  const loaded = contact.force > 0;
  const onset = hertz?.yield_onset_force;
  // Without load there is no contact and no figure of Hertz's theory.
  const elastic = loaded ? hertz : undefined;
  const { width, mean } = widthWords(contact);
  const undented = isDented(report, report.steps.indexOf(step));
  const first = undented ? 'first yield before any dent' : 'first yield';
  const { peak, width: wide, mean: average, force, strain, stiffness } = STEP_FIGURES;
  const zone = zoneWords(step, unit('length', report.units));
  return [
    { ...described(peak, report, step), elastic: elastic?.peak_pressure, undented },
    // Heights touch here and there up to the rim.
    ...(step.three_dimensional?.surface
      ? []
      : [
          {
            ...described(wide, report, step),
            elastic: elastic?.half_width,
            undented,
            note: width,
          },
        ]),
    ...ofRoller(report, step),
    ...ofHeights(report, step),
    ...(step.three_dimensional?.surface ? [] : longerAxis(report, step)),
    // Without load it is what a load has left.
    ...(isUnloaded(step) ? [] : [approach(report, step)]),
    {
      ...described(force, report, step),
      note: onset
        ? `${figure(contact.force / onset, 3)} × ${first} by elastic theory, ${figure(onset, 4)}`
        : '',
    },
    {
      ...described(average, report, step),
      elastic: elastic ? meanOf(elastic, report.analysis === 'axisymmetric') : undefined,
      undented,
      note: mean,
    },
    {
      ...described(strainOf(step) === undefined ? MEAN_STRAIN : strain, report, step),
      note: zone,
    },
    ...(typeof stiffness.value(step) !== 'number'
      ? []
      : [{ ...described(stiffness, report, step), note: 'dP/dα, slope of load over approach' }]),
    ...(step.flow
      ? [
          {
            name: 'Unloading stiffness',
            value: step.flow.unloading_stiffness,
            unit: stiffness.unit(report),
            note: 'dP/dα where the load begins to fall',
          },
        ]
      : []),
  ];
}

/**
 * Figures of the ends of a roller.
 * @param {Report} report
 * @param {Step} step
 * @returns {Answer[]}
 */
function ofRoller(report, { three_dimensional: ellipse, contact }) {
  const roller = ellipse?.roller;
  if (!roller || contact.force === 0) return [];
  const edge = Math.max(...roller.end_pressure);
  const tilted = Math.abs(roller.moment) > 1e-6 * contact.force * ellipse.b;
  return [
    {
      name: 'Edge pressure',
      value: edge,
      unit: unit('stress', report.units),
      note:
        edge > 0
          ? `${figure(edge / roller.middle_pressure, 3)} of that in the middle`
          : 'the contact ends before the roller',
    },
    ...(tilted
      ? [
          {
            name: 'Moment',
            value: roller.moment,
            unit: unit('energy', report.units),
            note: 'about the middle, positive towards y',
          },
          {
            name: 'Tilt',
            value: roller.tilt,
            unit: 'mrad',
            note: 'positive closer at positive y',
          },
        ]
      : []),
  ];
}

/**
 * Figures of the contact of a rough surface.
 * @param {Report} report
 * @param {Step} step
 * @returns {Answer[]}
 */
function ofHeights(report, { three_dimensional: ellipse }) {
  const rough = ellipse?.surface;
  if (!rough) return [];
  const plastic = rough.plastic_part;
  return [
    {
      name: 'Real contact area',
      value: 100 * rough.contact_ratio,
      unit: '%',
      note: 'of the area of the heights',
    },
    ...(plastic === undefined
      ? []
      : [
          {
            name: 'Area that yields',
            value: 100 * plastic,
            unit: '%',
            note: 'below which a body has yielded',
          },
        ]),
    {
      name: 'Nominal pressure',
      value: rough.nominal_pressure,
      unit: unit('stress', report.units),
      note: 'force over the area of the heights',
    },
  ];
}

/** @param {Report} report @param {Step} step @returns {Answer[]} */
const longerAxis = (report, { three_dimensional: ellipse }) =>
  ellipse
    ? [
        {
          name: 'Longer semi-axis',
          value: ellipse.b,
          unit: unit('length', report.units),
          error: ellipse.estimated_error?.b ?? undefined,
          elastic: ellipse.hertz?.b,
          note: '',
        },
      ]
    : [];

/**
 * @param {import('./step-figures.js').StepFigure} one
 * @param {Report} report
 * @param {Step} step
 * @returns {Answer}
 */
function described(one, report, step) {
  const title = titleOf(one, report);
  return {
    name: title[0].toUpperCase() + title.slice(1),
    value: one.value(step) ?? 0,
    unit: one.unit(report),
    error: one.bar && barOf(step, one.bar),
    note: '',
  };
}

/** @param {Report} report @param {Step} step @returns {Answer} */
function approach(report, step) {
  const answer = described(STEP_FIGURES.approach, report, step);
  return {
    ...answer,
    name: isUnloaded(step) ? 'Permanent approach' : answer.name,
    note: step.approach_datum,
    long: report.analysis === 'three_dimensional' ? 'of half-spaces' : 'between the supports',
  };
}

/** @param {Report} report @returns {Answer[]} */
const forceFound = (report) =>
  report.target
    ? [
        {
          name: 'Force found',
          value: report.target.force,
          unit: unit(forceOf(report), report.units),
          error: report.target.relative_error ?? undefined,
          note: targetWords(report),
        },
      ]
    : [];

/** @param {Job} job @param {Report} report @param {Step} step @returns {Answer[]} */
const firstYield = (job, report, { yield_onset: onset }) =>
  onset
    ? [
        {
          name: 'First yield',
          value: onset.force,
          unit: unit(forceOf(report), report.units),
          note: `on this mesh, in ${same(job.upper, job.lower) ? 'both bodies' : `the ${onset.body} body`}, ${figure(onset.depth, 3)} ${unit('length', report.units)} deep`,
        },
      ]
    : [];

/**
 * The pressure up to which the contact shakes down.
 * @param {Report} report
 * @param {Step} step
 * @returns {Answer[]}
 */
function shakedown(report, { hertz }) {
  const limit = hertz?.shakedown_pressure;
  return limit
    ? [
        {
          name: 'Shakedown pressure',
          value: limit,
          unit: unit('stress', report.units),
          note: `when it rolls freely, by elastic theory; Hertz’s peak is ${figure(hertz.peak_pressure / limit, 3)} of it`,
        },
      ]
    : [];
}

/** Bodies that have a profile over depth, two alike as one. @param {Job} job @param {Step} step */
const profilesOf = (job, { subsurface, subsurface_below_peak: beside }) =>
  (same(job.upper, job.lower)
    ? /** @type {const} */ (['lower'])
    : /** @type {const} */ (['upper', 'lower'])
  ).flatMap((body) => {
    const profiles = [subsurface?.[body], beside?.[body]].filter(
      (profile) => profile !== undefined && profile !== null,
    );
    return profiles.length > 0 ? [{ body, profiles }] : [];
  });

/** @param {Job} job @param {string} body */
const bodyWords = (job, body) => (same(job.upper, job.lower) ? 'both bodies' : `${body} body`);

/**
 * Where a strength that varies over depth is used most, and most below the case.
 * @param {Job} job @param {Report} report @param {Step} step @returns {Answer[]}
 */
function utilizations(job, report, step) {
  const length = unit('length', report.units);
  return profilesOf(job, step).flatMap(({ body, profiles }) => {
    const places = profiles.flatMap((profile) =>
      (profile.utilization ?? []).map((used, k) => ({ used, depth: profile.depth[k], profile })),
    );
    if (places.length === 0) return [];
    const most = (/** @type {number} */ from) =>
      places.reduce(
        (best, { used, depth }, k) => (depth >= from && !(used <= places[best]?.used) ? k : best),
        -1,
      );
    const [case_, whole] = [caseDepth(job, body, report.units) ?? Infinity, most(0)];
    const core = most(case_);
    const alike = same(job.upper, job.lower);
    const answer = (/** @type {string} */ name, /** @type {number} */ k) => {
      const { used, depth, profile } = places[k];
      return {
        name: alike ? name : `${name}, ${body} body`,
        value: 100 * used,
        unit: '%',
        note: `von Mises stress over yield stress, most at a depth of ${figure(depth, 3)} ${length}${depth >= case_ ? ', below the case' : ''}, on the line ${belowWords(step, report, profile)}`,
      };
    };
    return [
      answer('Utilization', whole),
      ...(core >= 0 && core !== whole ? [answer('Utilization of the core', core)] : []),
    ];
  });
}

/**
 * Depth of the hardened case of a body.
 * @param {Job} job
 * @param {'upper' | 'lower'} body
 * @param {Report['units']} units shown
 * @returns {number | undefined}
 */
export function caseDepth(job, body, units) {
  const depth = job[body]?.material?.plasticity?.over_depth?.hardness?.case_depth;
  return typeof depth === 'number' ? depth * factor('length', unitsOf(job), units) : undefined;
}

/**
 * The largest tension along the surface or across the section that is left.
 * @param {Job} job
 * @param {Report} report
 * @param {Step} step
 * @returns {Answer[]}
 */
function residualStress(job, report, step) {
  const found = profilesOf(job, step).flatMap(({ body, profiles }) =>
    profiles.flatMap((profile) =>
      /** @type {const} */ (['sigma_x', 'sigma_z']).map((component) => {
        const value = Math.max(...profile[component]);
        return {
          body,
          component,
          profile,
          value,
          depth: profile.depth[profile[component].indexOf(value)],
        };
      }),
    ),
  );
  if (!found.some(({ value }) => value > 0)) return [];
  const most = found.reduce((a, b) => (b.value > a.value ? b : a));
  return [
    {
      name: 'Residual tension',
      value: most.value,
      unit: unit('stress', report.units),
      note: `${nameOf(most.component, report.analysis)}, ${bodyWords(job, most.body)}, at a depth of ${figure(most.depth, 3)} ${unit('length', report.units)} on the line ${belowWords(step, report, most.profile)}`,
    },
  ];
}

/**
 * Where a profile over depth lies.
 * @param {Step} step
 * @param {Report} report
 * @param {import('../types.js').Profile | null | undefined} profile
 */
export function belowWords(step, report, profile) {
  const at = profile?.position ?? step.contact.peak_position;
  const name = abscissaOf(step, report.analysis === 'axisymmetric');
  const where = figure(at, 3);
  return name === 'along the arc'
    ? `at ${where} ${unit('length', report.units)} along the arc`
    : `at ${name} = ${where}${at === 0 ? '' : ` ${unit('length', report.units)}`}`;
}

/**
 * Figures after unloading: both surfaces and the work.
 * @param {Job} job
 * @param {Report} report
 * @param {Step} step
 * @returns {Answer[]}
 */
export function leftBehind(job, report, step) {
  const { flow, contact } = step;
  if (!flow) return [];
  const { units } = report;
  const length = unit('length', units);
  const loaded = contact.force > 0;
  const alike = same(job.upper, job.lower);
  const surfaces = /** @type {const} */ (['upper', 'lower']).flatMap((body) => {
    const surface = alike && body === 'upper' ? null : flow.surfaces[body];
    return surface ? [{ of: bodyWords(job, body), surface }] : [];
  });
  const put = workPutIn(report, report.steps.indexOf(step));
  const value = (100 * flow.energy.dissipated) / put;
  return [
    ...surfaces.map(({ of, surface }) => ({
      name: `${loaded ? 'Depth of the surface' : 'Depth of the dent'}, ${of}`,
      value: surface.depth,
      unit: length,
      note: `below the undeformed surface${surface.yielded_in_reverse ? '; yielded in reverse' : ''}`,
    })),
    ...surfaces.map(({ of, surface }) => ({
      name: `Pile-up, ${of}`,
      value: surface.pile_up,
      unit: length,
      note: `above the undeformed surface, at a distance of ${figure(surface.pile_up_position, 3)} ${length}`,
    })),
    ...(loaded ? [] : [approach(report, step)]),
    ...(put > 0
      ? [{ name: 'Work dissipated', value, unit: '%', note: 'of the work that the loads put in' }]
      : []),
  ];
}

/**
 * What widths and means are of, where that is not a plain half-chord.
 * @param {Step['contact']} contact
 */
function widthWords({ half_angle: angle, patches }) {
  if (angle !== undefined)
    return {
      width: `along the arc, ${figure(angle, 3)}° to each side`,
      mean: 'over the chord of the contact',
    };
  if (patches.length < 2) return { width: '', mean: '' };
  return {
    width: `half of the distance from end to end: ${patches.length} parts touch`,
    mean: 'over the whole width from end to end, gaps included',
  };
}

/** The target of a force search and its result. @param {Report} report */
export function targetWords({ target, units }) {
  if (!target) return '';
  const { label, quantity } = TARGETS[target.figure] ?? {
    label: target.figure.replaceAll('_', ' '),
    quantity: 'number',
  };
  if (quantity === 'strain')
    return `for a ${label.toLowerCase()} of ${exact(100 * target.wanted)} %, reached ${percent(target.reached, 5)}`;
  const name = quantity && quantity !== 'load' ? unit(quantity, units) : '';
  return `for a ${label.toLowerCase()} of ${exact(target.wanted)} ${name}, reached ${figure(target.reached)}`;
}

/** @param {{peak_pressure: number}} hertz @param {boolean} round */
const meanOf = ({ peak_pressure }, round) =>
  round ? (2 / 3) * peak_pressure : (Math.PI / 4) * peak_pressure;

/** @param {Step} step @param {string} length */
function zoneWords({ plasticity }, length) {
  const zones = Object.entries(plasticity).filter(([, zone]) => zone?.yielded);
  if (zones.length === 0) return 'neither body yields';
  const [name, zone] = zones.reduce((a, b) =>
    (b[1]?.max_equivalent_plastic_strain ?? 0) > (a[1]?.max_equivalent_plastic_strain ?? 0)
      ? b
      : a,
  );
  const where = zones.length === 2 ? 'both bodies' : `${name} body`;
  return `${where}, most at ${figure(zone?.depth, 3)} ${length} deep, ${zone?.reached_surface ? 'up to the surface' : 'below the surface'}`;
}
