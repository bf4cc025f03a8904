/**
 * Whether the page works at all: first view, a job, a dent, a sweep, a comparison, a refusal. The
 * rest is in `specs/`.
 */

import assert from 'node:assert/strict';
import { suite } from './browser.js';
import { draft, follow, shown, solved } from './jobs.js';

const service = suite();
const COARSE = { mesh: { elements_per_half_width: 6 } };

service.test('the first view shows the bodies, their set-up and elastic theory', async (page) => {
  await page.locator('#sketch svg').waitFor();
  assert.equal(await page.getByLabel('Radius').first().inputValue(), '20');
  const legend = page.locator('#panel-pressure .legend li');
  await legend.getByText('Hertz, elastic').waitFor();
  const { width, height } = (await legend.first().boundingBox()) ?? { width: 0, height: 0 };
  assert.ok(
    width > 3 * height,
    `the legend has words on one line, not letters below each other: ${width} × ${height}`,
  );
  const chosen = await page.locator('#example').evaluate((select) => {
    const words = /** @type {HTMLSelectElement} */ (select).selectedOptions[0].text;
    const context = /** @type {CanvasRenderingContext2D} */ (
      document.createElement('canvas').getContext('2d')
    );
    context.font = getComputedStyle(select).font;
    return { words, needs: context.measureText(words).width, has: select.clientWidth };
  });
  assert.ok(chosen.has > chosen.needs, JSON.stringify(chosen));
});

service.test('the reference job is solved', async (page) => {
  await page.getByRole('button', { name: 'Solve', exact: true }).click();
  await page.locator('[data-status=succeeded]').waitFor();
  await page
    .locator('#headline')
    .getByText(/11[45]\d/)
    .first()
    .waitFor();
  await page.locator('#panel-field canvas').first().waitFor();
});

service.test('a load that is taken away leaves a dent and stresses over depth', async (page) => {
  const history = [{ force: 612.6106 }, { force: 0 }];
  await shown(page, { load: { history }, solver: { theory: 'flow' }, ...COARSE });
  assert.match(
    (await page.locator('#panel-dent .plot').getAttribute('aria-label')) ?? '',
    /^Residual height/,
  );
  await page.locator('#panel-depth .plot svg').waitFor();
});

service.test('a sweep has a row for every load', async (page) => {
  await shown(page, { load: { forces: [100, 300, 612] }, ...COARSE });
  assert.equal(await page.locator('#panel-figures tbody tr').count(), 3);
  await page.locator('#panel-sweep .plot').waitFor();
});

service.test('two jobs are compared', async (page) => {
  const [one, other] = [
    await solved(page, COARSE),
    await solved(page, { load: { force: 400 }, ...COARSE }),
  ];
  await follow(page, `job=${one}&with=${other}`);
  await page.locator('#panel-differences tbody tr').first().waitFor();
  assert.deepEqual(await page.locator('#panel-differences tbody td').allTextContents(), [
    'Force [N/mm]',
    '612.6106',
    '400',
  ]);
});

service.test('a wrong input is refused where it stands', async (page) => {
  await page.getByLabel('Radius').first().fill('-3');
  await page.locator('[data-place="/upper/shape/radius"] .error').waitFor();
  assert.equal((await draft(page)).upper.shape.radius, -3);
  await page.getByRole('button', { name: 'Solve', exact: true }).click();
  await page.locator('#solve-state').getByText(/\S/).waitFor();
  assert.equal(await page.locator('[data-status]').count(), 0);
});
