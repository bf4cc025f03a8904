/** The draft beside its form: faulty texts, other analyses and units, definitions of others. */

import assert from 'node:assert/strict';
import { suite } from '../browser.js';
import { draft } from '../jobs.js';

const service = suite();

const FORCE = '[data-place="/load/force"] input[type=text]';

/** @param {import('playwright-core').Page} page @param {string} text that the field is to show */
const shows = (page, text) =>
  page.waitForFunction(
    ([field, text]) => /** @type {HTMLInputElement} */ (document.querySelector(field))?.value === text,
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
  await page.getByRole('button', { name: 'Give up, take the form’s' }).click();
  assert.equal(JSON.parse(await text.inputValue()).load.force, 500);
  await text.fill(`\ufeff${broken.replace(',,', '')}`);
  await page.locator('#json-state').getByText('in step').waitFor();
  await shows(page, '612.6106');
});

service.test('another analysis has the load of a millimetre as a whole, in either units, and says so', async (page) => {
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
});

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
      /** @type {HTMLInputElement} */ (document.querySelector('[data-place="/load/history"] input'))?.value === '{} 5',
  );
});
