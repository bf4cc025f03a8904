/** A service that goes away in the middle, and comes back: nothing has to be loaded again by hand. */

import assert from 'node:assert/strict';
import { suite } from '../browser.js';
import { follow, sent, solved } from '../jobs.js';

const service = suite();

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
