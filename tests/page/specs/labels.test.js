/** Words beside lines across a chart, struck through by nothing. No browser. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { placeWords } from '../../../web/result/labels.js';

const BOX = { left: 50, right: 450, top: 10, bottom: 210 };

test('words stand at the end of a level line, above it', () => {
  assert.deepEqual(placeWords([{ across: 'y', at: 100, width: 80 }], [], BOX), [
    { x: 366, y: 95 },
  ]);
  assert.deepEqual(placeWords([{ across: 'y', at: 100, width: 80, left: true }], [], BOX), [
    { x: 54, y: 95 },
  ]);
});

test('words go below a line at the top, where they would be cut', () => {
  const [{ y }] = placeWords([{ across: 'y', at: BOX.top, width: 80 }], [], BOX);
  assert.ok(y - 11 > BOX.top, `${y}`);
});

test('words go below a line where a curve runs above it', () => {
  const [{ x, y }] = placeWords(
    [{ across: 'y', at: 100, width: 80 }],
    [
      [
        [50, 92],
        [450, 92],
      ],
    ],
    BOX,
  );
  assert.equal(x, 366);
  assert.ok(y - 11 > 100, `${y}`);
});

test('words leave a corner that a curve crosses', () => {
  // A loop through the right end of the line.
  const curve = /** @type {[number, number][]} */ ([
    [50, 200],
    [410, 100],
    [450, 20],
  ]);
  const [{ x, y }] = placeWords([{ across: 'y', at: 100, width: 80 }], [curve], BOX);
  for (let t = 0; t <= 1; t += 0.01)
    for (const [[x0, y0], [x1, y1]] of [
      [curve[0], curve[1]],
      [curve[1], curve[2]],
    ]) {
      const [px, py] = [x0 + t * (x1 - x0), y0 + t * (y1 - y0)];
      assert.ok(px < x || px > x + 80 || py < y - 9 || py > y + 2, `${px} ${py} in ${x} ${y}`);
    }
});

test('words of two upright lines do not cover each other, and stay within the axes', () => {
  const places = placeWords(
    [
      { across: 'x', at: 440, width: 60 },
      { across: 'x', at: 445, width: 40 },
    ],
    [],
    BOX,
  );
  for (const { x } of places) assert.ok(x < 440 && x > 50, `${x}`);
  assert.ok(Math.abs(places[0].y - places[1].y) >= 14, JSON.stringify(places));
});
