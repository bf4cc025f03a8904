/**
 * What page and Python package share, as modules of the page: materials of `api/materials.json` and
 * names of columns of `api/columns.json`. `npm run presets` writes them, with `--check` they are
 * compared.
 */

import { readFile, writeFile } from 'node:fs/promises';

/** @param {string} name */
const read = async (name) =>
  JSON.parse(await readFile(new URL(`../../api/${name}`, import.meta.url), 'utf8'));

const library = await read('materials.json');
if (library.units !== 'mm_N_MPa')
  throw new Error(`the page takes figures in mm, N, MPa, not ${library.units}`);
/** @type {{name: string, source: string, material: object}[]} */
const materials = library.materials;
const lines = materials.map(
  ({ name, source, material }) => `  ${JSON.stringify({ name, source, material })},\n`,
);
const { roles, facts } = await read('columns.json');
const record = (/** @type {string} */ name, /** @type {object} */ of) =>
  `/* prettier-ignore */\n/** @type {{[name: string]: string}} */\nexport const ${name} = ${JSON.stringify(of, null, 2)};\n`;
const command = '`npm --prefix tests/page run presets`';

/** @type {[string, string][]} */
const files = [
  [
    'setup/presets.js',
    `/** Materials of \`api/materials.json\` [mm, N, MPa]: ${command}. */

/* prettier-ignore */
/** @type {import('./materials.js').Preset[]} */
export const PRESETS = [
${lines.join('')}];
`,
  ],
  [
    'lib/columns.js',
    `/** What laboratories call columns and specimens, \`api/columns.json\`: ${command}. */

${record('ROLES', roles)}
${record('FACTS', facts)}`,
  ],
];
for (const [name, text] of files) {
  const file = new URL(`../../web/${name}`, import.meta.url);
  if (!process.argv.includes('--check')) await writeFile(file, text);
  else if ((await readFile(file, 'utf8').catch(() => '')) !== text)
    throw new Error(`web/${name} is not what api/ says: npm --prefix tests/page run presets`);
}
