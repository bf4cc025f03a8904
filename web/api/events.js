/**
 * Server-sent events over fetch, because EventSource sends no Authorization header. Comes back with Last-Event-ID
 * until the stream has ended or the signal says stop.
 */

import { Problem, request } from './client.js';

const AGAIN = 1000;

/**
 * @param {string} path
 * @param {(event: string, data: any) => boolean} take one event; true ends the stream
 * @param {AbortSignal} signal
 */
export async function follow(path, take, signal) {
  let last = '';
  while (!signal.aborted) {
    try {
      const response = await request(path, {
        signal,
        headers: { Accept: 'text/event-stream', ...(last && { 'Last-Event-ID': last }) },
      });
      if (response.status === 204 || !response.body) return;
      for await (const { id, event, data } of messages(response.body)) {
        if (id) last = id;
        if (data && take(event, JSON.parse(data))) return;
      }
    } catch (error) {
      if (signal.aborted) return;
      if (error instanceof Problem && error.status >= 400 && error.status < 500) throw error;
    }
    await new Promise((resolve) => setTimeout(resolve, AGAIN));
  }
}

/** @param {ReadableStream<Uint8Array>} body */
async function* messages(body) {
  const reader = body.pipeThrough(/** @type {any} */ (new TextDecoderStream())).getReader();
  let rest = '';
  try {
    for (;;) {
      const { value, done } = await reader.read();
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
