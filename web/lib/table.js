/**
 * Tables of points as spreadsheets and instruments write them. A line above the figures is
 * understood, or left out and named where the columns say their units themselves, or refused.
 */

import { ROLES } from './columns.js';
import {
  columnsInWords,
  hasDecimalComma,
  parted,
  quoted,
  readNumber,
  withMinus,
} from './number.js';
import { beginsAtNothing, partsOf, recordOf } from './record.js';
import { inJobUnits, isUnit, unit } from './units.js';

/** @typedef {import('./units.js').Quantity} Quantity */
/** @typedef {import('./units.js').Units} Units */
/** @typedef {import('./record.js').Row} Row */
/** @typedef {import('./record.js').Record} Record */
/**
 * @typedef {{points: number[][], notes: string[], record?: Record, scale?: string} |
 *   {problem: string, record?: Record}} Table `record`: of a test, whose points are no curve yet;
 *   `scale`: of the hardness, where the text says it
 */

/** Most lines of figures that the service takes, and letters of a line of two or three of them. */
const [MOST, LONGEST] = [10_000, 1000];

/**
 * Points from as many columns as there are quantities, separated by tabs, semicolons, spaces or
 * commas. Lines above the first numbers name columns and their units; further columns are left out
 * where names tell which, or where the first one counts the lines.
 * @param {string} text
 * @param {Quantity[]} quantities of the columns
 * @param {Units} units of the job
 * @param {string[]} symbols of the columns, which headers may name in another order
 * @param {{modulus?: number, choice?: import('./record.js').Choice}} [of] Young's modulus [MPa] and what is pointed at, of records of tests
 * @returns {Table} `problem` names the first line at fault
 */
