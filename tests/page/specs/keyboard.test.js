/** Every task by keyboard alone. */

import assert from 'node:assert/strict';
import { suite } from '../browser.js';
import { draft, drawn, follow, solved } from '../jobs.js';

/** @typedef {import('playwright-core').Page} Page */

const service = suite();
const SOLVED = '[data-status=succeeded]';

/** What has the cursor, by its name. @param {Page} page */
const name = (page) =>
  page.evaluate(() => {
    const at = /** @type {HTMLElement | null} */ (document.activeElement);
    return (
      at?.getAttribute('aria-label') ??
      document.getElementById(at?.getAttribute('aria-labelledby') ?? '')?.textContent ??
      /** @type {HTMLInputElement | null} */ (at)?.labels?.[0]?.textContent ??
      at?.textContent ??
      ''
    ).trim();
  });

/** How many buttons a toolbar has that are seen, if the cursor is in one. @param {Page} page */
const alongside = (page) =>
  page.evaluate(() => {
    const bar = document.activeElement?.closest('[role=toolbar]');
    return bar
      ? [...bar.querySelectorAll('button, a')].filter((one) => one.checkVisibility()).length
      : 1;
  });

/** @param {Page} page @param {RegExp} wanted */
async function tabTo(page, wanted) {
  for (let k = 0; k < 160; k++) {
    await page.keyboard.press('Tab');
    for (let more = await alongside(page); more > 0; more--) {
      if (wanted.test(await name(page))) return;
      if (more > 1) await page.keyboard.press('ArrowRight');
    }
  }
  assert.fail(`Tab never comes to ${wanted}`);
}

/** @param {Page} page @param {RegExp} wanted @param {...string} keys */
async function press(page, wanted, ...keys) {
  await tabTo(page, wanted);
  for (const key of keys) await page.keyboard.press(key);
}

/** @param {Page} page @param {RegExp} wanted @param {string} text */
async function type(page, wanted, text) {
  await press(page, wanted, 'Control+A');
  await page.keyboard.type(text);
}

service.test('set up, solve, look around in the field', async (page) => {
  await page.keyboard.press('Tab');
  assert.equal(await name(page), 'Skip to the result');
  await type(page, /^Radius/, '25');
  await type(page, /^Material/, 'Rail');
  await press(page, /^From hardness/, 'Enter');
  await page.getByRole('dialog').waitFor();
  await page.keyboard.type('300');
  await press(page, /^Use$/, 'Enter');
  await type(page, /^Given/, 'Sweep');
  await type(page, /^Forces/, '100 300 612');
  await page.keyboard.press('F1');
  await page.locator('[popover]:popover-open').waitFor();
  await page.keyboard.press('Escape');
  await press(page, /^Solve$/, 'Enter');
  await page.locator(SOLVED).waitFor();
  const { upper, load } = await draft(page);
  assert.deepEqual([upper.shape.radius, upper.material.plasticity.yield_stress], [25, 772]);
  assert.deepEqual(load, { forces: [100, 300, 612] });
  await drawn(page);
  await press(page, /^Step$/, 'Home');
  await page.locator('.steps output').getByText('1 of 3').waitFor();
  await press(page, /^von Mises$/, 'Space');
  await page
    .locator('#panel-depth .legend')
    .getByText('von Mises', { exact: true })
    .waitFor({ state: 'detached' });
  await press(page, /^Shown$/, 'End');
  await press(page, /^Cut$/, 'Space');
  await press(page, /^Field of displacement uy/, '+', 'ArrowUp');
  await page.getByText(/^(upper|lower) body, x/).waitFor();
  await type(page, /^Cut from x$/, '0.05');
  await page.keyboard.press('Enter');
  await page.locator('.cut .plot[aria-label^="displacement uy along the cut"]').waitFor();
});

service.test(
  'compare, copy, take along, report',
  async (page) => {
    const [one, other] = [await solved(page, {}), await solved(page, { load: { force: 300 } })];
    await follow(page, `job=${one}`);
    await page.locator(SOLVED).waitFor();
    await press(page, /^Jobs$/, 'Enter');
    await press(page, new RegExp(`^Compare .*${other.slice(-8)}`), 'Space');
    await page.locator('#panel-differences tbody tr').first().waitFor();
    await press(page, /^Download$/, 'Enter');
    await press(page, /^Markdown: figures$/, 'Enter');
    await page.getByText('Markdown copied').waitFor();
    const [file] = await Promise.all([
      page.waitForEvent('download'),
      press(page, /^Pressure, CSV$/, 'Enter'),
    ]);
    assert.match(file.suggestedFilename(), /pressure\.csv$/);
    await page.keyboard.press('Escape');
    assert.equal(await page.locator('details.menu[open]').count(), 0);
    await press(page, /^Report$/, 'Enter');
    assert.equal(await name(page), 'Print or save as PDF');
    await press(page, /^Back$/, 'Enter');
    assert.equal(await name(page), 'Report', 'the cursor is where it was');
    await press(page, /^Units shown$/, 'Enter');
    await press(page, /^Unit of length$/, 'ArrowDown', 'ArrowDown');
    await page.locator('#headline').getByText('µm').first().waitFor();
  },
  { permissions: ['clipboard-read', 'clipboard-write'] },
);

