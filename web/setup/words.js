/** Keys of the job in messages of the service, as the form calls them. */

import { allFields } from './fields.js';

const PLAIN = ['analysis', 'units', 'support', 'theory', 'shape', 'material', 'load'];
const LABELS = new Map([
  ...PLAIN.map((key) => /** @type {[string, string]} */ ([key, key])),
  ['law', 'hardening'],
  ['type', 'shape'],
  ...allFields().map(
    ({ key, label }) => /** @type {[string, string]} */ ([key.slice(key.lastIndexOf('/') + 1), label.toLowerCase()]),
  ),
]);

/** @param {string} words */
const titled = (words) => `“${words[0].toUpperCase()}${words.slice(1)}”`;

/** What a key in back-quotes is called: a setting by the name under which it is looked for. @param {string} quoted @param {string} key */
function called(quoted, key) {
  const name = LABELS.get(key.slice(key.search(/[^./]*$/)));
  return name && /^(solver|mesh)\./.test(key) ? titled(name) : (name ?? quoted);
}

/** @param {string} message in which keys stand between back-quotes */
export const inWords = (message) =>
  message
    // Behind the words that it means, a key says nothing more.
    .replace(/ \(`[\w./]+`\)/g, '')
    .replace(/\b(the )?theory `flow`/g, 'flow theory')
    .replace(/\bsee `(\w+)`/g, (_, code) => `see the remark ${titled(code.replaceAll('_', ' '))}`)
    .replace(/`([\w./]+)`/g, called);
