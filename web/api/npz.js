/**
 * Reads the archives that the service sends fields in: `.npz`, a zip of arrays of numpy that are
 * not compressed.
 */

/**
 * @typedef {{upper: any, lower: any}} Arrays as {@link import('../types.js').Mesh}; `null` for a
 *   rigid body
 */

/** Nodal fields that are shown. @type {import('../types.js').Scalar[]} */
export const SCALARS = [
  'von_mises',
  'equivalent_plastic_strain',
  'sigma_x',
  'sigma_y',
  'sigma_z',
  'tau_xy',
];

const END = 0x06054b50;
const END_BYTES = 22;
const ENTRY_BYTES = 46;
const LOCAL_BYTES = 30;
/** Types of numbers that the service sends, and in which heights are kept. */
const KINDS = /** @type {Record<string, any>} */ ({
  '<f4': Float32Array,
  '<u4': Uint32Array,
  '<f8': Float64Array,
  '<i4': Int32Array,
  '<i2': Int16Array,
  '<u2': Uint16Array,
  '|u1': Uint8Array,
});

/**
 * Lists the files of an archive: names and offsets.
 * @param {DataView} view
 * @returns {{name: string, at: number, size: number}[]}
 */
function files(view) {
  // The service writes no comment behind the end.
  const end = view.byteLength - END_BYTES;
  if (end < 0 || view.getUint32(end, true) !== END)
    throw new Error('the fields are cut short, or these are none');
  const count = view.getUint16(end + 10, true);
  let at = view.getUint32(end + 16, true);
  return Array.from({ length: count }, () => {
    const [size, length] = [view.getUint32(at + 24, true), view.getUint16(at + 28, true)];
    const local = view.getUint32(at + 42, true);
    const name = new TextDecoder().decode(new Uint8Array(view.buffer, at + ENTRY_BYTES, length));
    at += ENTRY_BYTES + length + view.getUint16(at + 30, true) + view.getUint16(at + 32, true);
    const data =
      local + LOCAL_BYTES + view.getUint16(local + 26, true) + view.getUint16(local + 28, true);
    return { name, at: data, size };
  });
}

/**
 * Returns the numbers of a file, in memory of their own.
 * @param {DataView<ArrayBuffer>} view
 * @param {number} at
 * @param {number} size
 */
function numbers(view, at, size) {
  const data = at + 10 + view.getUint16(at + 8, true);
  const header = new TextDecoder().decode(new Uint8Array(view.buffer, at + 10, data - at - 10));
  const kind = KINDS[/'descr': '([^']*)'/.exec(header)?.[1] ?? ''];
  if (!kind) throw new Error(`numbers of another type: ${header}`);
  return new kind(view.buffer.slice(data, at + size));
}

/** @param {ArrayBuffer} file `.npy` of a grid @returns {number[][]} its rows */
export function readGrid(file) {
  const view = new DataView(file);
  if (file.byteLength < 12 || view.getUint32(0) !== 0x934e554d || view.getUint8(6) !== 1)
    throw new Error('this is no array of NumPy');
  const header = new TextDecoder().decode(new Uint8Array(file, 10, view.getUint16(8, true)));
  const shape = /'shape': \((\d+), (\d+)\)/.exec(header);
  if (!shape) throw new Error('heights are an array of two dimensions');
  const [rows, columns] = [Number(shape[1]), Number(shape[2])];
  const values = numbers(view, 0, file.byteLength);
  if (values.length !== rows * columns) throw new Error('the array is cut short');
  const [i, j] = /'fortran_order': True/.test(header) ? [1, rows] : [columns, 1];
  return Array.from({ length: rows }, (_, x) =>
    Array.from({ length: columns }, (_, y) => values[x * i + y * j]),
  );
}

/**
 * @param {ArrayBuffer} archive
 * @param {ArrayBuffer[]} buffers takes those of the arrays, to be handed over
 * @returns {Arrays}
 */
export function readFields(archive, buffers) {
  const view = new DataView(archive);
  const fields = /** @type {Arrays} */ ({ upper: null, lower: null });
  for (const { name, at, size } of files(view)) {
    const [body, array] = name.replace(/\.npy$/, '').split('/');
    const values = numbers(view, at, size);
    (fields[/** @type {'upper' | 'lower'} */ (body)] ??= {})[array] = values;
    buffers.push(/** @type {ArrayBuffer} */ (values.buffer));
  }
  return fields;
}
