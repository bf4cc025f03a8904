/**
 * The binary form of the fields of a step: eight letters, the length of a JSON header (u32), zero (u32), the header, which lists the
 * arrays of both bodies with their places, and the arrays.
 */

const MAGIC = 'BRNFLD01';
const HEADER = 16;

/** @typedef {{body: 'upper' | 'lower', name: string, type: 'f32' | 'f64' | 'u32', components: number, count: number, offset: number}} Entry */

/**
 * @param {Uint8Array} bytes
 * @param {ArrayBuffer[]} buffers takes those of the arrays, to be handed over
 * @returns {{upper: any, lower: any}} as {@link import('../types.js').Mesh}; `null` for a rigid body
 */
export function decodeFields(bytes, buffers) {
  if (new TextDecoder().decode(bytes.subarray(0, 8)) !== MAGIC) throw new Error('these are no fields');
  const view = new DataView(bytes.buffer, bytes.byteOffset);
  const length = view.getUint32(8, true);
  const { arrays } = JSON.parse(new TextDecoder().decode(bytes.subarray(HEADER, HEADER + length)));
  const fields = /** @type {Record<string, any>} */ ({ upper: null, lower: null });
  for (const entry of /** @type {Entry[]} */ (arrays)) {
    const values = read(bytes, HEADER + length, entry);
    fields[entry.body] ??= {};
    if (entry.name === 'elements') fields[entry.body].triangles = triangles(values);
    else fields[entry.body][entry.name] = values;
  }
  for (const mesh of [fields.upper, fields.lower])
    if (mesh) for (const array of Object.values(mesh)) buffers.push(/** @type {any} */ (array).buffer);
  return /** @type {any} */ (fields);
}

/** @param {Uint8Array} bytes @param {number} base @param {Entry} entry @returns {Float32Array | Uint32Array} a copy of its own */
function read(bytes, base, { type, components, count, offset }) {
  const from = bytes.byteOffset + base + offset;
  const numbers = count * components;
  const width = type === 'f64' ? 8 : 4;
  const part = bytes.buffer.slice(from, from + numbers * width);
  if (type === 'u32') return new Uint32Array(part);
  return type === 'f32' ? new Float32Array(part) : Float32Array.from(new Float64Array(part));
}

/** Each quadrilateral as two triangles. @param {ArrayLike<number>} corners four of each */
export function triangles(corners) {
  const packed = new Uint32Array(1.5 * corners.length);
  for (let k = 0; k < corners.length / 4; k++) {
    const [a, b, c, d] = [corners[4 * k], corners[4 * k + 1], corners[4 * k + 2], corners[4 * k + 3]];
    packed.set([a, b, c, a, c, d], 6 * k);
  }
  return packed;
}
