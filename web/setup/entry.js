/** One field of the form: label, entry, unit, hint and the service's complaint, tied together for screen readers. */

import { h } from '../lib/dom.js';

/** @typedef {import('./fields.js').Field} Field */
/**
 * @typedef {object} Entry
 * @property {HTMLElement} element
 * @property {HTMLElement} input
 * @property {(value: unknown) => void} show a value, unless it is being typed
 * @property {(unit: string) => void} setUnit
 * @property {(message: string) => void} complain; nothing takes the complaint back
 */

let count = 0;

/**
 * @param {Field} field
 * @param {(value: unknown) => void} change called with the value as it goes into the job
 * @returns {Entry}
 */
export function entry(field, change) {
  const id = `entry-${++count}`;
  const { input, read, write } = control(field, id);
  const unit = h('span', { class: 'unit' });
  const error = h('p', { class: 'error', id: `${id}-error`, hidden: true });
  const hint = field.hint && h('p', { class: 'hint', id: `${id}-hint` }, symbol(field.hint));
  input.setAttribute('aria-describedby', `${id}-error${hint ? ` ${id}-hint` : ''}`);
  input.addEventListener(field.kind === 'choice' || field.kind === 'flag' ? 'change' : 'input', () => change(read()));
  const label = h('label', { for: id }, field.label, field.symbol ? [' ', h('i', {}, symbol(field.symbol))] : null);
  return {
    element: h(
      'div',
      { class: `entry ${field.kind ?? 'number'}` },
      label,
      h('div', { class: 'value' }, input, unit),
      hint,
      error,
    ),
    input,
    show: (value) => {
      if (document.activeElement !== input || field.kind === 'choice') write(value);
    },
    setUnit: (text) => {
      unit.textContent = text;
    },
    complain: (message) => {
      error.textContent = message;
      error.hidden = !message;
      input.setAttribute('aria-invalid', String(Boolean(message)));
    },
  };
}

/** @param {string} text with `_x` and `^x` for what is written below and above @returns {(Node | string)[]} */
export function symbol(text) {
  return text
    .split(/([_^][\wσ.]+)/)
    .map((part) =>
      part[0] === '_' ? h('sub', {}, part.slice(1)) : part[0] === '^' ? h('sup', {}, part.slice(1)) : part,
    );
}

/**
 * @param {Field} field
 * @param {string} id
 * @returns {{input: HTMLInputElement | HTMLSelectElement | HTMLTextAreaElement, read: () => unknown, write: (value: any) => void}}
 */
function control(field, id) {
  if (field.kind === 'choice') {
    const options = Object.entries(field.choices ?? {}).map(([value, label]) => h('option', { value }, label));
    const input = h('select', { id }, options);
    return {
      input,
      read: () => input.value,
      write: (value) => {
        input.value = value ?? '';
      },
    };
  }
  if (field.kind === 'flag') {
    const input = h('input', { id, type: 'checkbox' });
    return {
      input,
      read: () => input.checked,
      write: (value) => {
        input.checked = value === true;
      },
    };
  }
  if (field.kind === 'points' || field.kind === 'tags') {
    const input = h('textarea', { id, rows: field.kind === 'tags' ? 2 : 5, spellcheck: 'false' });
    const [read, write] = field.kind === 'tags' ? [readTags, writeTags] : [readPoints, writePoints];
    return {
      input,
      read: () => read(input.value),
      write: (value) => {
        input.value = write(value);
      },
    };
  }
  const input = h('input', {
    id,
    type: 'text',
    inputmode: field.kind === 'list' ? 'text' : 'decimal',
    autocomplete: 'off',
    spellcheck: 'false',
  });
  if (field.kind === 'list')
    return {
      input,
      read: () => readList(input.value),
      write: (value) => {
        input.value = writeList(value);
      },
    };
  return {
    input,
    read: () => readNumber(input.value),
    write: (value) => {
      input.value = value === undefined ? '' : String(value);
    },
  };
}

/** What is no number goes to the service as it stands, which says what is wrong with it. @param {string} text */
export function readNumber(text) {
  const plain = text.trim().replace(/^([^.,]*),([^.,]*)$/, '$1.$2');
  if (plain === '') return undefined;
  return Number.isFinite(Number(plain)) ? Number(plain) : text;
}

/** @param {string} text numbers, or `first…last/count` */
export function readList(text) {
  const range = /^\s*(\S+?)\s*(?:…|\.\.\.?)\s*(\S+?)\s*\/\s*(\d+)\s*$/.exec(text);
  if (range) {
    const [first, last, many] = [Number(range[1]), Number(range[2]), Math.min(Number(range[3]), 1000)];
    const at = (/** @type {number} */ k) =>
      Number((first + ((last - first) * k) / Math.max(1, many - 1)).toPrecision(8));
    if (Number.isFinite(first + last)) return Array.from({ length: many }, (_, k) => at(k));
  }
  return text
    .split(/[\s;]+|,\s+/)
    .filter(Boolean)
    .map(readNumber);
}

/** @param {any} value */
const writeList = (value) => (Array.isArray(value) ? value.join(' ') : (value ?? ''));

/** @param {string} text */
const readPoints = (text) =>
  text
    .split('\n')
    .filter((line) => line.trim())
    .map((line) =>
      line
        .trim()
        .split(/[\s;]+|,\s*/)
        .map(readNumber),
    );

/** @param {any} value */
const writePoints = (value) =>
  Array.isArray(value) ? value.map((point) => (Array.isArray(point) ? point.join('  ') : point)).join('\n') : '';

/** @param {string} text */
function readTags(text) {
  const lines = text.split('\n').filter((line) => line.trim());
  if (lines.length === 0) return undefined;
  return Object.fromEntries(
    lines.map((line) => {
      const [name, ...rest] = line.split(':');
      return [name.trim(), rest.join(':').trim()];
    }),
  );
}

/** @param {any} value */
const writeTags = (value) =>
  Object.entries(value ?? {})
    .map(([name, text]) => `${name}: ${text}`)
    .join('\n');
