/** Tables of points as spreadsheets and instruments write them. */

import { orderCalled, unitsNamed } from './headers.js';
import { columnsInWords, commas, groupsJoined, parted, readQuantity, withMinus } from './number.js';
import { inJobUnits } from './units.js';

/** @typedef {import('./units.js').Quantity} Quantity */
/** @typedef {import('./units.js').Units} Units */
/** @typedef {import('./headers.js').Row} Row */
/** @typedef {{points: number[][], notes: string[]} | {problem: string}} Table */

/** Most lines of figures that the service takes, and letters of a line of two or three of them. */
const [MOST, LONGEST] = [10_000, 1000];

/**
 * Points from as many columns as there are quantities, separated by tabs, semicolons, spaces or commas. Lines of words before the first numbers are
 * headers; a unit that they name, or that stands behind a number, is converted. One that is not understood is refused.
 * @param {string} text
 * @param {Quantity[]} quantities of the columns
 * @param {Units} units of the job
 * @param {string[]} [symbols] of the columns, which headers may name in another order
 * @returns {Table} `problem` names the first line at fault
 */
export function readTable(text, quantities, units, symbols = []) {
  const typed = withMinus(text).split(/\r\n?|\n/);
  const long = typed.findIndex((line) => line.length > LONGEST);
  if (long >= 0)
    return { problem: `line ${long + 1} has ${typed[long].length} letters: a point has a line of its own` };
  const lines = typed.map(groupsJoined);
  const separator = separatorOf(lines);
  const given = withoutBlankColumns(
    lines.map((line, k) => ({ number: k + 1, ...cellsOf(line, separator) })).filter(({ cells }) => cells.length),
  );
  // Whatever sign stands before a digit, it is no word: a line of figures that cannot be read is said to be one.
  const isFigures = (/** @type {Row} */ { comment, cells }) =>
    !comment && cells.some((cell) => /^[^\p{L}\p{N}([]*\d/u.test(cell));
  const first = Math.max(0, given.findIndex(isFigures));
  const called = orderCalled(given.slice(0, first), symbols);
  if ('problem' in called) return called;
  const { order } = called;
  const rows = order ? given.map((row) => reordered(row, order)) : given;
  const headers = rows.slice(0, first);
  const body = rows.slice(headers.length).filter(({ comment }) => !comment);
  if (body.length > MOST) return { problem: `${body.length} lines of figures: at most ${MOST} are taken` };
  const meanings = new Set(body.flatMap(({ cells }) => cells.map((cell) => commas(parted(cell).digits))));
  if (meanings.has('decimal') && meanings.has('thousands'))
    return { problem: 'Commas are decimal in some lines and group thousands in others' };
  const meaning = meanings.has('decimal') ? 'decimal' : meanings.has('thousands') ? 'thousands' : undefined;
  const header = unitsNamed(headers, quantities, units);
  if ('problem' in header) return header;
  const { named } = header;
  const counted = quantities.map((_, axis) => body.some(({ cells }) => parted(cells[axis] ?? '').name));
  const lacking = (/** @type {string[]} */ cells) => {
    const bare = cells.find((cell, axis) => counted[axis] && !named[axis] && !parted(cell).name && /[1-9]/.test(cell));
    return bare && { problem: `“${bare}” has no unit, and others of its column have one` };
  };
  const points = /** @type {number[][]} */ ([]);
  const problems = [];
  for (const { number, cells } of body) {
    const readings = cells.map((cell, axis) =>
      cell
        ? readQuantity(cell, quantities[axis], units, { unit: named[axis], meaning })
        : { problem: `column ${axis + 1} is empty` },
    );
    const fault = readings.find((reading) => 'problem' in reading) ?? lacking(cells);
    if (fault && 'problem' in fault) problems.push(`line ${number}: ${fault.problem}`);
    else if (cells.length !== quantities.length)
      problems.push(
        `line ${number} has ${cells.length} column${cells.length === 1 ? '' : 's'}, not ${columnsInWords(quantities.length)}`,
      );
    else points.push(readings.map((reading) => ('value' in reading ? reading.value : NaN)));
  }
  if (problems.length) return { problem: problems[0] + more(problems.length - 1) };
  const skipped = headers.filter(({ comment }) => !comment).length;
  const notes = skipped ? [`${skipped} header line${skipped === 1 ? '' : 's'} skipped`] : [];
  if (order) notes.push('columns taken by their names');
  if (meaning === 'decimal') notes.push('decimal commas read');
  for (const [axis, name] of named.entries())
    if (name && inJobUnits(1, name, quantities[axis], units) !== 1)
      notes.push(`column ${axis + 1} converted from ${name}`);
  return { points, notes };
}

/** @param {Row} row @param {number[]} order @returns {Row} with its cells in another order, if it has as many */
const reordered = (row, order) =>
  row.cells.length === order.length ? { ...row, cells: order.map((k) => row.cells[k]) } : row;

/** @param {number} count of further lines at fault */
const more = (count) => (count === 0 ? '' : ` (and ${count} more line${count === 1 ? '' : 's'})`);

/** @param {string[]} lines @returns {RegExp} */
function separatorOf(lines) {
  for (const one of ['\t', ';']) if (lines.some((line) => line.includes(one))) return new RegExp(one);
  const spaced = lines.some((line) => /\d[.,]?\s+[+-]?[.,]?\d/.test(line));
  if (!spaced) return /,\s*|\s+/;
  return lines.some((line) => /\d,\s+[+-]?[.,]?\d/.test(line)) ? /,\s+|\s+/ : /\s+/;
}

/** The cells of a line up to the last one that is not empty; a unit in brackets belongs to the word before it. @param {string} line @param {RegExp} separator */
function cellsOf(line, separator) {
  const [sign] = /^\s*(#|%(?!\s*[;,\t])|\/\/)/.exec(line) ?? [''];
  const bare = line.slice(sign.length);
  const cells = (separator.test(' ') ? bare.replace(/(\S)\s+(?=[[(][^\])]*[\])])/g, '$1\u0000') : bare)
    .trimEnd()
    .replace(sign && /^\s+/, '')
    .split(separator)
    .map((cell) =>
      cell
        .replaceAll('\u0000', ' ')
        .trim()
        .replace(/^"(.*)"$/, '$1'),
    );
  return { comment: sign !== '', cells: cells.slice(0, cells.findLastIndex(Boolean) + 1) };
}

/** Without the columns that are empty in every line. @param {Row[]} rows @returns {Row[]} */
function withoutBlankColumns(rows) {
  const isBlank = (/** @type {number} */ axis) => rows.every(({ cells }) => !cells[axis]);
  return rows.map(({ cells, ...row }) => ({ ...row, cells: cells.filter((_, axis) => !isBlank(axis)) }));
}
