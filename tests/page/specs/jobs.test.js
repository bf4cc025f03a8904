/** Jobs of others and of before: links, list, search, comparison, downloads; with an API key. */

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFile } from 'node:fs/promises';
import { suite } from '../browser.js';
import { SI, drawn, follow, picture, sent, shown, solved } from '../jobs.js';

const service = suite();

service.test('a link shows a job and its definition', async (page) => {
  const id = await solved(page, { load: { force: 456 } });
  await follow(page, `job=${id}`);
  await page.locator('[data-status=succeeded]').waitFor();
  assert.equal(await page.getByLabel('Force P').inputValue(), '456');
  await page.getByLabel('Force P').fill('457');
  await page.getByText('The set-up has changed').waitFor();
  await page.getByRole('button', { name: 'Back to the job’s' }).click();
  assert.equal(await page.getByLabel('Force P').inputValue(), '456');
});

service.test(
  'a definition travels in a link by itself',
  async (page) => {
    await page.getByLabel('Force P').fill('321');
    await page.locator('#share-job').click();
    await page.getByText('Link to this definition copied').waitFor();
    const address = await page.evaluate(() => navigator.clipboard.readText());
    const other = await service.visit(address);
    await other.page.waitForFunction(
      () =>
        /** @type {HTMLInputElement} */ (
          document.querySelector('[data-place="/load/force"] input[type=text]')
        )?.value === '321',
    );
    await other.close();
  },
  { permissions: ['clipboard-read', 'clipboard-write'] },
);

service.test('jobs are listed, searched and laid over each other', async (page) => {
  await solved(page, { tags: { press: 'one' } });
  await solved(page, { tags: { press: 'two' }, load: { force: 300 } });
  await page.getByRole('button', { name: 'Jobs', exact: true }).click();
  const rows = page.locator('#jobs-list li');
  await page.getByLabel('Search jobs').fill('press:two');
  await page.waitForFunction(() => document.querySelectorAll('#jobs-list li').length === 1);
  await rows.locator('.open').click();
  await page.locator('[data-status=succeeded]').getByText('press: two').waitFor();
  await page.getByLabel('Search jobs').fill('one');
  await page.getByLabel('Compare one').check();
  const legend = page.locator('#panel-pressure .legend');
  await legend.getByText('one').waitFor();
  await legend.getByText('two').waitFor();
  await page.getByLabel('Compare one').uncheck();
  await legend.getByText('this contact').waitFor();
  await page.getByLabel('State', { exact: true }).selectOption('failed');
  await page.getByText('No job matches.').waitFor();
});

service.test('the peak of a job in SI is in pascals', async (page) => {
  const id = await solved(page, { ...SI, load: { force: 300e3 } });
  await page.getByRole('button', { name: 'Jobs', exact: true }).click();
  await page.getByLabel('Search jobs').fill(id);
  await page
    .locator('#jobs-list li')
    .getByText(/^peak 9\.\d+·10⁸ Pa$/)
    .waitFor();
});

service.test(
  'jobs of the list are cancelled at once and deleted after a question, by keyboard too',
  async (page) => {
    await page.getByRole('button', { name: 'Jobs', exact: true }).click();
    const compared = await solved(page, { tags: { press: 'beside' } });
    const id = await shown(page, { tags: { press: 'shown' } });
    await follow(page, `job=${id}&with=${compared}`);
    const legend = page.locator('#panel-pressure .legend');
    await legend.getByText('beside').waitFor();
    for (const [name, one] of /** @type {const} */ ([
      ['beside', compared],
      ['shown', id],
    ])) {
      const remove = page.getByRole('button', { name: `Delete ${name}` });
      await remove.focus();
      await page.keyboard.press('Enter');
      await page.keyboard.press('Escape');
      assert.equal(
        await page.evaluate(async (one) => (await fetch(`v1/jobs/${one}`)).status, one),
        200,
      );
      await remove.focus();
      await page.keyboard.press('Enter');
      await page.getByRole('dialog').getByText(`“${name}” and its result are removed`).waitFor();
      await page.keyboard.press('Enter');
      await remove.waitFor({ state: 'detached' });
      assert.equal(
        await page.evaluate(async (one) => (await fetch(`v1/jobs/${one}`)).status, one),
        404,
      );
      assert.notEqual(await page.evaluate(() => document.activeElement?.tagName), 'BODY');
    }
    await legend.getByText('this contact').waitFor();
    await page.locator('[data-status=removed]').waitFor();
    const long = {
      tags: { press: 'long' },
      mesh: { elements_per_half_width: 100 },
      load: { forces: [100, 200, 300] },
    };
    await sent(page, long);
    const cancel = page.getByRole('button', { name: 'Cancel long' });
    await cancel.focus();
    await page.keyboard.press('Enter');
    await page.locator('#jobs-list').getByText('Cancelled').waitFor();
    await page.getByRole('button', { name: 'Delete long' }).waitFor();
  },
);

