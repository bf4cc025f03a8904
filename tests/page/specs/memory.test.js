/**
 * What the browser keeps: nothing, where its storage is full or blocked; materials of one's own.
 */

import assert from 'node:assert/strict';
import { suite } from '../browser.js';
import { draft } from '../jobs.js';

const service = suite();

/** @typedef {import('playwright-core').Page} Page */

/** @param {Page} page @param {() => void} change of the browser */
async function changed(page, change) {
  await page.addInitScript(change);
  await page.reload();
  await page.getByText('1500.0 MPa').waitFor();
}

/** @param {Page} page @param {string} name */
async function keepAs(page, name) {
  // A browser that stores nothing begins with the fields of a door.
  const more = page.getByRole('button', { name: 'More: all fields' });
  if (await more.isVisible()) await more.click();
  await page.getByRole('button', { name: 'Keep as own…' }).first().click();
  await page.getByRole('dialog').getByLabel('Name', { exact: true }).fill(name);
  await page.getByRole('dialog').getByRole('button', { name: 'Keep', exact: true }).click();
}

const FULL = () => {
  Storage.prototype.setItem = () => {
    throw new DOMException('full', 'QuotaExceededError');
  };
};
const BLOCKED = () => {
  for (const name of ['localStorage', 'sessionStorage'])
    Object.defineProperty(window, name, {
      get: () => {
        throw new DOMException('blocked', 'SecurityError');
      },
    });
};

for (const [name, change] of /** @type {const} */ ([
  ['full', FULL],
  ['blocked', BLOCKED],
]))
  service.test(
    `a browser whose storage is ${name} is a page without memory, which says so`,
    async (page) => {
      await changed(page, change);
      await page.getByText('This browser stores nothing more for this page').waitFor();
      await page.locator('#theme').click();
      assert.equal(await page.locator('#theme').textContent(), 'Light');
      await page.getByLabel('Force P').fill('500');
      await page.getByRole('button', { name: 'Solve', exact: true }).click();
      await page.locator('[data-status=succeeded]').waitFor();
      await page.locator('#headline').getByText('500.00').waitFor();
      await page.getByRole('button', { name: 'Jobs', exact: true }).click();
      await page.locator('#jobs-list button.open').first().waitFor();
      await keepAs(page, 'Shop steel');
      await page.getByText('the material is there until this page is closed').waitFor();
      assert.equal(await page.locator('[data-preset=upper]').inputValue(), 'Shop steel');
    },
  );

service.test(
  'a key that the browser does not store is used all the same',
  async (page, { server }) => {
    await page.addInitScript(BLOCKED);
    await page.reload();
    await page.getByRole('dialog').waitFor();
    const asked = page.waitForRequest(
      (request) => request.headers().authorization === 'Bearer not-a-key',
    );
    await page.getByLabel('Key', { exact: true }).fill('not-a-key');
    await page.getByRole('button', { name: 'Use key' }).click();
    await asked;
    assert.ok(page.url().startsWith(server.url));
  },
  { own: ['--require-api-key'], amiss: true },
);

service.test(
  'a material of one’s own is shown, replaced and forgotten as one means it',
  async (page) => {
    const choice = page.locator('[data-preset=upper]');
    const dialog = page.getByRole('dialog');
    const yields = async () => (await draft(page)).upper.material.plasticity.yield_stress;
    await choice.selectOption('Steel S235');
    await keepAs(page, '  My   steel ');
    assert.equal(await choice.inputValue(), 'My steel');
    await choice.selectOption('Steel S235');
    assert.equal(
      await choice.inputValue(),
      'Steel S235',
      'of two that are alike the one that was chosen',
    );
    assert.match((await page.locator('[data-source=upper]').textContent()) ?? '', /EN 10025-2/);
    await choice.selectOption('Steel S355');
    await keepAs(page, 'my steel');
    await dialog
      .getByText('You have kept a material “My steel”. Press Keep again to replace it')
      .waitFor();
    await dialog.getByRole('button', { name: 'Cancel' }).click();
    await choice.selectOption('My steel');
    assert.equal(await yields(), 235);
    await choice.selectOption('Steel S355');
    await keepAs(page, 'My steel');
    await dialog.getByRole('button', { name: 'Keep', exact: true }).click();
    assert.equal(await choice.inputValue(), 'My steel');
    assert.equal(await yields(), 355);
    await keepAs(page, 'steel c45e +qt');
    await dialog.getByText('The library has a material of this name').waitFor();
    await dialog.getByRole('button', { name: 'Cancel' }).click();
    await page.locator('[data-forget=upper]').click();
    await dialog.getByRole('button', { name: 'Cancel' }).click();
    assert.equal(await choice.inputValue(), 'My steel');
    await page.locator('[data-forget=upper]').click();
    await dialog.getByText('“My steel” is removed from this browser').waitFor();
    await dialog.getByRole('button', { name: 'Forget' }).click();
    await page
      .locator('[data-preset=upper] option[value="My steel"]')
      .waitFor({ state: 'detached' });
    // The name stays with the figures, which are no longer those of a material that is known.
    assert.equal(await choice.inputValue(), '');
    assert.equal((await draft(page)).upper.material.name, 'My steel');
    assert.equal(await yields(), 355);
  },
);

service.test('a material with a figure that is wrong is not kept', async (page) => {
  const modulus = page.locator('[data-place="/upper/material/young_modulus"] input[type=text]');
  await modulus.fill('abc');
  await page.getByRole('button', { name: 'Keep as own…' }).first().click();
  await page.getByText('A material with a figure that is wrong is not kept').waitFor();
  assert.equal(await page.getByRole('dialog').count(), 0);
  assert.equal(await modulus.evaluate((input) => input === document.activeElement), true);
});
