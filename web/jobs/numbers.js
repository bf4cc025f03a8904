/** Every number of a job that can be varied: of one body, of both where they have the same, and of the load. */

import { set } from '../lib/pointer.js';
import { leaves, nameOf } from './names.js';

/** @typedef {import('../types.js').Job} Job */
/** @typedef {{key: string, pointers: string[], label: string, symbol: string, unit: string, value: number}} Numeric */

/** Members that are no figure of the contact. */
const LEFT = /^\/(mesh|solver|output|tags|units)|\/surface\/|\/(detrend|rotation)$/;

/** @param {Job} job @returns {Numeric[]} the load first */
export function numbersOf(job) {
  const found = [...leaves(job)].flatMap(([pointer, value]) =>
    typeof value === 'number' && !LEFT.test(pointer)
      ? [{ key: pointer, pointers: [pointer], ...nameOf(pointer, job), value }]
      : [],
  );
  const both = found.flatMap((one) => {
    const other = one.key.startsWith('/upper/') && one.key.replace('/upper/', '/lower/');
    const twin = other && found.find(({ key, value }) => key === other && value === one.value);
    if (!twin) return [];
    const label = `Both bodies: ${nameOf(one.key.replace('/upper', ''), job).label.toLowerCase()}`;
    return [{ ...one, key: `both${one.key}`, pointers: [one.key, twin.key], label }];
  });
  return [...both, ...found].sort((a, b) => rank(a.pointers[0]) - rank(b.pointers[0]));
}

/** Numbers that are varied most first. */
const ORDER = [
  /^\/load/,
  /radius|semi_axis/,
  /tilt|moment|case_depth/,
  /yield_stress|reference_stress/,
];

/** @param {string} pointer */
const rank = (pointer) => {
  const found = ORDER.findIndex((one) => one.test(pointer));
  return found < 0 ? (/young|poisson/.test(pointer) ? ORDER.length + 1 : ORDER.length) : found;
};

/** The job with another value. @param {Job} job @param {Numeric} number @param {number} value @returns {Job} */
export function withValue(job, { pointers }, value) {
  const changed = structuredClone(job);
  for (const pointer of pointers) set(changed, pointer, value);
  return changed;
}
