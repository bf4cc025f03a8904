/** The real server on a free port and a real Chromium before it. */

import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { existsSync } from 'node:fs';
import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { createInterface } from 'node:readline';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';

const ROOT = join(dirname(fileURLToPath(import.meta.url)), '../..');
export const flags = [
  '--no-sandbox',
  '--disable-background-networking',
  '--no-first-run',
  '--disable-component-update',
  '--disable-sync',
  // Without a graphics card the page is put together faster by the processor than by a card that
  // it plays.
  '--disable-gpu-compositing',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
];

/**
 * How long [ms] a step of a test may take, and how many such times the whole test: more on a slow
 * or busy machine.
 */
const PATIENCE = 1000 * Number(process.env.BRINELL_PAGE_PATIENCE ?? 60);
const STEPS = 5;

export const WIDE = { viewport: { width: 1440, height: 900 } };
export const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

/** The first of these that is there. @param {string} what @param {(string | undefined)[]} paths @param {string} help */
function found(what, paths, help) {
  const path = paths.find((one) => one && existsSync(one));
  if (!path) throw new Error(`${what} is missing: ${help}`);
  return path;
}

/**
 * `brinell serve` with a data directory of its own.
 * @param {string[]} [args]
 */
export async function serve(args = []) {
  const binary = found(
    'the program',
    [process.env.BRINELL_BIN, join(ROOT, 'target/debug/brinell')],
    'cargo build',
  );
  const data = await mkdtemp(join(tmpdir(), 'brinell-page-'));
  /** @param {string} address @returns {Promise<[import('node:child_process').ChildProcess, string]>} the process, and where it listens */
  const start = async (address) => {
    const child = spawn(binary, ['serve', '--listen', address, '--data-dir', data, ...args], {
      stdio: ['ignore', 'pipe', 'inherit'],
      env: { ...process.env, BRINELL_LOG: 'error' },
    });
    const [line] = await once(createInterface({ input: child.stdout }), 'line');
    return [child, /** @type {string} */ (line).replace('brinell listening on ', '')];
  };
  let [child, url] = await start('127.0.0.1:0');
  const kill = async () => {
    // One that has ended says so no second time.
    if (child.exitCode !== null || child.signalCode !== null) return;
    const ended = once(child, 'exit');
    child.kill('SIGKILL');
    await ended;
  };
  /** After {@link kill}: the same data at the same address. */
  const again = async () => {
    [child] = await start(url.replace(/^http:\/\//, ''));
  };
  const stop = async () => {
    await kill();
    await rm(data, { recursive: true });
  };
  return { url, binary, data, kill, again, stop };
}

export const chromiumPath = () =>
  found(
    'Chromium',
    [
      process.env.CHROMIUM,
      '/usr/bin/chromium',
      '/usr/bin/chromium-browser',
      '/usr/bin/google-chrome',
    ],
    'apt-get install chromium',
  );

/** @returns {Promise<import('playwright-core').Browser>} */
export const launch = () =>
  chromium.launch({ executablePath: chromiumPath(), headless: true, args: flags });

/**
 * A fresh page at the service that notes everything it should not do.
 * @param {import('playwright-core').Browser} browser
 * @param {string} url
 * @param {import('playwright-core').BrowserContextOptions & {few?: boolean}} [options] `few`: with
 *   the fields of a door and three panels, as a stranger has them
 */
export async function visit(browser, url, { few = false, ...options } = {}) {
  const context = await browser.newContext({ ...WIDE, ...options });
  context.setDefaultTimeout(PATIENCE);
  // Who tests them has every field and every panel; a stranger has those of a door, and three.
  if (!few)
    await context.addInitScript(() => {
      try {
        for (const part of ['form-whole', 'panels-more']) localStorage.setItem(part, 'true');
      } catch {
        // A browser that keeps nothing.
      }
    });
  const page = await context.newPage();
  const faults = /** @type {string[]} */ ([]);
  page.on('console', (message) => {
    // A refused draft is answered 422, which Chromium notes by itself.
    const answered = /status of 4\d\d/.test(message.text());
    // Without a graphics card pictures are read back, of which it complains.
    const readBack = /GL Driver Message/.test(message.text());
    if (['error', 'warning'].includes(message.type()) && !answered && !readBack)
      faults.push(`console: ${message.text()}`);
  });
  page.on('pageerror', (error) => faults.push(`uncaught: ${error.stack ?? error}`));
  page.on('request', (request) => {
    if (!request.url().startsWith(new URL(url).origin) && !request.url().startsWith('blob:'))
      faults.push(`asked elsewhere: ${request.url()}`);
  });
  await page.goto(url);
  return { page, faults, close: () => context.close() };
}

/** @typedef {Awaited<ReturnType<typeof serve>>} Server */
/**
 * @typedef {object} About a test
 * @property {string[]} [own] arguments of a service of its own
 * @property {string} [hash] where the page begins
 * @property {boolean} [few] whether there are few fields and panels, as for a stranger
 * @property {boolean} [amiss] whether something goes wrong that the browser notes; the first example may not be there
 */

/**
 * A service and a browser for the tests of a file.
 * @param {string[]} [args] of the service
 */
export function suite(args) {
  /** @type {Server} */
  let shared;
  /** @type {import('playwright-core').Browser} */
  let browser;
  before(async () => {
    [shared, browser] = await Promise.all([serve(args), launch()]);
  });
  after(async () => {
    await browser?.close();
    await shared?.stop();
  });
  return {
    get url() {
      return shared.url;
    },
    /** Another visitor. @param {string} url @param {import('playwright-core').BrowserContextOptions} [options] */
    visit: (url, options) => visit(browser, url, options),
    /**
     * A test on a fresh page that shows the first example, and at which nothing else goes wrong
     * than what is looked for.
     * @param {string} name
     * @param {(page: import('playwright-core').Page, with_: {server: Server, note: (text: string) => void}) => Promise<void>} work
     * @param {About & import('playwright-core').BrowserContextOptions} [about]
     */
    test: (name, work, { own, hash = '', amiss = false, ...options } = {}) =>
      test(name, { timeout: STEPS * PATIENCE }, async (context) => {
        const server = own ? await serve(own) : shared;
        const { page, faults, close } = await visit(browser, `${server.url}/${hash}`, options);
        try {
          if (!amiss) await page.getByText('1500.0 MPa').waitFor();
          await work(page, { server, note: (text) => context.diagnostic(text) });
          if (!amiss) assert.deepEqual(faults, []);
        } finally {
          await close();
          if (own) await server.stop();
        }
      }),
  };
}
