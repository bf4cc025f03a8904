/**
 * What is kept in this browser, which may be damaged, or of another version of the page. A browser
 * that keeps nothing, because its storage is full or blocked, is a page without memory: everything
 * works until it is closed.
 */

/**
 * @typedef {{get: (key: string) => string | null, set: (key: string, value: string) => boolean,
 *   remove: (key: string) => void}} Store `set` answers whether it is kept
 */

const listeners = /** @type {Set<(keeps: boolean) => void>} */ (new Set());

/**
 * @param {(keeps: boolean) => void} listener called with whether the browser keeps what it is
 *   given
 */
export const onKept = (listener) => listeners.add(listener);

/** @param {() => Storage} storage which may throw @returns {Store} */
function store(storage) {
  /** Values that the browser did not store. @type {Map<string, string>} */
  const memory = new Map();
  return {
    get: (key) => memory.get(key) ?? attempt(() => storage().getItem(key)) ?? null,
    set: (key, value) => {
      const keeps = attempt(() => (storage().setItem(key, value), true)) ?? false;
      if (keeps) memory.delete(key);
      else memory.set(key, value);
      for (const listener of listeners) listener(keeps);
      return keeps;
    },
    remove: (key) => {
      memory.delete(key);
      attempt(() => storage().removeItem(key));
    },
  };
}

/** @template T @param {() => T} work @returns {T | undefined} nothing if it throws */
function attempt(work) {
  try {
    return work();
  } catch {
    return undefined;
  }
}

/** Stored until removed, for all tabs. */
export const browser = store(() => localStorage);
/** Stored until the tab is closed. */
export const tab = store(() => sessionStorage);

/**
 * @template T
 * @param {Store} place
 * @param {string} key
 * @param {(value: any) => T | undefined} read what is kept, if it is good
 * @returns {T | undefined}
 */
export const kept = (place, key, read) =>
  attempt(() => read(JSON.parse(place.get(key) ?? 'null')));

/** @param {unknown} value @returns {value is Record<string, any>} */
export const isObject = (value) =>
  typeof value === 'object' && value !== null && !Array.isArray(value);