service.test('write the job, undo, move a slider', async (page) => {
  await press(page, /^JSON$/, 'Enter');
  await press(page, /^Job as JSON/, 'Control+A');
  const job = JSON.parse(await page.locator('#json-text').inputValue());
  await page.keyboard.insertText(JSON.stringify({ ...job, load: { force: 400 } }));
  const force = page.locator('[data-place="/load/force"] input[type=text]');
  await page.waitForFunction(
    () => JSON.parse(sessionStorage.getItem('draft') ?? 'null')?.load.force === 400,
  );
  await press(page, /^Undo$/, 'Enter');
  assert.equal(await force.inputValue(), '612.6106');
  await tabTo(page, /^Force/);
  await page.keyboard.press('F2');
  await page.keyboard.press('ArrowRight');
  await page.locator('[data-status=live]').waitFor();
  assert.notEqual(await force.inputValue(), '612.6106');
});

service.test(
  'from the first field to Solve there is a stop for each field',
  async (page) => {
    const stops = /** @type {string[]} */ ([]);
    while (stops.at(-1) !== 'Solve' && stops.length < 100) {
      await page.keyboard.press('Tab');
      stops.push(await name(page));
    }
    assert.equal(stops.length, 21, stops.join(' | '));
    assert.deepEqual(
      stops.filter((one) => /^(Explanation|Slider)$/.test(one)),
      [],
    );
    const first = stops.findIndex((one) => one.startsWith('Analysis'));
    const fields = await page
      .locator('#form :is(input, select, textarea)')
      .evaluateAll((all) => all.filter((one) => one.checkVisibility()).length);
    // Beside the fields: the tools of both materials, “more”, Solve.
    assert.equal(stops.length - first, fields + 4, stops.join(' | '));
  },
  { few: true },
);

service.test('arrows go along a toolbar, and Tab leaves it', async (page) => {
  await tabTo(page, /^From hardness/);
  await page.keyboard.press('ArrowRight');
  assert.match(await name(page), /^Hardness test/);
  await page.keyboard.press('ArrowRight');
  assert.match(await name(page), /^Keep as own/);
  await page.keyboard.press('ArrowRight');
  assert.match(await name(page), /^From hardness/, 'from the last to the first');
  await page.keyboard.press('End');
  await page.keyboard.press('Shift+Tab');
  assert.match(await name(page), /^Material/);
  await page.keyboard.press('Tab');
  await page.keyboard.press('Tab');
  assert.match(await name(page), /^Material’s name/);
});

service.test('open points from a file', async (page) => {
  await type(page, /^Hardening/, 'Table');
  const [chooser] = await Promise.all([
    page.waitForEvent('filechooser'),
    press(page, /^Open CSV…$/, 'Enter'),
  ]);
  const buffer = Buffer.from('strain;stress [MPa]\n0;500\n0,01;600\n0,1;750\n');
  await chooser.setFiles({ name: 'points.csv', mimeType: 'text/csv', buffer });
  await page.waitForFunction(
    () =>
      JSON.parse(sessionStorage.getItem('draft') ?? 'null')?.upper.material.plasticity.points
        ?.length === 3,
  );
  const { plasticity } = (await draft(page)).upper.material;
  assert.deepEqual(plasticity.points.map(Object.values), [
    [0, 500],
    [0.01, 600],
    [0.1, 750],
  ]);
});

service.test(
  'copy links',
  async (page) => {
    await press(page, /^Link$/, 'Enter');
    await page.getByText('Link to this definition copied').waitFor();
    const clipboard = () => page.evaluate(() => navigator.clipboard.readText());
    assert.match(await clipboard(), /#draft=./);
    await press(page, /^Solve$/, 'Enter');
    await page.locator(SOLVED).waitFor();
    await press(page, /^Copy link$/, 'Enter');
    await page.getByText('Link copied').waitFor();
    assert.equal(await clipboard(), page.url());
  },
  { permissions: ['clipboard-read', 'clipboard-write'] },
);

service.test(
  'give a key, or leave the question by Escape and ask for it again',
  async (page) => {
    const dialog = page.getByRole('dialog');
    await dialog.waitFor();
    await page.keyboard.press('Escape');
    await dialog.waitFor({ state: 'hidden' });
    await press(page, /^API key$/, 'Enter');
    await dialog.waitFor();
    await tabTo(page, /^Key$/);
    await page.keyboard.type('not-a-key');
    await page.keyboard.press('Enter');
    await dialog.getByText('The service does not know this key').waitFor();
  },
  { own: ['--require-api-key'], amiss: true },
);

service.test('two links before everything lead to the result and to Solve', async (page) => {
  for (const [stops, id] of /** @type {const} */ ([
    [1, 'result'],
    [2, 'solve'],
  ])) {
    await page.evaluate(() => /** @type {HTMLElement | null} */ (document.activeElement)?.blur());
    await page.reload();
    await page.getByText('1500.0 MPa').waitFor();
    for (let k = 0; k < stops; k++) await page.keyboard.press('Tab');
    const seen = await page.evaluate(
      () => document.activeElement?.getBoundingClientRect().left ?? -1,
    );
    assert.ok(seen >= 0, 'the link is seen');
    await page.keyboard.press('Enter');
    assert.equal(await page.evaluate(() => document.activeElement?.id), id);
  }
});
