/** Materials of one's own, kept in this browser, and strengths from a hardness. */

import { dialogue } from '../lib/dialogue.js';
import { h, toast } from '../lib/dom.js';
import { browser, isObject, kept } from '../lib/kept.js';
import { readNumber } from '../lib/number.js';
import { PRESETS } from './presets.js';
import { ROCKWELL } from './tables.js';

/** @typedef {import('./materials.js').Preset} Preset */

const KEPT = 'materials';

const listeners = /** @type {Set<() => void>} */ (new Set());

/** @param {() => void} listener called when one's own materials have changed, here or in another tab */
export function onMaterials(listener) {
  if (listeners.size === 0) addEventListener('storage', ({ key }) => key === KEPT && tell());
  listeners.add(listener);
}

function tell() {
  for (const listener of listeners) listener();
}

/** @returns {Preset[]} */
export function ownMaterials() {
  const good = (/** @type {any} */ one) => typeof one?.name === 'string' && isObject(one.material);
  const read = (/** @type {any} */ all) => (Array.isArray(all) ? all.filter(good) : undefined);
  return kept(browser, KEPT, read) ?? [];
}

/** @returns {Preset[]} */
export const allMaterials = () => [...ownMaterials(), ...PRESETS];

/** @param {Preset[]} all @returns {boolean} whether they are kept when the page is closed */
const write = (all) =>
  browser.set(KEPT, JSON.stringify(all.sort((a, b) => a.name.localeCompare(b.name))));

/** @param {Preset} preset replaces one of the same name */
const keep = (preset) =>
  write([...ownMaterials().filter(({ name }) => name !== preset.name), preset]);

/**
 * Yield strength of a steel from its Vickers hardness: Pavlina and Van Tyne, J. Mater. Eng.
 * Perform. 17 (2008) 888, a line through some 150 steels from 300 to 1700 MPa. [MPa]
 * @param {number} hardness
 */
export const strengthOf = (hardness) => -90.7 + 2.876 * hardness;

/** Hardnesses for which the line stands. */
const [SOFTEST, HARDEST] = [136, 622];
/** Brinell over Vickers hardness, ISO 18265. */
const BRINELL = 0.95;
/** @param {number} value @param {string} scale @returns {number} Vickers hardness; nothing where the table has none */
export function vickersOf(value, scale) {
  if (scale === 'HBW') return value / BRINELL;
  if (scale !== 'HRC') return value;
  const next = ROCKWELL.findIndex(([rockwell]) => rockwell >= value);
  if (next < 1) return value === ROCKWELL[0][0] ? ROCKWELL[0][1] : NaN;
  const [[c0, v0], [c1, v1]] = [ROCKWELL[next - 1], ROCKWELL[next]];
  return v0 + ((v1 - v0) * (value - c0)) / (c1 - c0);
}

/** @param {Record<string, any>} material in mm, N, MPa @param {unknown} given name that it has @param {(name: string) => void} done */
export function askToKeep(material, given, done) {
  const name = h('input', { type: 'text', maxlength: 80, value: String(given ?? '') });
  const source = h('input', { type: 'text', maxlength: 200 });
  /** The name under which one may be replaced. */
  let replaced = '';
  dialogue(
    'Keep this material',
    [
      h('label', {}, 'Name ', name),
      h('label', {}, 'Source of its figures ', source),
      h('p', { class: 'quiet' }, 'It is kept in this browser.'),
    ],
    'Keep',
    () => {
      const called = name.value.trim().replace(/\s+/g, ' ');
      const alike = (/** @type {Preset} */ one) => one.name.toLowerCase() === called.toLowerCase();
      if (!called) return 'A material has a name.';
      if (PRESETS.some(alike))
        return 'The library has a material of this name: choose another name.';
      const before = ownMaterials().find(alike)?.name;
      if (before && before !== replaced) {
        replaced = before;
        return `You have kept a material “${before}”. Press Keep again to replace it, or choose another name.`;
      }
      const keeps = keep({
        name: before ?? called,
        source: source.value.trim() || 'Own figures.',
        material,
      });
      if (!keeps)
        toast('The browser stores nothing more: the material is there until this page is closed');
      done(before ?? called);
      tell();
      return '';
    },
  );
}

/** @param {string} name */
export function askToForget(name) {
  const words = `“${name}” is removed from this browser. Jobs that have it stay as they are.`;
  dialogue('Forget a material', [h('p', {}, words)], 'Forget', () => {
    write(ownMaterials().filter((one) => one.name !== name));
    tell();
    return '';
  });
}

/** @param {(material: Record<string, any>) => void} use */
export function askHardness(use) {
  const figure = h('input', { type: 'text', inputmode: 'decimal' });
  const scale = h(
    'select',
    {},
    h('option', { value: 'HV' }, 'HV'),
    h('option', { value: 'HBW' }, 'HBW'),
    h('option', { value: 'HRC' }, 'HRC'),
  );
  dialogue(
    'Yield stress from hardness',
    [
      h(
        'p',
        { class: 'bar' },
        h('label', {}, 'Hardness ', figure),
        h('label', {}, 'Scale ', scale),
      ),
      h(
        'p',
        { class: 'quiet' },
        'σy = 2.876 HV − 90.7 MPa, Pavlina and Van Tyne 2008: a line through steels of 300 to 1700 MPa. Rails go by hardness: R260 has 260–300 HBW, R350HT 350–390 HBW (EN 13674-1). HBW and HRC become HV by ISO 18265, table A.1.',
      ),
    ],
    'Use',
    () => {
      const reading = readNumber(figure.value);
      if ('problem' in reading) return reading.problem;
      const vickers = vickersOf(reading.value, scale.value);
      if (!(vickers >= SOFTEST && vickers <= HARDEST)) {
        const is =
          scale.value !== 'HV' && vickers
            ? `${reading.value} ${scale.value} is ${Math.round(vickers)} HV. `
            : '';
        return `${is}The line stands for ${SOFTEST} to ${HARDEST} HV${scale.value === 'HRC' ? ', 20.3 to 56.3 HRC' : ''}.`;
      }
      use({
        young_modulus: 210000,
        poisson_ratio: 0.3,
        plasticity: {
          law: 'bilinear',
          yield_stress: Math.round(strengthOf(vickers)),
          tangent_modulus: 2100,
        },
      });
      return '';
    },
  );
}
