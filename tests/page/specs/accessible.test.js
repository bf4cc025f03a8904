/** Every view by axe-core, light and dark, on a wide page and on a phone; nothing sticks out of any of them. */

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { after, before, test } from 'node:test';
import { launch, serve, visit } from '../browser.js';

/** @typedef {import('playwright-core').Page} Page */

const AXE = await readFile(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const WIDE = { viewport: { width: 1440, height: 900 } };
const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

/** @type {Awaited<ReturnType<typeof serve>>} */
let server;
/** @type {import('playwright-core').Browser} */
let browser;
before(async () => {
  [server, browser] = await Promise.all([serve(), launch()]);
});
after(async () => {
  await browser?.close();
  await server?.stop();
});

/** What axe finds, in short. @param {Page} page @param {string} view @returns {Promise<string[]>} */
async function violations(page, view) {
  // Not by a script element: the page's policy allows none but its own.
  await page.evaluate(AXE);
  const found = await page.evaluate(async () => {
    const { violations } = await /** @type {any} */ (globalThis).axe.run(document, { resultTypes: ['violations'] });
    return violations.flatMap((/** @type {any} */ { id, nodes }) =>
      nodes.map((/** @type {any} */ node) => `${id}: ${node.html.slice(0, 160)} ${node.any[0]?.message ?? ''}`),
    );
  });
  const [inner, outer] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
  if (inner > outer) found.push(`${inner} px in ${outer}`);
  return found.map((/** @type {string} */ one) => `${view}: ${one}`);
}

/** @param {Page} page @param {object} change @returns {Promise<string>} */
const solved = (page, change) =>
  page.evaluate(async (change) => {
    const { examples } = await (await fetch('v1/examples')).json();
    const { job } = examples.find((/** @type {{name: string}} */ { name }) => name === 'two_cylinders');
    const answer = await fetch('v1/jobs', {
      method: 'POST',
      headers: { 'Content-Type': 'application/json', Prefer: 'wait=60' },
      body: JSON.stringify({ ...job, mesh: { elements_per_half_width: 8 }, ...change }),
    });
    return (answer.headers.get('content-location') ?? '').split('/')[3];
  }, change);

for (const [size, options] of /** @type {const} */ ([
  ['wide', WIDE],
  ['phone', PHONE],
]))
  for (const colorScheme of /** @type {const} */ (['light', 'dark']))
    test(`every view, ${size}, ${colorScheme}`, async () => {
      const { page, faults, close } = await visit(browser, server.url, { ...options, colorScheme });
      const found = [];
      await page.getByText('1500.0 MPa').waitFor();
      found.push(...(await violations(page, 'set-up')));
      await page.getByText('Mesh, solver, output, tags').click();
      await page.getByLabel('Shape').first().selectOption('profile');
      await page.getByLabel('Hardening').first().selectOption('table');
      await page.locator('[data-place="/load/force"]').getByRole('button', { name: 'Slider' }).click();
      await page.getByLabel('Points x, height').fill('0 0 0');
      await page.locator('[data-place="/upper/shape/points"] .error:visible').waitFor();
      found.push(...(await violations(page, 'form with a fault')));
      await page.getByRole('button', { name: 'JSON', exact: true }).click();
      await page.getByRole('button', { name: 'Jobs', exact: true }).click();
      const [one, other] = [
        await solved(page, { load: { forces: [200, 612] }, output: { fields: true } }),
        await solved(page, { load: { force: 400 } }),
      ];
      await page.goto(`${server.url}/#job=${one}&with=${other}`);
      await page.locator('#panel-differences tbody tr').first().waitFor();
      await page.waitForFunction(() => performance.getEntriesByName('field-drawn').length > 0);
      await page.getByLabel('Cut', { exact: true }).check();
      await page.getByText('Download', { exact: true }).click();
      await page.locator('#jobs-list .load').first().waitFor();
      found.push(...(await violations(page, 'result')));
      await page.keyboard.press('Escape');
      await page.locator('#form').getByRole('button', { name: 'Explanation' }).first().click();
      found.push(...(await violations(page, 'explanation')));
      await page.keyboard.press('Escape');
      await page.getByRole('button', { name: 'Report' }).click();
      found.push(...(await violations(page, 'report')));
      assert.deepEqual(found, []);
      assert.deepEqual(faults, []);
      await close();
    });

test('the question for a key, by axe', async () => {
  const guarded = await serve(['--require-api-key']);
  const { page, close } = await visit(browser, guarded.url);
  await page.getByRole('dialog').waitFor();
  assert.deepEqual(await violations(page, 'key'), []);
  await close();
  await guarded.stop();
});
