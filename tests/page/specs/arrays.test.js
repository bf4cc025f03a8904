/** The binary form of fields, read as the service writes it. No browser. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { decodeFields } from '../../../web/api/field-arrays.js';

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

test('arrays of both precisions are read, elements become triangles', () => {
  const bytes = encode([
    { body: 'lower', name: 'nodes', type: 'f32', components: 2, values: NODES },
    { body: 'lower', name: 'elements', type: 'u32', components: 4, values: [0, 1, 2, 3] },
    { body: 'lower', name: 'von_mises', type: 'f64', components: 1, values: [1, 2, 3, 4.5] },
  ]);
  // As it comes from a connection: somewhere in a larger buffer.
  const within = new Uint8Array(bytes.length + 3);
  within.set(bytes, 3);
  const buffers = /** @type {ArrayBuffer[]} */ ([]);
  const { upper, lower } = decodeFields(within.subarray(3), buffers);
  assert.equal(upper, null, 'a rigid body has no arrays');
  assert.deepEqual([...lower.nodes], NODES);
  assert.deepEqual([...lower.triangles], [0, 1, 2, 0, 2, 3]);
  assert.deepEqual([...lower.von_mises], [1, 2, 3, 4.5]);
  assert.equal(buffers.length, 3);
  assert.ok(
    buffers.every((buffer) => buffer !== within.buffer),
    'each array is its own',
  );
});

test('what is no fields is refused', () => {
  assert.throws(() => decodeFields(new TextEncoder().encode('{"title": "no"} and so on'), []), /no fields/);
});
