/** A table of figures in the forms that other programs take. */

/** @typedef {{title: string, unit?: string, of?: string}} Column `of`: title of the column whose error it has, where it stands by itself */
/** @typedef {string | number | null} Cell numbers go out in full where a program reads them */
/** @typedef {{columns: Column[], rows: Cell[][], write: (value: Cell, column: number) => string}} Table `write`: as people read it */

/** @param {Column} column */
const heading = ({ title, unit, of }) => `${of ? `${of} ` : ''}${title}${unit ? ` [${unit}]` : ''}`;

/** What a spreadsheet would take for a formula. */
const FORMULA = /^[=+@-]/;

/** @param {Cell} cell @param {string} separator */
const raw = (cell, separator) => {
  // Beyond twelve digits stands the noise of conversions.
  if (typeof cell === 'number') return String(Number(cell.toPrecision(12)));
  const text = `${FORMULA.test(cell ?? '') ? "'" : ''}${cell ?? ''}`;
  return text.includes(separator) || /["\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
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
    `| ${cells.map((cell) => cell.replace(/\s+/g, ' ').replace(/[\\|<*_`]/g, '\\$&')).join(' | ')} |\n`;
  const rule = columns.map((_, k) => (rows.every((row) => typeof row[k] !== 'string') ? '--:' : '---'));
  return line(columns.map(heading)) + line(rule) + rows.map((row) => line(row.map(write))).join('');
}

/** With the rules of `booktabs`. @param {Table} table */
export function toLatex({ columns, rows, write }) {
  const align = columns.map((_, k) => (rows.every((row) => typeof row[k] !== 'string') ? 'r' : 'l')).join('');
  const line = (/** @type {string[]} */ cells) => `${cells.map(escape).join(' & ')} \\\\\n`;
  return `\\begin{tabular}{${align}}\n\\toprule\n${line(columns.map(heading))}\\midrule\n${rows.map((row) => line(row.map(write))).join('')}\\bottomrule\n\\end{tabular}\n`;
}

const SUPERSCRIPT = '⁻⁰¹²³⁴⁵⁶⁷⁸⁹';
/** What LaTeX takes for something else, or has no letter for. @type {Record<string, string>} */
const LATEX = {
  '\\': '\\textbackslash{}',
  '~': '\\textasciitilde{}',
  '^': '\\textasciicircum{}',
  '<': '$<$',
  '>': '$>$',
  '|': '$|$',
  '"': "''",
  '±': '$\\pm$',
  '→': '$\\to$',
  '…': '\\dots{}',
  '—': '--',
  '−': '$-$',
  '·': '$\\cdot$',
  α: '$\\alpha$',
  γ: '$\\gamma$',
  ε: '$\\varepsilon$',
  θ: '$\\theta$',
  σ: '$\\sigma$',
  τ: '$\\tau$',
  µ: '$\\mu$',
  ν: '$\\nu$',
};

/** @param {string} text */
const escape = (text) =>
  text
    .replace(/\s+/g, ' ')
    .replace(/[%&#_${}]/g, '\u0000$&')
    .replace(/[\\~^<>|"±→…—−·αγεθστµν]/g, (sign) => LATEX[sign])
    .replaceAll('\u0000', '\\')
    .replace(
      /[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+/g,
      (power) => `$^{${[...power].map((sign) => '-0123456789'[SUPERSCRIPT.indexOf(sign)]).join('')}}$`,
    );
