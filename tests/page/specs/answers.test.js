/**
 * Answers that are lost, late, of somebody else or refused for now: what is said, and that the
 * page goes on by itself.
 */

import assert from 'node:assert/strict';
import { suite } from '../browser.js';

/** @typedef {import('playwright-core').Page} Page */
/** @typedef {import('playwright-core').Route} Route */

const service = suite();
const SOLVED = '[data-status=succeeded]';

/** @param {Page} page */
const solve = (page) => page.getByRole('button', { name: 'Solve', exact: true }).click();
/** @param {Page} page @param {string | RegExp} words */
const said = (page, words) => page.locator('#solve-state').getByText(words).waitFor();
/** @param {Page} page @returns {Promise<number>} */
const jobs = (page) =>
  page.evaluate(async () => (await (await fetch('v1/jobs')).json()).jobs.length);

/** Something that is let go. */
function gate() {
  let open = () => {};
  const opened = new Promise((resolve) => {
    open = () => resolve(undefined);
  });
  return { open, opened };
}

/** Does something else with the first jobs that are sent. @param {Page} page @param {...(route: Route) => Promise<void>} works */
async function atPost(page, ...works) {
  await page.route('**/v1/jobs', async (route) => {
    const work = route.request().method() === 'POST' ? works.shift() : undefined;
    await (work ? work(route) : route.continue());
  });
}

/** @param {number} status @param {string} [contentType] @param {string} [body] */
const answer =
  (status, contentType = 'text/html', body = '<h1>No</h1>') =>
  (/** @type {Route} */ route) =>
    route.fulfill({ status, contentType, body });

service.test(
  'a Solve whose answer is lost makes one job, and is followed when the service is back',
  async (page) => {
    await page.getByText('1500.0 MPa').waitFor();
    const { open, opened } = gate();
    await atPost(
      page,
      async (route) => {
        await route.fetch();
        await route.abort();
      },
      async (route) => {
        await opened;
        await route.abort();
      },
    );
    await solve(page);
    await said(
      page,
      'The service does not answer. The job is sent again when it does, and is made once.',
    );
    await page.getByText('Connection lost, retrying').waitFor({ state: 'hidden' });
    await said(page, 'The job is sent again when it does');
    open();
    await page.locator(SOLVED).waitFor();
    assert.equal(await page.locator('#solve-state').textContent(), '');
    assert.equal(await jobs(page), 1);
  },
  { own: [], amiss: true },
);

service.test(
  'another set-up goes before the one that waits to be sent, and an address that is followed before both',
  async (page) => {
    await page.getByText('1500.0 MPa').waitFor();
    const [first, second] = [gate(), gate()];
    // By the force that is sent: on a busy machine one is sent again.
    await page.route('**/v1/jobs', async (route) => {
      const force = route.request().postDataJSON()?.load.force;
      await (force === 400 ? second.opened : force === 500 ? undefined : first.opened);
      await route.continue().catch(() => {});
    });
    await solve(page);
    await page.getByLabel('Force P').fill('500');
    await solve(page);
    await page.locator('#headline').getByText('500.00').waitFor();
    first.open();
    const at = page.url();
    await page.getByLabel('Force P').fill('400');
    await solve(page);
    await page.evaluate(() => {
      location.hash = '';
    });
    await page.getByText('Begin with a picture').waitFor();
    second.open();
    await page.getByText('The job is made: the list of jobs has it').waitFor();
    assert.notEqual(page.url(), at);
    assert.equal(await page.locator(SOLVED).count(), 0);
  },
  { own: [], amiss: true },
);

service.test(
  'an answer of somebody else, and a queue that is full, are said and asked again',
  async (page) => {
    await page.getByText('1500.0 MPa').waitFor();
    const full = JSON.stringify({ status: 429, detail: 'as many jobs are waiting as may wait' });
    const soon = { 'Retry-After': '1' };
    await atPost(page, answer(200), (route) =>
      route.fulfill({
        status: 429,
        headers: soon,
        contentType: 'application/problem+json',
        body: full,
      }),
    );
    await solve(page);
    await said(page, /^Something else than the service answers, .* The job is sent again/);
    await said(
      page,
      'As many jobs are waiting as may wait. The job is sent again until it is taken.',
    );
    await page.locator(SOLVED).waitFor();
  },
  { amiss: true },
);

