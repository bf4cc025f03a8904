/**
 * One field of the form: label, entry, unit, hint and what is wrong with it, tied together for
 * screen readers.
 */

import { h, uniqueId } from '../lib/dom.js';
import { doubtOf, readQuantity } from '../lib/number.js';
import { isObject } from '../lib/kept.js';
import { same } from '../lib/pointer.js';
import { heightsControl } from './heights.js';
import { help } from './help.js';
import { historyControl } from './history.js';
import { listControl } from './list.js';
import { pointsControl, termsControl } from './points.js';
import { slider } from './slider.js';
import { written } from './written.js';

/** @typedef {import('./field.js').Field} Field */
/** @typedef {import('../lib/units.js').Quantity} Quantity */
/** @typedef {import('../lib/units.js').Units} Units */
/** @typedef {import('./field.js').Surroundings} Surroundings */
/** @typedef {import('./field.js').Control} Control */
/**
 * @typedef {object} Entry
 * @property {HTMLElement} element
 * @property {HTMLElement} input
 * @property {(() => unknown) | undefined} read the value that its text has now; not of a choice
 * @property {(value: unknown, otherwise: unknown) => void} show the value, or else what holds without one
 * @property {(unit: string) => void} setUnit
 * @property {(message: string) => void} showError an empty message takes it back
 */

/**
 * Most letters that a field of one figure takes: far more than one has, so that none is cut off
 * unseen.
 */
const LONGEST = 1000;

/**
 * @param {Field} field
 * @param {(value: unknown) => void} change called with the value as it goes into the job
 * @param {Surroundings} surroundings
 * @returns {Entry}
 */
export function entry(field, change, surroundings) {
  const id = uniqueId('entry');
  const { input, read, write, problem, beside } = control(field, id, change, surroundings);
  const unit = h('span', { class: 'unit' });
  const error = h('p', { class: 'error', id: `${id}-error`, hidden: true });
  const hint = field.hint && h('p', { class: 'hint', id: `${id}-hint` }, symbol(field.hint));
  input.setAttribute('aria-describedby', `${id}-error${hint ? ` ${id}-hint` : ''}`);
  input.addEventListener(
    field.kind === 'choice' || field.kind === 'flag' ? 'change' : 'input',
    () => change(read()),
  );
  const label = h(
    'label',
    { for: id, id: `${id}-label` },
    field.label,
    field.symbol ? [' ', h('i', {}, symbol(field.symbol))] : null,
  );
  let shown = /** @type {{value: unknown, otherwise: unknown}} */ ({
    value: undefined,
    otherwise: undefined,
  });
  // What is being typed stays as it is typed: `1.` and `0,30` read as the figures that they stand
  // for.
  const show = (/** @type {boolean} */ typing) => {
    if (!typing || !same(read(), shown.value)) write(shown.value ?? shown.otherwise);
  };
  input.addEventListener('blur', () => show(false));
  const own = () => problem?.(shown.value) ?? '';
  const { slide } = surroundings;
  const slides =
    slide && (field.kind ?? 'number') === 'number'
      ? slider({
          name: field.label,
          value: () => shown.value ?? shown.otherwise,
          bounds: field.bounds,
          refused: () => input.getAttribute('aria-invalid') === 'true',
          typical: () =>
            surroundings.wire(typeof field.example === 'number' ? field.example : 1, field),
          move: slide,
        })
      : undefined;
  const explanation = help(
    field.help ?? field.key,
    field.label,
    `${id}-label`,
    field.description,
    true,
  );
  const keys = { F1: explanation?.querySelector('button'), F2: slides?.button };
  input.setAttribute(
    'aria-keyshortcuts',
    Object.keys(keys)
      .filter((key) => keys[/** @type {'F1' | 'F2'} */ (key)])
      .join(' '),
  );
  input.addEventListener('keydown', (event) => {
    const button = keys[/** @type {'F1' | 'F2'} */ (/** @type {KeyboardEvent} */ (event).key)];
    if (!button) return;
    event.preventDefault();
    button.click();
  });
  return {
    element: h(
      'div',
      {
        class: `entry ${field.kind === 'terms' || field.kind === 'heights' ? 'points' : (field.kind ?? 'number')}`,
      },
      h('span', { class: 'name' }, label, explanation),
      h('div', { class: 'value' }, input, unit, slides?.button),
      slides?.element,
      beside ?? null,
      hint,
      error,
    ),
    input,
    read: problem && read,
    show: (value, otherwise) => {
      shown = { value, otherwise };
      show(document.activeElement === input);
      slides?.follow();
    },
    setUnit: (text) => {
      unit.textContent = text;
    },
    showError: (reported) => {
      const message = own() || reported;
      error.textContent = message;
      error.hidden = !message;
      input.setAttribute('aria-invalid', String(Boolean(message)));
    },
  };
}

