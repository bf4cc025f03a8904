/**
 * Every view by axe-core, light and dark, on a wide page and on a phone; nothing sticks out of any
 * of them.
 */

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { PHONE, WIDE, suite } from '../browser.js';
import { drawn, follow, shown, solved, unfold } from '../jobs.js';

/** @typedef {import('playwright-core').Page} Page */

const AXE = await readFile(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

const service = suite();

/** What axe finds, in short. @param {Page} page @param {string} view @returns {Promise<string[]>} */
async function violations(page, view) {
  // Not by a script element: the page's policy allows none but its own.
  await page.evaluate(AXE);
  const found = await page.evaluate(async () => {
    const { violations } = await /** @type {any} */ (globalThis).axe.run(document, {
      resultTypes: ['violations'],
      rules: { 'target-size': { enabled: true } },
    });
    return violations.flatMap((/** @type {any} */ { id, nodes }) =>
      nodes.map(
        (/** @type {any} */ node) =>
          `${id}: ${node.html.slice(0, 160)} ${node.any[0]?.message ?? ''}`,
      ),
    );
  });
  const [inner, outer] = await page.evaluate(() => [
    document.documentElement.scrollWidth,
    innerWidth,
  ]);
  if (inner > outer) found.push(`${inner} px in ${outer}`);
  return found.map((/** @type {string} */ one) => `${view}: ${one}`);
}

for (const [size, options] of /** @type {const} */ ([
  ['wide', WIDE],
  ['phone', PHONE],
]))
  for (const colorScheme of /** @type {const} */ (['light', 'dark']))
    service.test(
      `every view, ${size}, ${colorScheme}`,
      async (page) => {
        const found = [];
        await page.getByText('1500.0 MPa').waitFor();
        found.push(...(await violations(page, 'set-up')));
        await unfold(page);
        await page.getByLabel('Shape').first().selectOption('profile');
        await page.getByLabel('Hardening').first().selectOption('table');
        await page
          .locator('[data-place="/load/force"]')
          .getByRole('button', { name: 'Slider' })
          .click();
        await page.getByLabel('Points x, height').fill('0 0 0');
        await page.locator('[data-place="/upper/shape/points"] .error:visible').waitFor();
        found.push(...(await violations(page, 'form with a fault')));
        await page.getByRole('button', { name: 'JSON', exact: true }).click();
        await page.getByRole('button', { name: 'Jobs', exact: true }).click();
        const [one, other] = [
          await solved(page, { load: { forces: [200, 612] }, output: { fields: true } }),
          await solved(page, { load: { force: 400 } }),
        ];
        await follow(page, `job=${one}&with=${other}`);
        await page.locator('#panel-differences tbody tr').first().waitFor();
        await drawn(page);
        await page.getByLabel('Cut', { exact: true }).check();
        await page.getByText('Download', { exact: true }).click();
        await page.locator('#jobs-list .peak').first().waitFor();
        found.push(...(await violations(page, 'result')));
        await page.keyboard.press('Escape');
        await page.locator('#form').getByRole('button', { name: 'Explanation' }).first().click();
        found.push(...(await violations(page, 'explanation')));
        await page.keyboard.press('Escape');
        await page.getByRole('button', { name: 'Report' }).click();
        found.push(...(await violations(page, 'report')));
        assert.deepEqual(found, []);
      },
      { ...options, colorScheme },
    );

service.test(
  'the question for a key, by axe',
  async (page) => {
    await page.getByRole('dialog').waitFor();
    assert.deepEqual(await violations(page, 'key'), []);
  },
  { own: ['--require-api-key'], amiss: true },
);

for (const [size, options] of /** @type {const} */ ([
  ['wide', WIDE],
  ['phone', PHONE],
]))
  for (const colorScheme of /** @type {const} */ (['light', 'dark']))
    service.test(
      `the page about the interface, ${size}, ${colorScheme}`,
      async (page) => {
        await page.goto(new URL('docs', page.url()).href);
        await page.waitForFunction(
          (colours) => document.documentElement.dataset.colours === colours,
          colorScheme,
        );
        await page.locator('details summary').first().click();
        assert.deepEqual(await violations(page, 'interface'), []);
        // An example, by the keyboard.
        await page.locator('#post_validate summary').first().focus();
        await page.keyboard.press('Enter');
        assert.ok(await page.locator('#post_validate pre').first().isVisible());
      },
      { ...options, colorScheme },
    );

service.test(
  'where the system chooses the colours, the scale of the field keeps its own and what is chosen has a rim',
  async (page) => {
    await shown(page, { load: { forces: [300, 612] }, output: { fields: true } });
    await drawn(page);
    const adjusted = await page.evaluate(() =>
      ['.colours li:not(.unit, .last)', '.legend .swatch', '.stage .surface'].map((part) => {
        const [element] = document.querySelectorAll(part);
        return getComputedStyle(element, part.startsWith('.colours') ? '::after' : null)
          .forcedColorAdjust;
      }),
    );
    assert.deepEqual(adjusted, ['none', 'none', 'none']);
    const rims = await page.evaluate(() =>
      ['.segments', '.chips'].map(
        (part) =>
          getComputedStyle(
            /** @type {Element} */ (document.querySelector(`#panels ${part} :checked + span`)),
          ).outlineStyle,
      ),
    );
    assert.deepEqual(rims, ['solid', 'solid']);
  },
  { forcedColors: 'active' },
);

service.test('steps and buttons are called by what they are', async (page) => {
  await shown(page, { load: { forces: [100, 300] } });
  assert.equal(
    await page.getByLabel('Step', { exact: true }).getAttribute('aria-valuetext'),
    '2 of 2: 300.0 N/mm',
  );
  const alike = await page.locator('#result .panel button').evaluateAll((buttons) => {
    const names = buttons
      .filter((button) => button.checkVisibility())
      .map((button) => button.getAttribute('aria-label') ?? button.textContent);
    return names.filter((name, k) => names.indexOf(name) < k);
  });
  assert.deepEqual(alike, []);
});

service.test(
  'iterations are those of all steps, or of one, and it is said which',
  async (page) => {
    await shown(page, { load: { forces: [100, 300] } });
    await page
      .locator('#watch')
      .getByText(/2 steps solved in/)
      .waitFor();
    await page
      .locator('#headline')
      .getByText(/iterations? in this step; .* for all steps/)
      .waitFor({ state: 'attached' });
  },
);
