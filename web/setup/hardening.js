/** Hardening curves: from the record of a tensile test, and every law as a curve. */

import { Problem, post } from '../api/client.js';
import { numberOf } from '../lib/number.js';
import { inWords } from './words.js';

/** @typedef {[number, number]} Point */

/**
 * The hardening curve of a test, which the service computes: first slope, toe, yield, necking,
 * noise.
 * @param {Point[]} points strain and stress, the elastic part included
 * @param {'engineering' | 'true'} measure
 * @param {number} modulus NaN where the material has none
 * @param {import('../lib/units.js').Units} units
 * @returns {Promise<{points: Point[], note: string} | {problem: string}>}
 */
export async function fromTest(points, measure, modulus, units) {
  const test = { points, measure, units, ...(modulus > 0 && { young_modulus: modulus }) };
  try {
    const curve = await post('v1/hardening-curves', test);
    return { points: curve.points, note: curve.remarks.join(' ') };
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

/**
 * Equivalent stress over plastic strain, as `docs/theory.md` defines the laws.
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
  const stress = curves[law.law];
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
