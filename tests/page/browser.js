/** The real server on a free port and a real Chromium before it. */

import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { existsSync } from 'node:fs';
import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { createInterface } from 'node:readline';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';

const ROOT = join(dirname(fileURLToPath(import.meta.url)), '../..');
const QUIET = [
  '--no-sandbox',
  '--disable-background-networking',
  '--no-first-run',
  '--disable-component-update',
  '--disable-sync',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
];

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
  const binary = found('the program', [process.env.BRINELL_BIN, join(ROOT, 'target/debug/brinell')], 'cargo build');
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

/** @returns {Promise<import('playwright-core').Browser>} */
export function launch() {
  const executablePath = found(
    'Chromium',
    [process.env.CHROMIUM, '/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'],
    'apt-get install chromium',
  );
  return chromium.launch({ executablePath, headless: true, args: QUIET });
}

/**
 * A fresh page at the service that notes everything it should not do.
 * @param {import('playwright-core').Browser} browser
 * @param {string} url
 * @param {import('playwright-core').BrowserContextOptions} [options]
 */
export async function visit(browser, url, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, ...options });
  const page = await context.newPage();
  const faults = /** @type {string[]} */ ([]);
  page.on('console', (message) => {
    // A refused draft is answered 422, which Chromium notes by itself.
    const answered = /status of 4\d\d/.test(message.text());
    if (['error', 'warning'].includes(message.type()) && !answered) faults.push(`console: ${message.text()}`);
  });
  page.on('pageerror', (error) => faults.push(`uncaught: ${error.stack ?? error}`));
  page.on('request', (request) => {
    if (!request.url().startsWith(url) && !request.url().startsWith('blob:'))
      faults.push(`asked elsewhere: ${request.url()}`);
  });
  await page.goto(url);
  return { page, faults, close: () => context.close() };
}
