/** What stands around the contents: which parts are shown, and the API key. */

import { onKeyWanted, useKey } from './api/client.js';
import { byId } from './lib/dom.js';

/** Buttons that show and hide the JSON and the jobs. @param {() => void} jobsShown */
export function startParts(jobsShown) {
  for (const part of ['json', 'jobs']) {
    const button = byId(`show-${part}`);
    const turn = (/** @type {boolean} */ on) => {
      byId(part).hidden = !on;
      button.setAttribute('aria-pressed', String(on));
      localStorage.setItem(`show-${part}`, String(on));
      if (part === 'jobs') jobsShown();
    };
    button.addEventListener('click', () => turn(byId(part).hidden));
    turn(localStorage.getItem(`show-${part}`) === 'true');
  }
}

/** Asks for an API key when the service does. */
export function startKeys() {
  const dialog = /** @type {HTMLDialogElement} */ (byId('key-dialog'));
  const show = () => {
    if (!dialog.open) dialog.showModal();
  };
  onKeyWanted(() => {
    byId('api-key').hidden = false;
    show();
  });
  byId('api-key').addEventListener('click', show);
  dialog.addEventListener('close', () => {
    if (dialog.returnValue !== 'save') return;
    useKey(/** @type {HTMLInputElement} */ (byId('key-text')).value.trim());
    location.reload();
  });
}
