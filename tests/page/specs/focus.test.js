/** The focus is never lost: whatever is built anew, who works by keyboard goes on where they were. */

import assert from 'node:assert/strict';
import { suite } from '../browser.js';
import { shown, solved } from '../jobs.js';

/** @typedef {import('playwright-core').Page} Page */

const service = suite();

/** What has the focus. @param {Page} page */
const at = (page) =>
  page.evaluate(() => {
    const one = /** @type {HTMLElement} */ (document.activeElement);
    const place = /** @type {HTMLElement | null} */ (one.closest('[data-place], [data-key]'));
    return [
      place?.dataset.place ?? '',
      one.dataset.preset ?? '',
      one.id.replace(/^entry-\d+$/, ''),
      one.matches('button') ? one.textContent : one.tagName,
    ]
      .filter(Boolean)
      .join(' ');
  });

service.test('by undo and by choices that build the form anew', async (page) => {
  const shape = page.locator('[data-place="/upper/shape/type"] select');
  await shape.focus();
  await shape.selectOption('block');
  assert.equal(await at(page), '/upper/shape/type SELECT');
  await page.keyboard.press('Control+z');
  assert.equal(await at(page), '/upper/shape/type SELECT');
  const width = page.locator('[data-place="/upper/shape/width"] input[type=text]');
  await shape.selectOption('block');
  await width.fill('70');
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  assert.notEqual(await at(page), 'BODY', 'the field is gone: the one in its place has the focus');
  const preset = page.locator('[data-preset=upper]');
  await preset.focus();
  await preset.selectOption('Bearing steel, elastic');
  assert.equal(await at(page), 'upper SELECT');
  await page.locator('[data-place="/upper/shape/type"] select').selectOption('block');
  const same = page.getByRole('button', { name: 'same as lower' });
  await same.focus();
  await page.keyboard.press('Enter');
  assert.equal(await at(page), 'same as lower');
  await page.getByRole('button', { name: 'From hardness…' }).last().focus();
  await page.keyboard.press('Enter');
  await page.keyboard.type('300');
  await page.keyboard.press('Enter');
  await page.getByRole('dialog').waitFor({ state: 'detached' });
  assert.equal(await at(page), 'From hardness…');
});

service.test('at buttons that have nothing more to do', async (page) => {
  await page.getByLabel('Force P').fill('500');
  const undo = page.getByRole('button', { name: 'Undo' });
  await undo.focus();
  await page.keyboard.press('Enter');
  assert.equal(await undo.getAttribute('aria-disabled'), 'true');
  assert.equal(await at(page), 'undo ↶');
  await page.locator('#solve').focus();
  await page.keyboard.press('Enter');
  await page.locator('[data-status=succeeded]').waitFor();
  assert.equal(await at(page), 'solve Solve');
  await page.getByLabel('Force P').fill('400');
  await page.locator('#restore').focus();
  await page.keyboard.press('Enter');
  await page.locator('#stale').waitFor({ state: 'hidden' });
  assert.equal(await at(page), 'result SECTION');
  await page.locator('[data-preset=upper]').selectOption('Steel S235');
  await page.getByRole('button', { name: 'Keep as own…' }).first().click();
  await page.getByLabel('Name').fill('Mine');
  await page.keyboard.press('Enter');
  await page.locator('[data-forget=upper]').focus();
  await page.keyboard.press('Enter');
  await page.getByRole('dialog').getByRole('button', { name: 'Forget' }).press('Enter');
  await page.getByRole('dialog').waitFor({ state: 'detached' });
  assert.equal(await at(page), 'upper SELECT');
});

service.test('in the list of jobs, which is fetched again and again', async (page) => {
  const one = await solved(page);
  await shown(page, { load: { force: 300 } });
  await page.getByRole('button', { name: 'Jobs', exact: true }).click();
  const row = page.locator(`[data-key="${one}"]`);
  for (const part of ['button.open', 'input']) {
    await row.locator(part).focus();
    const before = await row.elementHandle();
    await page.locator('#jobs-filter select').evaluate((choice) => choice.dispatchEvent(new Event('change')));
    await page.waitForFunction((row) => !row?.isConnected, before);
    assert.equal(await row.locator(part).evaluate((one) => one === document.activeElement), true, part);
  }
});
