/**
 * A field of points: typed, pasted from a spreadsheet or opened from a file, with a picture of
 * what they make.
 */

import { h, plainButton } from '../lib/dom.js';
import { keepFocus } from '../lib/focus.js';
import { columnsInWords, numberOf, readNumber } from '../lib/number.js';
import { readTable } from '../lib/table.js';
import { textOf } from '../lib/text-file.js';
import { figure, inJobUnits, plain, unit } from '../lib/units.js';
import { same } from '../lib/pointer.js';
import { PROOF, fromTest } from './hardening.js';
import { CUT_OFFS, levelled, longWaves, noData, thinnedTrace } from './trace.js';
import { written } from './written.js';

/** Most letters of a table at fault that are shown to be put right. */
const LONG = 100_000;
/** Most points of a profile, and what a trace with more of them is thinned to by a button. */
const [MOST, FEWER] = [10_000, 2000];

/** @typedef {number[]} Point a line of the table */
/** @typedef {import('../lib/table.js').Table} Table */
/** @typedef {import('../lib/record.js').Record} Record */
/** @typedef {import('../lib/record.js').Choice} Choice */
/** @typedef {import('../lib/units.js').Units} Units */

/**
 * @param {import('./field.js').Field} field
 * @param {string} id
 * @param {(value: unknown) => void} change
 * @param {import('./field.js').Surroundings} surroundings
 * @returns {import('./field.js').Control}
 */
