/** The field in figures: limits of the colours, and the point under the probe. */

import { h } from '../lib/dom.js';
import { figure, unit } from '../lib/units.js';
import { locate, valueAt, vectorAt } from './locate.js';
import { limitOf } from './palette.js';
import {
  QUANTITIES,
  arraysOf,
  nameOf,
  parityOf,
  sectionOf,
  valueOf,
  valuesOf,
} from './quantities.js';

/** @typedef {import('../types.js').Mesh} Mesh */
/** @typedef {import('./quantities.js').Quantity} Quantity */
/** @typedef {{name: 'upper' | 'lower', mesh: Mesh, lift: number, moved: number}} Body */
/** @typedef {{analysis: string, symmetric: boolean, own: import('../lib/units.js').Units, units: import('../lib/units.js').UnitSet, length: number, stress: number}} Scales `own`: units of the job; `units`: those shown; factors from one to the other */
/** @typedef {{end: 'max' | 'min' | 'tension', value: number, error?: number | null, name: string, x: number, y: number, u: number, v: number}} Extreme at a node, or where an answer is */

/**
 * @param {Body[]} bodies
 * @param {Quantity} quantity
 * @param {{analysis: string, mesh: {symmetric: boolean}}} report
 * @returns {{low: number, high: number, ends: Extreme[]}} its limits, and where they are: the least value only of what has a sign
 */
export function extremes(bodies, quantity, { analysis, mesh: { symmetric } }) {
  const least = { value: Infinity, node: -1, body: bodies[0] };
  const most = { value: -Infinity, node: -1, body: bodies[0] };
  for (const body of bodies) {
    const values = valuesOf(body.mesh, quantity, body.moved);
    for (let node = 0; node < values.length; node++) {
      const value = values[node];
      if (value < least.value) Object.assign(least, { value, node, body });
      if (value > most.value) Object.assign(most, { value, node, body });
    }
  }
  const { signed } = QUANTITIES[quantity];
  /** @param {Extreme['end']} end @param {typeof most} found @param {1 | -1} side @returns {Extreme[]} */
  const at = (end, { value, node, body }, side) => {
    if (node < 0) return [];
    const [{ nodes, displacement: moved }, parity] = [
      body.mesh,
      parityOf(quantity, analysis, side),
    ];
    const [x, y, u, v] = [
      nodes[2 * node],
      nodes[2 * node + 1],
      moved[2 * node],
      moved[2 * node + 1],
    ];
    return [{ end, value: parity * value, name: body.name, x: side * x, y, u: side * u, v }];
  };
  if (symmetric && parityOf(quantity, analysis, -1) < 0) {
    // What is least on one side is largest on the other.
    const mirrors = -least.value > most.value;
    const largest = mirrors ? least : most;
    const size = Math.abs(largest.value);
    const [high, low] = /** @type {[1 | -1, 1 | -1]} */ (mirrors ? [-1, 1] : [1, -1]);
    return {
      low: -size,
      high: size,
      ends: [...at('max', largest, high), ...at('min', largest, low)],
    };
  }
  return {
    low: least.value,
    high: most.value,
    ends: [...at('max', most, 1), ...(signed ? at('min', least, 1) : [])],
  };
}

/** The bands from the highest down, each with its upper limit. @param {import('./palette.js').Bands} bands @param {string} unit */
export function colourBar(bands, unit) {
  const swatches = bands.colours.map((rgb, k) => {
    const swatch = h('li', {}, limitOf(bands, k + 1));
    swatch.style.setProperty('--band', `rgb(${rgb.map((c) => Math.round(255 * c)).join(' ')})`);
    return swatch;
  });
  return [
    ...swatches.reverse(),
    h('li', { class: 'last' }, limitOf(bands, 0)),
    ...(unit ? [h('li', { class: 'unit' }, unit)] : []),
  ];
}

/** @param {Quantity} quantity @param {Scales} scales @returns {{factor: number, unit: string}} of its figures */
export function scaleOf(quantity, { units, length, stress }) {
  const { kind } = QUANTITIES[quantity];
  if (kind === 'strain') return { factor: 100, unit: '%' };
  return kind === 'length'
    ? { factor: length, unit: unit('length', units) }
    : { factor: stress, unit: unit('stress', units) };
}

/** Stresses that are read out. @type {Quantity[]} */
const STRESSES = ['von_mises', 'sigma_x', 'sigma_y', 'sigma_z', 'tau_xy', 'tau_max'];
/** Beside the largest of them, less than this is the rounding of single precision. */
const NOISE = 1e-7;
/** @param {number[]} values of one kind */
const rounded = (values) => {
  const noise = NOISE * Math.max(...values.map(Math.abs));
  return values.map((value) => (Math.abs(value) < noise ? 0 : value));
};
/** Arrays that a reading is made of. */
export const READ = [
  ...new Set(
    [...STRESSES, /** @type {Quantity} */ ('equivalent_plastic_strain')].flatMap(arraysOf),
  ),
];

/**
 * What is at a point of the picture, in words: the place is that of the undeformed body. Of
 * quantities whose arrays have not been fetched nothing is said.
 * @param {Body[]} bodies
 * @param {Quantity} shown
 * @param {Scales} scales
 * @param {number} deformation
 * @param {[number, number]} point
 * @returns {string}
 */
export function readout(bodies, shown, scales, deformation, [x, y]) {
  const side = scales.symmetric && x < 0 ? -1 : 1;
  const section = sectionOf(scales.analysis);
  const [across, up] = section
    ? [section.x, 'z']
    : scales.analysis === 'axisymmetric'
      ? ['r', 'z']
      : ['x', 'y'];
  for (const { name, mesh, lift, moved } of bodies) {
    const place = locate(mesh, deformation, lift, side * x, y);
    if (!place) continue;
    const [px, py] = rounded(vectorAt(place, mesh.nodes).map((value) => value * scales.length));
    const there = (/** @type {Quantity} */ quantity) =>
      arraysOf(quantity).every((name) => mesh[name]);
    const valueOfThis = (/** @type {Quantity} */ quantity) =>
      valueAt(place, valueOf(mesh, quantity, moved)) * parityOf(quantity, scales.analysis, side);
    const size = Math.max(
      0,
      ...STRESSES.filter(there).map((quantity) => Math.abs(valueOfThis(quantity))),
    );
    const say = (/** @type {Quantity} */ quantity) => {
      const { factor } = scaleOf(quantity, scales);
      const [value] =
        QUANTITIES[quantity].kind === 'stress'
          ? rounded([valueOfThis(quantity), size])
          : [valueOfThis(quantity)];
      return `${nameOf(quantity, scales.analysis)
        .replace(' stress', '')
        .replace(/^.* (?=[στ])/, '')} ${figure(factor * value, 4)}`;
    };
    const where = `${name} body, ${across} ${figure(across === 'r' ? Math.abs(px) : side * px, 3)}, ${up} ${figure(section ? Math.abs(py) : py, 3)} ${unit('length', scales.units)}`;
    const stresses = STRESSES.filter(there);
    const others = /** @type {Quantity[]} */ ([...new Set(['equivalent_plastic_strain', shown])]);
    const parts = [
      stresses.length && `${stresses.map(say).join(' · ')} ${unit('stress', scales.units)}`,
      ...others
        .filter((one) => there(one) && !STRESSES.includes(one))
        .map((one) => `${say(one)} ${scaleOf(one, scales).unit}`),
    ];
    return `${where}:  ${parts.filter(Boolean).join(' · ')}`;
  }
  return 'outside the bodies';
}
