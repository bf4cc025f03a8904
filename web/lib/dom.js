/** Construction of elements without strings of HTML. */

/** @typedef {Node | string | number | null | undefined | false} Child */

/**
 * An element: `on…` properties are listeners, booleans are present or absent, the rest are
 * attributes.
 * @template {keyof HTMLElementTagNameMap} K
 * @param {K} name
 * @param {Record<string, any>} [properties]
 * @param {...(Child | Child[])} children
 * @returns {HTMLElementTagNameMap[K]}
 */
export function h(name, properties = {}, ...children) {
  return fill(document.createElement(name), properties, children);
}

/**
 * @param {string} text
 * @param {() => unknown} onclick
 * @param {Record<string, any>} [properties]
 */
export const button = (text, onclick, properties = {}) =>
  h('button', { type: 'button', onclick, ...properties }, text);

/** A button without a frame. @param {string} text @param {() => unknown} onclick @param {Record<string, any>} [properties] */
export const plainButton = (text, onclick, properties = {}) =>
  button(text, onclick, { class: 'plain', ...properties });

/**
 * Makes an element of SVG.
 * @template {keyof SVGElementTagNameMap} K
 * @param {K} name
 * @param {Record<string, any>} [properties]
 * @param {...(Child | Child[])} children
 * @returns {SVGElementTagNameMap[K]}
 */
export function svg(name, properties = {}, ...children) {
  return fill(document.createElementNS('http://www.w3.org/2000/svg', name), properties, children);
}

/**
 * @template {Element} E
 * @param {E} element
 * @param {Record<string, any>} properties
 * @param {(Child | Child[])[]} children
 * @returns {E}
 */
function fill(element, properties, children) {
  for (const [key, value] of Object.entries(properties)) {
    if (key.startsWith('on')) element.addEventListener(key.slice(2), value);
    else if (value === true) element.setAttribute(key, '');
    else if (value !== false && value != null) element.setAttribute(key, String(value));
  }
  element.append(
    .../** @type {(Node | string)[]} */ (
      children
        .flat()
        .filter((child) => child != null && child !== false)
        .map((child) => (typeof child === 'number' ? String(child) : child))
    ),
  );
  return element;
}

/**
 * Gives an element these children. Those that it has already stay where they are, with the focus
 * and with what the browser knows of what is being typed into them.
 * @param {Element} parent
 * @param {(Node | null | undefined | false)[]} children
 */
export function arrange(parent, children) {
  const wanted = children.filter((child) => child instanceof Node);
  for (const child of [...parent.childNodes]) if (!wanted.includes(child)) child.remove();
  wanted.forEach((child, k) => {
    const there = parent.childNodes[k];
    if (there !== child) parent.insertBefore(child, there ?? null);
  });
}

let count = 0;

/** An identifier that no other element has. @param {string} kind */
export const uniqueId = (kind) => `${kind}-${++count}`;

/**
 * The element of this id, which the page has.
 * @template {HTMLElement} [E=HTMLElement]
 * @param {string} id
 * @returns {E}
 */
export function byId(id) {
  const element = document.getElementById(id);
  if (!element) throw new Error(`the page has no #${id}`);
  return /** @type {E} */ (element);
}

/**
 * @template {unknown[]} A
 * @param {(...args: A) => void} work
 * @param {number} delay ms of quiet before it is done
 */
export function debounce(work, delay) {
  let timer = /** @type {ReturnType<typeof setTimeout> | undefined} */ (undefined);
  return (/** @type {A} */ ...args) => {
    clearTimeout(timer);
    timer = setTimeout(() => work(...args), delay);
  };
}

/** @param {string} text shown for a moment and read out */
export function toast(text) {
  const place = byId('toast');
  place.textContent = text;
  place.classList.add('shown');
  fade(place);
}
const fade = debounce((/** @type {HTMLElement} */ place) => place.classList.remove('shown'), 3000);

/**
 * Puts a text on the clipboard, also where the page does not come by https and browsers keep
 * theirs shut.
 * @param {string} text
 * @param {string} name of it
 */
export async function copy(text, name) {
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    const place = h('textarea', { class: 'visually-hidden' });
    place.value = text;
    document.body.append(place);
    place.select();
    document.execCommand('copy');
    place.remove();
  }
  toast(`${name} copied`);
}

/** @param {HTMLCanvasElement | null} canvas @returns {Promise<Blob | null>} a picture of it */
export const pngOf = (canvas) =>
  canvas ? new Promise((resolve) => canvas.toBlob(resolve)) : Promise.resolve(null);
