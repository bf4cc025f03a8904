/** Questions before the page. */

import { h } from './dom.js';

/**
 * A dialogue of a few entries.
 * @param {string} title
 * @param {import('./dom.js').Child[]} content
 * @param {string} action
 * @param {() => string} done takes what is entered; answers with what is wrong with it
 */
export function dialogue(title, content, action, done) {
  const error = h('p', { class: 'error', role: 'alert' });
  const box = h(
    'dialog',
    { 'aria-labelledby': 'dialogue-title' },
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
      h('h2', { id: 'dialogue-title' }, title),
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
