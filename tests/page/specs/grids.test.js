/** Heights in files of text, as instruments write them, and work on them. No browser. */

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { NotUnderstood, readGridText } from '../../../web/setup/grid-text.js';

/** Cases that the Python package reads too. @type {any[]} */
const CASES = JSON.parse(readFileSync(new URL('../../measured/grids.json', import.meta.url), 'utf8')); // prettier-ignore

const near = (/** @type {number} */ a, /** @type {number} */ b) =>
  assert.ok(Math.abs(a - b) <= 1e-6 * Math.abs(b), `${a}, not ${b}`);

for (const {
  name,
  text,
  refused,
  line,
  shape,
  across,
  up,
  spacing,
  missing,
  corners,
  says = '',
} of CASES)
  // prettier-ignore
  test(`${name}: ${refused === undefined ? 'understood' : 'refused'}`, () => {
    if (refused !== undefined) {
      assert.throws(
        () => readGridText(text),
        (error) => error instanceof NotUnderstood && error.message.includes(refused),
      );
      if (line) readGridText(text, [line]);
      return;
    }
    const grid = readGridText(text);
    assert.deepEqual([grid.heights.length, grid.heights[0].length], shape);
    assert.deepEqual([grid.across, grid.up], [across, up]);
    if (spacing) spacing.forEach((/** @type {number} */ one, /** @type {number} */ k) => near((grid.spacing ?? [])[k] ?? NaN, one)); // prettier-ignore
    else assert.equal(grid.spacing, undefined);
    assert.equal(grid.heights.flat().filter(Number.isNaN).length, missing);
    const [first, last] = [grid.heights[0], grid.heights[grid.heights.length - 1]];
    const ends = [first[0], first[first.length - 1], last[0], last[last.length - 1]];
    corners?.forEach((/** @type {number} */ one, /** @type {number} */ k) => near(ends[k], one));
    assert.ok(grid.notes.join('; ').includes(says), grid.notes.join('; '));
  });
