/** Hardening curves: from the record of a tensile test, and every law as a curve. */

import { Problem, post } from '../api/client.js';
import { numberOf } from '../lib/number.js';
import { inWords } from './words.js';

/** @typedef {[number, number]} Point */

/** Plastic strain of R_p0.2. */
export const PROOF = 0.002;

/**
 * The hardening curve of a test, which the service computes: first slope, toe, yield, necking,
 * noise.
 * @param {Point[]} points strain and stress, the elastic part included
 * @param {'engineering' | 'true'} measure
 * @param {number} modulus NaN where the material has none
 * @param {import('../lib/units.js').Units} units
 * @returns {Promise<{points: Point[], note: string, slope: number, proof: number | undefined} | {problem: string}>} `slope`: the first of the test; `proof`: R_p0.2
 */
export async function fromTest(points, measure, modulus, units) {
  const test = { points, measure, units, ...(modulus > 0 && { young_modulus: modulus }) };
  try {
    const [curve, proof] = await Promise.all([
      post('v1/hardening-curves', test),
      post('v1/hardening-curves', { ...test, offset: PROOF }).catch(() => undefined),
    ]);
    const { points, remarks, slope } = curve;
    return { points, note: remarks.join(' '), slope, proof: proof?.yield_stress };
  } catch (error) {
    if (!(error instanceof Problem)) throw error;
    const faults = error.errors.map(({ pointer, detail }) => `${placed(pointer)} ${detail}`);
    return { problem: inWords(faults.slice(0, 3).join('; ') || error.message) };
  }
}

/** The place of a fault in the table. @param {string} pointer */
function placed(pointer) {
  const [, row] = /\/points\/(\d+)/.exec(pointer) ?? [];
  return row ? `point ${Number(row) + 1}` : 'the table';
}

/** Backstress of a first pull, the sum of its terms, as `docs/theory.md` section 4a integrates. @param {unknown} terms @param {number} p */
const backstress = (terms, p) =>
  (Array.isArray(terms) ? terms : []).reduce((sum, term) => {
    const { modulus, rate } = term ?? {};
    return sum + (rate > 0 ? (modulus / rate) * -Math.expm1(-rate * p) : modulus * p);
  }, 0);

/**
 * Stress of a first pull over plastic strain, as `docs/theory.md` defines the laws and the backstress.
 * @param {Record<string, any> | undefined} material
 * @returns {((strain: number) => number) | undefined} nothing where there is no curve or its figures make none
 */
export function curve(material) {
  const law = material?.plasticity;
  const E = numberOf(material?.young_modulus);
  if (!law || !(E > 0)) return undefined;
  const y = law.yield_stress;
  const curves = /** @type {Record<string, (p: number) => number>} */ ({
    bilinear: (p) => y + ((E * law.tangent_modulus) / (E - law.tangent_modulus)) * p,
    ramberg_osgood: (p) =>
      law.reference_stress * ((p * E) / (law.offset * law.reference_stress)) ** (1 / law.exponent),
    swift: (p) => y * (1 + p / law.strain_offset) ** law.exponent,
    ludwik: (p) => y + law.coefficient * p ** law.exponent,
    voce: (p) => y + (law.saturation_stress - y) * (1 - Math.exp(-law.rate * p)),
    table: (p) => between(law.points, p),
  });
  const isotropic = curves[law.law];
  const stress =
    isotropic && ((/** @type {number} */ p) => isotropic(p) + backstress(law.backstress, p));
  return stress && Number.isFinite(stress(0)) && Number.isFinite(stress(0.01))
    ? stress
    : undefined;
}

/** Straight lines between the points, constant beyond the last. @param {unknown} points @param {number} strain */
function between(points, strain) {
  if (
    !Array.isArray(points) ||
    !points.every((point) => Array.isArray(point) && point.every(Number.isFinite))
  )
    return NaN;
  const next = points.findIndex(([at]) => at >= strain);
  if (next < 0) return points.at(-1)?.[1] ?? NaN;
  if (next === 0) return points[0][1];
  const [[x0, y0], [x1, y1]] = [points[next - 1], points[next]];
  return y0 + ((y1 - y0) * (strain - x0)) / (x1 - x0 || 1);
}