service.test(
  'a job that another deletes is said to be, as soon as the list is fetched',
  async (page) => {
    await page.getByRole('button', { name: 'Jobs', exact: true }).click();
    const id = await shown(page, { load: { force: 321 } });
    await page.evaluate((id) => fetch(`v1/jobs/${id}`, { method: 'DELETE' }), id);
    await page.locator('[data-status=removed]').waitFor();
    assert.notEqual(await page.locator('#headline .figure').count(), 0, 'its figures stay');
  },
);

service.test('everything can be taken along', async (page) => {
  const id = await solved(page, { output: { fields: true }, solver: { theory: 'deformation' } });
  await follow(page, `job=${id}`);
  await page.locator('[data-status=succeeded]').waitFor();
  await page.getByText('Download', { exact: true }).click();
  // Flow theory alone has increments and surfaces, tracks have passes, half-spaces layers; one load
  // has no curve.
  const files = page.locator('.menu li:not(.of-panel) > button');
  assert.deepEqual(await files.allTextContents(), [
    'Result, JSON',
    'Job, JSON',
    'Pressure, CSV',
    'Depth profiles, CSV',
    'Field, VTU',
    'Pressure, SVG',
    'Depth profiles, SVG',
  ]);
  for (const button of await files.all()) {
    const name = await button.textContent();
    const [file] = await Promise.all([page.waitForEvent('download'), button.click()]);
    assert.equal(await file.failure(), null, `${name}`);
    assert.ok(file.suggestedFilename().startsWith(id.slice(-8)), file.suggestedFilename());
  }
});

// Chromium takes ten files in a burst from one page, so that pictures have a page of their own.
service.test('every panel is a picture', async (page) => {
  const id = await solved(page, { output: { fields: true } });
  await follow(page, `job=${id}`);
  await page.locator('[data-status=succeeded]').waitFor();
  await page.locator('.solver > summary').click();
  for (const panel of ['pressure', 'field', 'depth', 'convergence']) {
    const file = await picture(page, panel, 'PNG');
    assert.equal(file.suggestedFilename(), `${id.slice(-8)}-${panel}.png`);
  }
});

service.test('a loop is a picture too, on the ground of the page', async (page) => {
  const history = [{ force: 600 }, { force: 0 }];
  await shown(page, { load: { history }, solver: { theory: 'flow' } });
  const sweep = page.locator('#panel-sweep');
  await sweep.locator('.plot svg').waitFor();
  const file = await picture(page, 'sweep', 'PNG');
  const bytes = [...(await readFile(await file.path()))];
  const ink = await page.evaluate(async (bytes) => {
    const bitmap = await createImageBitmap(
      new Blob([new Uint8Array(bytes)], { type: 'image/png' }),
    );
    const { width, height } = bitmap;
    const context = new OffscreenCanvas(width, height).getContext('2d');
    context?.drawImage(bitmap, 0, 0);
    const { data } = context?.getImageData(0, 0, width, height) ?? { data: [] };
    const at = (/** @type {number} */ k) => `${data[4 * k]},${data[4 * k + 1]},${data[4 * k + 2]}`;
    const colours = new Map();
    for (let k = 0; k < width * height; k++) colours.set(at(k), (colours.get(at(k)) ?? 0) + 1);
    return { width, height, corner: at(0), colours: Object.fromEntries(colours) };
  }, bytes);
  const curve = await sweep.locator('.plot svg circle').first().getAttribute('fill');
  const rgb = [1, 3, 5].map((at) => parseInt(curve?.slice(at, at + 2) ?? '', 16)).join();
  assert.ok(ink.width > 300 && ink.height > 240, `${ink.width} × ${ink.height}`);
  assert.ok(ink.colours[ink.corner] > 0.7 * ink.width * ink.height, 'a ground');
  assert.ok(ink.colours[rgb] > 40, `a curve in ${rgb}`);
});

service.test(
  'a service that wants a key is given it',
  async (page, { server }) => {
    const key = execFileSync(
      server.binary,
      ['key', 'create', '--scope', 'write', '--data-dir', server.data, 'page'],
      {
        encoding: 'utf8',
      },
    );
    const token = /brn\S+|[\w.-]{30,}/.exec(key)?.[0] ?? '';
    await page.getByLabel('Key', { exact: true }).fill(token);
    await page.getByRole('button', { name: 'Use key' }).click();
    await page.getByText('1500.0 MPa').waitFor();
    await page.getByRole('button', { name: 'Solve', exact: true }).click();
    await page.locator('[data-status=succeeded]').waitFor();
  },
  { own: ['--require-api-key'], amiss: true },
);

