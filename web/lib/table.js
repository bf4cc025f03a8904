/** Tables of points as spreadsheets and instruments write them. */

import { commas, groupsJoined, parted, readQuantity } from './number.js';
import { inJobUnits } from './units.js';

/** @typedef {import('./units.js').Quantity} Quantity */
/** @typedef {import('./units.js').Units} Units */
/** @typedef {{number: number, cells: string[]}} Row a line of the text, counted from 1 */
/** @typedef {{points: number[][], notes: string[]} | {problem: string}} Table */

/**
 * Points from as many columns as there are quantities, separated by tabs, semicolons, spaces or commas. Lines of words before the first numbers are
 * headers; a unit that they name, or that stands behind a number, is converted.
 * @param {string} text
 * @param {Quantity[]} quantities of the columns
 * @param {Units} units of the job
 * @returns {Table} `problem` names the first line at fault
 */
export function readTable(text, quantities, units) {
  const lines = groupsJoined(text).split(/\r\n?|\n/);
  const separator = separatorOf(lines);
  const rows = withoutBlankColumns(
    lines.map((line, k) => ({ number: k + 1, cells: cellsOf(line, separator) })).filter(({ cells }) => cells.length),
  );
  const first = rows.findIndex(({ cells }) => cells.some((cell) => /^[+\-−–]?[.,]?\d/.test(cell)));
  const [headers, body] = first < 0 ? [[], rows] : [rows.slice(0, first), rows.slice(first)];
  const meanings = new Set(body.flatMap(({ cells }) => cells.map((cell) => commas(parted(cell).digits))));
  if (meanings.has('decimal') && meanings.has('thousands'))
    return { problem: 'Commas are decimal in some lines and group thousands in others' };
  const meaning = meanings.has('decimal') ? 'decimal' : meanings.has('thousands') ? 'thousands' : undefined;
  const named = quantities.map((quantity, axis) =>
    headers
      .map(({ cells }) => unitIn(cells[axis] ?? ''))
      .find((found) => found !== undefined && inJobUnits(1, found, quantity, units)),
  );
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
  const notes = headers.length ? [`${headers.length} header line${headers.length === 1 ? '' : 's'} skipped`] : [];
  if (meaning === 'decimal') notes.push('decimal commas read');
  for (const [axis, name] of named.entries())
    if (name && inJobUnits(1, name, quantities[axis], units) !== 1)
      notes.push(`column ${axis + 1} converted from ${name}`);
  return { points, notes };
}

/** @param {number} columns */
export const columnsInWords = (columns) => ['no', 'one', 'two', 'three'][columns] ?? String(columns);

/** @param {number} count of further lines at fault */
const more = (count) => (count === 0 ? '' : ` (and ${count} more line${count === 1 ? '' : 's'})`);

/** @param {string[]} lines @returns {RegExp} */
function separatorOf(lines) {
  for (const one of ['\t', ';']) if (lines.some((line) => line.includes(one))) return new RegExp(one);
  const spaced = lines.some((line) => /\d[.,]?\s+[+\-−–]?[.,]?\d/.test(line));
  if (!spaced) return /,\s*|\s+/;
  return lines.some((line) => /\d,\s+[+\-−–]?[.,]?\d/.test(line)) ? /,\s+|\s+/ : /\s+/;
}

/** The cells of a line up to the last one that is not empty. @param {string} line @param {RegExp} separator */
function cellsOf(line, separator) {
  if (/^\s*(#|%|\/\/)/.test(line)) return [];
  const cells = line
    .trimEnd()
    .split(separator)
    .map((cell) => cell.trim().replace(/^"(.*)"$/, '$1'));
  return cells.slice(0, cells.findLastIndex(Boolean) + 1);
}

/** Without the columns that are empty in every line. @param {Row[]} rows @returns {Row[]} */
function withoutBlankColumns(rows) {
  const isBlank = (/** @type {number} */ axis) => rows.every(({ cells }) => !cells[axis]);
  return rows.map(({ number, cells }) => ({ number, cells: cells.filter((_, axis) => !isBlank(axis)) }));
}

/** A unit in brackets, behind a slash, behind “in”, or by itself. @param {string} header */
const unitIn = (header) =>
  /[[(]\s*([^\])]+?)\s*[\])]/.exec(header)?.[1] ??
  /(?:\/|\bin\b)\s*(\S+)$/.exec(header)?.[1] ??
  /^\S+$/.exec(header)?.[0];
