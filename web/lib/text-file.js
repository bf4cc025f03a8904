/** Text of a file that a spreadsheet or an instrument has written. */

/** Most that is read [bytes]: ten thousand lines are far less. */
const MOST = 4e6;

/**
 * UTF-8, UTF-16 where it begins as such, or else Windows-1252, in which spreadsheets write CSV.
 * @param {File} file
 * @param {number} [most] bytes
 * @returns {Promise<{text: string} | {problem: string}>}
 */
export async function textOf(file, most = MOST) {
  if (file.size > most) return { problem: `“${file.name}” is too large for a table of points` };
  const bytes = new Uint8Array(await file.arrayBuffer());
  const text = decoded(bytes);
  return text.includes('\0')
    ? { problem: `“${file.name}” is no text: save the table as CSV` }
    : { text };
}

/** @param {Uint8Array} bytes */
function decoded(bytes) {
  const mark =
    bytes[0] === 0xff && bytes[1] === 0xfe
      ? 'utf-16le'
      : bytes[0] === 0xfe && bytes[1] === 0xff
        ? 'utf-16be'
        : '';
  if (mark) return new TextDecoder(mark).decode(bytes);
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    return new TextDecoder('windows-1252').decode(bytes);
  }
}
