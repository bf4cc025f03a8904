/**
 * A field of heights on a grid: pasted, or opened from a file of text or of NumPy. What the file
 * does not say is asked, what is no height is named, and what is too much can be thinned.
 */

import { ask } from '../api/client.js';
import { readGrid } from '../api/npz.js';
import { button, h, plainButton } from '../lib/dom.js';
import { readQuantity } from '../lib/number.js';
import { same } from '../lib/pointer.js';
import { textOf } from '../lib/text-file.js';
import { grouped, inJobUnits, megabytes, plain, unit } from '../lib/units.js';
import { NotUnderstood, lengthInMm, readGridText } from './grid-text.js';
import {
  cropped,
  each,
  filled,
  lossWords,
  missing,
  sizeOf,
  suspects,
  thinned,
  transposed,
} from './grid-work.js';
import { fileButton, heightUnit, takesFiles } from './points.js';

/** Least and most heights along a side that a job takes. */
const [LEAST, MOST] = [8, 512];
/** Part of a request that its heights may take, and letters of one. */
const [ROOM, LETTERS] = [0.9, 15];
/** Largest file [bytes]: 2048 × 2048 heights of text. */
const LARGEST = 64e6;
const UNITS = ['mm', 'µm', 'nm', 'm', 'in'];

/** @typedef {import('./grid-text.js').Grid} Grid */
/**
 * @typedef {object} Question that stands between a grid and the job
 * @property {string} words
 * @property {[name: string, work: (grid: Grid) => Grid][]} answers
 */

/**
 * What has to be answered before a grid is taken, the first of it.
 * @param {Grid & {certain?: boolean}} grid
 * @param {number} most heights along a side
 * @param {string} [why] more are not taken
 * @returns {Question | undefined}
 */
export function questionOf(grid, most, why = '') {
  const { heights, notes } = grid;
  const doubtful = grid.certain ? undefined : suspects(heights);
  if (doubtful)
    return {
      words: doubtful.words,
      answers: [
        [
          'Make holes of them',
          (of) => ({
            ...of,
            heights: doubtful.holes,
            notes: [...notes, `${grouped(doubtful.count)} heights made holes`],
          }),
        ],
        ['They are heights', (of) => /** @type {Grid} */ ({ ...of, certain: true })],
      ],
    };
  const holes = missing(heights);
  const all = heights.length * heights[0].length;
  if (holes === all) return { words: 'None of the heights is known.', answers: [] };
  if (holes > 0)
    return {
      words: `${grouped(holes)} of ${grouped(all)} heights are missing.`,
      answers: [
        [
          'Fill the holes from their rims',
          (of) => ({
            ...of,
            heights: filled(heights),
            notes: [...notes, `${grouped(holes)} heights filled in from the rims of holes`],
          }),
        ],
      ],
    };
  if (Math.max(heights.length, heights[0].length) > most) {
    const fewer = thinned(heights, most);
    const middle = cropped(heights, most);
    const lost = lossWords(heights, fewer.heights, fewer.times);
    return {
      words: `${sizeOf(heights)} heights are more than the ${most} along a side that are taken${why}. Thinning: ${lost}.`,
      answers: [
        [
          `Thin to ${sizeOf(fewer.heights)}`,
          (of) => ({
            ...of,
            heights: fewer.heights,
            spacing: of.spacing && [
              of.spacing[0] * fewer.times[0],
              of.spacing[1] * fewer.times[1],
            ],
            times: fewer.times,
            notes: [...notes, lost],
          }),
        ],
        [
          `Keep the middle ${sizeOf(middle)}`,
          (of) => ({
            ...of,
            heights: middle,
            notes: [...notes, `the middle ${sizeOf(middle)} of ${sizeOf(heights)} kept`],
          }),
        ],
      ],
    };
  }
  if (Math.min(heights.length, heights[0].length) < LEAST)
    return {
      words: `${sizeOf(heights)} heights are too few: at least ${LEAST} along a side are wanted.`,
      answers: [],
    };
  return undefined;
}

/**
 * A grid in the units of the job.
 * @param {Grid & {times?: [number, number]}} grid with all units and, unless they are given, distances
 * @param {import('../lib/units.js').Units} units
 * @returns {{heights: number[][], spacing_x: number, spacing_y: number}}
 */
export function inJob({ heights, spacing = [NaN, NaN], across, up }, units) {
  const own = lengthInMm(unit('length', units)) ?? 1;
  const factor = (/** @type {string} */ name) => (lengthInMm(name) ?? NaN) / own;
  // Beyond eight digits stands the noise of conversions.
  const short = (/** @type {number} */ one) => Number(one.toPrecision(8));
  return {
    heights: each(heights, (one) => short(one * factor(up))),
    spacing_x: short(spacing[0] * factor(across)),
    spacing_y: short(spacing[1] * factor(across)),
  };
}

