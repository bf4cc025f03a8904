/** The field in figures: limits of the colours, and the point under the probe. */

import { h } from '../lib/dom.js';
import { figure, plain, unit } from '../lib/units.js';
import { locate, valueAt, vectorAt } from './locate.js';
import { QUANTITIES, arraysOf, nameOf, valueOf, valuesOf } from './quantities.js';

/** @typedef {import('../types.js').Mesh} Mesh */
/** @typedef {import('./quantities.js').Quantity} Quantity */
/** @typedef {{name: 'upper' | 'lower', mesh: Mesh, lift: number, moved: number}} Body */
/** @typedef {{analysis: string, symmetric: boolean, units: import('../lib/units.js').UnitSet, length: number, stress: number}} Scales factors from units of the job to those shown */
/** @typedef {{value: number, name: string, x: number, y: number, u: number, v: number, lift: number}} Extreme at a node */

/**
 * @param {Body[]} bodies
 * @param {Quantity} quantity
 * @param {boolean} mirrored
 * @returns {{low: number, high: number, most?: Extreme}} its limits, and where it is largest in size
 */
export function extremes(bodies, quantity, mirrored) {
  let [low, high] = [Infinity, -Infinity];
  let most = /** @type {{body: Body, node: number, value: number} | undefined} */ (undefined);
  const { signed, odd } = QUANTITIES[quantity];
  for (const body of bodies) {
    const values = valuesOf(body.mesh, quantity, body.moved);
    for (let k = 0; k < values.length; k++) {
      const value = values[k];
      if (value < low) low = value;
      if (value > high) high = value;
      if (!most || (signed ? Math.abs(value) > Math.abs(most.value) : value > most.value))
        most = { body, node: k, value };
    }
  }
  const size = Math.max(-low, high);
  const [nodes, moved] = [most?.body.mesh.nodes, most?.body.mesh.displacement];
  const at =
    most && nodes && moved
      ? {
          value: most.value,
          name: most.body.name,
          x: nodes[2 * most.node],
          y: nodes[2 * most.node + 1],
          u: moved[2 * most.node],
          v: moved[2 * most.node + 1],
          lift: most.body.lift,
        }
      : undefined;
  return mirrored && odd ? { low: -size, high: size, most: at } : { low, high, most: at };
}

/** The bands from the highest down, each with its upper limit. @param {import('./palette.js').Bands} bands @param {string} unit */
export function colourBar({ low, step, colours }, unit) {
  const swatches = colours.map((rgb, k) => {
    const swatch = h('li', {}, plain(low + (k + 1) * step));
    swatch.style.setProperty('--band', `rgb(${rgb.map((c) => Math.round(255 * c)).join(' ')})`);
    return swatch;
  });
  return [
    ...swatches.reverse(),
    h('li', { class: 'last' }, plain(low)),
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
/** Arrays that a reading is made of. */
export const READ = [
  ...new Set([...STRESSES, /** @type {Quantity} */ ('equivalent_plastic_strain')].flatMap(arraysOf)),
];

/**
 * What is at a point of the picture, in words: the place is that of the undeformed body. Of quantities whose arrays have not been
 * fetched nothing is said.
 * @param {Body[]} bodies
 * @param {Quantity} shown
 * @param {Scales} scales
 * @param {number} deformation
 * @param {[number, number]} point
 * @returns {string}
 */
export function readout(bodies, shown, scales, deformation, [x, y]) {
  const side = scales.symmetric && x < 0 ? -1 : 1;
  const [across, up] = scales.analysis === 'axisymmetric' ? ['r', 'z'] : ['x', 'y'];
  for (const { name, mesh, lift, moved } of bodies) {
    const place = locate(mesh, deformation, lift, side * x, y);
    if (!place) continue;
    const [px, py] = vectorAt(place, mesh.nodes).map((value) => value * scales.length);
    const there = (/** @type {Quantity} */ quantity) => arraysOf(quantity).every((name) => mesh[name]);
    const say = (/** @type {Quantity} */ quantity) => {
      const { factor } = scaleOf(quantity, scales);
      const value = valueAt(place, valueOf(mesh, quantity, moved)) * (QUANTITIES[quantity].odd ? side : 1);
      return `${nameOf(quantity, scales.analysis)
        .replace(' stress', '')
        .replace(/^.* (?=[στ])/, '')} ${figure(factor * value, 4)}`;
    };
    const where = `${name} body, ${across} ${figure(across === 'r' ? Math.abs(px) : side * px, 3)}, ${up} ${figure(py, 3)} ${unit('length', scales.units)}`;
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
