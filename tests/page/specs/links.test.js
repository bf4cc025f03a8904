/**
 * The address says what is seen: damaged links, jobs that are gone, back and forward, loading
 * again.
 */

import assert from 'node:assert/strict';
import { suite } from '../browser.js';
import { draft, follow, shown, solved } from '../jobs.js';

/** @typedef {import('playwright-core').Page} Page */

const service = suite();
const FORCE = '[data-place="/load/force"] input[type=text]';
const STALE = 'The set-up has changed since this job was sent.';

/** @param {Page} page @returns {Promise<string>} a link to the definition in the form */
const definition = (page) =>
  page.evaluate(async () => {
    const { draftLink } = await import(/** @type {any} */ ('/web/jobs/link.js'));
    return draftLink({
      ...JSON.parse(sessionStorage.getItem('draft') ?? '{}'),
      load: { force: 321 },
    });
  });

service.test(
  'a damaged link is said to be one, and shows nothing of what was seen before',
  async (page) => {
    await page.locator(FORCE).fill('400');
    await page.getByRole('button', { name: 'Solve', exact: true }).click();
    await page.locator('#headline').getByText('400.00').waitFor();
    const link = await definition(page);
    await follow(page, new URL(link.slice(0, -30)).hash);
    await page.locator('#headline').getByText('This link is damaged').waitFor();
    assert.equal(await page.locator('#watch *').count(), 0);
    assert.equal(await page.locator('#panel-figures').isVisible(), false);
    assert.equal(await page.getByText(STALE).isVisible(), false);
    assert.equal(await page.locator(FORCE).inputValue(), '612.6106', 'the first example');
    await page.goBack();
    await page.locator('#headline').getByText('400.00').waitFor();
  },
);

service.test('a job that is gone leaves nothing of the one before', async (page) => {
  await shown(page, { load: { force: 300 } });
  await page.locator(FORCE).fill('301');
  await page.getByText(STALE).waitFor();
  await follow(page, 'job=0197e1f0-0000-7000-8000-000000000000');
  await page.getByText('This link leads to a job that is not here').waitFor();
  assert.equal(await page.getByText(STALE).isVisible(), false);
  assert.equal(await page.locator(FORCE).inputValue(), '301', 'what was set up stays');
});

service.test('an address without a job shows none', async (page) => {
  await page.locator(FORCE).fill('400');
  await page.getByRole('button', { name: 'Solve', exact: true }).click();
  await page.locator('#headline').getByText('400.00').waitFor();
  await page.goBack();
  await page.locator('#headline').getByText('Begin with a picture').waitFor();
  await page.locator('#panel-pressure .plot').waitFor();
  assert.equal(await page.getByRole('button', { name: 'Copy link' }).count(), 0);
  await page.goForward();
  await page.locator('#headline').getByText('400.00').waitFor();
});

service.test('what was changed at an address is kept when it is loaded again', async (page) => {
  await shown(page, { load: { force: 300 } });
  await page.locator(FORCE).fill('301');
  await page.reload();
  await page.locator('#headline').getByText('300.00').waitFor();
  await page.getByText(STALE).waitFor();
  assert.equal(await page.locator(FORCE).inputValue(), '301');
  const other = await solved(page, { load: { force: 500 } });
  await page.getByRole('button', { name: 'Jobs', exact: true }).click();
  await page.getByLabel(new RegExp(`^Compare .*${other.slice(-8)}`)).check();
  await page.locator('#panel-figures tbody tr').nth(1).waitFor();
  await page.reload();
  await page.getByText(STALE).waitFor();
  assert.equal(await page.locator(FORCE).inputValue(), '301', 'a comparison changes the address');
  const link = await definition(page);
  await follow(page, new URL(link).hash);
  await page.waitForFunction(
    (field) => /** @type {HTMLInputElement} */ (document.querySelector(field))?.value === '321',
    FORCE,
  );
  await page.locator(FORCE).fill('322');
  await page.reload();
  await page.getByText('Begin with a picture').waitFor();
  assert.equal((await draft(page)).load.force, 322);
  assert.equal(await page.locator(FORCE).inputValue(), '322');
});

service.test(
  'jobs are gone through back and forth in a hurry, and the last one is seen',
  async (page) => {
    const forces = [200, 300, 400, 500];
    for (const force of forces) {
      const id = await solved(page, { load: { force }, output: { fields: true } });
      await follow(page, `job=${id}`);
      await page.locator('#headline').getByText(`${force}.00`).waitFor();
    }
    await page.evaluate(async () => {
      const gone = () =>
        new Promise((resolve) => addEventListener('popstate', resolve, { once: true }));
      for (const step of [-1, -1, -1, 1, -1, 1, 1, -1, -1, 1]) {
        const there = gone();
        history.go(step);
        await there;
      }
    });
    await page.locator('#headline').getByText('300.00').waitFor();
    assert.equal(await page.locator(FORCE).inputValue(), '300');
    await page.waitForFunction(
      () => document.querySelectorAll('#panel-figures tbody tr').length === 1,
    );
    await page.locator('#panel-figures tbody').getByText('300.00').waitFor();
    assert.equal(await page.getByText(STALE).isVisible(), false);
  },
);

