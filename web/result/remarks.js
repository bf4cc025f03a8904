/** What the service remarks on an answer, short, with the details behind it. */

import { factor, figure, unitsOf } from '../lib/units.js';
import { yieldStress } from '../setup/fields.js';
import { inWords } from '../setup/words.js';

/** @typedef {import('../types.js').Job} Job */
/** @typedef {import('../types.js').Report} Report */
/** @typedef {import('../types.js').Step} Step */

/**
 * Elastic peak over yield stress, and by how many per cent the peak pressure of deformation theory
 * is then above that of flow theory: for steel cylinders and spheres, docs/validity.md.
 */
const ABOVE = { line: [[3, 3], [4, 7], [5, 12]], round: [[3, 5], [4, 10], [5, 13]] }; // prettier-ignore

/**
 * @param {Job} job
 * @param {Report} report
 * @param {Step} step
 * @param {{code: string, message: string}} note
 * @returns {string[]} the first sentence, then the others
 */
export function remarkOf(job, report, step, { code, message }) {
  const sentences = inWords(message).split(/(?<=[a-z)%]\.)\s+(?=\p{Lu})/u);
  if (code !== 'deformation_theory') return sentences;
  // Of the figures for all ratios, those for this one.
  return [
    deformationWords(job, report, step),
    ...sentences.filter((one) => !/elastic peak/.test(one)),
  ];
}

/**
 * What deformation theory does at this ratio of pressure to strength.
 * @param {Job} job
 * @param {Report} report
 * @param {Step} step
 */
function deformationWords(job, report, { hertz }) {
  const strengths = [job.upper, job.lower].flatMap((body) => yieldStress(body?.material) ?? []);
  const least = Math.min(...strengths) * factor('stress', unitsOf(job), report.units);
  const ratio = hertz ? hertz.peak_pressure / least : NaN;
  if (!Number.isFinite(ratio))
    return 'Stresses grow in proportion here by assumption; flow theory follows the load.';
  const round = report.analysis === 'axisymmetric';
  const rows = round ? ABOVE.round : ABOVE.line;
  const [name, pair] = [
    `The elastic peak is ${figure(ratio, 2)} times the yield stress`,
    round ? 'spheres' : 'cylinders',
  ];
  const [first, last] = [rows[0], rows[rows.length - 1]];
  const beyond =
    ratio < first[0]
      ? ['less than', first[1]]
      : ratio > last[0]
        ? ['more than', last[1]]
        : ['about', between(rows, ratio)];
  return `${name}: the peak pressure is ${beyond[0]} ${figure(Number(beyond[1]), 1)} % above that of flow theory for steel ${pair}.`;
}

/** @param {number[][]} rows @param {number} ratio */
function between(rows, ratio) {
  const next = Math.max(
    1,
    rows.findIndex(([at]) => at >= ratio),
  );
  const [[r0, p0], [r1, p1]] = [rows[next - 1], rows[next]];
  return p0 + ((p1 - p0) * (ratio - r0)) / (r1 - r0);
}
