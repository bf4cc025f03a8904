/** The field in figures: limits of the colours, and the point under the probe. */

import { h } from '../lib/dom.js';
import { figure, plain, unit } from '../lib/units.js';
import { locate, valueAt } from './locate.js';

/** @typedef {import('../types.js').Mesh} Mesh */
/** @typedef {'von_mises' | 'equivalent_plastic_strain' | 'sigma_x' | 'sigma_y' | 'sigma_z' | 'tau_xy'} Quantity */

/** @type {Record<Quantity, string>} */
export const QUANTITIES = {
  von_mises: 'von Mises stress',
  equivalent_plastic_strain: 'plastic strain',
  sigma_x: 'σx',
  sigma_y: 'σy',
  sigma_z: 'σz',
  tau_xy: 'τxy',
};

/** Whether a quantity changes its sign from one side of a mirrored half to the other. @param {Quantity} quantity */
export const isOdd = (quantity) => quantity === 'tau_xy';

/**
 * @param {Mesh[]} meshes
 * @param {Quantity} quantity
 * @param {boolean} mirrored
 * @returns {[number, number]} its least and largest value
 */
export function rangeOf(meshes, quantity, mirrored) {
  let [low, high] = [Infinity, -Infinity];
  for (const mesh of meshes) {
    for (const value of mesh[quantity]) {
      if (value < low) low = value;
      if (value > high) high = value;
    }
  }
  const most = Math.max(-low, high);
  return mirrored && isOdd(quantity) ? [-most, most] : [low, high];
}

/** The bands from the highest down, each with its upper limit. @param {import('./palette.js').Bands} bands @param {string} unit */
export function colourBar({ low, step, colours }, unit) {
  const swatches = colours.map((rgb, k) => {
    const swatch = h('li', {}, plain(low + (k + 1) * step));
    swatch.style.setProperty('--band', `rgb(${rgb.map((c) => Math.round(255 * c)).join(' ')})`);
    return swatch;
  });
  return [...swatches.reverse(), ...(unit ? [h('li', { class: 'unit' }, unit)] : [])];
}

/**
 * What is at a point of the deformed bodies, in words.
 * @param {{name: string, mesh: Mesh, shift: number}[]} bodies
 * @param {import('../types.js').Report} report
 * @param {number} deformation
 * @param {[number, number]} point
 * @returns {string}
 */
export function readout(bodies, { units, mesh: { symmetric } }, deformation, [x, y]) {
  const [length, stress] = [unit('length', units), unit('stress', units)];
  const side = symmetric && x < 0 ? -1 : 1;
  const where = `x ${figure(x, 3)}, y ${figure(y, 3)} ${length}`;
  for (const { name, mesh, shift } of bodies) {
    const place = locate(mesh, deformation, shift, side * x, y);
    if (!place) continue;
    const at = (/** @type {Quantity} */ quantity) => valueAt(place, mesh[quantity]) * (isOdd(quantity) ? side : 1);
    const stresses = /** @type {Quantity[]} */ (['von_mises', 'sigma_x', 'sigma_y', 'sigma_z', 'tau_xy']);
    const figures = stresses.map((one) => `${QUANTITIES[one].replace(' stress', '')} ${figure(at(one), 4)}`);
    const strain = figure(100 * at('equivalent_plastic_strain'), 3);
    return `${name} body, ${where}:  ${figures.join(' · ')} ${stress} · plastic strain ${strain} %`;
  }
  return `${where}: outside the bodies`;
}