for (const [name, options] of /** @type {const} */ ([
  ['wide', {}],
  ['narrow', { viewport: { width: 390, height: 844 } }],
])) {
  service.test(
    `nothing sticks out of a ${name} page`,
    async (page) => {
      await page.getByRole('button', { name: 'Solve', exact: true }).click();
      await page.locator('[data-status=succeeded]').waitFor();
      await drawn(page);
      const [inner, outer] = await page.evaluate(() => [
        document.documentElement.scrollWidth,
        innerWidth,
      ]);
      assert.ok(inner <= outer, `${inner} px in ${outer}`);
      const nameless = await page.evaluate(() =>
        [...document.querySelectorAll('button, input, select, textarea, [role=img]')]
          .filter(
            (one) =>
              one.checkVisibility() &&
              !(
                one.getAttribute('aria-label') ||
                one.getAttribute('aria-labelledby') ||
                one.textContent?.trim() ||
                /** @type {HTMLInputElement} */ (one).labels?.length
              ),
          )
          .map((one) => one.outerHTML),
      );
      assert.deepEqual(nameless, [], 'every control has a name');
    },
    options,
  );
}

service.test('a search looks through the jobs that are not shown yet', async (page) => {
  const oldest = await solved(page, { load: { force: 101 }, tags: { bench: 'north-7' } });
  for (const force of [102, 103]) await solved(page, { load: { force } });
  // As if there were more jobs than a page of the list holds.
  await page.route(/v1\/jobs\?limit=\d+/, (route) =>
    route.continue({
      url: route
        .request()
        .url()
        .replace(/limit=\d+/, 'limit=1'),
    }),
  );
  await page.getByRole('button', { name: 'Jobs', exact: true }).click();
  await page.getByText('1 shown', { exact: true }).waitFor();
  const rows = page.locator('#jobs-list li .open');
  for (const word of [oldest, oldest.slice(-8), 'north', 'bench:', 'bench:north-7']) {
    await page.getByLabel('Search jobs').fill('');
    await page.getByText('1 shown', { exact: true }).waitFor();
    await page.getByLabel('Search jobs').fill(word);
    await rows.getByText('bench: north-7').waitFor();
    assert.equal(await rows.count(), 1, word);
  }
});

service.test('jobs of a run are one row that opens and closes', async (page) => {
  for (const force of [310, 320])
    await solved(page, { load: { force }, tags: { run: 'one', varied: `Force ${force} N/mm` } });
  await page.getByRole('button', { name: 'Jobs', exact: true }).click();
  const run = page.getByRole('button', { name: /^2 jobs: Force 310 N\/mm … 320 N\/mm/ });
  const jobs = page.locator('#jobs-list li', { hasText: 'varied: Force' });
  await run.click();
  await jobs.getByText('cylinder R 20 on cylinder R 20, 310 N/mm, bilinear').waitFor();
  assert.equal(await jobs.count(), 2);
  assert.equal(await jobs.getByText('run: one').count(), 0);
  await run.click();
  await jobs.first().waitFor({ state: 'detached' });
});

service.test('the list says why older jobs do not come', async (page) => {
  for (const force of [201, 202]) await solved(page, { load: { force } });
  let refused = true;
  await page.route(/v1\/jobs\?limit=\d+/, (route) => {
    const url = route
      .request()
      .url()
      .replace(/limit=\d+/, 'limit=1');
    const older = url.includes('cursor=') && refused;
    return older
      ? route.fulfill({ status: 429, json: { detail: 'too many questions' } })
      : route.continue({ url });
  });
  await page.getByRole('button', { name: 'Jobs', exact: true }).click();
  await page.getByText('1 shown', { exact: true }).waitFor();
  await page.getByRole('button', { name: 'Older jobs' }).click();
  await page.getByText('Could not list the jobs: too many questions.').waitFor();
  refused = false;
  await page.getByRole('button', { name: 'Older jobs' }).click();
  await page.getByText('2 shown', { exact: true }).waitFor();
});

service.test('pictures of the convergence have both of its charts', async (page) => {
  await shown(page);
  await page.locator('.solver > summary').click();
  const file = await picture(page, 'convergence');
  const text = await readFile(await file.path(), 'utf8');
  for (const words of ['out-of-balance force', 'approach', 'peak pressure'])
    assert.ok(text.includes(words), words);
});
