/** Materials of one's own, kept in this browser. */

import { dialogue } from '../lib/dialogue.js';
import { h, toast } from '../lib/dom.js';
import { browser, isObject, kept } from '../lib/kept.js';
import { PRESETS } from './presets.js';

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
