/** Axes of the job, digits that follow the error, searches. No browser. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { figureOf } from '../../../web/lib/digits.js';
import { alongJob, axesAt, mapInJob } from '../../../web/result/axes.js';
import { search } from '../../../web/result/search.js';

test('a map has the x and y of the job, however its contact is turned', () => {
  // Values are 10 x + y of the contact, at 0 … 1 and 0 … 2.
  const maps = {
    x: [0, 1],
    y: [0, 1, 2],
    pressure: [0, 1, 2, 10, 11, 12],
    other: 'stays',
  };
  /** What is at a place of the job. @param {typeof maps} map @param {number} x @param {number} y */
  const at = ({ x: xs, y: ys, pressure }, x, y) =>
    pressure[xs.indexOf(x) * ys.length + ys.indexOf(y)];
  for (const orientation of [0, 90, -90, 180]) {
    const made = mapInJob(maps, axesAt(orientation));
    const [sine, cosine] = [
      Math.round(Math.sin((orientation * Math.PI) / 180)),
      Math.round(Math.cos((orientation * Math.PI) / 180)),
    ];
    for (const [i, x] of maps.x.entries())
      for (const [j, y] of maps.y.entries()) {
        const place = [cosine * x - sine * y || 0, sine * x + cosine * y || 0];
        assert.equal(at(made, place[0], place[1]), 10 * i + j, `${orientation}° ${place}`);
      }
    for (const axis of [made.x, made.y])
      assert.deepEqual(
        axis,
        [...axis].sort((a, b) => a - b),
      );
    assert.equal(made.other, 'stays');
  }
  assert.equal(mapInJob(maps, axesAt(30)), maps);
  assert.match(axesAt(-30).words, /−30\.0° from x of the sketch/);
  assert.deepEqual(alongJob([1, 2], [5, 6], { name: 'x', sign: -1 }), { x: [-2, -1], y: [6, 5] });
});

test('a figure ends where its error does', () => {
  assert.equal(figureOf(1182.38, 0.0021), '1182');
  assert.equal(figureOf(0.307891, 0.022), '0.308');
  assert.equal(figureOf(0.0028801, 0.34), '0.0029');
  assert.equal(figureOf(612.6106, 0), '612.61');
  assert.equal(figureOf(0.9174, null), '0.917');
  assert.equal(figureOf(5.4321, 3), '5.4');
  assert.equal(figureOf(110423.6, 0.013), '110000');
  assert.equal(figureOf(1155.2, null), '1155');
});

test('a search finds what a figure asks for, and says what none gives', async () => {
  for (const [figure, wanted] of /** @type {[(x: number) => number, number][]} */ ([
    [(x) => x ** 2, 50],
    [(x) => 1 / x, 0.01],
    [(x) => Math.exp(-x), 0.5],
    [(x) => 1000 * Math.cbrt(x), 1182],
    [(x) => (x < 2.5 ? NaN : 100 - x), 90],
  ])) {
    const { best, found, looks } = await search(
      async (x) => figure(x),
      3,
      wanted,
      () => false,
    );
    assert.ok(found && Math.abs(figure(best.at) / wanted - 1) <= 2e-3, `${best.at} of ${figure}`);
    assert.ok(looks.length <= 24 && looks.some(({ at }) => at === best.at));
  }
  const none = await search(
    async () => 5,
    3,
    7,
    () => false,
  );
  assert.equal(none.found, false);
  const stopped = await search(
    async (x) => x,
    3,
    1000,
    () => true,
  );
  assert.equal(stopped.looks.length, 1);
});
