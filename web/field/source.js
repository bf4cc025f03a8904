/** The fields of a job, fetched step by step as they are looked at, of which only so many are kept. */

import { fetchFields, giveBack } from '../api/result.js';

/** @typedef {import('../types.js').Mesh} Mesh */
/** @typedef {{upper: Mesh | null, lower: Mesh | null}} Fields */

/** Most bytes that are kept. */
const KEPT = 24e6;

export class FieldSource {
  /** By step, those that were looked at last at the end. @type {Map<number, Fields>} */
  #kept = new Map();
  /** @type {Map<number, Promise<Fields>>} */
  #coming = new Map();

  /** Step that is looked at, whose fields stay. */
  shown = -1;

  /** @param {string} id of a job */
  constructor(id) {
    this.id = id;
  }

  /** @param {number} step counted from 0 @returns {Fields | undefined} if they are here */
  peek(step) {
    const fields = this.#kept.get(step);
    if (fields) {
      this.#kept.delete(step);
      this.#kept.set(step, fields);
    }
    return fields;
  }

  /**
   * @param {number} step counted from 0
   * @param {(received: number, total: number) => void} [progress] in bytes
   * @returns {Promise<Fields>}
   */
  get(step, progress) {
    const there = this.peek(step);
    if (there) return Promise.resolve(there);
    const coming = this.#coming.get(step) ?? fetchFields(this.id, step, progress);
    this.#coming.set(step, coming);
    return coming.then(
      (fields) => {
        this.#coming.delete(step);
        this.#kept.set(step, fields);
        this.#forget();
        return fields;
      },
      (error) => {
        this.#coming.delete(step);
        throw error;
      },
    );
  }

  /** Whether the fields of so many steps like those of this one can all be kept. @param {number} steps @param {Fields} fields */
  holds(steps, fields) {
    return steps * bytesOf(fields) < KEPT;
  }

  #forget() {
    const newest = [...this.#kept.keys()].at(-1);
    let sum = 0;
    for (const [step, fields] of [...this.#kept].reverse()) {
      sum += bytesOf(fields);
      if (sum <= KEPT || step === newest || step === this.shown) continue;
      this.#kept.delete(step);
      free(fields);
    }
  }

  /** Gives back what is kept, when another job is looked at. */
  close() {
    for (const fields of this.#kept.values()) free(fields);
    this.#kept.clear();
  }
}

/** @param {Fields} fields */
const free = ({ upper, lower }) =>
  giveBack(
    [upper, lower].flatMap((mesh) =>
      Object.values(mesh ?? {}).map(({ buffer }) => /** @type {ArrayBuffer} */ (buffer)),
    ),
  );

/** @param {Fields} fields */
const bytesOf = ({ upper, lower }) =>
  [upper, lower].flatMap((mesh) => (mesh ? Object.values(mesh) : [])).reduce((sum, array) => sum + array.byteLength, 0);
