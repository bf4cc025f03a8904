/** What is folded stays as somebody has left it, however often it is drawn anew. */

import { h } from './dom.js';

/** Folds that were opened or closed by hand. @type {Map<string, boolean>} */
const left = new Map();

/**
 * @param {string} key of folds that are the same
 * @param {boolean} open until somebody opens or closes it
 * @param {import('./dom.js').Child[]} summary
 * @param {...(import('./dom.js').Child | import('./dom.js').Child[])} content
 */
export function fold(key, open, summary, ...content) {
  const head = h('summary', {}, summary);
  const element = h('details', { open: left.get(key) ?? open }, head, ...content);
  head.addEventListener('click', () => left.set(key, !element.open));
  return element;
}
