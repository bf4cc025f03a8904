/** Materials of one's own, kept in this browser, and strengths from a hardness. */

import { h } from '../lib/dom.js';
import { isObject, kept } from '../lib/kept.js';
import { readNumber } from '../lib/number.js';
import { PRESETS } from './materials.js';

/** @typedef {import('./materials.js').Preset} Preset */

const KEPT = 'materials';

/** @param {() => void} listener called when another tab has changed the materials */
export const onOthers = (listener) =>
  addEventListener('storage', ({ key }) => {
    if (key === KEPT) listener();
  });

/** @returns {Preset[]} */
export function ownMaterials() {
  const good = (/** @type {any} */ one) => typeof one?.name === 'string' && isObject(one.material);
  const read = (/** @type {any} */ all) => (Array.isArray(all) ? all.filter(good) : undefined);
  return kept(localStorage, KEPT, read) ?? [];
}

/** @returns {Preset[]} */
export const allMaterials = () => [...ownMaterials(), ...PRESETS];

/** @param {Preset} preset replaces one of the same name */
function keep(preset) {
  const others = ownMaterials().filter(({ name }) => name !== preset.name);
  localStorage.setItem(KEPT, JSON.stringify([...others, preset].sort((a, b) => a.name.localeCompare(b.name))));
}

/** @param {string} name */
export const forget = (name) =>
  localStorage.setItem(KEPT, JSON.stringify(ownMaterials().filter((one) => one.name !== name)));

/**
 * Yield strength of a steel from its Vickers hardness: Pavlina and Van Tyne, J. Mater. Eng. Perform. 17 (2008) 888, a line through
 * some 150 steels from 300 to 1700 MPa. [MPa]
 * @param {number} hardness
 */
export const strengthOf = (hardness) => -90.7 + 2.876 * hardness;

/** Hardnesses for which the line stands. */
const [SOFTEST, HARDEST] = [136, 622];
/** Brinell over Vickers hardness, ISO 18265. */
const BRINELL = 0.95;

/**
 * A dialogue of a few entries.
 * @param {string} title
 * @param {import('../lib/dom.js').Child[]} content
 * @param {string} action
 * @param {() => string} done takes what is entered; answers with what is wrong with it
 */
function dialogue(title, content, action, done) {
  const error = h('p', { class: 'error', role: 'alert' });
  const box = h(
    'dialog',
    { 'aria-labelledby': 'library-title' },
    h(
      'form',
      {
        method: 'dialog',
        onsubmit: (/** @type {SubmitEvent} */ event) => {
          if (/** @type {HTMLButtonElement | null} */ (event.submitter)?.value !== 'save') return;
          error.textContent = done();
          if (error.textContent) event.preventDefault();
        },
      },
      h('h2', { id: 'library-title' }, title),
      content,
      error,
      h(
        'div',
        { class: 'bar' },
        h('button', { value: 'save', class: 'primary' }, action),
        h('button', { value: '', formnovalidate: true }, 'Cancel'),
      ),
    ),
  );
  box.addEventListener('close', () => box.remove());
  document.body.append(box);
  box.showModal();
}

/** @param {Record<string, any>} material in mm, N, MPa @param {() => void} done */
export function askToKeep(material, done) {
  const name = h('input', { type: 'text', maxlength: 60 });
  const source = h('input', { type: 'text', maxlength: 200 });
  dialogue(
    'Keep this material',
    [
      h('label', {}, 'Name ', name),
      h('label', {}, 'Source of its figures ', source),
      h('p', { class: 'quiet' }, 'It is kept in this browser.'),
    ],
    'Keep',
    () => {
      if (!name.value.trim()) return 'A material has a name.';
      if (PRESETS.some((preset) => preset.name === name.value.trim())) return 'This name is taken.';
      keep({ name: name.value.trim(), source: source.value.trim() || 'Own figures.', material });
      done();
      return '';
    },
  );
}

/** @param {(material: Record<string, any>) => void} use */
export function askHardness(use) {
  const figure = h('input', { type: 'text', inputmode: 'decimal' });
  const scale = h('select', {}, h('option', { value: 'HV' }, 'HV'), h('option', { value: 'HBW' }, 'HBW'));
  dialogue(
    'Yield stress from hardness',
    [
      h('p', { class: 'bar' }, h('label', {}, 'Hardness ', figure), h('label', {}, 'Scale ', scale)),
      h(
        'p',
        { class: 'quiet' },
        'σy = 2.876 HV − 90.7 MPa, Pavlina and Van Tyne 2008: a line through steels of 300 to 1700 MPa. Rails go by hardness: R260 has 260–300 HBW, R350HT 350–390 HBW (EN 13674-1).',
      ),
    ],
    'Use',
    () => {
      const reading = readNumber(figure.value);
      if ('problem' in reading) return reading.problem;
      const vickers = scale.value === 'HBW' ? reading.value / BRINELL : reading.value;
      if (!(vickers >= SOFTEST && vickers <= HARDEST)) return `The line stands for ${SOFTEST} to ${HARDEST} HV.`;
      use({
        young_modulus: 210000,
        poisson_ratio: 0.3,
        plasticity: { law: 'bilinear', yield_stress: Math.round(strengthOf(vickers)), tangent_modulus: 2100 },
      });
      return '';
    },
  );
}
