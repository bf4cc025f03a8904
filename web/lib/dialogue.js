/** Questions before the page. */

import { h } from './dom.js';

/**
 * A dialogue of a few entries.
 * @param {string} title
 * @param {import('./dom.js').Child[]} content
 * @param {string} action
 * @param {() => string | true} done takes what is entered; answers with what is wrong with it, or with `true` where the dialogue stays
 * @param {() => void} [left] called when it is closed
 * @returns {HTMLDialogElement}
 */
export function dialogue(title, content, action, done, left = () => {}) {
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
          const answer = done();
          error.textContent = answer === true ? '' : answer;
          if (answer) event.preventDefault();
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
  box.addEventListener('close', () => {
    box.remove();
    left();
  });
  document.body.append(box);
  box.showModal();
  return box;
}