export function pointsControl(field, id, change, { units, parent, beside, inMaterial }) {
  const quantities = field.columns ?? ['number', 'number'];
  const input = h('textarea', { id, rows: 5, spellcheck: 'false', autocomplete: 'off' });
  const note = h('p', { class: 'note', role: 'status' });
  const offers = h('div', { class: 'offers' });
  const modulus = () => numberOf(parent()?.young_modulus);
  const short = (/** @type {string} */ text, /** @type {Choice | undefined} */ choice) =>
    readTable(text, quantities, units(), field.symbol?.split(', ') ?? [], {
      modulus: inJobUnits(modulus(), unit('stress', units()), 'stress', 'mm_N_MPa') || undefined,
      choice,
    });
  const isTrace = quantities.every((one) => one === 'length');
  /** @param {string} text @param {Choice} [choice] */
  const table = (text, choice) =>
    isTrace ? inPieces(text, (piece) => short(piece, undefined)) : short(text, choice);
  /** Why a table that can be read is no value yet. @param {Table} result */
  const doubtOf = (result) => {
    if ('problem' in result) return result.problem;
    const scale = parent()?.plasticity?.over_depth?.hardness?.hardness_scale ?? 'HV';
    if (result.scale && result.scale !== scale)
      return `${result.scale} above the figures, and the scale of this field is ${scale}`;
    const measure = result.record?.measure;
    if (measure === 'indentation')
      return 'force over depth of an indentation is no hardening curve';
    return measure ? `${MEASURES[measure]} strain and stress of a test are no hardening curve yet: press “From …”` : ''; // prettier-ignore
  };
  // A table at fault stays in the draft as its text, and is refused there.
  const read = () => {
    const result = table(input.value);
    return 'points' in result && !doubtOf(result) ? result.points : input.value;
  };
  /** What the note is of. @type {unknown} */
  let noted;
  /** Whether lines were typed since the page wrote the last ones. */
  let typed = false;
  const say = (/** @type {string} */ text, /** @type {Node[]} */ more = []) => {
    note.textContent = text;
    keepFocus(offers, () => offers.replaceChildren(...more));
  };
  const write = (/** @type {any} */ value) => {
    if (!same(value, noted)) say('');
    input.value = Array.isArray(value)
      ? value.map((point) => (Array.isArray(point) ? point.join('  ') : point)).join('\n')
      : written(value);
    typed = false;
  };
  /** @param {Point[] | string} value @param {string[]} notes @param {Node[]} [more] @param {string} [scale] */
  const put = (value, notes, more, scale) => {
    noted = value;
    write(value);
    say(notes.join('; '), more);
    if (scale) beside({ profile: value, hardness_scale: scale });
    else change(value);
  };
  /** @param {string} text from elsewhere @param {Choice} [choice] @returns {boolean} whether all is done that can be done with it */
  const take = (text, choice) => {
    const result = table(text, choice);
    const record = result.record;
    if (record) {
      const { points = [] } = 'points' in result ? result : {};
      const again = (/** @type {Choice} */ other) => take(text, other);
      const ways = points.length ? waysOf(record.measure, points) : [];
      const more = [...ways, ...pointing(record, again)];
      // Why it is not taken yet is said of the value.
      if ('problem' in result) put(text, [], more);
      else put(textOfRecord(record.measure, points, units()), [`${points.length} points read`, ...result.notes], more); // prettier-ignore
      return true;
    }
    if ('points' in result && result.points.length) {
      const { points, notes } = inOrder(result.points);
      const strange = isTrace ? noData(points) : [];
      const read = [`${points.length} points read`, ...result.notes, ...notes, ...strange];
      const scale = field.key.endsWith('/profile') ? result.scale : '';
      if (points.length <= MOST)
        put(points, [...read, ...(scale ? [`scale ${scale}`] : [])], [], scale); // prettier-ignore
      else if (points.some(([x], k) => k > 0 && !(x > points[k - 1][0])))
        say(`Not taken: ${points.length} lines of figures: at most ${MOST} are taken of what is no trace, whose x rises`); // prettier-ignore
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
    say(`Not taken: ${refused}`);
    // What is long is not put right in a field.
    return !('problem' in result) || text.length > LONG;
  };
  /** What can be made of a record. @param {Record['measure']} measure @param {Point[]} points @returns {Node[]} */
  const waysOf = (measure, points) => {
    if (measure === 'indentation')
      return [
        plainButton('Material from this curve…', async () =>
          (await import('./from-curve.js')).askMaterial(points, parent() ?? {}, units(), (found) =>
            inMaterial({ plasticity: found }),
          ),
        ),
      ];
    const made = (/** @type {'engineering' | 'true'} */ one, /** @type {string} */ words) =>
      plainButton(words, () => curveOf(/** @type {Pair[]} */ (points), one));
    const both = [
      made('engineering', 'From engineering values'),
      made('true', 'From total strain'),
    ];
    return measure === 'true' ? both.reverse() : both;
  };
  /** The hardening curve of a record, and what was found on the way. @param {Pair[]} points @param {'engineering' | 'true'} measure @returns {Promise<void>} */
  const curveOf = async (points, measure) => {
    const before = input.value;
    const result = await fromTest(points, measure, modulus(), units());
    // What was typed meanwhile stays.
    if (input.value !== before) return;
    if ('problem' in result)
      return say(`Not converted: ${result.problem}`, waysOf(measure, points));
    const stress = unit('stress', units());
    const { slope, proof } = result;
    const first = Number(slope.toPrecision(4));
    put(result.points, [result.note], [
      plainButton(`Take E = ${figure(first, 4)} ${stress}`, () => inMaterial({ young_modulus: first }), { title: 'Young’s modulus becomes the first slope of the test' }), // prettier-ignore
      proof && plainButton(`Bilinear law from R_p0.2 = ${figure(proof, 4)} ${stress}`, () => inMaterial({ plasticity: bilinear(result.points, proof, modulus() || slope) }), { title: 'In place of the curve' }), // prettier-ignore
    ].filter((one) => one instanceof Node)); // prettier-ignore
  };
  input.addEventListener('paste', (event) => {
    const text = event.clipboardData?.getData('text') ?? '';
    const whole = input.selectionEnd - input.selectionStart === input.value.length;
    // Lines that nobody has typed are a sample, or a table before this one.
    if (text.trim().includes('\n') && (whole || !typed) && take(text)) event.preventDefault();
    else say('');
  });
  input.addEventListener('input', () => {
    typed = true;
    const { record, ...result } = quantities[0] === 'strain' ? table(input.value) : {};
    const points = 'points' in result ? result.points : undefined;
    say('', record && points ? waysOf(record.measure, points) : []);
  });
  const open = async (/** @type {File | undefined} */ file) => {
    if (!file) return;
    const read = await textOf(file);
    if ('problem' in read) return say(`Not taken: ${read.problem}`);
    if (take(read.text)) return;
    say('');
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
    if ('problem' in result) say(`Not converted: ${result.problem}`);
    else if (!same(result.points, points)) put(result.points, [result.note]);
  };
  const conversions = quantities[1] === 'length' ? heights(convert, units) : [];
  return {
    input,
    read,
    write,
    problem: (value) => {
      const result = typeof value === 'string' ? table(value) : undefined;
      if (!result) return '';
      return (
        doubtOf(result) ||
        `${columnsInWords(quantities.length)} columns of figures are wanted: ${quantities.map((one) => unit(one, units()) || '1').join(' and ')}`
      );
    },
    beside: [h('div', { class: 'bar beside' }, fileButton(open), conversions), note, offers],
  };
}

/** @type {{[measure: string]: string}} */
const MEASURES = { engineering: 'engineering', true: 'true', force: 'engineering' };

/** A record as text that says what it is. @param {Record['measure']} measure @param {Point[]} points @param {Units} units */
const textOfRecord = (measure, points, units) =>
  [
    measure === 'indentation'
      ? `penetration depth [${unit('length', units)}]\tforce [${unit('force', units)}]`
      : `${measure} strain [1]\t${measure} stress [${unit('stress', units)}]`,
    ...points.map((point) => point.map((one) => Number(one.toPrecision(8))).join('\t')),
  ].join('\n');

/** A straight line from the proof stress to the end of a curve. @param {Point[]} points @param {number} proof @param {number} modulus */
function bilinear(points, proof, modulus) {
  const [strain, stress] = points[points.length - 1];
  const slope = Math.max(0, (stress - proof) / (strain - PROOF)) || 0;
  const round = (/** @type {number} */ value) => Number(value.toPrecision(4));
  return {
    law: 'bilinear',
    yield_stress: round(proof),
    tangent_modulus: round((modulus * slope) / (modulus + slope)),
  };
}

/** Columns and units to point at, and the specimen of force over travel. @param {Record} record @param {(choice: Choice) => void} again @returns {Node[]} */
function pointing({ columns, choice, measure, problem }, again) {
  const { columns: at = [], units: taken = [] } = choice;
  const changed = (/** @type {Choice} */ other) => again({ ...choice, ...other });
  const isForce = measure === 'force' || choice.section !== undefined;
  const names = measure === 'indentation' || isForce ? ['length', 'force'] : ['strain', 'stress'];
  const pick = (
    /** @type {string[]} */ words,
    /** @type {number | string} */ value,
    /** @type {string} */ label,
    /** @type {(value: string) => void} */ take,
  ) => {
    const options = words.map((word, k) => h('option', { value: typeof value === 'number' ? k : word }, word || 'unit…')); // prettier-ignore
    const select = h(
      'select',
      { 'aria-label': label, onchange: () => take(select.value) },
      options,
    );
    select.value = String(value);
    return select;
  };
  const set = (/** @type {any[]} */ list, /** @type {number} */ k, /** @type {any} */ value) =>
    list.map((one, n) => (n === k ? value : one));
  const rows = names.map((name, k) =>
    h('span', { class: 'group' }, `${name === 'length' ? 'travel' : name} `,
      columns.length > 2 ? pick(columns.map((one, n) => one.name || `column ${n + 1}`), at[k] ?? k, `Column of ${name}`, (value) => changed({ columns: set(at, k, Number(value)), units: set(taken, k, columns[Number(value)].unit) })) : null, // prettier-ignore
      pick([...new Set([taken[k] ?? '', ...UNITS[name]])], taken[k] ?? '', `Unit of ${name}`, (value) => changed({ units: set(taken, k, value) })), // prettier-ignore
    ),
  ); // prettier-ignore
  if (!isForce)
    return problem || columns.length > 2 ? [h('div', { class: 'bar beside' }, rows)] : [];
  const box = (
    /** @type {string} */ label,
    /** @type {number | undefined} */ value,
    /** @type {(value: number) => void} */ take,
  ) => {
    const field = h('input', { type: 'text', inputmode: 'decimal', size: 7, onchange: () => {
      const reading = readNumber(field.value);
      if ('value' in reading && reading.value > 0) take(reading.value);
    } }); // prettier-ignore
    field.value = value ? String(Number(value.toPrecision(6))) : '';
    return h('label', {}, `${label} `, field);
  };
  return [
    h('div', { class: 'bar beside' }, rows),
    h(
      'div',
      { class: 'bar beside' },
      box('Diameter [mm]', undefined, (d) => changed({ section: (Math.PI / 4) * d * d })),
      box('or section [mm²]', choice.section, (section) => changed({ section })),
      box('Gauge length [mm]', choice.gauge_length, (length) => changed({ gauge_length: length })),
    ),
  ];
}

/** @type {{[quantity: string]: string[]}} */
const UNITS = {
  strain: ['%', '1', '‰', 'µm/m'],
  stress: ['MPa', 'GPa', 'Pa', 'ksi', 'psi'],
  length: ['mm', 'µm', 'nm', 'm', 'in'],
  force: ['N', 'kN', 'mN', 'µN', 'lbf'],
};

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
