/** Meshes that are refined to an accuracy: the choice, its time, and a figure that misses it. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { searchOf } from '../../../web/result/find.js';
import { progressOf } from '../../../web/result/progress.js';
import { timeWords } from '../../../web/setup/accuracy.js';
import { suite } from '../browser.js';
import { draft, follow, sent } from '../jobs.js';

/** @typedef {import('playwright-core').Page} Page */

const service = suite();

const FORCE = '[data-place="/load/force"] input[type=text]';
const STEEL = { young_modulus: 210000, poisson_ratio: 0.3 };
const ROLLER = { shape: { type: 'cylinder', radius: 20 }, material: STEEL };
/** Elastic rollers on a mesh that is far from 0.3 %, four times as fine too. */
const ROLLERS = {
  upper: ROLLER,
  lower: ROLLER,
  load: { force: 600 },
  mesh: { elements_per_half_width: 4 },
};

/** @param {Page} page */
const choice = (page) => page.locator('[data-place="/mesh/accuracy"] select');
/** @param {Page} page */
const options = (page) => choice(page).locator('option').allTextContents();
/** @param {Page} page @param {string} words */
const costs = (page, words) => page.locator('#cost').getByText(words).waitFor();
/** @param {Page} page */
const solve = (page) => page.getByRole('button', { name: 'Solve', exact: true }).click();

service.test('an accuracy is chosen, and taken back', async (page) => {
  assert.deepEqual(await options(page), ['Mesh as given', '3 %', '1 %', '0.3 %']);
  await choice(page).selectOption({ label: '1 %' });
  assert.equal((await draft(page)).mesh.accuracy, 0.01);
  await costs(page, 'at most 367');
  await page.getByLabel('Analysis').selectOption('three_dimensional');
  await costs(page, 'at most');
  assert.equal(await choice(page).inputValue(), '0.01', 'in three dimensions too');
  await choice(page).selectOption('');
  assert.equal('accuracy' in (await draft(page)).mesh, false);
});

service.test('an accuracy of a job as JSON stays, and goes with what is sent', async (page) => {
  await page.getByRole('button', { name: 'JSON', exact: true }).click();
  const job = { ...JSON.parse(await page.locator('#json-text').inputValue()), ...ROLLERS };
  job.mesh = { elements_per_half_width: 4, accuracy: 0.02 };
  await page.locator('#json-text').fill(JSON.stringify(job));
  await page.waitForFunction(
    () =>
      /** @type {HTMLSelectElement} */ (
        document.querySelector('[data-place="/mesh/accuracy"] select')
      ).value === '0.02',
  );
  assert.ok((await options(page)).includes('2 %'));
  await page.locator(FORCE).fill('700');
  const [request] = await Promise.all([
    page.waitForRequest((one) => one.method() === 'POST' && one.url().endsWith('/v1/jobs')),
    solve(page),
  ]);
  assert.deepEqual(request.postDataJSON().mesh, job.mesh);
  assert.equal(request.postDataJSON().load.force, 700);
});

service.test(
  'a solved mesh tells the times, and a figure that is missed is named',
  async (page) => {
    await follow(page, `job=${await sent(page, ROLLERS)}`);
    await page.locator('[data-status=succeeded]').waitFor();
    const told = async () => (await options(page)).slice(1).join();
    await page.waitForFunction(() =>
      document.querySelector('[data-place="/mesh/accuracy"]')?.textContent?.includes('at most'),
    );
    assert.match(
      await told(),
      /^3 %, about \S+ m?s,1 %, (about|at most) \S+ m?s,0.3 %, at most \S+ m?s$/,
    );
    await page.locator(FORCE).fill('601');
    assert.equal(await told(), '3 %,1 %,0.3 %', 'of another load they are not known');
    await page.locator(FORCE).fill('600');
    assert.match(await told(), /at most/);
    await choice(page).selectOption('0.003');
    await solve(page);
    await page.getByText('Keep in mind: accuracy missed').click();
    await page
      .locator('[data-code=accuracy_missed]')
      .getByText(/has ± \S+ %, on 16 elements/)
      .waitFor();
    assert.match(await told(), /0.3 %, at most/, 'told by the mesh before');
  },
);

service.test('a slider moves on one mesh, and is left on those of the accuracy', async (page) => {
  const asks = (/** @type {unknown} */ accuracy) =>
    page.waitForRequest(
      (one) => one.url().endsWith('/v1/solve') && one.postDataJSON().mesh.accuracy === accuracy,
    );
  await choice(page).selectOption('0.03');
  const place = page.locator('[data-place="/load/force"]');
  await place.getByRole('button', { name: 'Slider' }).click();
  const both = Promise.all([asks(undefined), asks(0.03)]);
  await place.getByRole('slider').press('ArrowRight');
  await both;
});

service.test('a search that asks for an accuracy is refused at its field', async (page) => {
  await page.getByRole('button', { name: 'JSON', exact: true }).click();
  const find = { vary: '/load/force', between: [300, 900], until: { peak_pressure: 900 } };
  const job = {
    ...JSON.parse(await page.locator('#json-text').inputValue()),
    ...ROLLERS,
    find,
    mesh: { accuracy: 0.01 },
  };
  await page.locator('#json-text').fill(JSON.stringify(job));
  const error = page.locator('[data-place="/mesh/accuracy"] .error');
  await error.getByText('searches and tolerances compare answers of one number').waitFor();
  await choice(page).selectOption('');
  await error.waitFor({ state: 'hidden' });
});

test('“What if” asks on one mesh', () => {
  const job = { ...ROLLERS, mesh: { elements_per_half_width: 4, accuracy: 0.01 } };
  const asked = searchOf(
    job,
    /** @type {any} */ ({ pointers: ['/load/force'] }),
    /** @type {any} */ ({ name: 'peak_pressure', body: null }),
    [300, 900],
    900,
  );
  assert.deepEqual(JSON.parse(JSON.stringify(asked)).mesh, ROLLERS.mesh);
});

test('no time left is told while meshes are refined', () => {
  const increment = { load: 5, loads: 20, number: 1, count: 2 };
  const history = [2000, 6000].map((elapsed_ms) => ({ iteration: 4, elapsed_ms, increment }));
  const words = (/** @type {object} */ mesh) =>
    progressOf(/** @type {any} */ (history), { mesh }).words;
  assert.equal(words({}), 'load 5 of 20, about 16 s left');
  assert.equal(words({ accuracy: 0.01 }), 'load 5 of 20');
});

test('times add those of all meshes up to the one that is fine enough', () => {
  const row = (/** @type {unknown} */ error, detail = false) => ({ error, detail });
  const report = /** @type {any} */ ({
    steps: [{ answers: [row(0.02), row('exact'), row(0.5, true)] }],
    timings_ms: { total: 1000 },
  });
  const words = (/** @type {number} */ asked, job = ROLLERS) =>
    timeWords(asked, job, { job: ROLLERS, report });
  assert.equal(words(0.03), 'about 1.0 s');
  // 1 + 1.5^2.3 + 2.25^2.3
  assert.equal(words(0.01), 'about 10 s');
  assert.equal(words(0.003), 'at most 51 s');
  assert.equal(words(0.01, { ...ROLLERS, mesh: { elements_per_half_width: 8 } }), 'about 4.9 s');
  assert.equal(words(0.01, { ...ROLLERS, load: { force: 2 } }), '');
  const typed = /** @type {any} */ ({ elements_per_half_width: 'many' });
  assert.equal(words(0.01, { ...ROLLERS, mesh: typed }), '');
});
