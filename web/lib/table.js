/**
 * Tables of points as spreadsheets and instruments write them. What stands above the figures is
 * known word for word, or refused.
 */

import { columnsInWords, hasDecimalComma, quoted, readNumber, withMinus } from './number.js';
import { inJobUnits, isUnit, unit } from './units.js';

/** @typedef {import('./units.js').Quantity} Quantity */
/** @typedef {import('./units.js').Units} Units */
/**
 * @typedef {{number: number, cells: string[], comment: boolean}} Row a line of the text, counted
 *   from 1
 */
/** @typedef {{points: number[][], notes: string[]} | {problem: string}} Table */

/** Most lines of figures that the service takes, and letters of a line of two or three of them. */
const [MOST, LONGEST] = [10_000, 1000];

/**
 * Points from as many columns as there are quantities, separated by tabs, semicolons, spaces or
 * commas. Lines above the first numbers name columns and their units.
 * @param {string} text
 * @param {Quantity[]} quantities of the columns
 * @param {Units} units of the job
 * @param {string[]} symbols of the columns, which headers may name in another order
 * @returns {Table} `problem` names the first line at fault
 */
export function readTable(text, quantities, units, symbols) {
  const lines = withMinus(text).split(/\r\n?|\n/);
  const long = lines.findIndex((line) => line.length > LONGEST);
  if (long >= 0)
    return {
      problem: `line ${long + 1} has ${lines[long].length} letters: a point has a line of its own`,
    };
  const separator = separatorOf(lines);
  const rows = lines
    .map((line, k) => ({ number: k + 1, ...cellsOf(line, separator) }))
    .filter(({ cells }) => cells.length);
  // A sign before a digit starts no word: a line of unreadable figures is
  // said to be one.
  const first = rows.findIndex(
    ({ comment, cells }) => !comment && cells.some((one) => /^[^\p{L}\p{N}([]*\d/u.test(one)),
  );
  const headers = rows.slice(0, Math.max(0, first));
  const body = rows.slice(headers.length).filter(({ comment }) => !comment);
  if (body.length > MOST)
    return { problem: `${body.length} lines of figures: at most ${MOST} are taken` };
  const header = namedBy(headers, quantities, units, symbols);
  if ('problem' in header) return header;
  const { order, named } = header;
  const commas = body.some(({ cells }) => cells.some(hasDecimalComma));
  const problems = /** @type {string[]} */ ([]);
  const points = body.map(({ number, cells }) => {
    const readings = cells.map((cell) => readNumber(cell, commas));
    const fault = readings.find((reading) => 'problem' in reading);
    if (fault && 'problem' in fault) problems.push(`line ${number}: ${fault.problem}`);
    else if (cells.length !== quantities.length)
      problems.push(
        `line ${number} has ${counted(cells.length, 'column')}, not ${columnsInWords(quantities.length)}`,
      );
    return order.map((k, axis) => {
      const reading = readings[k];
      const value = reading && 'value' in reading ? reading.value : NaN;
      return inJobUnits(value, named[axis], quantities[axis], units) ?? value;
    });
  });
  const [fault, ...more] = problems;
  if (fault)
    return {
      problem: more.length ? `${fault} (and ${counted(more.length, 'more line')})` : fault,
    };
  const notes = headers.length ? [`${counted(headers.length, 'header line')} read`] : [];
  if (order.some((k, axis) => k !== axis)) notes.push('columns taken by their names');
  if (commas) notes.push('decimal commas read');
  for (const [axis, name] of named.entries())
    if (name && inJobUnits(1, name, quantities[axis], units) !== 1)
      notes.push(`column ${order[axis] + 1} converted from ${name}`);
  return { points, notes };
}

/** @param {number} count @param {string} what */
const counted = (count, what) => `${count} ${what}${count === 1 ? '' : 's'}`;

/** @param {string[]} lines @returns {RegExp} */
function separatorOf(lines) {
  for (const one of ['\t', ';'])
    if (lines.some((line) => line.includes(one))) return new RegExp(one);
  const spaced = lines.some((line) => /\d[.,]?\s+[+-]?[.,]?\d/.test(line));
  if (!spaced) return /,\s*|\s+/;
  return lines.some((line) => /\d,\s+[+-]?[.,]?\d/.test(line)) ? /,\s+|\s+/ : /\s+/;
}

/**
 * Splits a line into cells; a unit in brackets belongs to the word before it.
 * @param {string} line
 * @param {RegExp} separator
 */
function cellsOf(line, separator) {
  const [sign] = /^\s*(#|%(?!\s*[;,\t])|\/\/)/.exec(line) ?? [''];
  const bare = line.slice(sign.length).trim();
  const cells = (separator.test(' ') ? bare.replace(/(\S)\s+(?=[[(][^\])]*[\])])/g, '$1\u0000') : bare)
    .split(separator)
    .map((cell) => cell.replace('\u0000', ' ').trim().replace(/^"(.*)"$/, '$1')); // prettier-ignore
  return { comment: sign !== '', cells: cells.slice(0, cells.findLastIndex(Boolean) + 1) };
}

const STRESS = '(residual)?(σ|s|sig|sigma|stress)';
/**
 * Names of columns, by their symbols; lower case without spaces, dots and dashes.
 * @type {Record<string, RegExp>}
 */
const CALLED = {
  x: /^(x|r|position|distance)$/,
  height: /^(h|y|z|height|profile)$/,
  z: /^(z|depth|tiefe)$/,
  HV: /^(hardness|härte|vickers)*((hv|vhn|dph|dpn)[\d,/]*)?$/,
  factor: /^factor$/,
  σ_x: new RegExp(`^${STRESS}(x|xx|11)$`),
  σ_z: new RegExp(`^${STRESS}(z|zz|33)$`),
  σ_r: new RegExp(`^${STRESS}(r|rr|11)$`),
  σ_θ: new RegExp(`^${STRESS}(θ|θθ|t|33)$`),
  ε_p: /^(true|plastic)*(ε|eps|epsilon|strain)p?$/,
  q: /^(true|flow|vonmises)*(σ|sig|sigma|stress|q)$/,
  C: /^(c|modulus)$/,
  γ: /^(γ|gamma|rate)$/,
};

/** Other scales of hardness than that of Vickers, whose figures look alike. */
const OTHER_SCALE =
  /(?<![a-z])(HR\s?[A-Z]?|HBW?S?|BHN|HK|KHN|HLD?|rockwell|brinell|knoop|shore|leeb)(?![a-z])/i;

/** Strain and stress as a tensile test gives them, which a button beside the table converts. */
const OF_A_TEST = /^(eng|engineering|nominal|total)(?![a-z])|^(engineering|nominal|total)/i;

/**
 * Name and unit of a header: the unit in brackets, or behind the last words.
 * @param {string} header
 * @returns {[name: string, unit: string]}
 */
function partsOf(header) {
  const [, before, bracketed] = /^(.*?)\s*[[(]\s*([^\])]+?)\s*[\])]$/.exec(header) ?? [];
  if (bracketed) return [before, bracketed];
  const start = [0, ...[...header.matchAll(/[\s/,_]/g)].map(({ index }) => index + 1)];
  const at = start.find((from) => isUnit(header.slice(from).trim()));
  return at === undefined
    ? [header, '']
    : [header.slice(0, at).replace(/(\sin)?[\s/,_]*$/, ''), header.slice(at).trim()];
}

