/** What a field is looked at with: quantity, displacement, mesh, isolines, cut, zoom. */

import { h, plainButton } from '../lib/dom.js';

const LOUPE = [0, 1, 2, 5, 10, 20];

/**
 * @typedef {object} Handlers
 * @property {() => void} choose another quantity is chosen
 * @property {(times: number) => void} exaggerate displacements
 * @property {(on: boolean) => void} mesh
 * @property {(on: boolean) => void} isolines
 * @property {(on: boolean) => void} cut
 * @property {(factor: number) => void} zoom
 * @property {() => void} home the whole contact is to be seen
 */

/** @param {Handlers} on @param {Node} range of the colours */
export function fieldTools(on, range) {
  const quantities = h('select', { 'aria-label': 'Shown', onchange: on.choose });
  const loupe = h(
    'select',
    { onchange: () => on.exaggerate(Number(loupe.value)) },
    LOUPE.map((times) => h('option', { value: times, selected: times === 1 }, `×${times}`)),
  );
  const flag = (/** @type {string} */ text, /** @type {(on: boolean) => void} */ set) => {
    const box = h('input', { type: 'checkbox', onchange: () => set(box.checked) });
    return h('label', {}, box, ` ${text}`);
  };
  const button = (
    /** @type {string} */ sign,
    /** @type {string} */ name,
    /** @type {() => void} */ work,
  ) => plainButton(sign, work, { 'aria-label': name, title: name });
  const displacement = h('label', {}, 'Displacement ', loupe);
  const element = h(
    'div',
    { class: 'bar tools' },
    quantities,
    displacement,
    flag('Mesh', on.mesh),
    flag('Isolines', on.isolines),
    flag('Cut', on.cut),
    h(
      'span',
      { class: 'group' },
      button('−', 'Zoom out', () => on.zoom(0.8)),
      button('+', 'Zoom in', () => on.zoom(1.25)),
      button('⌂', 'Whole contact', on.home),
    ),
    range,
  );
  return { element, quantities, displacement };
}
