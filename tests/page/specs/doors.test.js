/** The first view: six doors that fill the form, and what they leave to “more”. */

import assert from 'node:assert/strict';
import { suite } from '../browser.js';
import { draft, sent } from '../jobs.js';

const service = suite();
/** Doors, each with the most fields that its form begins with. @type {[string, number][]} */
const DOORS = [
  ['press', 10],
  ['raceway', 10],
  ['rolling', 16],
  ['hardness', 10],
  ['surface', 13],
  ['depth', 21],
];

service.test(
  'six doors fill the form with few fields, none of them at fault',
  async (page) => {
    const fields = page.locator('#form [data-place]:visible');
    for (const [door, most] of DOORS) {
      await page.locator(`[data-door=${door}]`).click();
      await page.locator(`[data-door=${door}][aria-pressed=true]`).waitFor();
      await page.locator('#cost').getByText('equations').waitFor();
      assert.equal(await page.locator('#setup .error:visible').count(), 0, door);
      const count = await fields.count();
      assert.ok(count > 6 && count <= most, `${door}: ${count} fields`);
      const { load } = await draft(page);
      const plot = await page.locator('#panel-pressure:visible').count();
      if (load.hardness) assert.equal(plot, 0, 'there is no chart without an elastic solution');
    }
    const few = await fields.count();
    await page.getByRole('button', { name: /^More: all fields/ }).click();
    assert.ok((await fields.count()) > few + 20);
    await page.reload();
    await page.getByRole('button', { name: 'Fewer fields' }).waitFor();
  },
  { few: true },
);

service.test(
  'what is not as usual is seen, and so is what is wrong',
  async (page) => {
    const field = (/** @type {string} */ place) => page.locator(`[data-place="${place}"]`);
    await page.locator('[data-door=press]').click();
    assert.equal(await field('/upper/support').isVisible(), false);
    assert.equal(await field('/solver/tolerance').isVisible(), false);
    const job = { ...(await draft(page)), solver: { tolerance: 5 } };
    job.upper.support = 'roller';
    await page.getByRole('button', { name: 'JSON', exact: true }).click();
    await page.locator('#json-text').fill(JSON.stringify(job));
    await field('/upper/support').waitFor();
    await field('/solver/tolerance').locator('.error:visible').waitFor();
    job.upper.material.poisson_ratio = 2;
    await page.locator('#json-text').fill(JSON.stringify(job));
    await field('/upper/material/poisson_ratio').locator('.error:visible').waitFor();
  },
  { few: true },
);

service.test('the lower body follows the upper until it is changed', async (page) => {
  const radius = (/** @type {string} */ body) =>
    page.locator(`[data-place="/${body}/shape/radius"] input[type=text]`);
  await radius('upper').fill('25');
  await page.locator('[data-preset=upper]').selectOption('Steel S355');
  const { upper, lower } = await draft(page);
  assert.deepEqual(lower, upper);
  assert.deepEqual([lower.shape.radius, lower.material.name], [25, 'Steel S355']);
  await page.getByRole('button', { name: 'Undo' }).click();
  assert.deepEqual((await draft(page)).lower.material, (await draft(page)).upper.material);
  await radius('lower').fill('30');
  await radius('upper').fill('40');
  assert.equal((await draft(page)).lower.shape.radius, 30);
  await page.getByRole('button', { name: 'same as upper' }).click();
  await page.locator('[data-place="/upper/shape/type"] select').selectOption('block');
  assert.equal((await draft(page)).lower.shape.type, 'cylinder');
});

service.test(
  'a job is opened from a file, and the last results from the first view',
  async (page) => {
    const id = await sent(page, { title: 'Roller 4711-A' }, true);
    await page.reload();
    await page.getByRole('button', { name: 'Last results' }).click();
    await page
      .locator('#jobs-list')
      .getByRole('button', { name: /^Roller 4711-A/ })
      .click();
    await page.locator('[data-status=succeeded]').waitFor();
    assert.match(page.url(), new RegExp(id));
    await page.goBack();
    const choose = async (/** @type {string} */ text) => {
      const chooser = page.waitForEvent('filechooser');
      await page.getByRole('button', { name: 'Open a job…' }).click();
      await (await chooser).setFiles({ name: 'a.json', mimeType: '', buffer: Buffer.from(text) });
    };
    await choose('[1, 2');
    await page.getByText('“a.json” is not a job: Download saves one as “Job, JSON”').waitFor();
    const job = await draft(page);
    await choose(JSON.stringify({ ...job, load: { force: 77 } }));
    await page.waitForFunction(() => /"force":77\b/.test(sessionStorage.getItem('draft') ?? ''));
  },
);
