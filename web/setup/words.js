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

/** @param {string} message in which keys stand between back-quotes */
export const inWords = (message) =>
  message.replace(/`([\w./]+)`/g, (quoted, key) => LABELS.get(key.slice(key.search(/[^./]*$/))) ?? quoted);
