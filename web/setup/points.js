/**
 * A field of points: typed, pasted from a spreadsheet or opened from a file, with a picture of
 * what they make.
 */

import { h, plainButton } from '../lib/dom.js';
import { columnsInWords, numberOf } from '../lib/number.js';
import { readTable } from '../lib/table.js';
import { textOf } from '../lib/text-file.js';
import { inJobUnits, plain, unit } from '../lib/units.js';
import { same } from '../lib/pointer.js';
import { fromTest } from './hardening.js';
import { CUT_OFFS, levelled, longWaves, noData, thinnedTrace } from './trace.js';
import { written } from './written.js';

/** Most letters of a table at fault that are shown to be put right. */
const LONG = 100_000;
/** Most points of a profile, and what a trace with more of them is thinned to by a button. */
const [MOST, FEWER] = [10_000, 2000];

/** @typedef {number[]} Point a line of the table */

/**
 * @param {import('./field.js').Field} field
 * @param {string} id
 * @param {(value: unknown) => void} change
 * @param {import('./field.js').Surroundings} surroundings
 * @returns {import('./field.js').Control}
 */
export function pointsControl(field, id, change, { units, parent }) {
  const quantities = field.columns ?? ['number', 'number'];
  const input = h('textarea', { id, rows: 5, spellcheck: 'false', autocomplete: 'off' });
  const note = h('p', { class: 'note', role: 'status' });
  const short = (/** @type {string} */ text) =>
    readTable(text, quantities, units(), field.symbol?.split(', ') ?? []);
  const isTrace = quantities.every((one) => one === 'length');
  const table = (/** @type {string} */ text) => (isTrace ? inPieces(text, short) : short(text));
  // A table at fault stays in the draft as its text, and is refused there.
  const read = () => {
    const result = table(input.value);
    return 'points' in result ? result.points : input.value;
  };
  /** What the note is of. @type {unknown} */
  let noted;
  const write = (/** @type {any} */ value) => {
    if (!same(value, noted)) note.textContent = '';
    input.value = Array.isArray(value)
      ? value.map((point) => (Array.isArray(point) ? point.join('  ') : point)).join('\n')
      : written(value);
  };
  /** @param {Point[]} points @param {string[]} notes */
  const put = (points, notes) => {
    noted = points;
    write(points);
    note.textContent = notes.join('; ');
    change(points);
  };
  /** @param {string} text from elsewhere @returns {boolean} whether all is done that can be done with it */
  const take = (text) => {
    const result = table(text);
    if ('points' in result && result.points.length) {
      const { points, notes } = inOrder(result.points);
      const strange = isTrace ? noData(points) : [];
      const read = [`${points.length} points read`, ...result.notes, ...notes, ...strange];
      if (points.length <= MOST) put(points, read);
      else if (points.some(([x], k) => k > 0 && !(x > points[k - 1][0])))
        note.textContent = `Not taken: ${points.length} lines of figures: at most ${MOST} are taken of what is no trace, whose x rises`;
      else {
        const fewer = thinnedTrace(/** @type {Pair[]} */ (points), MOST);
        put(fewer.points, [
          ...read,
          fewer.note,
          '“Long waves” or “Thin” below make fewer of them',
        ]);
      }
      return true;
    }
    const refused = 'problem' in result ? result.problem : 'no figures in it';
    note.textContent = `Not taken: ${refused}`;
    // What is long is not put right in a field.
    return !('problem' in result) || text.length > LONG;
  };
  input.addEventListener('paste', (event) => {
    const text = event.clipboardData?.getData('text') ?? '';
    const whole = input.selectionEnd - input.selectionStart === input.value.length;
    if (text.trim().includes('\n') && (whole || !input.value.trim()) && take(text))
      event.preventDefault();
    else note.textContent = '';
  });
  input.addEventListener('input', () => {
    note.textContent = '';
  });
  const open = async (/** @type {File | undefined} */ file) => {
    if (!file) return;
    const read = await textOf(file);
    if ('problem' in read) {
      note.textContent = `Not taken: ${read.problem}`;
      return;
    }
    if (take(read.text)) return;
    note.textContent = '';
    write(read.text);
    change(read.text);
  };
  takesFiles(input, open);
  /** @type {Convert} */
  const convert = async (work) => {
    const points = read();
    if (!Array.isArray(points)) return;
    const result = await work(/** @type {Pair[]} */ (points));
    // What was typed meanwhile stays.
    if (!same(read(), points)) return;
    if ('problem' in result) note.textContent = `Not converted: ${result.problem}`;
    else if (!same(result.points, points)) put(result.points, [result.note]);
  };
  const modulus = () => numberOf(parent()?.young_modulus);
  const shapes = quantities[1] === 'length' ? heights(convert, units) : [];
  const conversions = quantities[0] === 'strain' ? strains(convert, modulus, units) : shapes;
  return {
    input,
    read,
    write,
    problem: (value) => {
      const result = typeof value === 'string' ? table(value) : undefined;
      if (!result) return '';
      if ('problem' in result) return result.problem;
      return `${columnsInWords(quantities.length)} columns of figures are wanted: ${quantities.map((one) => unit(one, units()) || '1').join(' and ')}`;
    },
    beside: [h('div', { class: 'bar beside' }, fileButton(open), conversions), note],
  };
}

