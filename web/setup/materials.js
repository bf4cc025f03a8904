/**
 * Materials in the units of a job. Strengths of the library are the least that a standard grants,
 * or follow from the least hardness that it grants; a part in hand may be stronger. They are a
 * start, not a substitute for a test of one's own.
 */

import { materialIn } from './draft.js';

/** @typedef {{name: string, source: string, material: Record<string, any>}} Preset in mm, N, MPa */

/** @param {{material: Record<string, any>}} preset @param {import('../lib/units.js').Units} units */
export const materialOf = ({ material }, units) => materialIn(material, 'mm_N_MPa', units);

/** @param {Record<string, any>} material @param {import('../lib/units.js').Units} units @returns {Record<string, any>} as presets have it */
export const inMegapascals = (material, units) => materialIn(material, units, 'mm_N_MPa');
