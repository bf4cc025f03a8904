/**
 * What stands around the contents: which parts are shown, the API key, menus, the title of the
 * tab.
 */

import { hasKey, onKeyWanted, useKey } from './api/client.js';
import { announce } from './api/connection.js';
import { byId } from './lib/dom.js';
import { browser, onKept } from './lib/kept.js';
import { toolbar } from './lib/toolbar.js';

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
  const open = () =>
    /** @type {NodeListOf<HTMLDetailsElement>} */ (
      document.querySelectorAll('details.menu[open]')
    );
  addEventListener('keydown', (event) => {
    if (event.key !== 'Escape') return;
    for (const menu of open()) {
      menu.open = false;
      menu.querySelector('summary')?.focus();
    }
  });
  addEventListener('click', (event) => {
    for (const menu of open())
      if (!menu.contains(/** @type {Node} */ (event.target))) menu.open = false;
  });
}

/** @param {string} part of the page @param {boolean} [on] */
export function showPart(part, on = true) {
  byId(part).hidden = !on;
  byId(`show-${part}`).setAttribute('aria-pressed', String(on));
  browser.set(`show-${part}`, String(on));
}

/** Buttons that show and hide the JSON and the jobs. @param {() => void} jobsShown */
export function startParts(jobsShown) {
  toolbar(byId('parts'), 'Parts, interface, colours');
  toolbar(byId('setup-tools'), 'Set-up');
  for (const part of ['json', 'jobs']) {
    const turn = (/** @type {boolean} */ on) => {
      showPart(part, on);
      if (part === 'jobs') jobsShown();
    };
    byId(`show-${part}`).addEventListener('click', () => {
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
    if (declined || dialog.open) return;
    show(
      refused
        ? `The service does not know this key. Enter another one. ${kept}`
        : `This service asks for a key. ${kept}`,
    );
  });
  byId('api-key').addEventListener('click', () =>
    show(`The key that is used for this service. ${kept}`),
  );
  const text = /** @type {HTMLInputElement} */ (byId('key-text'));
  /** Without what cannot be seen and comes along when one copies. */
  const key = () => text.value.replace(/[\s\u200b-\u200f\u2060\ufeff]/g, '');
  dialog.addEventListener('submit', (event) => {
    const saves = /** @type {HTMLButtonElement | null} */ (event.submitter)?.value === 'save';
    if (!saves || /^[!-~]*$/.test(key())) return;
    event.preventDefault();
    show(
      'This is no key: keys have letters, digits and signs such as - and _. Copy it once more.',
    );
  });
  dialog.addEventListener('close', () => {
    declined = dialog.returnValue !== 'save';
    // Where nothing on the page had the focus before, the dialogue's field has it until the page
    // is drawn.
    const at = document.activeElement;
    if (!at || at === document.body || dialog.contains(at)) byId('api-key').focus();
    if (declined) return;
    if (useKey(key())) location.reload();
    else announce();
  });
}
