/** Other tabs, other languages, other scales. */

import assert from 'node:assert/strict';
import { suite } from '../browser.js';
import { shown } from '../jobs.js';

const service = suite();
const FORCE = '[data-place="/load/force"] input[type=text]';

service.test(
  'two tabs have drafts and answers of their own, and the same materials',
  async (page) => {
    const other = await page.context().newPage();
    await other.goto(service.url);
    await other.getByText('1500.0 MPa').waitFor();
    for (const [tab, force] of /** @type {const} */ ([
      [page, '400'],
      [other, '500'],
    ])) {
      await tab.locator(FORCE).fill(force);
      await tab.getByRole('button', { name: 'Solve', exact: true }).click();
    }
    await page.locator('#headline').getByText('400.00').waitFor();
    await other.locator('#headline').getByText('500.00').waitFor();
    await page.reload();
    await page.locator('#headline').getByText('400.00').waitFor();
    assert.equal(await page.locator(FORCE).inputValue(), '400');
    await other.getByRole('button', { name: 'Keep as own…' }).first().click();
    await other.getByLabel('Name', { exact: true }).fill('Shop steel');
    await other.getByRole('button', { name: 'Keep', exact: true }).click();
    await page
      .locator('[data-preset=upper] option')
      .getByText('Shop steel')
      .waitFor({ state: 'attached' });
  },
);

for (const locale of ['de-DE', 'fr-FR'])
  service.test(
    `figures are the same in a browser of ${locale}`,
    async (page) => {
      await page.locator(FORCE).fill('1234,5');
      await page.getByRole('button', { name: 'Solve', exact: true }).click();
      await page.locator('#headline').getByText('1234.5').waitFor();
      await page.getByRole('button', { name: 'Jobs', exact: true }).click();
      await page
        .locator('#jobs-list li', { hasText: '1234.5 N/mm' })
        .getByText(/^peak \d{4} MPa$/)
        .first()
        .waitFor();
    },
    { locale },
  );

/** A tip of 100 nm on a block, in SI. */
const TINY = {
  units: 'SI',
  analysis: 'axisymmetric',
  upper: { shape: { type: 'cylinder', radius: 1e-7 }, material: { rigid: true } },
  lower: {
    shape: { type: 'block', width: 4e-6, depth: 2e-6 },
    material: {
      young_modulus: 210e9,
      poisson_ratio: 0.3,
      plasticity: { law: 'bilinear', yield_stress: 5e8, tangent_modulus: 2e9 },
    },
  },
  load: { forces: [1e-9, 1e-8, 1e-7] },
};

service.test(
  'figures of a tiny contact stand whole in their cards, and in units of its size',
  async (page) => {
    await shown(page, TINY);
    for (const width of [1440, 1100]) {
      await page.setViewportSize({ width, height: 900 });
      // No figure is broken within its digits.
      await page.waitForFunction((width) => {
        const rows = (/** @type {Element} */ one) => {
          const range = document.createRange();
          range.selectNodeContents(/** @type {Node} */ (one.firstChild));
          return new Set([...range.getClientRects()].map(({ top }) => Math.round(top))).size;
        };
        return (
          innerWidth === width &&
          [...document.querySelectorAll('#headline .figure')].every((one) => rows(one) === 1)
        );
      }, width);
    }
    await page.getByText('Units shown').click();
    await page.getByLabel('Unit of length').selectOption('nm');
    await page.getByLabel('Unit of force').selectOption('mN');
    await page.getByLabel('Unit of stress').selectOption('GPa');
    const card = (/** @type {string} */ name) =>
      page.locator(`[data-answer=${name}] .figure`).textContent();
    assert.match((await card('half_width')) ?? '', /^[4-6]\.\d+nm$/);
    assert.equal(await card('force'), '0.00010000mN');
  },
);

service.test('loads of many digits are told in the sketch without leaving it', async (page) => {
  for (const [history, words] of /** @type {[object[], string][]} */ ([
    [[{ approach: 0.01 }, { force: 800 }, { force: 0 }], 'α = 0.01 mm → P = 800 → 0 N/mm'],
    [
      [612.610612345678, 0, 612.123456789].map((force) => ({ force })),
      'P = 612.610612346 → 0 → 612.123456789 N/mm',
    ],
    [[{ force: 612.610612345678 }, { approach: 0.0212345678912 }, { force: 0 }], '3 loads'],
  ])) {
    await shown(page, { load: { history }, solver: { theory: 'flow' } });
    await page.locator('#sketch').getByText(words, { exact: true }).waitFor();
    const [right, end] = await page
      .locator('#sketch')
      .evaluate((sketch) =>
        ['.load', 'svg'].map(
          (part) => sketch.querySelector(part)?.getBoundingClientRect().right ?? 0,
        ),
      );
    // Around letters there is a rim.
    assert.ok(right > 0 && right <= end + 2, `${right} of ${end}`);
  }
});

service.test(
  'a history of thirty loads is told in the sketch without leaving it',
  async (page) => {
    const history = Array.from({ length: 30 }, (_, k) => ({ force: k % 2 ? 0 : 300 + 10 * k }));
    await shown(page, { load: { history }, solver: { theory: 'flow' } });
    await page.locator('#sketch').getByText('P = 30 loads up to 580 N/mm').waitFor();
    const [right, end] = await page
      .locator('#sketch')
      .evaluate((sketch) =>
        ['.load', 'svg'].map(
          (part) => sketch.querySelector(part)?.getBoundingClientRect().right ?? 0,
        ),
      );
    assert.ok(right > 0 && right <= end, `${right} of ${end}`);
    await page.locator('#panel-figures tbody tr').nth(29).waitFor();
    await page.getByRole('button', { name: 'Report' }).click();
    await page.getByRole('main', { name: 'Report' }).getByText('300 → 0 → 320 → 0').waitFor();
  },
);
