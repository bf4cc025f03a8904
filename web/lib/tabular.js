/** Tables of figures, also in formats of other programs. */

import { figureOf } from './digits.js';
import { figure } from './units.js';

/**
 * @typedef {{title: string, unit?: string, of?: string, exact?: boolean}} Column `of`: title of the
 *   column whose error it has, where it stands by itself; `exact`: what is given or follows from it
 */
/** @typedef {string | number | null} Cell numbers go out in full where a program reads them */
/**
 * @typedef {{columns: Column[], rows: Cell[][], write: (value: Cell, column: number, row: Cell[]) => string}}
 *   Table `write`: as people read it
 */

/**
 * Figures that end where their error does, which the next column has in per cent: of them, or
 * where they are shares, of the whole.
 * @param {Column[]} columns
 * @returns {Table['write']}
 */
export const endingAtErrors = (columns) => (cell, k, row) => {
  if (typeof cell !== 'number') return cell ?? '';
  if (columns[k].title === '±') return cell === 0 ? '' : figure(cell, 2);
  const error = columns[k + 1]?.title === '±' ? row[k + 1] : null;
  if (typeof error !== 'number') return figureOf(cell, columns[k].exact ? 0 : null);
  return figureOf(cell, error && error / (columns[k].unit === '%' ? Math.abs(cell) : 100));
};

/** @param {Column} column */
const heading = ({ title, unit, of }) =>
  `${of ? `${of} ` : ''}${title}${unit ? ` [${unit}]` : ''}`;

/** Texts that a spreadsheet would read as a formula. */
const FORMULA = /^[=+@-]/;

/** @param {Cell} cell @param {string} separator */
const raw = (cell, separator) => {
  // Beyond twelve digits stands the noise of conversions.
  if (typeof cell === 'number') return String(Number(cell.toPrecision(12)));
  const text = `${FORMULA.test(cell ?? '') ? "'" : ''}${cell ?? ''}`;
  return text.includes(separator) || /["\r\n]/.test(text)
    ? `"${text.replaceAll('"', '""')}"`
    : text;
};

/** @param {Table} table @param {string} separator */
const separated = ({ columns, rows }, separator) =>
  [columns.map(heading), ...rows]
    .map((row) => `${row.map((cell) => raw(cell, separator)).join(separator)}\n`)
    .join('');

/** For a spreadsheet. @param {Table} table */
export const toTsv = (table) => separated(table, '\t');

/** @param {Table} table */
export const toCsv = (table) => separated(table, ',');

/** @param {Table} table */
export function toMarkdown({ columns, rows, write }) {
  const line = (/** @type {string[]} */ cells) =>
    `| ${cells.map((cell) => cell.replace(/\s+/g, ' ').replace(/[\\|<*_`]/g, '\\$&')).join(' | ')} |\n`;
  const rule = columns.map((_, k) =>
    rows.every((row) => typeof row[k] !== 'string') ? '--:' : '---',
  );
  return (
    line(columns.map(heading)) + line(rule) + rows.map((row) => line(row.map(write))).join('')
  );
}

/** With the rules of `booktabs`. @param {Table} table */
export function toLatex({ columns, rows, write }) {
  const align = columns
    .map((_, k) => (rows.every((row) => typeof row[k] !== 'string') ? 'r' : 'l'))
    .join('');
  const line = (/** @type {string[]} */ cells) => {
    const row = cells.map(escape).join(' & ');
    // Behind the end of a row, a bracket or a star would belong to it.
    return `${/^\s*[[*]/.test(row) ? '{}' : ''}${row} \\\\\n`;
  };
  return `\\begin{tabular}{${align}}\n\\toprule\n${line(columns.map(heading))}\\midrule\n${rows.map((row) => line(row.map(write))).join('')}\\bottomrule\n\\end{tabular}\n`;
}

const SUPERSCRIPT = '⁻⁰¹²³⁴⁵⁶⁷⁸⁹';
/** Characters that LaTeX interprets or lacks. @type {Record<string, string>} */
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
  '≤': '$\\le$',
  '≥': '$\\ge$',
  '≠': '$\\neq$',
  '≈': '$\\approx$',
  '×': '$\\times$',
  '∞': '$\\infty$',
  '√': '$\\surd$',
  '∅': '$\\emptyset$',
  '⌀': '$\\emptyset$',
  '′': "$'$",
  '″': "$''$",
  '‰': '\\textperthousand{}',
  ε: '$\\varepsilon$',
  µ: '$\\mu$',
  ο: 'o',
  ς: '$\\varsigma$',
};

/** Greek letters that have the names of Latin text. */
const GREEK =
  'αalpha βbeta γgamma δdelta ζzeta ηeta θtheta ιiota κkappa λlambda μmu νnu ξxi πpi ρrho σsigma τtau υupsilon φphi χchi ψpsi ωomega ' +
  'ΓGamma ΔDelta ΘTheta ΛLambda ΞXi ΠPi ΣSigma ΥUpsilon ΦPhi ΨPsi ΩOmega';
for (const [letter, ...name] of GREEK.split(' ')) LATEX[letter] = `$\\${name.join('')}$`;
const SUBSCRIPT = '₋₀₁₂₃₄₅₆₇₈₉';

/**
 * Digits that are raised or lowered, on the line.
 * @param {string} text
 * @param {string} signs minus and ten digits
 */
const levelled = (text, signs) =>
  [...text].map((sign) => '-0123456789'[signs.indexOf(sign)]).join('');

/** @param {string} text */
const escape = (text) =>
  text
    .replace(/\s+/g, ' ')
    .replace(/[%&#_${}]/g, '\u0000$&')
    .replace(/[\\~^<>|"]|[^\x00-\x7f]/g, (sign) => LATEX[sign] ?? sign)
    .replaceAll('\u0000', '\\')
    .replace(/[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+/g, (power) => `$^{${levelled(power, SUPERSCRIPT)}}$`)
    .replace(/[₋₀₁₂₃₄₅₆₇₈₉]+/g, (index) => `$_{${levelled(index, SUBSCRIPT)}}$`);
