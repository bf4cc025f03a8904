/**
 * Server-sent events over fetch, because EventSource sends no Authorization header. Reconnects
 * with Last-Event-ID until the stream has ended or the signal says stop.
 */

import { Problem, request } from './client.js';
import { reconnected } from './connection.js';

/** Time [ms] before the stream is requested again. */
const AGAIN = 1000;
/**
 * Time [ms] without a word, of which the service says one every 15 s, after which it counts as
 * gone.
 */
const SILENT = 40_000;

/**
 * @param {string} path
 * @param {(event: string, data: any) => boolean} take one event; true ends the stream
 * @param {AbortSignal} signal
 * @param {(problem: Problem) => Promise<boolean>} failed called when the service refuses the
 *   stream for now; true ends it
 */
export async function follow(path, take, signal, failed) {
  let last = '';
  while (!signal.aborted) {
    let pause = AGAIN;
    try {
      const headers = { Accept: 'text/event-stream', ...(last && { 'Last-Event-ID': last }) };
      const stream = await request(path, { signal, headers }, ({ status, body }) =>
        status === 204 ? null : body,
      );
      if (!stream) return;
      for await (const { id, event, data } of messages(stream)) {
        if (id) last = id;
        if (data && take(event, JSON.parse(data))) return;
      }
    } catch (error) {
      if (signal.aborted) return;
      if (error instanceof Problem) {
        if (!error.passing && error.status < 500) throw error;
        if (error.status !== 0 && (await failed(error))) return;
        pause = 1000 * error.retryAfter;
      }
    }
    await reconnected();
    await new Promise((resolve) => setTimeout(resolve, pause));
  }
}

/** @param {ReadableStream<Uint8Array>} body */
async function* messages(body) {
  const reader = body.pipeThrough(/** @type {any} */ (new TextDecoderStream())).getReader();
  let rest = '';
  try {
    for (;;) {
      const timer = setTimeout(() => reader.cancel(), SILENT);
      const { value, done } = await reader.read().finally(() => clearTimeout(timer));
      if (done) return;
      const blocks = (rest + value).split(/\r?\n\r?\n/);
      rest = blocks.pop() ?? '';
      for (const block of blocks) yield message(block);
    }
  } finally {
    await reader.cancel().catch(() => {});
  }
}

/** @param {string} block */
function message(block) {
  const fields = { id: '', event: 'message', data: '' };
  for (const line of block.split(/\r?\n/)) {
    const [, name, value] = /^(\w+): ?(.*)$/.exec(line) ?? [];
    if (name === 'data') fields.data += (fields.data && '\n') + value;
    else if (name === 'id' || name === 'event') fields[name] = value;
  }
  return fields;
}