service.test(
  'a slider goes on after a job that is gone, and a report of it names no job',
  async (page) => {
    await shown(page, { load: { force: 300 } });
    const place = page.locator('[data-place="/load/force"]');
    await place.getByRole('button', { name: 'Slider' }).click();
    const live = page.locator('[data-status=live]').getByText('solved in');
    await place.getByRole('slider').press('ArrowRight');
    await live.waitFor();
    await follow(page, 'job=0197e1f0-0000-7000-8000-000000000000');
    await page.getByText('This link leads to a job that is not here').waitFor();
    await follow(page, '');
    await page.locator('#headline').getByText('Begin with a picture').waitFor();
    await place.getByRole('slider').press('ArrowRight');
    await live.waitFor();
    await page.getByRole('button', { name: 'Report' }).click();
    const foot = page.locator('.sheet-foot');
    await foot.getByText('solved beside a slider and kept as no job').waitFor();
    assert.equal(await foot.locator('.link').count(), 0);
  },
);

service.test(
  'a link that names no job is called damaged, and nothing is asked for',
  async (page) => {
    const asked = /** @type {string[]} */ ([]);
    page.on('request', (request) => asked.push(request.url()));
    await page.evaluate(() => {
      location.hash = 'job=../../livez?&with=../metrics';
    });
    await page.getByText('This link is damaged: it does not name a job.').waitFor();
    assert.deepEqual(
      asked.filter((url) => /livez|metrics|request/.test(url)),
      [],
    );
  },
);

service.test(
  'another address is followed although the answer of a slider comes first',
  async (page) => {
    // The event of a new address is let go by hand: it may be as late as the page is busy.
    await page.addInitScript(() => {
      const held = /** @type {Event[]} */ ([]);
      let holding = false;
      addEventListener('hashchange', (event) => {
        if (!holding) return;
        event.stopImmediatePropagation();
        held.push(event);
      });
      Object.assign(window, {
        hold: () => {
          holding = true;
        },
        letGo: () => {
          holding = false;
          dispatchEvent(new Event('hashchange'));
        },
      });
    });
    await page.reload();
    await shown(page, { load: { force: 300 } });
    const place = page.locator('[data-place="/load/force"]');
    await place.getByRole('button', { name: 'Slider' }).click();
    let answer = () => {};
    const held = new Promise((resolve) => {
      answer = () => resolve(undefined);
    });
    await page.route('**/v1/solve', async (route) => {
      await held;
      await route.continue();
    });
    // What a slider has solved is removed from the service before it is shown.
    const answered = page.waitForResponse((response) => response.request().method() === 'DELETE');
    await place.getByRole('slider').press('ArrowRight');
    await page.evaluate('hold()');
    await follow(page, 'job=0197e1f0-0000-7000-8000-000000000000');
    answer();
    await answered;
    assert.match(page.url(), /#job=0197e1f0-0000-7000-8000-000000000000$/);
    await page.evaluate('letGo()');
    await page.getByText('This link leads to a job that is not here').waitFor();
  },
);

service.test(
  'a job that was removed while it is shown is said to be, and its report has no link',
  async (page) => {
    const id = await shown(page, { load: { force: 300 } });
    await page.evaluate((id) => fetch(`v1/jobs/${id}`, { method: 'DELETE' }), id);
    await page.getByRole('button', { name: 'Report' }).click();
    const foot = page.locator('.sheet-foot');
    await foot.getByText('The service no longer has it.').waitFor();
    assert.equal(await foot.locator('.link').count(), 0);
    await page.keyboard.press('Escape');
    await page
      .locator('[data-status=removed]')
      .getByText('The service no longer has this job.')
      .waitFor();
    assert.equal(await page.getByRole('button', { name: 'Copy link' }).count(), 0);
    assert.match(await page.title(), /^Removed/);
    await page.locator('#headline').getByText('300.00').waitFor();
  },
);

service.test(
  'a link to more jobs than can be told apart names those that are shown',
  async (page) => {
    const ids = [];
    for (let k = 0; k < 8; k++) ids.push(await solved(page, { load: { force: 300 + k } }));
    await follow(page, `job=${ids[0]}&with=${ids.join()}`);
    await page.waitForFunction(
      () => document.querySelectorAll('#panel-differences thead th').length === 7,
    );
    assert.equal(
      await page.evaluate(() => location.hash),
      `#job=${ids[0]}&with=${ids.slice(1, 6).join()}`,
    );
  },
);
