/** Whoever clicks twice, holds a key down or turns back before an answer is here. */

import assert from 'node:assert/strict';
import { suite } from '../browser.js';
import { drawn, follow, mises, shown, solved } from '../jobs.js';

/** @typedef {import('playwright-core').Page} Page */

const service = suite();

/** Counts jobs that are sent. @param {Page} page */
function sentJobs(page) {
  const sent = { count: 0 };
  page.on('request', (request) => {
    if (request.method() === 'POST' && request.url().endsWith('/v1/jobs')) sent.count += 1;
  });
  return sent;
}

/** Holds back what is asked of a job. @param {Page} page @param {string} id */
async function hold(page, id) {
  let letGo = () => {};
  const held = new Promise((resolve) => {
    letGo = () => resolve(undefined);
  });
  const asked = page.waitForRequest((request) => request.url().includes(`${id}/result`));
  await page.route(`**/${id}/result**`, async (route) => {
    await held;
    await route.continue();
  });
  return { asked, letGo };
}

service.test('a double click or a key that is held down makes one job', async (page) => {
  const sent = sentJobs(page);
  await page.getByRole('button', { name: 'Solve', exact: true }).dblclick({ delay: 60 });
  await page.locator('[data-status=succeeded]').waitFor();
  assert.equal(sent.count, 1);
  await page.getByLabel('Force P').fill('400');
  await page.keyboard.down('Control');
  for (let k = 0; k < 8; k++) await page.keyboard.down('Enter');
  await page.keyboard.up('Enter');
  await page.keyboard.up('Control');
  await page.locator('#headline').getByText('400.00').waitFor();
  assert.equal(sent.count, 2);
});

service.test('a comparison that is taken back before it is here stays away', async (page) => {
  const [one, other] = [await solved(page), await solved(page, { load: { force: 300 } })];
  await follow(page, `job=${one}`);
  await page.locator('[data-status=succeeded]').waitFor();
  await page.getByRole('button', { name: 'Jobs', exact: true }).click();
  const { asked, letGo } = await hold(page, other);
  const box = page.getByLabel(new RegExp(`^Compare .*${other.slice(-8)}`));
  await box.check();
  await asked;
  // The list that is fetched anew knows what was chosen.
  const row = await box.elementHandle();
  await page.getByLabel('State', { exact: true }).selectOption('succeeded');
  await page.waitForFunction((row) => !row?.isConnected, row);
  assert.equal(await box.isChecked(), true);
  await box.uncheck();
  const came = page.waitForResponse((response) => response.url().includes(`${other}/result`));
  letGo();
  await (await came).finished();
  await page.getByLabel('Force P').fill('401');
  await page.getByText('The set-up has changed since this job was sent.').waitFor();
  assert.equal(await page.locator('#panel-figures tbody tr').count(), 1);
  assert.equal(new URL(page.url()).hash, `#job=${one}`);
  assert.equal(await box.isChecked(), false);
});

service.test(
  'a comparison of a link that was left is not laid over the next job',
  async (page) => {
    const [one, other, next] = [
      await solved(page),
      await solved(page, { load: { force: 300 } }),
      await solved(page, { load: { force: 200 } }),
    ];
    const { asked, letGo } = await hold(page, other);
    await follow(page, `job=${one}&with=${other}`);
    await asked;
    await follow(page, `job=${next}`);
    await page.locator('#headline').getByText('200.00').waitFor();
    const came = page.waitForResponse((response) => response.url().includes(`${other}/result`));
    letGo();
    await (await came).finished();
    await page.goBack();
    await page.locator('#panel-figures tbody tr').nth(1).waitFor();
    await page.goForward();
    await page.locator('#headline').getByText('200.00').waitFor();
    assert.equal(await page.locator('#panel-figures tbody tr').count(), 1);
  },
);

service.test('a report is left by Escape, and by Back', async (page) => {
  await shown(page, { load: { force: 300 }, output: { fields: true } });
  await shown(page, { load: { force: 400 }, output: { fields: true } });
  await drawn(page);
  const print = page.getByRole('button', { name: 'Print or save as PDF' });
  await page.getByRole('button', { name: 'Report' }).click();
  await print.waitFor();
  await page.keyboard.press('Escape');
  await print.waitFor({ state: 'hidden' });
  await page.getByRole('button', { name: 'Report' }).click();
  await page.goBack();
  await print.waitFor({ state: 'hidden' });
  await page.locator('#headline').getByText('300.00').waitFor();
});

service.test(
  'whoever solves again while a field is loading sees the field of the new job',
  async (page) => {
    let letGo = () => {};
    const held = new Promise((resolve) => {
      letGo = () => resolve(undefined);
    });
    let first = true;
    await page.route('**/fields/**', async (route) => {
      if (first) {
        first = false;
        await held;
      }
      await route.continue().catch(() => {});
    });
    const id = await solved(page, { load: { force: 300 }, output: { fields: true } });
    await follow(page, `job=${id}`);
    await page.getByText('Loading the field of this step').waitFor();
    await page.getByLabel('Force P').fill('612.6106');
    await page.getByRole('button', { name: 'Solve', exact: true }).click();
    await page.locator('#headline').getByText('612.61').waitFor();
    await mises(page);
    letGo();
    await page.waitForFunction(() =>
      / to 5[0-9][0-9][.]/.test(document.querySelector('.over')?.getAttribute('aria-label') ?? ''),
    );
    assert.equal(await page.locator('#panel-field .stage.stale').count(), 0);
  },
);
