/** What goes wrong is said where it went wrong. */

import assert from 'node:assert/strict';
import { suite } from '../browser.js';
import { follow, sent } from '../jobs.js';

const service = suite(['--workers', '1']);

service.test('wrong input shows at its field, and goes when it is put right', async (page) => {
  const ratio = page.getByLabel('Poisson’s ratio').nth(1);
  await ratio.fill('0.6');
  const entry = page.locator('[data-place="/lower/material/poisson_ratio"]');
  await entry.getByText('must be between 0 and 0.499999, got 0.6').waitFor();
  assert.equal(await ratio.getAttribute('aria-invalid'), 'true');
  assert.match((await ratio.getAttribute('aria-describedby')) ?? '', /-error/);
  await page.getByLabel('Radius').first().fill('twenty');
  await page
    .locator('[data-place="/upper/shape/radius"] .error')
    .getByText(/number/)
    .waitFor();
  await page.getByLabel('Radius').first().fill('20');
  await ratio.fill('0,3');
  await page.waitForFunction(() => document.querySelectorAll('[aria-invalid=true]').length === 0);
});

service.test('a refused job takes the cursor to its fault', async (page) => {
  await page.getByLabel('Force P').fill('-5');
  await page.getByRole('button', { name: 'Solve', exact: true }).click();
  await page.waitForFunction(
    () => document.activeElement?.getAttribute('aria-invalid') === 'true',
  );
  assert.equal(
    await page.getByLabel('Force P').evaluate((input) => input === document.activeElement),
    true,
  );
});

service.test('an unknown key in the JSON is named although no field has it', async (page) => {
  await page.getByRole('button', { name: 'JSON', exact: true }).click();
  await page.getByText('1500.0 MPa').waitFor();
  const job = JSON.parse(await page.locator('#json-text').inputValue());
  await page.locator('#json-text').fill(JSON.stringify({ ...job, colour: 'red' }));
  await page.locator('#check').getByText('/colour').waitFor();
});

const SOFT = {
  shape: { type: 'cylinder', radius: 20 },
  material: {
    young_modulus: 210000,
    poisson_ratio: 0.3,
    plasticity: { law: 'bilinear', yield_stress: 500, tangent_modulus: 0 },
  },
};
/**
 * A job that iterates until it is stopped: perfect plasticity in plane stress, which strong
 * coupling never gets to rest.
 */
const ENDLESS = {
  analysis: 'plane_stress',
  upper: SOFT,
  lower: SOFT,
  load: { force: 673.2 },
  solver: { coupling: 'strong', tolerance: 1e-12, max_iterations: 100000 },
  mesh: { elements_per_half_width: 40 },
};

service.test('a job is cancelled, and those behind it know their place', async (page) => {
  const slow = await sent(page, ENDLESS);
  const waiting = await sent(page, ENDLESS);
  await follow(page, `job=${waiting}`);
  await page.locator('[data-status=queued]').getByText('next in line').waitFor();
  await follow(page, `job=${slow}`);
  await page.locator('[data-status=running]').waitFor();
  await page.locator('.so-far progress').waitFor();
  // Of a preliminary solve there are no figures.
  const iterations = (/** @type {string} */ id) =>
    fetch(`v1/jobs/${id}`).then(async (answer) => (await answer.json()).progress.iterations);
  while ((await page.evaluate(iterations, slow)) === 0);
  await page.getByRole('button', { name: 'Cancel' }).click();
  await page.locator('[data-status=cancelled]').waitFor();
  await page.getByText('its figures are no answer').waitFor();
  await page.evaluate((id) => fetch(`v1/jobs/${id}/cancel`, { method: 'POST' }), waiting);
});

service.test('a link to a job that is not here says so', async (page) => {
  await follow(page, `job=0197e1f0-0000-7000-8000-000000000000`);
  await page.getByText('This link leads to a job that is not here').waitFor();
});

service.test(
  'a service that goes away is said beside the button, and the page goes on when it is back',
  async (page, { server }) => {
    await page.getByText('1500.0 MPa').waitFor();
    await server.kill();
    await page.getByRole('button', { name: 'Solve', exact: true }).click();
    const said = page.locator('#solve-state');
    await said
      .getByText('The service does not answer. The job is sent again when it does')
      .waitFor();
    assert.equal(
      await said.evaluate(
        (one) => one.checkVisibility() && one.getBoundingClientRect().bottom <= innerHeight,
      ),
      true,
    );
    await page.getByText('Connection lost, retrying').waitFor();
    await server.again();
    await page.getByText('Connection lost, retrying').waitFor({ state: 'hidden' });
    await page.locator('[data-status=succeeded]').waitFor();
    assert.equal(await said.textContent(), '');
  },
  { own: [], amiss: true },
);

service.test(
  'a key that the service does not know is called wrong, and a link to a job asks for one',
  async (page) => {
    const dialog = page.getByRole('dialog');
    await dialog.getByText('This service asks for a key').waitFor();
    await page.getByLabel('Key', { exact: true }).fill('not-a-key');
    await page.getByRole('button', { name: 'Use key' }).click();
    await dialog.getByText('The service does not know this key').waitFor();
    await page.getByText('This job is shown to holders of an API key.').waitFor();
  },
  { own: ['--require-api-key'], hash: '#job=0197e1f0-0000-7000-8000-000000000000', amiss: true },
);

service.test('messages speak the language of the form', async (page) => {
  await page.getByLabel('Tangent modulus').first().fill('300000');
  const error = page.locator('[data-place="/upper/material/plasticity/tangent_modulus"] .error');
  await error.getByText('must be less than Young’s modulus').waitFor();
  assert.doesNotMatch((await error.textContent()) ?? '', /_/);
  await page.getByLabel('Radius').first().fill('1e-9');
  const radius = page.locator('[data-place="/upper/shape/radius"] .error');
  await radius.getByText('must be between').waitFor();
  assert.doesNotMatch((await radius.textContent()) ?? '', /_/);
  await page.getByLabel('Given').selectOption('forces');
  await page.locator('[data-place="/load/forces"] input').fill('');
  await page
    .locator('[data-place="/load/forces"] .error')
    .getByText('is empty: 1 to 1000 are needed')
    .waitFor();
});