/** @param {string} text with `_x` and `^x` for what is written below and above @returns {(Node | string)[]} */
export function symbol(text) {
  return text
    .split(/([_^][\wσθ.]+)/)
    .map((part) =>
      part[0] === '_'
        ? h('sub', {}, part.slice(1))
        : part[0] === '^'
          ? h('sup', {}, part.slice(1))
          : part,
    );
}

/** @param {Field} field @param {string} id @param {(value: unknown) => void} change @param {Surroundings} surroundings @returns {Control} */
function control(field, id, change, surroundings) {
  switch (field.kind) {
    case 'choice':
      return choiceControl(field, id);
    case 'flag':
      return flagControl(id);
    case 'points':
      return pointsControl(field, id, change, surroundings);
    case 'heights':
      return heightsControl(id, change, surroundings);
    case 'terms':
      return termsControl(field, id, change, surroundings);
    case 'tags': {
      const input = h('textarea', { id, rows: 2, spellcheck: 'false' });
      const problem = (/** @type {unknown} */ value) =>
        typeof value === 'string' ? faultOfTags(value) : '';
      return { input, ...text(input, readTags, writeTags), problem };
    }
    case 'text': {
      const input = h('input', {
        id,
        type: 'text',
        maxlength: field.longest,
        autocomplete: 'off',
      });
      return { input, ...text(input, (typed) => typed.trim() || undefined, written) };
    }
    case 'history':
      return historyControl(field, id, change, surroundings);
    case 'list':
      return listControl(field, id, surroundings);
    default:
      return numberControl(field, id, surroundings);
  }
}

/** @param {HTMLInputElement | HTMLTextAreaElement} input @param {(text: string) => unknown} read @param {(value: any) => string} write */
const text = (input, read, write) => ({
  read: () => read(input.value),
  write: (/** @type {any} */ value) => {
    input.value = write(value);
  },
});

/** @param {Field} field @param {string} id @returns {Control} */
function choiceControl(field, id) {
  const options = Object.entries(field.choices ?? {}).map(([value, label]) =>
    h('option', { value }, label),
  );
  const input = h(
    'select',
    { id },
    field.optional ? h('option', { value: '' }, field.none ?? 'automatic') : null,
    options,
  );
  return {
    input,
    read: () => (input.value && field.quantity ? Number(input.value) : input.value || undefined),
    write: (value) => {
      input.value = value ?? '';
    },
  };
}

/** @param {string} id @returns {Control} */
function flagControl(id) {
  const input = h('input', { id, type: 'checkbox' });
  return {
    input,
    read: () => input.checked,
    write: (value) => {
      input.checked = value === true;
    },
  };
}

/** @param {Field} field @param {string} id @param {Surroundings} surroundings @returns {Control} */
function numberControl(field, id, { units, quantity }) {
  const typing = { inputmode: 'decimal', autocomplete: 'off', spellcheck: 'false' };
  const input = h('input', { id, type: 'text', maxlength: LONGEST, ...typing });
  const reading = (/** @type {string} */ typed) => {
    const problem = doubtOf(typed);
    return problem ? { problem } : readQuantity(typed, quantity(field), units());
  };
  // What is no number stays in the draft as it is typed, and is refused there.
  const read = (/** @type {string} */ typed) => {
    if (typed.trim() === '') return undefined;
    const result = reading(typed);
    return 'value' in result ? result.value : typed;
  };
  return {
    input,
    ...text(input, read, written),
    problem: (value) => {
      const result = typeof value === 'string' ? reading(value) : { value };
      return 'problem' in result ? result.problem : '';
    },
  };
}

/** Names of tags and what they say. @param {string} text one a line */
const tagsIn = (text) =>
  text
    .split('\n')
    .filter((line) => line.trim())
    .map((line) => {
      const [name, ...rest] = line.split(':');
      return [name.trim(), rest.join(':').trim()];
    });

/** @param {string} text @returns {string} why no tags can be read from it */
function faultOfTags(text) {
  const tags = tagsIn(text);
  const nameless = tags.find(([name]) => !name);
  if (nameless) return `“: ${nameless[1]}” has no name before the colon`;
  const twice = tags.find(([name], k) => tags.findIndex(([other]) => other === name) < k);
  return twice ? `there are two tags “${twice[0]}”: a name stands for one` : '';
}

/** @param {string} text @returns {Record<string, string> | string | undefined} what cannot be read stays as it is typed */
function readTags(text) {
  const tags = tagsIn(text);
  return tags.length === 0 ? undefined : faultOfTags(text) ? text : Object.fromEntries(tags);
}

/** @param {any} value */
const writeTags = (value) =>
  isObject(value)
    ? Object.entries(value)
        .map(([name, text]) => `${name}: ${text}`)
        .join('\n')
    : written(value);
