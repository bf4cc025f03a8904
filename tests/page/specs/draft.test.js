/** The draft beside its form: faulty texts, other analyses and units, definitions of others. */

import assert from 'node:assert/strict';
import { suite } from '../browser.js';
import { draft, unfold } from '../jobs.js';

const service = suite();

const FORCE = '[data-place="/load/force"] input[type=text]';

/** @param {import('playwright-core').Page} page @param {string} text that the field is to show */
const shows = (page, text) =>
  page.waitForFunction(
    ([field, text]) =>
      /** @type {HTMLInputElement} */ (document.querySelector(field))?.value === text,
    [FORCE, text],
  );

service.test('a JSON at fault stays until it is put right or given up', async (page) => {
  const json = page.getByRole('button', { name: 'JSON', exact: true });
  await json.click();
  const text = page.locator('#json-text');
  const broken = (await text.inputValue()).replace('612.6106', '612.6106,,');
  await text.fill(broken);
  await page.locator('#json-text[aria-invalid=true]').waitFor();
  await page.locator(FORCE).fill('500');
  assert.equal(await text.inputValue(), broken);
  await json.click();
  await page.locator(FORCE).press('Control+Enter');
  await page.getByText('The JSON beside is not a job').waitFor();
  assert.equal(
    await text.evaluate((one) => one === document.activeElement),
    true,
    'it is shown, with the cursor in it',
  );
  await page.getByRole('button', { name: 'Discard, show the form’s job' }).click();
  assert.equal(JSON.parse(await text.inputValue()).load.force, 500);
  await text.fill(`\ufeff${broken.replace(',,', '')}`);
  await page.locator('#json-state').getByText('same job as in the form').waitFor();
  await shows(page, '612.6106');
});

service.test(
  'another analysis has the load of a millimetre as a whole, in either units, and says so',
  async (page) => {
    for (const [units, force] of [
      ['mm_N_MPa', '612.6106'],
      ['SI', '612610.6'],
    ]) {
      await page.getByLabel('Units', { exact: true }).selectOption(units);
      await shows(page, force);
      await page.getByLabel('Analysis').selectOption('axisymmetric');
      await shows(page, '612.6106');
      await page.getByText('The load is that of the whole contact now, in N').waitFor();
      await page.getByLabel('Analysis').selectOption('plane_stress');
      await shows(page, force);
    }
  },
);

service.test('what was no figure is read again where its unit has become right', async (page) => {
  await page.locator(FORCE).fill('600 N');
  await page.getByText('“N” is no unit known here for this figure').waitFor();
  await page.getByLabel('Analysis').focus();
  await page.getByLabel('Analysis').selectOption('axisymmetric');
  await shows(page, '600');
  assert.equal((await draft(page)).load.force, 600);
  await page.keyboard.press('Control+Z');
  await shows(page, '600 N');
});

service.test('what a definition has instead of figures is shown as it is', async (page) => {
  await page.getByRole('button', { name: 'JSON', exact: true }).click();
  const text = page.locator('#json-text');
  const job = JSON.parse(await text.inputValue());
  await text.fill(JSON.stringify({ ...job, load: { force: {} } }));
  await shows(page, '{}');
  await text.fill(JSON.stringify({ ...job, load: { history: [{}, { force: 5 }] } }));
  await page.waitForFunction(
    () =>
      /** @type {HTMLInputElement} */ (
        document.querySelector('[data-place="/load/history"] input')
      )?.value === '{} 5',
  );
});

service.test('a load that deformation theory does not know says so', async (page) => {
  await page.getByLabel('Theory', { exact: true }).selectOption('deformation');
  await page.getByLabel('Given', { exact: true }).selectOption('target');
  await page.getByLabel('Figure', { exact: true }).selectOption('dent_depth');
  const place = page.locator('[data-place="/load/target/dent_depth"]');
  await place.locator('.error').getByText('it needs flow theory').waitFor();
  await page.getByLabel('Theory', { exact: true }).selectOption('flow');
  await place.locator('.error').waitFor({ state: 'hidden' });
});

service.test('loads are repeated one more time at each press', async (page) => {
  await page.getByLabel('Given', { exact: true }).selectOption('history');
  const field = page.locator('[data-place="/load/history"] input');
  await field.fill('600 0');
  const more = page.getByRole('button', { name: 'and once more' });
  await more.click();
  assert.equal(await field.inputValue(), '600 0 600 0');
  await more.click();
  assert.equal(await field.inputValue(), '600 0 600 0 600 0');
  await field.fill('100 0 200');
  await more.click();
  assert.equal(await field.inputValue(), '100 0 200 100 0 200');
});

service.test('two tags of one name are refused, and one without a name', async (page) => {
  await page.getByText('Mesh, solver, output, tags').click();
  const place = page.locator('[data-place="/tags"]');
  await place.locator('textarea').fill('a: 1\na: 2');
  await place.getByText('there are two tags “a”: a name stands for one').waitFor();
  await place.locator('textarea').fill(': x');
  await place.getByText('“: x” has no name before the colon').waitFor();
  await place.locator('textarea').fill('a: 1\nb: 2');
  await page.waitForFunction(() => document.querySelectorAll('[aria-invalid=true]').length === 0);
  assert.deepEqual((await draft(page)).tags, { a: '1', b: '2' });
});

service.test(
  'the onset of Hertz says that it does not know stress before the load',
  async (page) => {
    await unfold(page);
    await page.locator('[data-place="/lower/material/stress_kind"] select').selectOption('given');
    await page.locator('#check').getByText('not known beside stress before the load').waitFor();
  },
);