export function readTable(text, quantities, units, symbols, { modulus, choice } = {}) {
  const lines = withMinus(text.replace(/^\ufeff/, '')).split(/\r\n?|\n/);
  const long = lines.findIndex((line) => line.length > LONGEST);
  if (long >= 0)
    return {
      problem: `line ${long + 1} has ${lines[long].length} letters: a point has a line of its own`,
    };
  if (lines.some((line) => /^\s*\*\s*[a-z]/i.test(line))) return readCard(lines, symbols);
  const separator = separatorOf(lines);
  const rows = lines
    .map((line, k) => ({ number: k + 1, ...cellsOf(line, separator) }))
    .filter(({ cells }) => cells.length);
  // What a line says of the specimen or the test stands before its one figure.
  const isSaid = (/** @type {string[]} */ cells) =>
    /^["“]?\p{L}/u.test(cells[0]) && cells.filter(isFigure).length < 2 && cells.length < 4;
  const isAlone = (/** @type {string[]} */ cells) =>
    hasTable && (cells.length < 2 || isSaid(cells));
  const hasTable = rows.some(
    ({ comment, cells }) => !comment && cells.filter(isFigure).length > 1,
  );
  // A sign before a digit starts no word: a line of unreadable figures is
  // said to be one. A line that begins with words and has no figure of its own is a title.
  const first = rows.findIndex(
    ({ comment, cells }) =>
      !comment && !isTitle(cells.join(' ')) && !isAlone(cells) && cells.some(isFigure),
  );
  const headers = rows.slice(0, Math.max(0, first));
  const body = rows.slice(headers.length).filter(({ comment }) => !comment);
  const tail = body.length - 1 - body.findLastIndex(({ cells }) => !isSaid(cells));
  if (hasTable && tail > 0) body.splice(-tail);
  if (body.length > MOST && !symbols.includes('ε_p'))
    return { problem: `${body.length} lines of figures: at most ${MOST} are taken` };
  const isCurve = symbols.includes('ε_p');
  const record = isCurve ? recordOf(headers, body, modulus ?? STEEL, choice) : undefined;
  if (record) return ofRecord(record, units);
  const header = namedBy(headers, body, quantities, units, symbols);
  if ('problem' in header) return header;
  const { order, named, width, notes, scale } = header;
  const used = (/** @type {string[]} */ cells) => order.map((k) => cells[k] ?? '');
  const commas = body.some(({ cells }) => used(cells).some((cell) => hasDecimalComma(digitsOf(cell)))); // prettier-ignore
  const problems = /** @type {string[]} */ ([]);
  /** Units that stand beside the figures of each column. @type {Set<string>[]} */
  const beside = quantities.map(() => new Set());
  const points = body.map(({ number, cells }) => {
    const wrong = width === quantities.length ? cells.length !== width : cells.length > width;
    const found = used(cells).map((cell, axis) => {
      const own = unitBeside(cell, quantities[axis]);
      return { reading: readNumber(own ? digitsOf(cell) : cell, commas), own };
    });
    const fault = found.find(({ reading }) => 'problem' in reading)?.reading;
    // Of cells that are no figure the first is quoted, before columns are counted.
    const shown = wrong ? cells.map((cell) => readNumber(cell, commas)).find((one) => 'problem' in one) : fault; // prettier-ignore
    if (shown && 'problem' in shown) problems.push(`line ${number}: ${shown.problem}`);
    else if (wrong)
      problems.push(
        `line ${number} has ${counted(cells.length, 'column')}, not ${columnsInWords(quantities.length)}`,
      );
    return found.map(({ reading, own }, axis) => {
      const value = 'value' in reading ? reading.value : NaN;
      if (own) beside[axis].add(own);
      return inJobUnits(value, own || named[axis], quantities[axis], units) ?? value;
    });
  });
  for (const [axis, own] of beside.entries()) {
    const isOwn = (/** @type {string} */ one) => inJobUnits(1, one, quantities[axis], units) === 1;
    if (named[axis] || [...own].every(isOwn)) continue;
    const isBare = (/** @type {Row} */ { cells }) => {
      const cell = cells[order[axis]] ?? '';
      return !unitBeside(cell, quantities[axis]) && !/^[-+]?0*[.,]?0*$/.test(cell);
    };
    const bare = body.find(isBare);
    if (bare)
      problems.push(
        `line ${bare.number}: ${quoted(bare.cells[order[axis]] ?? '')} has no unit, and others of its column are in ${[...own].join(', ')}`,
      );
  }
  const [fault, ...more] = problems;
  if (fault)
    return {
      problem: more.length ? `${fault} (and ${counted(more.length, 'more line')})` : fault,
    };
  const said = headers.length ? [`${counted(headers.length, 'header line')} read`] : [];
  said.push(...notes);
  if (order.some((k, axis) => k !== axis) && width === quantities.length)
    said.push('columns taken by their names');
  if (commas) said.push('decimal commas read');
  for (const [axis, name] of named.entries())
    for (const one of beside[axis].size ? beside[axis] : [name])
      if (one && inJobUnits(1, one, quantities[axis], units) !== 1)
        said.push(`column ${order[axis] + 1} converted from ${one}`);
  if (tail > 0 && hasTable) said.push(`${counted(tail, 'line')} below the figures left out`);
  if (scale) return { points, notes: said, scale };
  const made =
    named.some(Boolean) || order.some((k, axis) => k !== axis)
      ? { points, notes: said }
      : turned(points, said, symbols);
  if (!isCurve || 'problem' in made || !beginsAtNothing(made.points)) return made;
  // Figures alone: which of two columns they are in is known by now.
  const names = ['strain', `stress [${unit('stress', units)}]`].map((name, k) => ({ name, unit: k ? unit('stress', units) : '', role: name.slice(0, 6) })); // prettier-ignore
  const bare = recordOf([{ number: 0, cells: names.map(({ name }) => name), comment: false }], made.points.map((cells, k) => ({ number: body[k].number, cells: cells.map(String), comment: false })), modulus ?? STEEL, choice); // prettier-ignore
  return bare ? ofRecord(bare, units) : made;
}

/** [MPa] */
const STEEL = 210_000;

/** A record in the units of a job. @param {Record} record @param {Units} units @returns {Table} */
function ofRecord(record, units) {
  if (record.problem) return { problem: record.problem, record };
  const [a, b] = record.measure === 'indentation' ? ['length', 'force'] : ['strain', 'stress'];
  const one = [a, b].map((quantity) => inJobUnits(1, unit(/** @type {Quantity} */ (quantity), 'mm_N_MPa') || '1', /** @type {Quantity} */ (quantity), units) ?? 1); // prettier-ignore
  const points = record.points.map((point) => point.map((value, k) => value * one[k]));
  return { points, notes: record.notes, record };
}

/** Whether a cell begins as a figure does: a sign before a digit starts no word. @param {string} cell */
const isFigure = (cell) => /^[^\p{L}\p{N}([]*\d/u.test(cell);

/** The digits of a cell that may have a unit behind them. @param {string} cell */
const digitsOf = (cell) => parted(cell).digits;

/** The unit behind the digits of a cell, if it is one of the quantity. @param {string} cell @param {Quantity} quantity */
function unitBeside(cell, quantity) {
  const { name } = parted(cell);
  return name && inJobUnits(1, name, quantity, 'mm_N_MPa') !== undefined ? name : '';
}

/** @param {number[][]} points @param {number} axis */
const rises = (points, axis) =>
  points.length > 1 && points.every((point, k) => k === 0 || point[axis] > points[k - 1][axis]);

/**
 * Columns without names that are those of the other order, turned where there is no doubt.
 * @param {number[][]} points @param {string[]} notes @param {string[]} symbols
 * @returns {Table}
 */
function turned(points, notes, symbols) {
  const column = (/** @type {number} */ axis) => points.map((point) => point[axis]);
  const swapped = () => points.map(([a, b]) => [b, a]);
  const last = points.at(-1) ?? [];
  if (symbols.includes('HV')) {
    const isSwapped =
      rises(points, 1) && !rises(points, 0) && Math.min(...column(0)) > Math.max(...column(1));
    if (isSwapped)
      return { points: swapped(), notes: [...notes, 'columns taken as hardness, depth'] };
  }
  if (symbols.includes('ε_p') && last[0] > 20 && last[0] > 50 * Math.abs(last[1]))
    return { points: swapped(), notes: [...notes, 'columns taken as stress, strain'] };
  if (symbols[0] === 'z' && points.length > 1 && !rises(points, 0)) {
    const other = symbols.findIndex((_, axis) => axis > 0 && rises(points, axis));
    if (other > 0)
      return {
        problem: `the first column, the depth, does not rise, and column ${other + 1} does: are they swapped? Put their names above the figures (${symbols.map((one) => one.replace('_', '')).join(', ')})`,
      };
  }
  return { points, notes };
}

/**
 * A card `*PLASTIC` of finite-element programs: lines of stress and plastic strain.
 * @param {string[]} lines @param {string[]} symbols
 * @returns {Table}
 */
function readCard(lines, symbols) {
  const isKey = (/** @type {string} */ line) => /^\s*\*\s*[a-z]/i.test(line);
  const at = lines.findIndex((line) => /^\s*\*\s*plastic\b/i.test(line));
  const said = (/** @type {number} */ k) => `line ${k + 1}: ${quoted(lines[k])}`;
  if (at < 0) return { problem: `${said(lines.findIndex(isKey))} is no card known here` };
  if (!symbols.includes('ε_p')) return { problem: `${said(at)} is a hardening curve` };
  const more = lines.findIndex((line, k) => k > at && /^\s*\*\s*plastic\b/i.test(line));
  if (more > 0) return { problem: `${said(more)}: one card is taken` };
  const option = /,\s*(rate|scale|hardening\s*=\s*(?!isotropic)\w+)/i.exec(lines[at])?.[1];
  if (option) return { problem: `${said(at)}: “${option}” is not known here` };
  const end = lines.findIndex((line, k) => k > at && isKey(line));
  const rows = lines
    .slice(at + 1, end < 0 ? undefined : end)
    .map((line, k) => ({ number: at + k + 2, line }))
    .filter(({ line }) => line.trim() && !/^\s*\*\*/.test(line))
    .map(({ number, line }) => ({ number, cells: line.replace(/,\s*$/, '').split(',').map((cell) => cell.trim()) })); // prettier-ignore
  const points = [];
  for (const { number, cells } of rows) {
    const values = cells.map((cell) => readNumber(cell.replace(/d(?=[+-]?\d+$)/i, 'e')));
    const fault = values.find((one) => 'problem' in one);
    if (fault && 'problem' in fault) return { problem: `line ${number}: ${fault.problem}` };
    if (cells.length < 2 || cells.length > 3)
      return { problem: `line ${number} has ${counted(cells.length, 'column')}: stress and plastic strain are wanted` }; // prettier-ignore
    if (cells.length === 3 && cells[2] !== rows[0].cells[2])
      return { problem: `line ${number} is of another temperature: leave the lines of one of them` }; // prettier-ignore
    const [stress, strain] = values.map((one) => ('value' in one ? one.value : NaN));
    points.push([strain, stress]);
  }
  return { points, notes: ['card *PLASTIC read: stress, plastic strain'] };
}

/** @param {number} count @param {string} what */
const counted = (count, what) => `${count} ${what}${count === 1 ? '' : 's'}`;

/** Told by the lines of figures, or by all where none begins with one. @param {string[]} all @returns {RegExp} */
function separatorOf(all) {
  const figures = all.filter((line) => /^[\s"]*[-+.,]?\d/.test(line));
  for (const lines of [figures, all])
    for (const one of ['\t', ';'])
      if (lines.some((line) => line.includes(one))) return new RegExp(one);
  if (figures.some((line) => /^\s*".*",/.test(line))) return /,(?=(?:[^"]*"[^"]*")*[^"]*$)/;
  const comma = figures.length && figures.every((line) => /,/.test(line) && !/\d\s+[-+.\d]/.test(line)); // prettier-ignore
  if (comma) return /,\s*/;
  const spaced = all.some((line) => /\d[.,]?\s+[+-]?[.,]?\d/.test(line));
  if (!spaced) return /,\s*|\s+/;
  return all.some((line) => /\d,\s+[+-]?[.,]?\d/.test(line)) ? /,\s+|\s+/ : /\s+/;
}

/**
 * Splits a line into cells; a unit in brackets belongs to the word before it.
 * @param {string} line
 * @param {RegExp} separator
 */
function cellsOf(line, separator) {
  const [sign] = /^\s*(#|%(?!\s*[;,\t])|\/\/)/.exec(line) ?? [''];
  const bare = line.slice(sign.length).trim();
  const spaced = bare
    .replace(/(\S)\s+(?=[[(][^\])]*[\])])/g, '$1\u0000')
    .replace(/(\d)\s+(?=([^\s\d.,;+-]\S*)(?:\s|$))/g, (whole, digit, word) =>
      isUnit(word) || /^HV[\d.,/]*$/i.test(word) ? `${digit}\u0000` : whole,
    );
  const cells = (separator.test(' ') ? spaced : bare)
    .split(separator)
    .map((cell) => cell.replace('\u0000', ' ').trim().replace(/^"(.*)"$/, '$1')); // prettier-ignore
  return { comment: sign !== '', cells: cells.slice(0, cells.findLastIndex(Boolean) + 1) };
}

const STRESS = '(residual|eigen)?(σ|s|sig|sigma|stress|spannung|contrainte)';
const role = (/** @type {string} */ name) => new RegExp(`^(${ROLES[name]})$`, 'u');
/**
 * Names of columns, by their symbols; lower case without spaces, dots and dashes.
 * @type {{[symbol: string]: RegExp}}
 */
const CALLED = {
  x: role('place'),
  height: role('height'),
  z: role('depth'),
  HV: role('hardness'),
  factor: role('factor'),
  σ_x: new RegExp(`^${STRESS}(x|xx|11)$`),
  σ_z: new RegExp(`^${STRESS}(z|zz|33)$`),
  σ_r: new RegExp(`^${STRESS}(r|rr|11)$`),
  σ_θ: new RegExp(`^${STRESS}(θ|θθ|t|33)$`),
  ε_p: new RegExp(`^(${ROLES.plastic_strain}|${ROLES.true_strain}|${ROLES.strain})$`, 'u'),
  q: new RegExp(`^(${ROLES.true_stress}|${ROLES.stress})$`, 'u'),
  C: /^(c|modulus)$/,
  γ: /^(γ|gamma|rate)$/,
};

/** The scale that the service converts. */
const OF_HRC =
  /^(hardness|härte(wert)?|dureté|durezza|dureza)?\s*[[(]?(HR\s?C|rockwell c)[\])]?$/i;
const DATE = /^\d{1,4}[-./]\d{1,2}[-./]\d{1,4}/;

/** Other scales of hardness than that of Vickers, whose figures look alike. */
const OTHER_SCALE =
  /(?<![a-z])(HR\s?[A-Z]?|HBW?S?|BHN|HK|KHN|HLD?|rockwell|brinell|knoop|shore|leeb)(?![a-z])/i;

/**
 * Whether a line has plain words and numbers that count or date, and no unit. What multiplies or
 * equals something is none.
 * @param {string} line
 */
const isTitle = (line) =>
  /^["“]?\p{L}[\p{L}\d\s.,:;()"“”/_-]*$/u.test(line) &&
  /\p{L}{2}/u.test(line) &&
  !/\d[.,]\d|(?<!\p{L})x\s?\d/u.test(line.replace(/\b\d{1,2}\.\d{1,2}\.\d{2,4}\b/g, '')) &&
  !line.split(/[^\p{L}µ°]+/u).some((word) => isUnit(word) || /^(HV|HR[A-C]?|HBW?)$/.test(word));

/** Names of columns that count the lines. */
const COUNTS = role('count');

/** Whether the first column is 1, 2, 3, … @param {Row[]} body */
const countsLines = (body) =>
  body.length > 1 && body.every(({ cells }, k) => cells[0].replace(/\.$/, '') === String(k + 1));

/**
 * What the lines above the figures say: for each wanted column the one of the text, and its unit.
 * @param {Row[]} headers
 * @param {Row[]} body
 * @param {Quantity[]} quantities
 * @param {Units} units of the job
 * @param {string[]} symbols
 * @returns {{order: number[], named: string[], width: number, notes: string[], scale: string} | {problem: string}}
 *   `width`: number of columns of the text; `scale`: of the hardness, where the text says it
 */
function namedBy(headers, body, quantities, units, symbols) {
  const wanted = quantities.length;
  const widest = Math.max(0, ...body.map(({ cells }) => cells.length));
  const extra = widest === wanted + 1 && countsLines(body) ? 1 : 0;
  let order = quantities.map((_, axis) => axis + extra);
  let width = wanted + extra;
  const named = quantities.map(() => '');
  const notes = extra ? ['the first column counts the lines and is left out'] : [];
  const example = quantities.map(
    (one, axis) =>
      `${symbols[axis].replace('_', '')}${unit(one, units) && ` [${unit(one, units)}]`}`,
  );
  let scale = '';
  /** Lines that are not understood, and the first refusal of one. */
  const left = /** @type {string[]} */ ([]);
  let pending = /** @type {{problem: string} | undefined} */ (undefined);
  const leave = (
    /** @type {number} */ number,
    /** @type {string[]} */ cells,
    /** @type {{problem: string}} */ refusal,
  ) => {
    left.push(`line ${number} (${quoted(cells.join(' '))})`);
    pending ??= refusal;
  };
  for (const { number, cells } of headers) {
    const refuse = (/** @type {string} */ text, /** @type {string} */ words) => ({
      problem: `line ${number}: ${quoted(text)} ${words}. The names of the columns are ${example.join(', ')}; other lines above the figures are to be left out`,
    });
    if (
      quantities.includes('hardness') &&
      cells.length > 1 &&
      cells.some((cell) => OF_HRC.test(cell))
    ) {
      scale = 'HRC';
      cells.splice(0, cells.length, ...cells.map((cell) => (OF_HRC.test(cell) ? 'HV' : cell)));
    } else if (
      quantities.includes('hardness') &&
      cells.length > 1 &&
      cells.some((cell) => /HV|VHN|DP[HN]/.test(cell))
    )
      scale ||= 'HV';
    const other = quantities.includes('hardness') && OTHER_SCALE.exec(cells.join(' '))?.[0];
    if (other) return { problem: `line ${number}: “${other}” is another scale, and the figures here are Vickers hardness HV: convert them first, for steels by ISO 18265` }; // prettier-ignore
    // A header may leave out the column that counts.
    const shift = cells.length === wanted && width === wanted + 1 ? 1 : 0;
    if (cells.length !== wanted && (cells.length < wanted || widest <= wanted)) {
      if (isTitle(cells.join(' '))) continue;
      leave(number, cells, refuse(cells.join(' '), 'is not known here'));
      continue;
    }
    const parts = cells.map(partsOf);
    const plain = parts.map(([name]) => name.toLowerCase().replace(/[\s_.:-]/g, ''));
    const isCalled = (/** @type {number} */ k, /** @type {number} */ axis) =>
      CALLED[symbols[axis]]?.test(plain[k]);
    const axes = parts.map((_, k) => {
      const own = order.indexOf(k + shift);
      if (own >= 0 && (!plain[k] || isCalled(k, own))) return own;
      return plain[k] ? symbols.findIndex((_, axis) => isCalled(k, axis)) : -1;
    });
    const isWider = cells.length > wanted;
    if (axes.every((axis) => axis < 0) && cells.length <= width) {
      if (!isTitle(cells.join(' '))) leave(number, cells, refuse(cells[0], 'is not known here'));
      continue;
    }
    const strange = axes.findIndex((axis, k) => (axis < 0 ? !isWider : axes.indexOf(axis) < k));
    if (strange >= 0) return refuse(cells[strange], 'is not known here');
    const missing = quantities.findIndex((_, axis) => !axes.includes(axis));
    if (missing >= 0) {
      return refuse(cells.join(' '), `has no column called ${example[missing]}`);
    }
    for (const [k, [, name]] of parts.entries()) {
      const axis = axes[k];
      // The figure behind a scale is the load of its test.
      const isLoad = quantities[axis] === 'hardness' && /^[\d.,/]+$/.test(name);
      if (axis < 0 || isLoad) continue;
      if (name && inJobUnits(1, name, quantities[axis], units) === undefined)
        return refuse(name, `is no unit known here for column ${k + 1}`);
      if (name && named[axis] && named[axis] !== name)
        return refuse(name, `is not “${named[axis]}” as in a line above`);
      named[axis] ||= name;
    }
    if (isWider) {
      width = Math.max(width, cells.length, widest);
      notes.length = 0;
      for (const [k, axis] of axes.entries())
        if (axis < 0 && plain[k])
          notes.push(COUNTS.test(plain[k]) ? `column ${quoted(cells[k])} counts the lines and is left out` : `column ${quoted(cells[k])} left out`); // prettier-ignore
    }
    order = quantities.map((_, axis) => axes.indexOf(axis) + shift);
  }
  // What a line says may be a unit or a scale of columns that say none.
  const says = quantities.every(
    (one, axis) => named[axis] || one === 'hardness' || one === 'number',
  );
  const figures = headers.some(({ cells }) => isFigure(cells[0]) && !DATE.test(cells[0]));
  if (pending && !(says && !figures)) return pending;
  if (left.length)
    notes.push(
      `${left.slice(0, 3).join(', ')}${left.length > 3 ? ` and ${left.length - 3} more` : ''} left out`,
    );
  return { order, named, width, notes, scale };
}
