/** What the lines above the figures of a table say of their units. Nothing that may be a unit is passed over in silence. */

import { columnsInWords, quoted } from './number.js';
import { inJobUnits, isUnit, unit } from './units.js';

/** @typedef {import('./units.js').Quantity} Quantity */
/** @typedef {import('./units.js').Units} Units */
/** @typedef {{number: number, cells: string[], comment: boolean}} Row a line of the text, counted from 1 */

/** Signs that names do not have. */
const SIGN = /[%‰µμ²³^·"″\u{fffd}]/u;

/** Other scales of hardness than that of Vickers, whose figures look alike. */
const OTHER_SCALE =
  /(?<![a-z])(HR\s?[A-Z]?\d*[A-Z]*|HBW?S?|BHN|HK|KHN|HLD?|rockwell|brinell|knoop|shore|leeb)(?![a-z])/i;
const VICKERS = /(?<![a-z])(HV|VHN|DPH|vickers)/i;

/** @param {Row[]} headers @param {Quantity[]} quantities @returns {{problem: string} | undefined} where hardness is of another scale */
function otherScale(headers, quantities) {
  const axis = quantities.indexOf('hardness');
  if (axis < 0) return undefined;
  for (const { number, cells } of headers)
    for (const cell of cells.length === quantities.length ? [cells[axis]] : cells) {
      const name = VICKERS.test(cell) ? undefined : OTHER_SCALE.exec(cell)?.[0];
      if (name)
        return {
          problem: `line ${number}: “${name}” is another scale, and the figures here are Vickers hardness HV: convert them first, for steels by ISO 18265`,
        };
    }
  return undefined;
}

/** A factor on the figures of a column: x1000, *1e3, · 10³, 10^-3; not the x1 that is a name. */
const MULTIPLIER = /[*×·⋅]\s*\d|\d\s*[*×·⋅]|\S\s+x\s?\d{2}|[(\[]x\s?\d{2}|10(?:\s*\^|[⁺⁻]?[⁰¹²³⁴⁵⁶⁷⁸⁹])/i;

/** @param {Row[]} headers @param {number} columns @returns {{problem: string} | undefined} where figures are to be multiplied */
function multiplied(headers, columns) {
  for (const { number, cells, comment } of headers) {
    const texts = cells.length === columns ? cells : comment ? [] : [cells.join(' ')];
    const found = texts.find((text) => MULTIPLIER.test(text));
    if (found)
      return { problem: `line ${number}: ${quoted(found)} has a factor: write the figures themselves, and their unit` };
  }
  return undefined;
}

const END = '(?![a-zα-ω])';
const STRESS = '^(?:residual )?(?:σ|s|sig|sigma|stress)[\\s_]*';
/** How columns are called, by their symbols. @type {Record<string, RegExp | undefined>} */
const CALLED = {
  z: new RegExp(`^(z|depth|tiefe)${END}`, 'i'),
  σ_x: new RegExp(`${STRESS}(x|xx|11)${END}`, 'i'),
  σ_z: new RegExp(`${STRESS}(z|zz|33)${END}`, 'i'),
  HV: /^(HV|VHN|DPH|DPN|vickers|hardness|härte)/i,
  factor: /^factor/i,
  ε_p: new RegExp(`^((true|plastic|total|eng\\w*) )*(ε|eps|epsilon|strain)`, 'i'),
  q: new RegExp(`^((true|eng\\w*|von mises) )*(σ|sig|sigma|stress)(?![a-z])`, 'i'),
};

/**
 * The order of columns that the headers call by their names.
 * @param {Row[]} headers
 * @param {string[]} symbols of the columns as they are wanted
 * @returns {{order: number[] | undefined} | {problem: string}} for each wanted column the one of the text, where they stand otherwise
 */
export function orderCalled(headers, symbols) {
  for (const { number, cells } of headers) {
    if (cells.length !== symbols.length) continue;
    const wanted = cells.map((cell) => symbols.findIndex((symbol) => CALLED[symbol]?.test(cell)));
    const moved = wanted.findIndex((axis, k) => axis >= 0 && axis !== k);
    if (moved < 0) continue;
    if (!wanted.includes(-1) && new Set(wanted).size === symbols.length)
      return { order: symbols.map((_, axis) => wanted.indexOf(axis)) };
    const order = symbols.map((symbol) => symbol.replace('_', '')).join(', ');
    return {
      problem: `line ${number}: ${quoted(cells[moved])} is not what column ${moved + 1} has here: the columns are ${order}`,
    };
  }
  return { order: undefined };
}

/**
 * @param {Row[]} headers
 * @param {Quantity[]} quantities of the columns
 * @param {Units} units of the job
 * @returns {{named: (string | undefined)[]} | {problem: string}} the unit that is named for each column
 */
export function unitsNamed(headers, quantities, units) {
  const refused = otherScale(headers, quantities) ?? multiplied(headers, quantities.length);
  if (refused) return refused;
  const named = /** @type {(string | undefined)[]} */ (quantities.map(() => undefined));
  const known = (/** @type {string} */ name, /** @type {number} */ axis) =>
    inJobUnits(1, name, quantities[axis], units) !== undefined;
  for (const { number, cells } of headers) {
    const places = cells.length === 2 && quantities.every((one) => one === 'length') ? cells.map(isPlace) : [];
    if (places[1] && !places[0])
      return { problem: `line ${number}: ${quoted(cells[1])} is the second column, and places x belong in the first` };
    if (cells.length !== quantities.length) {
      const other = cells
        .map(unitIn)
        .find(({ name }) => quantities.some((one, axis) => known(name, axis) && unit(one, units) !== name));
      if (other)
        return {
          problem: `line ${number}: it cannot be told which of the ${columnsInWords(quantities.length)} columns “${other.name}” is the unit of`,
        };
      continue;
    }
    // A line of units has nothing else; HV is the name of a column too.
    const bare = cells.some((cell, axis) => cell !== '1' && quantities[axis] !== 'hardness' && known(cell, axis));
    for (const [axis, cell] of cells.entries()) {
      const { name, sure } = unitIn(cell);
      if (known(name, axis)) {
        if (named[axis] !== undefined && named[axis] !== name)
          return { problem: `line ${number}, column ${axis + 1}: “${name}”, and “${named[axis]}” in a line above` };
        named[axis] = name;
      } else if (sure || bare) {
        const own = unit(quantities[axis], units);
        return {
          problem: `line ${number}, column ${axis + 1}: ${quoted(name)} is no unit known here for this column. ${
            own
              ? `Write a unit such as ${own}, or leave it out if the figures are in ${own}`
              : 'Leave it out if the figures are plain numbers'
          }`,
        };
      }
    }
  }
  return { named };
}

/** Whether a header names the place along the surface. @param {string} header */
const isPlace = (header) => /^(x|r|position|distance)(?![a-zα-ω])/i.test(header);

/**
 * What may be the unit in a header: in brackets, behind a slash or an underscore, or the last word. `sure`: it is nothing else.
 * @param {string} header
 * @returns {{name: string, sure: boolean}}
 */
function unitIn(header) {
  const bracketed = /[[(]\s*([^\])]+?)\s*[\])]\s*$/.exec(header)?.[1];
  if (bracketed) return { name: bracketed, sure: true };
  const last =
    header
      .trim()
      .split(/[\s,]+/)
      .at(-1) ?? '';
  const name = isUnit(last) || VICKERS.test(last) ? last : (/[/_](.+)$/.exec(last)?.[1] ?? last);
  const sure = isUnit(name) && !/^[\d-]$/.test(name);
  return { name, sure: sure || SIGN.test(name) || (last.includes('/') && name !== last) };
}
