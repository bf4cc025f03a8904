/** Tables that are taken along hold what they should, whatever a job is called. No browser. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { toCsv, toLatex, toMarkdown, toTsv } from '../../../web/lib/tabular.js';

const NASTY = 'a\\b {x}_1 $5 ~^<b>|c"d\n2 %';
const TABLE = {
  columns: [
    { title: 'job' },
    { title: 'approach', unit: 'mm' },
    { title: '±', of: 'approach', unit: '%' },
    { title: 'dP/dα', unit: 'N/mm²' },
  ],
  rows: [
    [NASTY, 1.5e-7, null, -3],
    ['=1+1', 0.1 + 0.2, 0.5, 4],
  ],
  write: (/** @type {string | number | null} */ cell) =>
    cell === 1.5e-7
      ? '1.5·10⁻⁷'
      : typeof cell === 'number'
        ? String(cell).replace('-', '−')
        : (cell ?? ''),
};

test('CSV has a name for every column, quotes what has to be, and holds no formula', () => {
  assert.equal(
    toCsv(TABLE),
    `job,approach [mm],approach ± [%],dP/dα [N/mm²]\n"${NASTY.replace('"', '""')}",1.5e-7,,-3\n'=1+1,0.3,0.5,4\n`,
  );
  assert.equal(toTsv(TABLE).split('\n')[3], "'=1+1\t0.3\t0.5\t4");
});

test('Markdown keeps a job in its cell', () => {
  const [head, rule, row] = toMarkdown(TABLE).split('\n');
  assert.equal(head, '| job | approach [mm] | approach ± [%] | dP/dα [N/mm²] |');
  assert.equal(rule, '| --- | --: | --: | --: |');
  assert.equal(row, '| a\\\\b {x}\\_1 $5 ~^\\<b>\\|c"d 2 % | 1.5·10⁻⁷ |  | −3 |');
});

test('LaTeX escapes what is not a letter', () => {
  const lines = toLatex(TABLE).split('\n');
  assert.equal(lines[0], '\\begin{tabular}{lrrr}');
  assert.equal(
    lines[2],
    'job & approach [mm] & approach $\\pm$ [\\%] & dP/d$\\alpha$ [N/mm$^{2}$] \\\\',
  );
  const [cell, figure, , slope] = lines[4].split(' & ');
  assert.equal(
    cell,
    "a\\textbackslash{}b \\{x\\}\\_1 \\$5 \\textasciitilde{}\\textasciicircum{}$<$b$>$$|$c''d 2 \\%",
  );
  assert.equal(figure, '1.5$\\cdot$10$^{-7}$');
  assert.equal(slope, '$-$3 \\\\');
});

test('LaTeX takes no row for the option of a rule, and has a name for every letter of the page', () => {
  const write = (/** @type {string | number | null} */ cell) => String(cell);
  const latex = toLatex({
    columns: [{ title: 'job' }, { title: 'λ ≤ 2' }],
    rows: [
      ['[A] first', 1],
      ['*B', 2],
      ['p₀ × 10⁻³ Δψ', 3],
    ],
    write,
  });
  assert.match(latex, /\\midrule\n\{\}\[A\] first/);
  assert.match(latex, /\n\{\}\*B &/);
  assert.match(latex, /job & \$\\lambda\$ \$\\le\$ 2/);
  assert.match(latex, /p\$_\{0\}\$ \$\\times\$ 10\$\^\{-3\}\$ \$\\Delta\$\$\\psi\$/);
  // Beyond Latin text nothing is left that pdfLaTeX does not know.
  assert.doesNotMatch(latex, /[^\x00-\xff]/);
});