/** Most heights along a side that go into a request, and why. @param {number[][]} heights */
async function mostOf(heights) {
  const { limits } = /** @type {any} */ (await ask('v1/capacity').catch(() => ({})));
  const room = limits?.body_bytes ?? Infinity;
  const letters = LETTERS * heights.length * heights[0].length;
  const longer = Math.max(heights.length, heights[0].length);
  const most = Math.floor(longer * Math.sqrt((ROOM * room) / letters));
  return most < Math.min(longer, MOST)
    ? { most, why: ` where a request may have ${megabytes(room)}; ${MOST} are the most with more` }
    : { most: MOST, why: '' };
}

/** @param {unknown} value @returns {value is number[][]} */
const isGrid = (value) => Array.isArray(value) && value.every(Array.isArray);

/** @param {string} text what was typed @returns {string} why no heights can be read from it */
function faultOf(text) {
  try {
    readGridText(text);
    return '';
  } catch (error) {
    return /** @type {Error} */ (error).message;
  }
}

/**
 * @param {string} id
 * @param {(value: unknown) => void} change
 * @param {import('./field.js').Surroundings} surroundings
 * @returns {import('./field.js').Control}
 */
export function heightsControl(id, change, { units, beside }) {
  const input = h('textarea', { id, rows: 2, spellcheck: 'false', autocomplete: 'off' });
  const note = h('p', { class: 'note', role: 'status' });
  const panel = h('div', { class: 'asked', hidden: true });
  /** What the field holds while its text is empty. @type {unknown} */
  let held;
  // What is typed is taken as a file is: when it is done, with what it does not say.
  const read = () => (input.value.trim() && faultOf(input.value) ? input.value : held);
  const write = (/** @type {unknown} */ value) => {
    if (!same(value, held)) {
      note.textContent = '';
      show();
    }
    held = value;
    // A grid is no text to be read: its picture stands below.
    input.value = typeof value === 'string' ? value : '';
    input.placeholder = isGrid(value)
      ? `${value.length} × ${value[0]?.length ?? 0} heights; paste others here`
      : 'Paste a grid of heights';
  };
  const show = (/** @type {Node[]} */ ...children) => {
    panel.replaceChildren(...children);
    panel.hidden = !children.length;
  };
  const leave = plainButton('Leave it', () => (show(), (note.textContent = 'Not taken')));
  const buttons = (/** @type {[string, () => void][]} */ answers) =>
    h('div', { class: 'bar' }, ...answers.map(([name, work]) => button(name, work)), leave);
  /** Takes a grid, or asks what stands between. @param {Grid} grid @param {{most: number, why: string}} limit */
  const consider = (grid, limit) => {
    const question = questionOf(grid, limit.most, limit.why);
    const said = `${sizeOf(grid.heights)} heights read, not taken yet. ${sentences(grid.notes)}`;
    if (question) {
      note.textContent = said;
      const answers = question.answers.map(
        ([name, work]) =>
          /** @type {[string, () => void]} */ ([name, () => consider(work(grid), limit)]),
      );
      return show(h('p', {}, question.words), buttons(answers));
    }
    if (grid.spacing && grid.across && grid.up) return finish(grid);
    note.textContent = said;
    const form = lengthsForm(grid, units, (answered) => finish(answered));
    show(...form.children, buttons([['Take them', form.take]]));
  };
  const finish = (/** @type {Grid} */ grid) => {
    const values = inJob(grid, units());
    const length = unit('length', units());
    write(values.heights);
    beside(values);
    show();
    note.textContent = `${sizeOf(values.heights)} heights read, ${plain(values.spacing_x)} × ${plain(values.spacing_y)} ${length} apart. ${sentences(grid.notes)}`;
  };
  /** @param {() => Grid} reading @param {(skip: number) => void} [without] reads again without a line */
  const take = async (reading, without) => {
    show();
    try {
      const grid = reading();
      consider(grid, await mostOf(grid.heights));
    } catch (error) {
      const { message, line } = /** @type {NotUnderstood} */ (error);
      note.textContent = `Not taken: ${message}`;
      if (line === undefined || !without) return;
      show(
        h('p', {}, 'Do the heights depend on this line?'),
        buttons([[`Leave line ${line} out`, () => without(line)]]),
      );
    }
  };
  const takeText = (/** @type {string} */ text, /** @type {number[]} */ skip = []) =>
    take(
      () => readGridText(text, skip),
      (line) => takeText(text, [...skip, line]),
    );
  const open = async (/** @type {File | undefined} */ file) => {
    if (!file) return;
    note.textContent = `“${file.name}” is read…`;
    if (file.name.endsWith('.npy')) {
      const buffer = await file.arrayBuffer();
      const notes = ['an array: rows along y, one for each x'];
      return take(() => ({ heights: readGrid(buffer), across: '', up: '', notes }));
    }
    const read = await textOf(file, LARGEST);
    if ('text' in read) return takeText(read.text);
    show();
    note.textContent = `Not taken: ${read.problem}`;
  };
  input.addEventListener('paste', (event) => {
    const text = event.clipboardData?.getData('text') ?? '';
    const whole = input.selectionEnd - input.selectionStart === input.value.length;
    if (!text.trim().includes('\n') || !whole) return;
    event.preventDefault();
    takeText(text);
  });
  input.addEventListener('change', () => {
    const text = input.value;
    if (text.trim() && !faultOf(text)) takeText(text);
  });
  takesFiles(input, open);
  const work = (
    /** @type {(heights: number[][]) => number[][]} */ change_,
    /** @type {string} */ words,
  ) => {
    if (!isGrid(held)) return;
    const heights = change_(held);
    write(heights);
    note.textContent = words;
    change(heights);
  };
  const convert = (/** @type {string} */ name) =>
    work(
      (heights) => each(heights, (one) => inJobUnits(one, name, 'length', units()) ?? one),
      `heights converted from ${name}`,
    );
  return {
    input,
    read,
    write,
    problem: (value) => (typeof value === 'string' ? faultOf(value) : ''),
    beside: [
      h(
        'div',
        { class: 'bar beside' },
        fileButton(open, 'Open file…', ',.npy,.asc,.xyz,.grd,.csv'),
        heightUnit(convert),
        plainButton('x ↔ y', () => work(transposed, 'rows and columns exchanged'), {
          title: 'For grids whose lines lie along x',
        }),
      ),
      note,
      panel,
    ],
  };
}

