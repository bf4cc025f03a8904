/** Fetches results and fields, packs mesh fields into typed arrays and hands them over without copying. */

import { decodeFields, triangles } from './field-arrays.js';

/** Nodal fields that are shown. */
const SCALARS = ['von_mises', 'equivalent_plastic_strain', 'sigma_x', 'sigma_y', 'sigma_z', 'tau_xy'];
/** Bytes between two reports of how far it is. */
const REPORTED = 1 << 20;

const running = /** @type {Map<number, AbortController>} */ (new Map());

self.addEventListener('message', async ({ data: { number, url, options, abort } }) => {
  if (abort) return running.get(number)?.abort();
  const controller = new AbortController();
  running.set(number, controller);
  try {
    const response = await fetch(url, { ...options, signal: controller.signal });
    const bytes = await received(response, number);
    // 202: it takes longer than one waits, and goes on as a job.
    if (response.status === 202) return self.postMessage({ number, status: 202, problem: {} });
    if (!response.ok) return self.postMessage({ number, status: response.status, problem: problemOf(bytes) });
    const buffers = /** @type {ArrayBuffer[]} */ ([]);
    const answer = /^application\/json/.test(response.headers.get('content-type') ?? '')
      ? report(bytes, buffers)
      : decodeFields(bytes, buffers);
    /** @type {any} */ (self).postMessage({ number, answer }, buffers);
  } catch (error) {
    self.postMessage({ number, status: 0, problem: {}, aborted: controller.signal.aborted, error: String(error) });
  } finally {
    running.delete(number);
  }
});

/** The body of an answer, of which is told as it comes. @param {Response} response @param {number} number @returns {Promise<Uint8Array>} */
async function received(response, number) {
  const total = Number(response.headers.get('content-length') ?? 0);
  const reader = response.body?.getReader();
  const parts = /** @type {Uint8Array[]} */ ([]);
  let [length, told] = [0, 0];
  while (reader) {
    const { value, done } = await reader.read();
    if (done) break;
    parts.push(value);
    length += value.length;
    if (length - told > REPORTED) {
      told = length;
      self.postMessage({ number, received: length, total });
    }
  }
  if (parts.length === 1) return parts[0];
  const bytes = new Uint8Array(length);
  let at = 0;
  for (const part of parts) {
    bytes.set(part, at);
    at += part.length;
  }
  return bytes;
}

/** @param {Uint8Array} bytes */
function problemOf(bytes) {
  try {
    return JSON.parse(new TextDecoder().decode(bytes));
  } catch {
    return {};
  }
}

/** @param {Uint8Array} bytes @param {ArrayBuffer[]} buffers */
function report(bytes, buffers) {
  const answer = JSON.parse(new TextDecoder().decode(bytes));
  // A solve answers with its job, which has the result inside.
  const parsed = answer.result ?? answer;
  for (const step of parsed.steps ?? []) {
    for (const side of ['upper', 'lower']) {
      if (step.fields?.[side]) step.fields[side] = pack(step.fields[side], buffers);
    }
  }
  return parsed;
}

/** @param {any} field @param {ArrayBuffer[]} buffers */
function pack(field, buffers) {
  const packed = /** @type {Record<string, any>} */ ({
    nodes: pairs(field.nodes),
    displacement: pairs(field.displacement),
    triangles: triangles(field.elements.flat()),
  });
  for (const name of SCALARS) packed[name] = Float32Array.from(field[name]);
  for (const array of Object.values(packed)) buffers.push(array.buffer);
  return packed;
}

/** @param {[number, number][]} list */
function pairs(list) {
  const packed = new Float32Array(2 * list.length);
  for (let k = 0; k < list.length; k++) {
    packed[2 * k] = list[k][0];
    packed[2 * k + 1] = list[k][1];
  }
  return packed;
}
