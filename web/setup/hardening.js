/**
 * Hardening curves: from figures of a tensile test to plastic strain and true stress, and every
 * law as a curve.
 */

import { numberOf } from '../lib/number.js';

/** @typedef {[number, number]} Point */

/**
 * Engineering strain e and stress s of a tensile test, elastic part included: ε = ln(1 + e), σ = s
 * (1 + e), which holds up to the onset of necking.
 * @param {Point[]} points
 * @param {number} modulus
 */
export const fromEngineering = (points, modulus) =>
  fromTotal(
    points.map(([e, s]) => [Math.log1p(e), s * (1 + e)]),
    modulus,
  );

/**
 * Total strain and true stress: ε_p = ε − σ/E. The elastic part becomes one point at ε_p = 0; what
 * falls again is left out.
 * @param {Point[]} points
 * @param {number} modulus
 * @returns {{points: Point[], note: string}}
 */
export function fromTotal(points, modulus) {
  if (!(modulus > 0)) return { points, note: '' };
  const plastic = /** @type {Point[]} */ (
    points.map(([total, stress]) => [total - stress / modulus, stress])
  );
  const begin = plastic.findIndex(([strain]) => strain > 2e-5);
  if (begin < 0) return { points, note: '' };
  const yielded = begin > 0 ? plastic[begin - 1][1] : plastic[begin][1];
  const kept = /** @type {Point[]} */ ([[0, round(yielded)]]);
  for (const [strain, stress] of plastic.slice(begin)) {
    const [last, most] = kept[kept.length - 1];
    if (strain > last && stress >= most) kept.push([round(strain), round(stress)]);
  }
  const left = points.length - begin - (kept.length - 1);
  return {
    points: kept,
    note: `converted to plastic strain and true stress; ${begin} elastic${left > 0 ? ` and ${left} falling` : ''} point${begin + left === 1 ? '' : 's'} left out`,
  };
}

/** @param {number} value */
const round = (value) => Number(value.toPrecision(7));

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
