/** The binary form of fields, read as the service writes it. No browser. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { FieldReader } from '../../../web/api/field-arrays.js';

/** @typedef {{body: string, name: string, type: 'f32' | 'f64' | 'u32', components: number, values: number[]}} Given */

/** As docs/results.md has it. @param {Given[]} given */
function encode(given) {
  let offset = 0;
  const arrays = given.map(({ body, name, type, components, values }) => {
    const entry = { body, name, type, components, count: values.length / components, offset };
    offset += Math.ceil((values.length * (type === 'f64' ? 8 : 4)) / 8) * 8;
    return entry;
  });
  let header = JSON.stringify({ arrays });
  header += ' '.repeat((8 - (header.length % 8)) % 8);
  const bytes = new Uint8Array(16 + header.length + offset);
  bytes.set(new TextEncoder().encode('BRNFLD01'));
  const view = new DataView(bytes.buffer);
  view.setUint32(8, header.length, true);
  bytes.set(new TextEncoder().encode(header), 16);
  given.forEach(({ type, values }, k) => {
    const at = 16 + header.length + arrays[k].offset;
    values.forEach((value, j) => {
      if (type === 'f64') view.setFloat64(at + 8 * j, value, true);
      else if (type === 'f32') view.setFloat32(at + 4 * j, value, true);
      else view.setUint32(at + 4 * j, value, true);
    });
  });
  return bytes;
}

const NODES = [0, 0, 1, 0, 1, 1, 0, 1];

/** Reads bytes that come in pieces of a size. @param {FieldReader} reader @param {Uint8Array} bytes @param {number} size */
function inPieces(reader, bytes, size) {
  for (let at = 0; at < bytes.length; at += size) reader.push(bytes.subarray(at, at + size));
  const buffers = /** @type {ArrayBuffer[]} */ ([]);
  return { ...reader.finish(buffers), buffers };
}

const GIVEN = /** @type {Given[]} */ ([
  { body: 'lower', name: 'nodes', type: 'f32', components: 2, values: NODES },
  { body: 'lower', name: 'elements', type: 'u32', components: 4, values: [0, 1, 2, 3] },
  { body: 'lower', name: 'von_mises', type: 'f64', components: 1, values: [1, 2, 3, 4.5] },
  { body: 'lower', name: 'sigma_x', type: 'f32', components: 1, values: [5, 6, 7] },
]);

test('arrays of both precisions are read in whatever pieces they come', () => {
  const bytes = encode(GIVEN);
  for (const size of [1, 7, 64, 1000]) {
    const { upper, lower, buffers } = inPieces(new FieldReader(), bytes, size);
    assert.equal(upper, null, 'a rigid body has no arrays');
    assert.deepEqual([...lower.nodes], NODES);
    assert.deepEqual([...lower.elements], [0, 1, 2, 3]);
    assert.deepEqual([...lower.von_mises], [1, 2, 3, 4.5]);
    assert.deepEqual([...lower.sigma_x], [5, 6, 7]);
    assert.equal(new Set(buffers).size, 4, 'each array is its own');
  }
});

test('what is no fields, or half of them, is refused', () => {
  const bytes = encode(GIVEN);
  assert.throws(
    () => inPieces(new FieldReader(), new TextEncoder().encode('{"title": "no"} and so on'), 100),
    /no fields/,
  );
  for (const length of [0, 12, 40, bytes.length - 9])
    assert.throws(() => inPieces(new FieldReader(), bytes.subarray(0, length), 100), /cut short/);
});
