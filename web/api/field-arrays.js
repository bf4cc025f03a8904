/**
 * The binary form of the fields of a step: eight letters, the length of a JSON header (u32), zero (u32), the header, which lists the
 * arrays of both bodies with their places, and the arrays. They are put in their places as they come, so that nothing is held twice.
 */

const MAGIC = 'BRNFLD01';
const HEADER = 16;

/** @typedef {{body: 'upper' | 'lower', name: string, type: 'f32' | 'f64' | 'u32', components: number, count: number, offset: number}} Entry */
/** @typedef {{upper: any, lower: any}} Arrays as {@link import('../types.js').Mesh}; `null` for a rigid body */

/** @param {Entry} entry @returns {number} bytes */
const sizeOf = ({ type, components, count }) => components * count * (type === 'f64' ? 8 : 4);

export class FieldReader {
  /** Bytes of the header so far. @type {number[]} */
  #head = [];
  /** Each array with its bytes so far; nothing until the header is there. @type {{entry: Entry, bytes: Uint8Array<ArrayBuffer>}[] | undefined} */
  #targets;
  /** The target that is being filled. */
  #filling = 0;
  /** Place of the next byte among those of the arrays. */
  #at = 0;

  /** @param {Uint8Array} chunk that comes next */
  push(chunk) {
    if (!this.#targets) return this.#begin(chunk);
    const end = this.#at + chunk.length;
    for (; this.#filling < this.#targets.length; this.#filling++) {
      const { entry, bytes } = this.#targets[this.#filling];
      const [from, to] = [Math.max(entry.offset, this.#at), Math.min(entry.offset + bytes.length, end)];
      if (to > from) bytes.set(chunk.subarray(from - this.#at, to - this.#at), from - entry.offset);
      if (entry.offset + bytes.length > end) break;
    }
    this.#at = end;
  }

  /** @param {Uint8Array} chunk */
  #begin(chunk) {
    const known = this.#head.length;
    // The header is a few kilobytes; a chunk may be more.
    for (let k = 0; k < chunk.length && this.#head.length < this.#headLength(); k++) this.#head.push(chunk[k]);
    if (this.#head.length < this.#headLength()) return;
    const text = new TextDecoder().decode(Uint8Array.from(this.#head.slice(HEADER)));
    const base = this.#head.length;
    const entries = /** @type {Entry[]} */ (JSON.parse(text).arrays);
    this.#targets = entries.map((entry) => ({ entry, bytes: new Uint8Array(sizeOf(entry)) }));
    this.push(chunk.subarray(base - known));
  }

  /** How long the header is, as far as is known. */
  #headLength() {
    if (this.#head.length < HEADER) return HEADER;
    if (String.fromCharCode(...this.#head.slice(0, MAGIC.length)) !== MAGIC) throw new Error('these are no fields');
    return HEADER + new DataView(Uint8Array.from(this.#head.slice(8, 12)).buffer).getUint32(0, true);
  }

  /** @param {ArrayBuffer[]} buffers takes those of the arrays, to be handed over @returns {Arrays} */
  finish(buffers) {
    if (!this.#targets || this.#filling < this.#targets.length) throw new Error('the fields are cut short');
    const fields = /** @type {Arrays} */ ({ upper: null, lower: null });
    for (const { entry, bytes } of this.#targets) {
      const { buffer } = bytes;
      const values =
        entry.type === 'u32'
          ? new Uint32Array(buffer)
          : entry.type === 'f32'
            ? new Float32Array(buffer)
            : Float32Array.from(new Float64Array(buffer));
      fields[entry.body] ??= {};
      fields[entry.body][entry.name] = values;
      buffers.push(/** @type {ArrayBuffer} */ (values.buffer));
    }
    this.#targets = undefined;
    return fields;
  }
}