/**
 * The same for a list of objects of figures; without a line there is no list.
 * @param {import('./field.js').Field} field
 * @param {string} id
 * @param {(value: unknown) => void} change
 * @param {import('./field.js').Surroundings} surroundings
 * @returns {import('./field.js').Control}
 */
export function termsControl(field, id, change, surroundings) {
  const members = field.members ?? ['0', '1'];
  const term = (/** @type {number[]} */ figures) =>
    Object.fromEntries(members.map((name, k) => [name, figures[k]]));
  const terms = (/** @type {any} */ points) =>
    !Array.isArray(points) ? points : points.length ? points.map(term) : undefined;
  const control = pointsControl(field, id, (points) => change(terms(points)), surroundings);
  if (members.length === 2) /** @type {HTMLTextAreaElement} */ (control.input).rows = 2;
  return {
    ...control,
    read: () => terms(control.read()),
    write: (value) =>
      control.write(
        Array.isArray(value) ? value.map((one) => members.map((name) => one?.[name])) : value,
      ),
  };
}

/** Opens a file that is dropped there. @param {HTMLElement} place @param {(file: File) => void} open */
export function takesFiles(place, open) {
  place.addEventListener('dragover', (event) => event.preventDefault());
  place.addEventListener('drop', (event) => {
    const file = event.dataTransfer?.files[0];
    if (!file) return;
    event.preventDefault();
    open(file);
  });
}

/** @param {(file: File | undefined) => void} open @param {string} [words] @param {string} [more] kinds of files beside tables */
export function fileButton(open, words = 'Open CSV…', more = '') {
  const accept = `.csv,.tsv,.txt,.dat,text/plain,text/csv${more}`;
  const chooser = h('input', { type: 'file', accept, hidden: true });
  chooser.addEventListener('change', () => {
    open(chooser.files?.[0]);
    chooser.value = '';
  });
  return [chooser, plainButton(words, () => chooser.click())];
}

/** @typedef {[number, number]} Pair */
/** @typedef {{points: Point[], note: string} | {problem: string}} Converted */
/** @typedef {(work: (points: Pair[]) => Converted | Promise<Converted>) => Promise<void>} Convert of the fields of two columns */

/** @param {string} text @param {string} title @param {() => void} work */
const button = (text, title, work) => plainButton(text, work, { title });

/**
 * Reads more lines than a table has, as long as each piece of them is one.
 * @param {string} text
 * @param {(text: string) => import('../lib/table.js').Table} read
 * @returns {import('../lib/table.js').Table}
 */
