/** A value as the text of a field. */

/** @param {unknown} value of a field of text, which may be anything where the job was not written here */
export const written = (value) =>
  value == null ? '' : typeof value === 'object' ? JSON.stringify(value) : String(value);
