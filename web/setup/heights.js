/**
 * A field of heights on a grid: pasted, or opened from a file of text or of NumPy. What it holds
 * is shown as a picture.
 */

import { readGrid } from '../api/npz.js';
import { h } from '../lib/dom.js';
import { same } from '../lib/pointer.js';
import { textOf } from '../lib/text-file.js';
import { inJobUnits } from '../lib/units.js';
import { fileButton, heightUnit } from './points.js';

/**
 * @param {string} text a line for each row; between figures spaces, tabs, semicolons or, where there is nothing else, commas
 * @returns {{heights: number[][]} | {problem: string}}
 */
export function readHeights(text) {
  const lines = text.split(/\r?\n/).filter((line) => line.trim() && !line.trim().startsWith('#'));
  const spaced = lines.some((line) => /[\s;]/.test(line.trim().replace(/,\s+/g, ',')));
  const heights = lines.map((line) =>
    spaced
      ? line
          .trim()
          .split(/[\s;]+/)
          .filter(Boolean)
          .map((one) => Number(one.replace(/,$/, '').replace(',', '.')))
      : line.split(',').map((one) => (one.trim() ? Number(one) : NaN)),
  );
  return faultOf(heights) ? { problem: faultOf(heights) } : { heights };
}

/** @param {number[][]} heights @returns {string} what is wrong with them */
function faultOf(heights) {
  const columns = heights[0]?.length ?? 0;
  const uneven = heights.findIndex((row) => row.length !== columns);
  if (heights.length < 2 || columns < 2) return 'a grid of heights is wanted, a line for each x';
  if (uneven > 0)
    return `line ${uneven + 1} has ${heights[uneven].length} heights, the first has ${columns}`;
  const hole = heights.findIndex((row) => !row.every(Number.isFinite));
  return hole < 0 ? '' : `line ${hole + 1} has a height that is no number: fill holes before`;
}

/** @param {unknown} value @returns {value is number[][]} */
const isGrid = (value) => Array.isArray(value) && value.every(Array.isArray);

/**
 * @param {string} id
 * @param {(value: unknown) => void} change
 * @param {import('./entry.js').Surroundings} surroundings
 * @returns {import('./entry.js').Control}
 */
export function heightsControl(id, change, { units }) {
  const input = h('textarea', { id, rows: 2, spellcheck: 'false', autocomplete: 'off' });
  const note = h('p', { class: 'note', role: 'status' });
  /** What the field holds while its text is empty. @type {unknown} */
  let held;
  const read = () => {
    if (!input.value.trim()) return held;
    const result = readHeights(input.value);
    return 'heights' in result ? result.heights : input.value;
  };
  const write = (/** @type {unknown} */ value) => {
    if (!same(value, held)) note.textContent = '';
    held = value;
    // A grid is no text to be read: its picture stands below.
    input.value = typeof value === 'string' ? value : '';
    input.placeholder = isGrid(value)
      ? `${value.length} × ${value[0]?.length ?? 0} heights; paste others here`
      : 'Paste a grid of heights';
  };
  const put = (/** @type {number[][]} */ heights, /** @type {string} */ words) => {
    write(heights);
    note.textContent = words;
    change(heights);
  };
  const take = (/** @type {{heights: number[][]} | {problem: string}} */ result) => {
    if ('problem' in result) note.textContent = `Not taken: ${result.problem}`;
    else
      put(result.heights, `${result.heights.length} × ${result.heights[0].length} heights read`);
  };
  const open = async (/** @type {File | undefined} */ file) => {
    if (!file) return;
    try {
      if (!file.name.endsWith('.npy')) {
        const read = await textOf(file);
        return take('problem' in read ? read : readHeights(read.text));
      }
      const heights = readGrid(await file.arrayBuffer());
      const problem = faultOf(heights);
      take(problem ? { problem } : { heights });
    } catch (error) {
      take({ problem: /** @type {Error} */ (error).message });
    }
  };
  input.addEventListener('paste', (event) => {
    const text = event.clipboardData?.getData('text') ?? '';
    if (!text.trim().includes('\n') || input.value.trim()) return;
    event.preventDefault();
    take(readHeights(text));
  });
  input.addEventListener('dragover', (event) => event.preventDefault());
  input.addEventListener('drop', (event) => {
    const file = event.dataTransfer?.files[0];
    if (file) event.preventDefault();
    open(file);
  });
  const each = (
    /** @type {(heights: number[][]) => number[][]} */ work,
    /** @type {string} */ words,
  ) => {
    if (isGrid(held)) put(work(held), words);
  };
  const turn = () =>
    each(
      (heights) => heights[0].map((_, j) => heights.map((row) => row[j])),
      'rows and columns exchanged',
    );
  const convert = (/** @type {string} */ name) =>
    each(
      (heights) =>
        heights.map((row) => row.map((one) => inJobUnits(one, name, 'length', units()) ?? one)),
      `heights converted from ${name}`,
    );
  return {
    input,
    read,
    write,
    problem: (value) => {
      const result = typeof value === 'string' ? readHeights(value) : undefined;
      return result && 'problem' in result ? result.problem : '';
    },
    beside: [
      h(
        'div',
        { class: 'bar beside' },
        fileButton(open, 'Open file…', ',.npy,.asc'),
        heightUnit(convert),
        h(
          'button',
          {
            type: 'button',
            class: 'plain',
            title: 'For grids whose lines lie along x',
            onclick: turn,
          },
          'x ↔ y',
        ),
      ),
      note,
    ],
  };
}
