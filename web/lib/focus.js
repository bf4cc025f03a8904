/**
 * A part of the page that is built anew keeps the focus: on what had it, on what stands for it, or
 * on what is in its place.
 */

const FOCUSABLE = 'a[href], button, input, select, textarea, summary, [tabindex]';

/** Whether an element can take the focus: hidden ones cannot. @param {Element} one */
const isShown = (one) => one.checkVisibility({ visibilityProperty: true });

/** @param {Element} root */
const focusables = (root) =>
  /** @type {HTMLElement[]} */ ([...root.querySelectorAll(FOCUSABLE)]).filter(
    (one) => !(/** @type {HTMLInputElement} */ (one).disabled) && isShown(one),
  );

/**
 * Finds the counterpart of an element: of the same field or row, with the same words.
 * @param {HTMLElement} one
 */
function keyOf(one) {
  const part = /** @type {HTMLElement | null} */ (one.closest('[data-place], [data-key]'));
  const words = one.matches('button, summary, a') && !part?.dataset.key ? one.textContent : '';
  // An entry of the form gets a new id when it is built.
  const own = part?.dataset.place ? one.tagName : one.id || one.tagName;
  return [part?.dataset.place, part?.dataset.key, own, one.getAttribute('aria-label'), words].join(
    '|',
  );
}

/**
 * @param {HTMLElement} root
 * @param {() => void} build changes what is in it
 */
export function keepFocus(root, build) {
  const had = document.activeElement;
  if (!(had instanceof HTMLElement) || had === root || !root.contains(had)) return build();
  const before = focusables(root);
  const [at, key] = [before.indexOf(had), keyOf(had)];
  const sameBefore = before.filter((one) => keyOf(one) === key).indexOf(had);
  build();
  if (document.activeElement === had) return;
  if (had.isConnected && isShown(had)) return had.focus({ preventScroll: true });
  const now = focusables(root);
  const alike = now.filter((one) => keyOf(one) === key);
  (
    alike[sameBefore] ??
    alike[0] ??
    inPlaceOf(had, before.slice(0, at), now) ??
    now[Math.min(at, now.length - 1)]
  )?.focus({
    preventScroll: true,
  });
}

/**
 * For a field that is gone: the last button before it that is still there. In another field the
 * next key would change another figure.
 * @param {HTMLElement} had
 * @param {HTMLElement[]} before those before it
 * @param {HTMLElement[]} now
 */
function inPlaceOf(had, before, now) {
  if (!had.closest('[data-place]')) return undefined;
  const keys = new Map(now.filter((one) => one.matches('button')).map((one) => [keyOf(one), one]));
  const left = before.findLast((one) => keys.has(keyOf(one)));
  return left && keys.get(keyOf(left));
}
