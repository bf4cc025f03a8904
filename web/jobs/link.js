/**
 * What the address says: `#job=ID` shows a job of this service, `&with=ID,ID` lays others over it,
 * `#draft=…` carries a definition (deflated, base64url), which works on any service.
 */

/** What may be the id of a job; it becomes part of addresses. */
const ID = /^[\w-]{1,64}$/;

/**
 * @returns {{job?: string, compared: string[], draft?: string, damaged: boolean}} `damaged`: it
 *   names a job by what is no id
 */
export function read() {
  const fragment = new URLSearchParams(location.hash.slice(1));
  const job = fragment.get('job') ?? undefined;
  const damaged = job !== undefined && !ID.test(job);
  return {
    damaged,
    job: damaged ? undefined : job,
    compared:
      fragment
        .get('with')
        ?.split(',')
        .filter((id) => ID.test(id)) ?? [],
    draft: fragment.get('draft') ?? undefined,
  };
}

/** The address of the page for people: the one that the service is told, or else that of the browser. */
const address = () =>
  /** @type {HTMLLinkElement | null} */ (document.querySelector('link[rel=canonical]'))?.href ??
  document.baseURI.replace(/#.*/, '');

/** Where what is shown is found. @returns {string} */
export const here = () => new URL(location.hash, address()).href;

/** @param {string} id @param {string[]} [compared] jobs laid over it @returns {string} */
export const jobFragment = (id, compared = []) =>
  `#job=${id}${compared.length ? `&with=${compared.join(',')}` : ''}`;

/**
 * The link to what is shown: job and those compared with it. A title says to people what it is.
 * @param {string} title
 */
export function jobLink(title) {
  const words = title.trim().replace(/\s+/g, '-');
  const link = here().replace(/&title=[^&]*/, '');
  return words ? `${link}&title=${encodeURIComponent(words)}` : link;
}

/** @param {unknown} job @returns {Promise<string>} */
export async function draftLink(job) {
  const bytes = await through(
    new TextEncoder().encode(JSON.stringify(job)),
    new CompressionStream('deflate-raw'),
  );
  const text = btoa(String.fromCharCode(...bytes))
    .replaceAll('+', '-')
    .replaceAll('/', '_')
    .replaceAll('=', '');
  return new URL(`#draft=${text}`, address()).href;
}

/** @param {string} text @returns {Promise<any>} */
export async function unpack(text) {
  const plain = atob(text.replaceAll('-', '+').replaceAll('_', '/'));
  const bytes = await through(
    Uint8Array.from(plain, (letter) => letter.charCodeAt(0)),
    new DecompressionStream('deflate-raw'),
  );
  return JSON.parse(new TextDecoder().decode(bytes));
}

/**
 * @param {Uint8Array<ArrayBuffer>} bytes
 * @param {CompressionStream | DecompressionStream} stream
 */
const through = async (bytes, stream) =>
  new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