service.test(
  'what is refused for good is said in words',
  async (page) => {
    await page.getByText('1500.0 MPa').waitFor();
    await atPost(page, answer(413), answer(500), answer(404));
    for (const words of [
      'This is too large for the service: try fewer points or loads.',
      'The service is at fault, not what you asked.',
      'The service does not take this.',
    ]) {
      await solve(page);
      await said(page, words);
    }
    await solve(page);
    await page.locator(SOLVED).waitFor();
  },
  { amiss: true },
);

service.test(
  'a service that is silent is waited for, then counts as away, and the page goes on when it speaks',
  async (page) => {
    await page.clock.install();
    await page.reload();
    await page.getByText('1500.0 MPa').waitFor();
    let frozen = true;
    await page.route(/\/(v1\/(validate|hertz)|livez)/, (route) => {
      if (!frozen) return route.continue();
      if (route.request().url().endsWith('livez')) return route.abort();
    });
    const asked = page.waitForRequest('**/v1/validate');
    await page.getByLabel('Force P').fill('272.27');
    await asked;
    await page.clock.runFor(3000);
    await page.getByText('Waiting for the service…').waitFor();
    await page.clock.runFor(9000);
    await page.getByText('Connection lost, retrying…').waitFor();
    frozen = false;
    await page.clock.runFor(6000);
    await page.locator('.hertz dd').getByText('1000.0').waitFor();
    assert.equal(await page.locator('#connection').isVisible(), false);
  },
  { amiss: true },
);

service.test(
  'a job whose events are refused is followed by asking for its state',
  async (page) => {
    await page.getByText('1500.0 MPa').waitFor();
    let [refused, held] = [0, true];
    await page.route('**/events', (route) => answer(++refused % 2 ? 429 : 500)(route));
    await page.route(/\/v1\/jobs\/[^/?]+$/, (route) =>
      held ? answer(503)(route) : route.continue(),
    );
    await solve(page);
    await page.locator('#watch').getByText('No answer yet').waitFor();
    await page.locator('#watch').getByText('it is asked again').waitFor();
    held = false;
    await page.locator(SOLVED).waitFor();
    await page.locator('#panel-figures tbody tr').first().waitFor();
  },
  { amiss: true },
);

service.test(
  'a check that is refused once is made again, and leaves no alarm',
  async (page) => {
    await page.getByText('1500.0 MPa').waitFor();
    for (const [status, force, peak] of /** @type {[number, string, string][]} */ ([
      [503, '272.27', '1000.0'],
      [500, '612.6106', '1500.0'],
    ])) {
      await page.route('**/v1/{validate,hertz}', answer(status), { times: 2 });
      await page.getByLabel('Force P').fill(force);
      await page.locator('#check').getByText('The set-up is not checked yet').waitFor();
      await page.locator('.hertz dd').getByText(peak).waitFor();
      assert.equal(await page.locator('#check .error').count(), 0);
    }
  },
  { amiss: true },
);

service.test(
  'a slider leaves the way back as it is, and tells a service that is not ready from one that is away',
  async (page) => {
    await page.getByText('1500.0 MPa').waitFor();
    const before = await page.evaluate(() => history.length);
    const place = page.locator('[data-place="/load/force"]');
    await place.getByRole('button', { name: 'Slider' }).click();
    await place.getByRole('slider').press('ArrowRight');
    await page.locator('[data-status=live]').getByText('solved in').waitFor();
    assert.equal(await page.evaluate(() => history.length), before);
    await page.route('**/v1/solve', answer(503));
    await place.getByRole('slider').press('ArrowRight');
    await said(page, 'The service is not ready. Move the slider again, or press Solve.');
  },
  { amiss: true },
);

service.test(
  'where Hertz’s theory does not apply it is not asked, and the form says why',
  async (page) => {
    let asked = 0;
    page.on('request', (request) => {
      if (request.url().endsWith('/v1/hertz')) asked += 1;
    });
    for (const [example, why] of [
      ['Pin in a hole', 'one body lies within the other'],
      ['Crowned face from measured points', 'it takes round surfaces, and a profile is none'],
    ]) {
      await page.locator('#example').selectOption({ label: example });
      await page.locator('#check').getByText(`Hertz’s theory does not apply: ${why}`).waitFor();
    }
    await page.getByLabel('Shape').first().selectOption('wedge');
    await page.locator('#check').getByText('and a wedge is none').waitFor();
    assert.equal(asked, 0);
  },
);
