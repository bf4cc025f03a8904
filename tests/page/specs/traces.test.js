/** Traces of a stylus: level, filter, fewer points. No browser. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { levelled, longWaves, noData, thinnedTrace } from '../../../web/setup/trace.js';

/** @param {(x: number) => number} height @returns {[number, number][]} 5 mm by 0.5 µm */
const trace = (height) => Array.from({ length: 10_001 }, (_, k) => [k * 5e-4, height(k * 5e-4)]);
const wave = (/** @type {number} */ long) => (/** @type {number} */ x) =>
  1e-3 * Math.sin((2 * Math.PI * x) / long);
const middle = (/** @type {[number, number][]} */ points) =>
  points.filter(([x]) => x > 1 && x < 4).map(([, z]) => z);

test('half of a wave as long as the cut-off passes, none of a short one, all of a long one', () => {
  for (const [long, part] of [
    [0.8, 0.5],
    [0.08, 0],
    [40, 1],
  ]) {
    const found = longWaves(trace(wave(long)), 0.8, 'mm');
    assert.ok('points' in found);
    const most = Math.max(...middle(found.points).map(Math.abs));
    const given = Math.max(...middle(trace(wave(long))).map(Math.abs));
    assert.ok(Math.abs(most / given - part) < 0.03, `${long}: ${most / given}`);
    assert.match(found.note, /ISO 16610-21, λ_c 0.800 mm/);
    assert.ok(found.points.length < 60);
  }
  const refused = longWaves(trace(wave(1)), 8, 'mm');
  assert.match(
    'problem' in refused ? refused.problem : '',
    /between 0.001.* and its length 5.00 mm/,
  );
});

test('a level trace has no slope, and a thin one says what it lost', () => {
  const { points, note } = levelled(trace((x) => 3 + 0.02 * x));
  assert.ok(points.every(([, z]) => Math.abs(z) < 1e-9));
  assert.match(note, /a slope of 0.0200 is taken away/);
  const thin = thinnedTrace(trace(wave(0.004)), 1000);
  assert.equal(thin.points.length, 911);
  assert.match(thin.note, /10\u202f001 points thinned to 911; \d+ % of the slope is lost/);
});

test('heights of a trace that stand for no data are named with their place', () => {
  const plain = trace(wave(0.8));
  assert.deepEqual(noData(plain), []);
  assert.deepEqual(noData(plain.map(([x, z], k) => [x, k === 50 ? -0.004 : z])), []);
  for (const figure of [-9.999, -9999, -32.768, 1e35, 9.999e-3]) {
    const [said, ...more] = noData(plain.map(([x, z], k) => [x, k === 50 ? figure : z]));
    assert.match(said, /^1 of 10\u202f001 heights is .*, the first at point 51, .*no data\?/);
    assert.equal(more.length, 0);
  }
});
