/** The job as text beside the form: a change of one is a change of the other. */

import { byId, debounce } from '../lib/dom.js';

const SOURCE = 'json';
/** Said where text and form are of the same job. */
const ALIKE = 'same job as in the form';

/**
 * What is typed and is no job stays until it is put right, or given up for what the form has.
 * @param {import('./draft.js').Draft} draft
 * @returns {{read: () => string, focusFault: () => void, remark: (words: string) => void}} `read` takes what is typed at once; answers with what is wrong with it
 */
export function startJson(draft) {
  const text = /** @type {HTMLTextAreaElement} */ (byId('json-text'));
  const state = byId('json-state');
  const give = /** @type {HTMLButtonElement} */ (byId('json-again'));
  let typed = false;
  /** What is wrong with what is typed. */
  let fault = '';
  /** What the service says of a job that can be read. */
  let remark = '';
  const show = () => {
    text.value = print(draft.job);
    take('');
  };
  const take = (/** @type {string} */ wrong) => {
    fault = wrong;
    if (wrong) text.setAttribute('aria-invalid', 'true');
    else text.removeAttribute('aria-invalid');
    state.textContent = wrong || remark || ALIKE;
    give.hidden = !wrong;
    return wrong;
  };
  const read = () => {
    if (!typed) return fault;
    typed = false;
    try {
      const job = JSON.parse(text.value.replace(/^\ufeff/, ''), finite);
      if (job === null || typeof job !== 'object' || Array.isArray(job))
        throw new Error('a job is an object');
      draft.replace(job, SOURCE);
      return take('');
    } catch (error) {
      return take(/** @type {Error} */ (error).message);
    }
  };
  draft.addEventListener('change', (event) => {
    if (/** @type {CustomEvent} */ (event).detail === SOURCE) take('');
    else if (!fault && !typed) show();
    else take(read() || fault);
  });
  give.addEventListener('click', () => {
    typed = false;
    show();
    text.focus();
  });
  const later = debounce(read, 200);
  text.addEventListener('input', () => {
    typed = true;
    later();
  });
  const focusFault = () => {
    text.focus();
    const at = Number(/position (\d+)/.exec(fault)?.[1] ?? NaN);
    if (at >= 0) text.setSelectionRange(at, at);
  };
  return {
    read,
    focusFault,
    remark: (words) => {
      remark = words;
      take(fault);
    },
  };
}

/** @param {string} key @param {unknown} value @returns {unknown} the same, unless it is a number that JSON cannot carry on */
function finite(key, value) {
  if (typeof value === 'number' && !Number.isFinite(value))
    throw new Error(`“${key}” is too large for a number`);
  return value;
}

/** Two spaces, with lists of numbers and small objects on one line. @param {unknown} value @returns {string} */
export function print(value, indent = '') {
  const flat = JSON.stringify(value);
  if (
    value === null ||
    typeof value !== 'object' ||
    (flat.length < 40 && !/[[{].*[[{].*[[{]/.test(flat))
  ) {
    return value !== null && typeof value === 'object' ? spaced(value) : flat;
  }
  const deeper = `${indent}  `;
  if (Array.isArray(value))
    return `[\n${value.map((one) => deeper + print(one, deeper)).join(',\n')}\n${indent}]`;
  const entries = Object.entries(value).map(
    ([key, one]) => `${deeper}${JSON.stringify(key)}: ${print(one, deeper)}`,
  );
  return `{\n${entries.join(',\n')}\n${indent}}`;
}

/** @param {object} value @returns {string} */
function spaced(value) {
  const inner = (/** @type {unknown} */ one) =>
    one !== null && typeof one === 'object' ? spaced(one) : JSON.stringify(one);
  if (Array.isArray(value)) return `[${value.map(inner).join(', ')}]`;
  const entries = Object.entries(value).map(
    ([key, one]) => `${JSON.stringify(key)}: ${inner(one)}`,
  );
  return entries.length ? `{ ${entries.join(', ')} }` : '{}';
}
