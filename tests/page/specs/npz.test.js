/** The archive of fields, read as the service writes it. No browser. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { readFields } from '../../../web/api/npz.js';

/** @param {number[]} numbers each of 2 or 4 bytes, as pairs of value and width */
function little(...numbers) {
  const bytes = [];
  for (let k = 0; k < numbers.length; k += 2)
    for (let j = 0; j < numbers[k + 1]; j++) bytes.push((numbers[k] >>> (8 * j)) & 255);
  return bytes;
}

/** An array of numpy. @param {string} kind @param {string} shape @param {Float32Array | Uint32Array} values */
function npy(kind, shape, values) {
  const text =
    `{'descr': '${kind}', 'fortran_order': False, 'shape': ${shape}, }`.padEnd(117) + '\n';
  const start = [
    0x93,
    ...Buffer.from('NUMPY'),
    1,
    0,
    ...little(text.length, 2),
    ...Buffer.from(text),
  ];
  return [...start, ...new Uint8Array(values.buffer)];
}

/** A zip whose sizes stand behind each file and in the directory, as a stream has it. @param {[string, number[]][]} files */
function zip(files) {
  const [bytes, directory] = [/** @type {number[]} */ ([]), /** @type {number[]} */ ([])];
  for (const [name, data] of files) {
    const [at, size, letters] = [bytes.length, data.length, [...Buffer.from(name)]];
    const common = [...little(20, 2, 8, 2, 0, 2, 0, 4)];
    bytes.push(
      ...little(0x04034b50, 4),
      ...common,
      ...little(0, 4, 0, 4, 0, 4, letters.length, 2, 0, 2),
    );
    bytes.push(...letters, ...data, ...little(0x08074b50, 4, 0, 4, size, 4, size, 4));
    directory.push(...little(0x02014b50, 4, 20, 2), ...common, ...little(0, 4, size, 4, size, 4));
    directory.push(...little(letters.length, 2, 0, 2, 0, 2, 0, 2, 0, 2, 0, 4, at, 4), ...letters);
  }
  const end = little(
    0x06054b50,
    4,
    0,
    4,
    files.length,
    2,
    files.length,
    2,
    directory.length,
    4,
    bytes.length,
    4,
    0,
    2,
  );
  return Uint8Array.from([...bytes, ...directory, ...end]).buffer;
}

const NODES = [0, 0, 1, 0, 1, 1, 0, 1];
const ARCHIVE = zip([
  ['lower/nodes.npy', npy('<f4', '(4, 2)', Float32Array.from(NODES))],
  ['lower/elements.npy', npy('<u4', '(1, 4)', Uint32Array.from([0, 1, 2, 3]))],
  ['lower/von_mises.npy', npy('<f4', '(4,)', Float32Array.from([1, 2, 3, 4.5]))],
]);

test('each array has its numbers, in memory of its own', () => {
  const buffers = /** @type {ArrayBuffer[]} */ ([]);
  const { upper, lower } = readFields(ARCHIVE, buffers);
  assert.equal(upper, null, 'a rigid body has no arrays');
  assert.deepEqual([...lower.nodes], NODES);
  assert.deepEqual([...lower.elements], [0, 1, 2, 3]);
  assert.deepEqual([...lower.von_mises], [1, 2, 3, 4.5]);
  assert.deepEqual(
    buffers.map((buffer) => buffer.byteLength),
    [32, 16, 16],
  );
});

test('an archive that is cut short, or none, or of other numbers, is refused', () => {
  for (const length of [0, 12, 40, ARCHIVE.byteLength - 9])
    assert.throws(() => readFields(ARCHIVE.slice(0, length), []), /cut short/);
  const doubles = zip([['lower/nodes.npy', npy('<c16', '(1,)', new Uint32Array(4))]]);
  assert.throws(() => readFields(doubles, []), /another type/);
});