/** Whether a line has plain words alone, none of them a unit. @param {string} line */
const isTitle = (line) =>
  /^[\p{L}\s.,:;()-]+$/u.test(line) && !line.split(/[^\p{L}]+/u).some(isUnit);

/**
 * What the lines above the figures say: for each wanted column the one of the text, and its unit.
 * @param {Row[]} headers @param {Quantity[]} quantities @param {Units} units of the job @param
 *   {string[]} symbols
 * @returns {{order: number[], named: string[]} | {problem: string}}
 */
function namedBy(headers, quantities, units, symbols) {
  let order = quantities.map((_, axis) => axis);
  const named = quantities.map(() => '');
  const example = quantities.map(
    (one, axis) =>
      `${symbols[axis].replace('_', '')}${unit(one, units) && ` [${unit(one, units)}]`}`,
  );
  for (const { number, cells } of headers) {
    const refuse = (/** @type {string} */ text, /** @type {string} */ words) => ({
      problem: `line ${number}: ${quoted(text)} ${words}. The names of the columns are ${example.join(', ')}; other lines above the figures are to be left out`,
    });
    const scale = quantities.includes('hardness') && OTHER_SCALE.exec(cells.join(' '))?.[0];
    if (scale) return { problem: `line ${number}: “${scale}” is another scale, and the figures here are Vickers hardness HV: convert them first, for steels by ISO 18265` }; // prettier-ignore
    const measured = symbols.includes('ε_p') && cells.find((cell) => OF_A_TEST.test(cell));
    if (measured) return { problem: `line ${number}: ${quoted(measured)} is not plastic strain or true stress: leave this line out, and press “From engineering values” or “From total strain” below` }; // prettier-ignore
    if (cells.length !== quantities.length) {
      if (isTitle(cells.join(' '))) continue;
      return refuse(cells.join(' '), 'is not known here');
    }
    const parts = cells.map(partsOf);
    const axes = parts.map(([name], k) => {
      const plain = name.toLowerCase().replace(/[\s_.:-]/g, '');
      const isCalled = (/** @type {number} */ axis) => CALLED[symbols[axis]]?.test(plain);
      return !plain || isCalled(order[k])
        ? order[k]
        : symbols.findIndex((_, axis) => isCalled(axis));
    });
    const strange = axes.findIndex((axis, k) => axis < 0 || axes.indexOf(axis) < k);
    if (strange >= 0) return refuse(cells[strange], 'is not known here');
    for (const [k, [, name]] of parts.entries()) {
      const axis = axes[k];
      if (name && inJobUnits(1, name, quantities[axis], units) === undefined)
        return refuse(name, `is no unit known here for column ${k + 1}`);
      if (name && named[axis] && named[axis] !== name)
        return refuse(name, `is not “${named[axis]}” as in a line above`);
      named[axis] ||= name;
    }
    order = order.map((_, axis) => axes.indexOf(axis));
  }
  return { order, named };
}