/** @param {string[]} notes */
const sentences = (notes) =>
  notes.map((one) => `${one.charAt(0).toUpperCase()}${one.slice(1)}.`).join(' ');

/**
 * Asks for the units and distances that a file does not say.
 * @param {Grid & {times?: [number, number]}} grid
 * @param {() => import('../lib/units.js').Units} units
 * @param {(grid: Grid) => void} done
 */
function lengthsForm(grid, units, done) {
  const problem = h('p', { class: 'error', role: 'alert', hidden: true });
  const choice = () =>
    h('select', {}, h('option', { value: '' }, 'choose…'), UNITS.map((name) => h('option', {}, name))); // prettier-ignore
  const labelled = (/** @type {string} */ words, /** @type {HTMLElement} */ of) =>
    h('label', {}, words, ' ', of);
  const box = (/** @type {string} */ placeholder) =>
    h('input', { type: 'text', autocomplete: 'off', spellcheck: 'false', placeholder });
  const [up, across, dx, dy] = [choice(), choice(), box('such as 1 µm'), box('as along x')];
  const asksSpacing = !grid.spacing;
  const lacking = [grid.up ? '' : 'unit of its heights', asksSpacing ? 'distance of its heights' : grid.across ? '' : 'unit of its distances'].filter(Boolean); // prettier-ignore
  const refuse = (/** @type {string} */ words) => {
    problem.textContent = words;
    problem.hidden = false;
  };
  const length = (/** @type {string} */ text) => {
    const reading = readQuantity(text, 'length', units());
    return 'value' in reading && reading.value > 0 ? reading.value : undefined;
  };
  const take = () => {
    if (!grid.up && !up.value) return refuse('Choose the unit of the heights');
    const named = { ...grid, up: grid.up || up.value };
    if (!asksSpacing)
      return grid.across || across.value
        ? done({ ...named, across: grid.across || across.value })
        : refuse('Choose the unit of the distances');
    const x = length(dx.value);
    const y = dy.value.trim() ? length(dy.value) : x;
    if (x === undefined || y === undefined)
      return refuse('Give the distance of neighbouring heights, such as 1 µm');
    // It is that of the file, whose heights may have been thinned since.
    const [sx, sy] = grid.times ?? [1, 1];
    done({ ...named, spacing: [x * sx, y * sy], across: unit('length', units()) });
  };
  return {
    take,
    children: [
      h('p', {}, `The file says no ${lacking.join(' and no ')}.`),
      h(
        'div',
        { class: 'bar' },
        grid.up ? null : labelled('Unit of the heights', up),
        asksSpacing ? labelled('Distance along x', dx) : null,
        asksSpacing ? labelled('Distance along y', dy) : null,
        asksSpacing || grid.across ? null : labelled('Unit of the distances', across),
      ),
      problem,
    ],
  };
}
