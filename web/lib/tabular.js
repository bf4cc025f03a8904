/** A table of figures in the forms that other programs take. */

/** @typedef {{title: string, unit?: string, latex?: string}} Column */
/** @typedef {string | number | null} Cell numbers go out in full where a program reads them */
/** @typedef {{columns: Column[], rows: Cell[][], write: (value: Cell, column: number) => string}} Table `write`: as people read it */

/** @param {Column} column */
const heading = ({ title, unit }) => (unit ? `${title} [${unit}]` : title);

/** @param {Cell} cell @param {string} separator */
const raw = (cell, separator) => {
  // Beyond twelve digits stands the noise of conversions.
  const text = cell === null ? '' : String(typeof cell === 'number' ? Number(cell.toPrecision(12)) : cell);
  return text.includes(separator) || text.includes('"') ? `"${text.replaceAll('"', '""')}"` : text;
};

/** @param {Table} table @param {string} separator */
const separated = ({ columns, rows }, separator) =>
  [columns.map(heading), ...rows].map((row) => `${row.map((cell) => raw(cell, separator)).join(separator)}\n`).join('');

/** For a spreadsheet. @param {Table} table */
export const toTsv = (table) => separated(table, '\t');

/** @param {Table} table */
export const toCsv = (table) => separated(table, ',');

/** @param {Table} table */
export function toMarkdown({ columns, rows, write }) {
  const line = (/** @type {string[]} */ cells) =>
    `| ${cells.map((cell) => cell.replaceAll('|', '\\|')).join(' | ')} |\n`;
  const rule = columns.map((_, k) => (rows.every((row) => typeof row[k] !== 'string') ? '--:' : '---'));
  return line(columns.map(heading)) + line(rule) + rows.map((row) => line(row.map(write))).join('');
}

/** With the rules of `booktabs`. @param {Table} table */
export function toLatex({ columns, rows, write }) {
  const align = columns.map((_, k) => (rows.every((row) => typeof row[k] !== 'string') ? 'r' : 'l')).join('');
  const line = (/** @type {string[]} */ cells) => `${cells.map(escape).join(' & ')} \\\\\n`;
  return `\\begin{tabular}{${align}}\n\\toprule\n${line(columns.map(heading))}\\midrule\n${rows.map((row) => line(row.map(write))).join('')}\\bottomrule\n\\end{tabular}\n`;
}

const GREEK = /** @type {Record<string, string>} */ ({
  α: '\\alpha',
  ε: '\\varepsilon',
  σ: '\\sigma',
  τ: '\\tau',
  µ: '\\mu',
  ν: '\\nu',
});
const SUPERSCRIPT = '⁰¹²³⁴⁵⁶⁷⁸⁹';

/** @param {string} text */
const escape = (text) =>
  text
    .replace(/[%&#_$]/g, '\\$&')
    .replace(/[αεστµν]/g, (letter) => `$${GREEK[letter]}$`)
    .replace(
      /·?10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)/g,
      (all, power) =>
        `$${all.startsWith('·') ? '\\cdot ' : ''}10^{${[...power].map((sign) => (sign === '⁻' ? '-' : SUPERSCRIPT.indexOf(sign))).join('')}}$`,
    )
    .replace(/[⁰¹²³⁴⁵⁶⁷⁸⁹]/g, (digit) => `$^${SUPERSCRIPT.indexOf(digit)}$`)
    .replace(/−(?=[\d.])/g, '$-$')
    .replaceAll('·', '$\\cdot$')
    .replaceAll('—', '--');
