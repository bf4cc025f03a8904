/**
 * A service that goes away in the middle, and comes back: nothing has to be loaded again by hand.
 */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { serve, suite } from '../browser.js';
import { drawn, follow, sent, solved } from '../jobs.js';

const service = suite();

/** A sweep that takes some seconds. */
const LONG = {
  mesh: { elements_per_half_width: 30 },
  load: { forces: Array.from({ length: 12 }, (_, k) => 100 * (k + 1)) },
  // Flow theory solves a list that rises as one history, and hands its loads over together.
  solver: { theory: 'deformation' },
  output: { fields: true },
};

test('a service that was killed is stopped all the same', { timeout: 20_000 }, async () => {
  const server = await serve();
  await server.kill();
  await server.stop();
});

service.test(
  'a running job that the service has lost is said to be removed',
  async (page, { server }) => {
    await page.getByText('1500.0 MPa').waitFor();
    // Longer than the slowest machine takes to see it begin.
    const forces = Array.from({ length: 600 }, (_, k) => k + 600);
    const id = await sent(page, { ...LONG, load: { forces }, output: { fields: false } });
    await follow(page, `job=${id}`);
    await page.locator('[data-status=running]').waitFor();
    await server.kill();
    await page.getByText('Connection lost, retrying').waitFor();
    // As a service answers that has come back without its data.
    await page.route(`**/v1/jobs/${id}*`, (route) =>
      route.fulfill({ status: 404, json: { detail: 'there is no such job' } }),
    );
    await page.route(`**/v1/jobs/${id}/**`, (route) =>
      route.fulfill({ status: 404, json: { detail: 'there is no such job' } }),
    );
    await server.again();
    await page
      .locator('[data-status=removed]')
      .getByText('press Solve to solve it again')
      .waitFor();
    assert.match(await page.title(), /^Removed/);
  },
  { own: ['--workers', '1'], amiss: true },
);

service.test(
  'a program of the page that does not come is asked for again',
  async (page) => {
    await page.getByText('1500.0 MPa').waitFor();
    let refused = 0;
    await page.route('**/result-worker.js', (route) => {
      refused += 1;
      return refused < 3 ? route.abort() : route.continue();
    });
    await page.getByRole('button', { name: 'Solve', exact: true }).click();
    await page.locator('[data-status=succeeded]').waitFor();
    await page.locator('#panel-figures tbody tr').first().waitFor();
    assert.ok(refused >= 3, `asked for ${refused} times`);
  },
  { amiss: true },
);

service.test(
  'a slider that begins while the service is away goes on when it is back',
  async (page, { server }) => {
    await page.getByText('1500.0 MPa').waitFor();
    const place = page.locator('[data-place="/load/force"]');
    await server.kill();
    await place.getByRole('button', { name: 'Slider' }).click();
    await place.getByRole('slider').press('ArrowRight');
    await page.getByText('Connection lost, retrying').waitFor();
    await server.again();
    await page.getByText('Connection lost, retrying').waitFor({ state: 'hidden' });
    await place.getByRole('slider').press('ArrowRight');
    await page.locator('[data-status=live]').getByText('solved in').waitFor();
  },
  { own: [], amiss: true },
);

service.test(
  'a job that is cut off in its middle is followed again, to an answer that can be read',
  async (page, { server }) => {
    await page.getByText('1500.0 MPa').waitFor();
    const id = await sent(page, LONG);
    await follow(page, `job=${id}`);
    await page.getByText(/^Load ([2-9]|1\d) of 12/).waitFor();
    await server.kill();
    await page.getByText('Connection lost, retrying').waitFor();
    await server.again();
    await page.locator('[data-status=succeeded]').waitFor({ timeout: 120_000 });
    assert.equal(await page.locator('#panel-figures tbody tr').count(), 12);
    await drawn(page);
    assert.equal(await page.getByText('Connection lost, retrying').isVisible(), false);
  },
  { own: ['--workers', '1'], amiss: true },
);

service.test(
  'a field whose service goes away while it comes is drawn when it is back',
  async (page, { server }) => {
    await page.getByText('1500.0 MPa').waitFor();
    const id = await solved(page, { ...LONG, mesh: { elements_per_half_width: 40 } });
    await follow(page, `job=${id}`);
    await drawn(page);
    let asked = 0;
    await page.route('**/fields/**', async (route) => {
      asked += 1;
      if (asked === 1) await server.kill();
      await route.continue().catch(() => {});
    });
    await page.getByLabel('Step', { exact: true }).press('Home');
    await page
      .getByText('Could not load the field of this step: the service does not answer')
      .waitFor();
    await server.again();
    await page.locator('#panel-field .stage:not(.stale)').waitFor();
    await page.locator('.waiting').waitFor({ state: 'hidden' });
    assert.match(
      (await page.locator('#panel-field .over').getAttribute('aria-label')) ?? '',
      /^Field of (von Mises stress|plastic strain)/,
    );
    await page.locator('.steps output').getByText('1 of 12').waitFor();
  },
  { own: [], amiss: true },
);
