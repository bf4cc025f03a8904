/** The narrowest phones: everything that is wider than the page scrolls by itself. */

import assert from 'node:assert/strict';
import { PHONE, suite } from '../browser.js';
import { drawn, follow, shown, solved, unfold } from '../jobs.js';

/** @typedef {import('playwright-core').Page} Page */

const service = suite();
const WIDTH = 320;
const NARROW = { ...PHONE, viewport: { width: WIDTH, height: 700 } };

/** What goes beyond the page, by its class: a page that is too wide is made narrower by the browser as a whole. @param {Page} page */
const beyond = (page) =>
  page.evaluate(
    (width) => [
      ...(document.documentElement.scrollWidth > width
        ? [`the page is ${document.documentElement.scrollWidth} wide`]
        : []),
      ...[...document.querySelectorAll('body *')]
        .filter((one) => {
          if (!one.checkVisibility() || one.getBoundingClientRect().right <= width + 0.5)
            return false;
          for (let at = one.parentElement; at; at = at.parentElement)
            if (getComputedStyle(at).overflowX !== 'visible') return false;
          return true;
        })
        .map((one) => `${one.tagName} ${one.className} ${one.textContent?.slice(0, 40)}`),
    ],
    WIDTH,
  );

service.test(
  'every shape and curve in the form',
  async (page) => {
    const shapes = page.getByLabel('Shape').first();
    const values = await shapes
      .locator('option')
      .evaluateAll((all) => all.map((one) => /** @type {HTMLOptionElement} */ (one).value));
    assert.ok(values.length > 6, values.join());
    for (const value of values) {
      await shapes.selectOption(value);
      assert.deepEqual(await beyond(page), [], value);
    }
    await shapes.selectOption('cylinder');
    await page.getByLabel('Hardening').first().selectOption('table');
    await unfold(page);
    await page.getByLabel('Strength over depth').first().selectOption({ index: 1 });
    await page.getByLabel('Initial stress').first().selectOption('given');
    assert.deepEqual(await beyond(page), []);
  },
  NARROW,
);

service.test(
  'a result, its cut, jobs and report',
  async (page) => {
    await shown(page, { load: { forces: [100, 300, 612] }, output: { fields: true } });
    await drawn(page);
    await page.getByLabel('Cut', { exact: true }).check();
    for (const part of ['JSON', 'Jobs'])
      await page.getByRole('button', { name: part, exact: true }).click();
    await page.locator('#jobs-list .peak').first().waitFor();
    await page.getByText('Units shown').click();
    await page.locator('.remarks > summary').click();
    assert.deepEqual(await beyond(page), []);
    await page.keyboard.press('Escape');
    await page.getByRole('button', { name: 'Report' }).click();
    await page.getByRole('button', { name: 'Print or save as PDF' }).waitFor();
    assert.deepEqual(await beyond(page), []);
  },
  NARROW,
);

service.test(
  'legends of compared sweeps are no wider than the narrowest phone',
  async (page) => {
    const ids = [];
    for (const force of [300, 400])
      ids.push(await solved(page, { load: { forces: [100, 200, force] } }));
    await follow(page, `job=${ids[0]}&with=${ids[1]}`);
    await page.locator('#panel-differences tbody tr').first().waitFor();
    await page.locator('#panel-depth .legend').getByText('plastic strain').first().waitFor();
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 320);
  },
  { ...PHONE, viewport: { width: 320, height: 700 } },
);

service.test(
  'who wants nothing to move is brought to the result at once',
  async (page) => {
    await page.emulateMedia({ reducedMotion: 'reduce' });
    await page.evaluate(() => {
      const seen = /** @type {unknown[]} */ ([]);
      Object.assign(globalThis, { seen });
      Element.prototype.scrollIntoView = (/** @type {unknown} */ how) => void seen.push(how);
    });
    await shown(page, {});
    assert.deepEqual(await page.evaluate('seen'), [{ behavior: 'auto' }]);
  },
  PHONE,
);

service.test(
  'Solve stays in reach while the form is gone through',
  async (page) => {
    const solve = page.getByRole('button', { name: 'Solve', exact: true });
    for (const place of [
      '/analysis',
      '/upper/shape/radius',
      '/lower/material/young_modulus',
      '/load/force',
    ]) {
      const field = page.locator(`[data-place="${place}"] :is(input[type=text], select)`);
      await field.scrollIntoViewIfNeeded();
      await field.focus();
      const [seen, button] = await Promise.all([field.boundingBox(), solve.boundingBox()]);
      assert.ok(
        seen && button && button.y >= 0 && button.y + button.height <= 844,
        `${place}: ${button?.y}`,
      );
      assert.ok(seen.y + seen.height <= button.y, `${place} is not behind the bar with Solve`);
    }
  },
  PHONE,
);
