/** The figures that answer a job at one step, with error bar and elastic theory: for the cards of the page and for the report. */

import { exact, figure, forceOf, percent, stiffnessOf, unit } from '../lib/units.js';
import { same } from '../lib/pointer.js';
import { TARGETS } from '../setup/fields.js';
import { barOf, strainOf } from './figures.js';
import { isDented, workPutIn } from './loads.js';

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
 * @property {boolean} [long] whether the note is too long for a card
 */

/** Why a stiffness is 0. */
const APART = 'without load the bodies are apart, and nothing resists';

/** @param {Job} job @param {Report} report @param {Step} step @returns {Answer[]} what counts under a load, or what it has left behind, first */
export function answersOf(job, report, step) {
  const { units } = report;
  const { contact, hertz } = step;
  const [length, stress, force] = [unit('length', units), unit('stress', units), unit(forceOf(report), units)];
  const slope = unit(stiffnessOf(report), units);
  const loaded = contact.force > 0;
  const onset = hertz?.yield_onset_force;
  const round = report.analysis === 'axisymmetric';
  // Without load there is no contact for Hertz's theory to tell of.
  const elastic = loaded ? hertz : undefined;
  const { width, mean } = widthWords(contact);
  const undented = isDented(report, report.steps.indexOf(step));
  const first = undented ? 'first yield of undented bodies' : 'first yield';
  return [
    {
      name: 'Peak pressure',
      value: contact.peak_pressure,
      unit: stress,
      error: barOf(step, 'peak_pressure'),
      elastic: elastic?.peak_pressure,
      undented,
      note: '',
    },
    {
      name: round ? 'Contact radius' : 'Half-width',
      value: contact.half_width,
      unit: length,
      error: barOf(step, 'half_width'),
      elastic: elastic?.half_width,
      undented,
      note: width,
    },
    {
      name: 'Approach',
      value: step.approach,
      unit: length,
      error: barOf(step, 'approach'),
      note: step.approach_datum,
      long: true,
    },
    {
      name: 'Force',
      value: contact.force,
      unit: force,
      error: barOf(step, 'force'),
      note: onset
        ? loaded
          ? `${figure(contact.force / onset, 3)} × ${first} by elastic theory, ${figure(onset, 4)}`
          : `${first} by elastic theory at ${figure(onset, 4)}`
        : '',
    },
    {
      name: 'Mean pressure',
      value: contact.mean_pressure,
      unit: stress,
      elastic: elastic ? meanOf(elastic, round) : undefined,
      undented,
      note: mean,
    },
    ...(report.target
      ? [
          {
            name: 'Force found',
            value: report.target.force,
            unit: force,
            error: report.target.relative_error ?? undefined,
            note: targetWords(report),
          },
        ]
      : []),
    { name: 'Plastic strain', value: 100 * strainOf(step), unit: '%', note: zoneWords(step, length) },
    {
      name: 'Contact stiffness',
      value: step.contact_stiffness,
      unit: slope,
      error: barOf(step, 'contact_stiffness'),
      note: loaded ? 'dP/dα, slope of load over approach' : APART,
    },
    ...(step.flow
      ? [
          {
            name: 'Unloading stiffness',
            value: step.flow.unloading_stiffness,
            unit: slope,
            note: loaded ? 'dP/dα where the load begins to fall' : APART,
          },
        ]
      : []),
    ...(step.yield_onset
      ? [
          {
            name: 'First yield',
            value: step.yield_onset.force,
            unit: force,
            note: `on this mesh, in ${same(job.upper, job.lower) ? 'both bodies' : `the ${step.yield_onset.body} body`}, ${figure(step.yield_onset.depth, 3)} ${length} deep`,
          },
        ]
      : []),
  ];
}

/** What a load has left on both surfaces, and of its work. @param {Report} report @param {Step} step @returns {Answer[]} */
export function leftBehind(report, step) {
  const { flow, contact } = step;
  if (!flow) return [];
  const { units } = report;
  const length = unit('length', units);
  const loaded = contact.force > 0;
  const surfaces = /** @type {const} */ (['upper', 'lower']).flatMap((body) => {
    const surface = flow.surfaces[body];
    if (!surface) return [];
    return [
      {
        name: `${loaded ? 'Depth of the surface' : 'Depth of the dent'}, ${body} body`,
        value: surface.depth,
        unit: length,
        note: `below the undeformed surface${surface.yielded_in_reverse ? '; yielded in reverse' : ''}`,
      },
      {
        name: `Pile-up, ${body} body`,
        value: surface.pile_up,
        unit: length,
        note: 'above the undeformed surface',
      },
    ];
  });
  const put = workPutIn(report, report.steps.indexOf(step));
  const value = (100 * flow.energy.dissipated) / put;
  return put > 0
    ? [...surfaces, { name: 'Work dissipated', value, unit: '%', note: 'of the work that the loads put in' }]
    : surfaces;
}

/** What widths and means are of, where that is not a plain half-chord. @param {Step['contact']} contact */
function widthWords({ half_angle: angle, patches }) {
  if (angle !== undefined)
    return { width: `along the arc, ${figure(angle, 3)}° to each side`, mean: 'over the chord of the contact' };
  if (patches.length < 2) return { width: '', mean: '' };
  return {
    width: `half of the distance from end to end: ${patches.length} parts touch`,
    mean: 'over the whole width from end to end, gaps included',
  };
}

/** For what a force was looked for, and what came of it. @param {Report} report */
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
const meanOf = ({ peak_pressure }, round) => (round ? (2 / 3) * peak_pressure : (Math.PI / 4) * peak_pressure);

/** @param {Step} step @param {string} length */
function zoneWords({ plasticity }, length) {
  const zones = Object.entries(plasticity).filter(([, zone]) => zone?.yielded);
  if (zones.length === 0) return 'neither body yields';
  const [name, zone] = zones.reduce((a, b) =>
    (b[1]?.max_equivalent_plastic_strain ?? 0) > (a[1]?.max_equivalent_plastic_strain ?? 0) ? b : a,
  );
  const where = zones.length === 2 ? 'both bodies' : `${name} body`;
  return `${where}, most at ${figure(zone?.depth, 3)} ${length} deep, ${zone?.reached_surface ? 'up to the surface' : 'below the surface'}`;
}