function inPieces(text, read) {
  const lines = text.split(/\r\n?|\n/);
  if (lines.length <= MOST) return read(text);
  const start = lines.findIndex((line) => /^[\s"]*[-+\u2212.,]?\d/.test(line));
  const head = lines.slice(0, Math.max(start, 0));
  const points = /** @type {Point[]} */ ([]);
  let notes = /** @type {string[]} */ ([]);
  const room = MOST - head.length;
  for (let at = head.length; at < lines.length; at += room) {
    const piece = read([...head, ...lines.slice(at, at + room)].join('\n'));
    if ('problem' in piece)
      return { problem: piece.problem.replace(/line (\d+)/g, (_, k) => `line ${k > head.length ? Number(k) + at - head.length : k}`) }; // prettier-ignore
    points.push(...piece.points);
    notes = piece.notes.length > notes.length ? piece.notes : notes;
  }
  return { points, notes };
}

/** Traces that are measured from right to left, turned round. @param {Point[]} points @returns {{points: Point[], notes: string[]}} */
function inOrder(points) {
  const falls = points.length > 1 && points.every(([x], k) => k === 0 || x < points[k - 1][0]);
  return falls
    ? { points: [...points].reverse(), notes: ['taken from the last to the first'] }
    : { points, notes: [] };
}

/** Points in the order of their first column, of those at one place the first. @param {Pair[]} points */
function sorted(points) {
  const inTurn = [...points].sort(([a], [b]) => a - b);
  const kept = inTurn.filter(([x], k) => k === 0 || x > inTurn[k - 1][0]);
  const left = points.length - kept.length;
  return {
    points: kept,
    note: `sorted by x${left ? `; ${left} further point${left === 1 ? '' : 's'} at the same x left out` : ''}`,
  };
}

/** The highest point at the origin. @param {Pair[]} points */
function centred(points) {
  const [x0, top] = points.reduce((a, b) => (b[1] > a[1] ? b : a));
  const less = (/** @type {number} */ value, /** @type {number} */ by) =>
    Number((value - by).toPrecision(12));
  return {
    points: points.map(([x, height]) => [less(x, x0), less(height, top)]),
    note: `moved by ${plain(-x0)} along and ${plain(-top)} up`,
  };
}

/** Units of the heights of traces. */
const HEIGHTS = ['mm', 'µm', 'nm', 'm', 'in'];

/** Heights that are written in another unit than those of the job. @param {(name: string) => void} convert from the unit of this name */
export function heightUnit(convert) {
  const choice = h(
    'select',
    {
      onchange: () => {
        const name = choice.value;
        choice.value = '';
        convert(name);
      },
    },
    h('option', { value: '' }, 'unit…'),
    HEIGHTS.map((name) => h('option', {}, name)),
  );
  return h(
    'label',
    { title: 'Takes the heights that stand in the box for figures in this unit' },
    'Heights are in ',
    choice,
  );
}

/** Work on traces whose x rises. @param {(points: Pair[]) => {points: Point[], note: string} | {problem: string}} work */
const rising = (work) => (/** @type {Pair[]} */ points) =>
  points.length < 3 || points.some(([x], k) => k > 0 && !(x > points[k - 1][0]))
    ? {
        problem: 'x has to rise from each of at least three points to the next: “Sort by x” first',
      }
    : work(points);

/** The filter of roughness. @param {Convert} convert @param {() => import('../lib/units.js').Units} units */
function longWavesOf(convert, units) {
  const choice = h(
    'select',
    {
      onchange: () => {
        const cutoff = inJobUnits(Number(choice.value), 'mm', 'length', units()) ?? NaN;
        choice.value = '';
        convert(rising((points) => longWaves(points, cutoff, unit('length', units()))));
      },
    },
    h('option', { value: '' }, 'λ_c…'),
    CUT_OFFS.map((one) => h('option', { value: one }, `${one} mm`)),
  );
  return h(
    'label',
    { title: 'Gaussian filter of ISO 16610-21: roughness shorter than λ_c is taken away' },
    'Long waves beyond ',
    choice,
  );
}

/** @param {Convert} convert @param {() => import('../lib/units.js').Units} units */
const heights = (convert, units) => [
  heightUnit((name) =>
    convert((points) => ({
      points: points.map(([x, height]) => [
        x,
        inJobUnits(height, name, 'length', units()) ?? height,
      ]),
      note: `heights converted from ${name}`,
    })),
  ),
  button('Sort by x', 'For traces whose x falls or jumps', () => convert(sorted)),
  button('Top to 0', 'Moves the highest point to x = 0 and height 0', () => convert(centred)),
  button('Level', 'Takes the least-squares line away', () => convert(rising(levelled))),
  longWavesOf(convert, units),
  button('Thin', `Keeps every n-th point, ${FEWER} of them`, () =>
    convert(rising((points) => thinnedTrace(points, FEWER))),
  ),
  button('Flip heights', 'For depths measured into the body: heights count outward', () =>
    convert((points) => ({
      points: points.map(([x, height]) => [x, -height || 0]),
      note: 'heights flipped',
    })),
  ),
];

/** @param {Convert} convert @param {() => number} modulus @param {() => import('../lib/units.js').Units} units */
const strains = (convert, modulus, units) => [
  button(
    'From engineering values',
    'The points are engineering strain and stress of a tensile test, the elastic part included',
    () => convert((points) => fromTest(points, 'engineering', modulus(), units())),
  ),
  button(
    'From total strain',
    'The points are total strain and true stress, the elastic part included',
    () => convert((points) => fromTest(points, 'true', modulus(), units())),
  ),
];
