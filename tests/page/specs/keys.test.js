/**
 * API keys: none, wrong ones, one that is revoked while somebody works, one that may only read.
 */

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { suite } from '../browser.js';

/** @typedef {import('playwright-core').Page} Page */
/** @typedef {import('../browser.js').Server} Server */

const service = suite();
const FORCE = '[data-place="/load/force"] input[type=text]';
const WANTED = { own: ['--require-api-key'], amiss: true };

/** @param {Server} server @param {...string} words */
const key = ({ binary, data }, ...words) =>
  execFileSync(binary, ['key', ...words, '--data-dir', data], {
    encoding: 'utf8',
    env: { ...process.env, BRINELL_LOG: 'error' },
  });

/** @param {Server} server @param {string} name @param {string} [scope] @returns {string} its token */
const made = (server, name, scope = 'write') =>
  /brn\S+|[\w.-]{30,}/.exec(key(server, 'create', '--scope', scope, name))?.[0] ?? '';

/** @param {Page} page @param {string} token */
async function give(page, token) {
  await page.getByLabel('Key', { exact: true }).fill(token);
  // The page is loaded anew; until then the one before is there.
  const loaded = page.waitForEvent('load');
  await page.getByRole('button', { name: 'Use key' }).click();
  await loaded;
}

service.test(
  'a key that is revoked while somebody works is asked for anew, and what was set up stays',
  async (page, { server }) => {
    await give(page, made(server, 'first'));
    await page.getByText('1500.0 MPa').waitFor();
    await page.getByRole('button', { name: 'Solve', exact: true }).click();
    await page.locator('[data-status=succeeded]').waitFor();
    const [id] = /^[0-9a-f-]{36}/m.exec(key(server, 'list')) ?? [''];
    key(server, 'revoke', id);
    // The service may know the key for a while.
    await page.waitForFunction(async () => {
      const headers = { Authorization: `Bearer ${sessionStorage.getItem('api-key')}` };
      return (await fetch('v1/jobs', { headers })).status === 401;
    });
    await page.locator(FORCE).fill('501');
    const dialog = page.getByRole('dialog');
    await dialog.getByText('The service does not know this key').waitFor();
    await page.keyboard.press('Escape');
    await page.getByRole('button', { name: 'Solve', exact: true }).click();
    await page.getByText('The service does not know this API key, or no longer.').waitFor();
    await page.getByRole('button', { name: 'API key' }).click();
    await give(page, made(server, 'second'));
    await page.getByText('This link leads to a job that is not here').waitFor();
    assert.equal(await page.locator(FORCE).inputValue(), '501');
    await page.getByRole('button', { name: 'Solve', exact: true }).click();
    await page.locator('#headline').getByText('501.00').waitFor();
  },
  WANTED,
);

service.test(
  'a key that may only read is said to be one, and can be changed for another',
  async (page, { server }) => {
    await give(page, made(server, 'reader', 'read'));
    await page.locator(FORCE).waitFor();
    await page.getByRole('button', { name: 'Solve', exact: true }).click();
    await page.getByText('this API key may only read').waitFor();
    await page.getByRole('button', { name: 'API key' }).click();
    await give(page, made(server, 'writer'));
    await page.getByText('1500.0 MPa').waitFor();
    await page.getByRole('button', { name: 'Solve', exact: true }).click();
    await page.locator('[data-status=succeeded]').waitFor();
  },
  WANTED,
);

service.test(
  'a key that cannot be one is told in the dialogue, and what came along unseen is left out',
  async (page, { server }) => {
    const dialog = page.getByRole('dialog');
    await dialog.waitFor();
    await page.getByLabel('Key', { exact: true }).fill('ключ');
    await page.getByRole('button', { name: 'Use key' }).click();
    await dialog.getByText('This is no key').waitFor();
    await give(page, `\u200b${made(server, 'first')} `);
    await page.getByText('1500.0 MPa').waitFor();
  },
  WANTED,
);

service.test(
  'who gives no key is told so on the page, and has the focus on it',
  async (page) => {
    const dialog = page.getByRole('dialog');
    await dialog.waitFor();
    await page.keyboard.press('Escape');
    await dialog.waitFor({ state: 'hidden' });
    await page.waitForFunction(() => document.activeElement !== document.body);
    await page.locator('#check').getByText('The service asks for an API key.').waitFor();
  },
  WANTED,
);
