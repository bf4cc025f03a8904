/** JSON pointers (RFC 6901). */

/** @param {string} pointer */
const parts = (pointer) =>
  pointer
    .split('/')
    .slice(1)
    .map((part) => part.replaceAll('~1', '/').replaceAll('~0', '~'));

/**
 * @param {unknown} document
 * @param {string} pointer
 * @returns {any} what is there; `undefined` if nothing is
 */
export function get(document, pointer) {
  /** @type {any} */
  let place = document;
  for (const part of parts(pointer)) {
    if (place === null || typeof place !== 'object') return undefined;
    place = place[part];
  }
  return place;
}

/**
 * Puts a value in its place, objects on the way included; `undefined` removes it.
 * @param {any} document
 * @param {string} pointer
 * @param {unknown} value
 */
export function set(document, pointer, value) {
  const path = parts(pointer);
  const last = path.pop();
  if (last === undefined) return;
  let place = document;
  for (const part of path) {
    if (place[part] === null || typeof place[part] !== 'object') {
      if (value === undefined) return;
      place[part] = {};
    }
    place = place[part];
  }
  if (value === undefined) delete place[last];
  else place[last] = value;
}

/**
 * @param {unknown} a
 * @param {unknown} b
 * @returns {boolean} whether both are the same JSON, whatever the order of keys
 */
export function same(a, b) {
  if (a === b) return true;
  if (typeof a !== 'object' || typeof b !== 'object' || !a || !b) return false;
  const keys = Object.keys(a);
  return (
    keys.length === Object.keys(b).length &&
    keys.every((key) => same(/** @type {any} */ (a)[key], /** @type {any} */ (b)[key]))
  );
}
