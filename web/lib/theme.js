/** Light and dark colours: those of the system, or as chosen here. */

import { byId } from './dom.js';
import { browser } from './kept.js';

const ORDER = ['auto', 'light', 'dark'];
const NAMES = { auto: 'as the system', light: 'light', dark: 'dark' };
const systemDark = matchMedia('(prefers-color-scheme: dark)');
const listeners = /** @type {Set<() => void>} */ (new Set());

/** @param {() => void} listener called when colours change */
export const onTheme = (listener) => listeners.add(listener);

/** @param {string} name of a custom property @returns {string} a colour */
export const colour = (name) =>
  getComputedStyle(document.documentElement).getPropertyValue(name).trim();

/**
 * @param {string} name of a custom property
 * @returns {string} the colour it has on paper, which is light
 */
export const paper = (name) => getComputedStyle(byId('paper')).getPropertyValue(name).trim();

/** @param {keyof typeof NAMES} theme */
function apply(theme) {
  const dark = theme === 'auto' ? systemDark.matches : theme === 'dark';
  document.documentElement.dataset.colours = dark ? 'dark' : 'light';
  const button = byId('theme');
  button.textContent = theme[0].toUpperCase() + theme.slice(1);
  button.setAttribute('aria-label', `${button.textContent}: colours ${NAMES[theme]}`);
  for (const listener of listeners) listener();
}

export function startTheme() {
  const kept = browser.get('theme') ?? 'auto';
  let theme = /** @type {keyof typeof NAMES} */ (ORDER.includes(kept) ? kept : 'auto');
  apply(theme);
  byId('theme').addEventListener('click', () => {
    theme = /** @type {keyof typeof NAMES} */ (ORDER[(ORDER.indexOf(theme) + 1) % ORDER.length]);
    browser.set('theme', theme);
    apply(theme);
  });
  systemDark.addEventListener('change', () => apply(theme));
}
