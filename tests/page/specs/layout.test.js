/**
 * Imports run one way: no file of the page imports, over others, from one that imports it. Imports
 * of types count.
 */

import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { dirname, join, normalize } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const WEB = fileURLToPath(new URL('../../../web/', import.meta.url));

/** @typedef {Map<string, string[]>} Graph the files that each file imports from */

/** @param {Map<string, string>} texts by path @returns {Graph} */
function graphOf(texts) {
  const places = /(?:\bfrom|\bimport\(|^import)\s*'(\.[^']*)'/gm;
  const imports = (/** @type {[string, string]} */ [path, text]) =>
    [...text.matchAll(places)].map(([, to]) => normalize(join(dirname(path), to)));
  return new Map([...texts].map((file) => [file[0], imports(file)]));
}

/** @param {Graph} graph @param {string} from @returns {Set<string>} */
function reached(graph, from) {
  const seen = /** @type {Set<string>} */ (new Set());
  const next = [from];
  for (let file = next.pop(); file !== undefined; file = next.pop())
    for (const one of graph.get(file) ?? []) {
      if (!seen.has(one)) next.push(one);
      seen.add(one);
    }
  return seen;
}

/** @param {Graph} graph @returns {string[]} imports that lead back */
const circles = (graph) =>
  [...graph].flatMap(([file, imported]) =>
    imported.filter((one) => reached(graph, one).has(file)).map((one) => `${file} imports ${one}`),
  );

test('no files of the page import each other', () => {
  const names = readdirSync(WEB, { recursive: true, encoding: 'utf8' });
  const files = names.filter((name) => name.endsWith('.js'));
  const graph = graphOf(new Map(files.map((name) => [name, readFileSync(WEB + name, 'utf8')])));
  const lost = [...graph.values()].flat().filter((name) => !graph.has(name));
  assert.deepEqual(lost, [], 'every import leads to a file');
  assert.ok([...graph.values()].flat().length > 400);
  assert.deepEqual(circles(graph), []);
});

test('a circle over an import of types is found', () => {
  const graph = graphOf(
    new Map([
      ['setup/entry.js', "import { list } from './list.js';"],
      [
        'setup/list.js',
        "import { h } from '../lib/dom.js';\n/** @param {import('./entry.js').Field} field */",
      ],
      ['lib/dom.js', ''],
    ]),
  );
  assert.deepEqual(circles(graph), [
    'setup/entry.js imports setup/list.js',
    'setup/list.js imports setup/entry.js',
  ]);
});
