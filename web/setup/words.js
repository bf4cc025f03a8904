/** Keys of the job in messages of the service, as the form calls them. */

import { allFields } from './fields.js';

/** Keys of the job, as the form calls them. */
const LABELS = new Map([
  ...['analysis', 'units', 'support', 'theory', 'shape', 'material', 'load'].map((key) => [key, key]),
  ['law', 'hardening'],
  ['type', 'shape'],
  ...allFields().map(({ key, label }) => [key.slice(key.lastIndexOf('/') + 1), label.toLowerCase()]),
]);

/** @param {string} message in which keys stand between back-quotes */
export const inWords = (message) =>
  message.replace(/`([\w./]+)`/g, (quoted, key) => LABELS.get(key.slice(key.search(/[^./]*$/))) ?? quoted);
