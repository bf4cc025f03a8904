/** Heights in files of text, as instruments write them, and work on them. No browser. */

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { NotUnderstood, readGridText } from '../../../web/setup/grid-text.js';
import { filled, missing } from '../../../web/setup/grid-work.js';
import { inJob, questionOf } from '../../../web/setup/heights.js';

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

/** Heights that no symmetry hides. @param {number} nx @param {number} ny */
const bumps = (nx, ny) =>
  Array.from({ length: nx }, (_, i) =>
    Array.from({ length: ny }, (_, j) => Math.sin(0.7 * i + 0.3) + 0.5 * Math.cos(0.9 * j)),
  );
const grid = (/** @type {number[][]} */ heights) => ({ heights, across: 'µm', up: 'nm', notes: [], spacing: /** @type {[number, number]} */ ([0.5, 0.25]) }); // prettier-ignore

test('figures that are no heights are asked for, with their count and place', () => {
  for (const [figure, at] of /** @type {[number, number[][]][]} */ ([
    [
      -9999,
      [
        [3, 4],
        [3, 5],
      ],
    ],
    [1e10, [[3, 4]]],
    [
      0,
      [
        [5, 5],
        [5, 6],
        [6, 5],
        [6, 6],
        [5, 7],
        [6, 7],
        [7, 5],
        [7, 6],
        [7, 7],
      ],
    ],
    [
      -40,
      [
        [3, 4],
        [9, 9],
        [1, 1],
      ],
    ],
  ])) {
    const heights = bumps(24, 16);
    for (const [i, j] of at) heights[i][j] = figure;
    const question = questionOf(grid(heights), 512);
    assert.match(question?.words ?? '', new RegExp(`^${at.length} of 384 heights are ${figure}`));
    const holed = question?.answers[0][1](grid(heights)) ?? grid([]);
    assert.equal(missing(holed.heights), at.length);
    const [[, fill]] = questionOf(holed, 512)?.answers ?? [];
    const done = fill?.(holed) ?? grid([]);
    assert.equal(questionOf(done, 512), undefined);
    assert.ok(Math.max(...done.heights.flat().map(Math.abs)) < 1.6);
    const kept = question?.answers[1][1](grid(heights)) ?? grid([]);
    assert.equal(questionOf(kept, 512), undefined);
  }
  const steps = bumps(24, 16).map((row) => row.map((one) => (one > 0 ? 0 : -1)));
  for (const heights of [bumps(24, 16), steps])
    assert.equal(questionOf(grid(heights), 512), undefined);
});

test('a hole takes the harmonic function of its rim', () => {
  const skin = (/** @type {number} */ i, /** @type {number} */ j) => i * i - j * j + 3 * i * j;
  const holed = bumps(40, 30).map((row, i) =>
    row.map((_, j) => (i >= 10 && i < 25 && j >= 8 && j < 20 ? NaN : skin(i, j))),
  );
  filled(holed).forEach((row, i) =>
    row.forEach((one, j) => assert.ok(Math.abs(one - skin(i, j)) < 1e-6, `${one}`)),
  );
});

test('more heights than are taken are thinned or cropped, with what is lost', () => {
  const large = grid(bumps(120, 90));
  const question = questionOf(large, 60, ' here');
  assert.match(question?.words ?? '', /120 × 90 heights are more than the 60 along a side that are taken here.*% of the slope/); // prettier-ignore
  const [[thin, means], [crop, middle]] = question?.answers ?? [];
  assert.deepEqual([thin, crop], ['Thin to 60 × 45', 'Keep the middle 60 × 60']);
  const thinned = means(large);
  const [[a, b], [c, d]] = [large.heights[0], large.heights[1]];
  near(thinned.heights[0][0], (a + b + c + d) / 4);
  const job = inJob(thinned, 'mm_N_MPa');
  assert.deepEqual([job.spacing_x, job.spacing_y], [0.001, 0.0005]);
  near(job.heights[3][4], 1e-6 * thinned.heights[3][4]);
  near(inJob(thinned, 'SI').heights[3][4], 1e-9 * thinned.heights[3][4]);
  assert.equal(middle(large).heights[0][0], large.heights[30][15]);
  assert.equal(questionOf(middle(large), 60), undefined);
});
