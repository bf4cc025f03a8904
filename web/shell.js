/** What stands around the contents: which parts are shown, the API key, menus, the title of the tab. */

import { hasKey, onKeyWanted, useKey } from './api/client.js';
import { announce } from './api/connection.js';
import { byId } from './lib/dom.js';
import { browser, onKept } from './lib/kept.js';

const NAME = document.title;

/** @param {string} [state] of the job, which the tab says before the page's name */
export const showTitle = (state) => {
  document.title = state ? `${state} · Brinell` : NAME;
};

/** Says where the browser keeps nothing. */
export function startMemory() {
  onKept((keeps) => {
    byId('memory').hidden = keeps;
  });
}

/** Menus close by Escape and by a click elsewhere. */
export function startMenus() {
  const open = () => /** @type {NodeListOf<HTMLDetailsElement>} */ (document.querySelectorAll('details.menu[open]'));
  addEventListener('keydown', (event) => {
    if (event.key !== 'Escape') return;
    for (const menu of open()) {
      menu.open = false;
      menu.querySelector('summary')?.focus();
    }
  });
  addEventListener('click', (event) => {
    for (const menu of open()) if (!menu.contains(/** @type {Node} */ (event.target))) menu.open = false;
  });
}

/** Buttons that show and hide the JSON and the jobs. @param {() => void} jobsShown */
export function startParts(jobsShown) {
  for (const part of ['json', 'jobs']) {
    const button = byId(`show-${part}`);
    const turn = (/** @type {boolean} */ on) => {
      byId(part).hidden = !on;
      button.setAttribute('aria-pressed', String(on));
      browser.set(`show-${part}`, String(on));
      if (part === 'jobs') jobsShown();
    };
    button.addEventListener('click', () => {
      turn(byId(part).hidden);
      // On a narrow page the parts are stacked, and this one may be far below.
      if (!byId(part).hidden && innerWidth <= 900) byId(part).scrollIntoView();
    });
    turn(browser.get(`show-${part}`) === 'true');
  }
}

/** Asks for an API key when the service does. */
export function startKeys() {
  const dialog = /** @type {HTMLDialogElement} */ (byId('key-dialog'));
  const show = (/** @type {string} */ words) => {
    byId('key-words').textContent = words;
    if (!dialog.open) dialog.showModal();
  };
  const kept = 'It is kept until this tab is closed.';
  byId('api-key').hidden = !hasKey();
  let declined = false;
  onKeyWanted((refused) => {
    byId('api-key').hidden = false;
    // Every change of the form asks the service: who has said no is not asked again at each.
    if (declined) return;
    show(
      refused
        ? `The service does not know this key. Enter another one. ${kept}`
        : `This service asks for a key. ${kept}`,
    );
  });
  byId('api-key').addEventListener('click', () => show(`The key that is used for this service. ${kept}`));
  dialog.addEventListener('close', () => {
    declined = dialog.returnValue !== 'save';
    if (declined) return;
    if (useKey(/** @type {HTMLInputElement} */ (byId('key-text')).value.trim())) location.reload();
    else announce();
  });
}
