/** What to solve next where a job has no answer: each is a job. */

import { figure, forceOf, unit, unitsOf } from '../lib/units.js';
import { numberOf } from '../lib/number.js';
import { loadOf } from '../setup/fields.js';
import { forceIn } from './rows.js';

/** @typedef {import('../types.js').Job} Job */
/** @typedef {import('../types.js').Report} Report */
/** @typedef {{words: string, job: Job}} Next */

/** Passes that a service takes where a job does not say how many. */
const PASSES = 30;

/** Verdicts of a load that rolls which another hardening or more passes may change. */
const OPEN = ['not_known', 'not_converged', 'shakes_down'];

/**
 * @param {Job} job
 * @param {Report} report in the units of the job
 * @param {number} at step
 * @returns {Next[]}
 */
export function nextSteps(job, report, at) {
  const step = report.steps[at];
  const level = step.verdict.level;
  if (job.load?.rolling) return OPEN.includes(level) ? rolled(job) : [];
  if (step.status === 'converged' || !['force', 'forces', 'history'].includes(loadOf(job.load)))
    return [];
  const solved = report.steps.filter(({ status }) => status === 'converged');
  const most = Math.max(0, ...solved.map(forceIn));
  const force = round(most || forceIn(step) / 2);
  const name = `${figure(force, 4)} ${unit(forceOf(job), unitsOf(job))}`;
  return [
    {
      words: most
        ? `Solve with ${name}, the largest that does`
        : `Solve with half the force, ${name}`,
      job: { ...job, load: { force } },
    },
    ...(force && most ? [between(job, most, forceIn(step))] : []),
  ];
}

/** A force has five digits. @param {number} force */
const round = (force) => Number(force.toPrecision(5));

/** Loads on the way to the one that did not. @param {Job} job @param {number} from @param {number} to @returns {Next} */
const between = (job, from, to) => ({
  words: 'Solve in smaller steps',
  job: {
    ...job,
    load: { forces: [0, 1, 2, 3, 4].map((k) => round(from + ((to - from) * k) / 4)) },
  },
});

/** @param {Job} job @returns {Next[]} */
function rolled(job) {
  const { rolling } = job.load;
  const passes = 2 * (numberOf(rolling.passes) || PASSES);
  const [upper, lower] = [job.upper, job.lower].map(kinematic);
  const isNew = upper !== job.upper || lower !== job.lower;
  return [
    { words: `Roll ${passes} passes`, job: { ...job, load: { rolling: { ...rolling, passes } } } },
    ...(isNew ? [{ words: 'Solve with kinematic hardening', job: { ...job, upper, lower } }] : []),
  ];
}

/** A bilinear body whose yield surface moves where it grew. @param {Record<string, any>} body */
function kinematic(body) {
  const { young_modulus: modulus, plasticity: law } = body?.material ?? {};
  const slope = law?.tangent_modulus;
  if (law?.law !== 'bilinear' || law.backstress || !(slope > 0 && slope < modulus)) return body;
  const backstress = [{ modulus: (modulus * slope) / (modulus - slope), rate: 0 }];
  const plasticity = { ...law, tangent_modulus: 0, backstress };
  return { ...body, material: { ...body.material, plasticity } };
}
