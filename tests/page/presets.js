/**
 * The page's library of materials from `api/materials.json`: `npm run presets` writes it, with
 * `--check` it is compared.
 */

import { readFile, writeFile } from 'node:fs/promises';

const FILE = new URL('../../web/setup/presets.js', import.meta.url);
const library = JSON.parse(
  await readFile(new URL('../../api/materials.json', import.meta.url), 'utf8'),
);
if (library.units !== 'mm_N_MPa')
  throw new Error(`the page takes figures in mm, N, MPa, not ${library.units}`);

/** @type {{name: string, source: string, material: object}[]} */
const materials = library.materials;
const lines = materials.map(
  ({ name, source, material }) => `  ${JSON.stringify({ name, source, material })},\n`,
);
const text = `/** Materials of \`api/materials.json\` [mm, N, MPa]: \`npm --prefix tests/page run presets\`. */

/* prettier-ignore */
/** @type {import('./materials.js').Preset[]} */
export const PRESETS = [
${lines.join('')}];
`;
if (!process.argv.includes('--check')) await writeFile(FILE, text);
else if ((await readFile(FILE, 'utf8').catch(() => '')) !== text)
  throw new Error(
    'web/setup/presets.js is not what api/materials.json says: npm --prefix tests/page run presets',
  );
