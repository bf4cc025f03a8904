/** Keys of the job in messages of the service, as the form calls them. */

import { ELASTIC, LAWS, LOADS, SETTINGS, SHAPES } from './fields.js';

const fields = [
  ...Object.values({ ...SHAPES, ...LAWS }).flatMap((kind) => kind.fields),
  ...ELASTIC,
  ...SETTINGS,
  ...Object.values(LOADS).flatMap(({ field }) => field ?? []),
];
const LABELS = new Map(fields.map(({ key, label }) => [key.slice(key.lastIndexOf('/') + 1), label.toLowerCase()]));

/** @param {string} message in which keys stand between back-quotes */
export const inWords = (message) =>
  message.replace(/`([\w./]+)`/g, (quoted, key) => LABELS.get(key.slice(key.search(/[^./]*$/))) ?? quoted);
