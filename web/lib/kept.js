/** What is kept in this browser, which may be damaged, or of another version of the page. */

/**
 * @template T
 * @param {Storage} storage
 * @param {string} key
 * @param {(value: any) => T | undefined} read what is kept, if it is good
 * @returns {T | undefined}
 */
export function kept(storage, key, read) {
  try {
    return read(JSON.parse(storage.getItem(key) ?? 'null'));
  } catch {
    return undefined;
  }
}

/** @param {unknown} value @returns {value is Record<string, any>} */
export const isObject = (value) => typeof value === 'object' && value !== null && !Array.isArray(value);
