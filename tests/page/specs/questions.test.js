/** Tiles follow the question: what was asked comes first. */

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';
import { vickersOf } from '../../../web/setup/from-hardness.js';
import { suite } from '../browser.js';
import { shown, solved, follow, steel, taken } from '../jobs.js';

const service = suite();

/** @param {import('playwright-core').Page} page */
const cards = (page) => page.locator('#headline dl dt').allTextContents();
/** @param {import('playwright-core').Page} page @param {string} name */
const card = (page, name) =>
  page.locator('#headline dl > div', { has: page.getByText(name, { exact: true }) });
/** The row of the table of all figures. @param {import('playwright-core').Page} page @param {string} name */
async function row(page, name) {
  const table = page.locator('#headline .rest details');
  if ((await table.getAttribute('open')) === null) await table.locator('summary').click();
  return table.locator('tr', { has: page.getByText(name, { exact: true }) });
}

service.test(
  'a force that is looked for comes first, and so does an onset of yield',
  async (page) => {
    await shown(page, { load: { target: { peak_pressure: 900 } } });
    assert.equal((await cards(page))[0], 'Force found');
    await shown(page, { load: { onset: true } });
    assert.equal((await cards(page))[0], 'First yield');
  },
);

service.test(
  'a case says how much of its strength is used, and that of the core',
  async (page) => {
    const law = { law: 'bilinear', yield_stress: 1000, tangent_modulus: 2100 };
    const over_depth = { hardness: { surface: 720, core: 380, case_depth: 1 } };
    const body = {
      shape: { type: 'cylinder', radius: 20 },
      material: { ...steel(), plasticity: { ...law, over_depth } },
    };
    await shown(page, { upper: body, lower: body, load: { force: 1500 } });
    assert.deepEqual((await cards(page)).slice(0, 3), [
      'Utilization',
      'Margin to first yield',
      'Core utilization',
    ]);
    await (await row(page, 'Core utilization')).getByText('below the case').waitFor();
    const depth = page.locator('#panel-depth');
    await depth.locator('.legend').getByText('utilization', { exact: true }).waitFor();
    const [file] = await Promise.all([
      page.waitForEvent('download'),
      taken(page, 'Save stress over depth as SVG'),
    ]);
    const drawing = await readFile(await file.path(), 'utf8');
    for (const words of ['case depth', /utilization \d+\.?\d* %/, 'depth at x = 0'])
      assert.match(drawing, new RegExp(words));
    // One of the two is read on the right.
    await depth.locator('[data-component=equivalent_plastic_strain]').click();
    await depth
      .locator('.legend')
      .getByText('utilization', { exact: true })
      .waitFor({ state: 'detached' });
    await shown(page, { load: { force: 300 } });
    assert.equal(await depth.locator('[data-component=utilization]').count(), 0);
  },
);

service.test('rolling shakes down up to a pressure that is said', async (page) => {
  await shown(page, { load: { force: 612.6106 } });
  const limit = await row(page, 'Shakedown pressure');
  await limit.getByText(/Hertz's peak is 1\.30? times that/).waitFor();
});

service.test('the stress that is left has the names of axisymmetry', async (page) => {
  const history = [{ force: 5000 }, { force: 0 }];
  await shown(page, { analysis: 'axisymmetric', load: { history }, solver: { theory: 'flow' } });
  assert.deepEqual((await cards(page)).slice(0, 3), ['Dent', 'Pile-up', 'Permanent approach']);
  const tension = await row(page, 'Residual tension');
  await tension.getByText(/\bof all /).waitFor();
  for (const name of ['σr', 'σθ'])
    await page.locator('#panel-depth .legend').getByText(name, { exact: true }).waitFor();
});

service.test(
  'a comparison begins in the list, without an open job, and keeps its ticks',
  async (page) => {
    const [one, other] = [
      await solved(page, { load: { force: 300 } }),
      await solved(page, { load: { force: 400 } }),
    ];
    await page.getByRole('button', { name: 'Jobs', exact: true }).click();
    const rows = page.locator('#jobs-list li');
    await rows.first().getByText('cylinder R 20 on cylinder R 20, 400 N/mm, bilinear').waitFor();
    const box = (/** @type {string} */ id) =>
      page.getByLabel(new RegExp(`^Compare .*${id.slice(-8)}`));
    await rows.first().getByText('Compare', { exact: true }).waitFor();
    await box(one).check();
    await page.locator('[data-status=succeeded]').waitFor();
    await box(other).check();
    await page.locator('#panel-differences tbody tr').first().waitFor();
    assert.deepEqual([await box(one).isChecked(), await box(other).isChecked()], [true, true]);
    const third = await solved(page, { load: { force: 500 } });
    await page.getByLabel('Search jobs').fill('');
    await rows.nth(2).waitFor();
    await rows
      .filter({ hasText: third.slice(-8) })
      .locator('.open')
      .click();
    await page.locator('#headline').getByText('500.00').waitFor();
    await page.locator('#panel-differences tbody tr').first().waitFor();
    assert.equal(await box(other).isChecked(), true);
  },
);

service.test(
  'the report of a comparison has every set-up, and keeps what it is headed with',
  async (page) => {
    const one = await solved(page, {
      load: { force: 300 },
      tags: { title: 'Press roll', part: '4711' },
    });
    const other = await solved(page, { load: { force: 400 } });
    await follow(page, `job=${one}&with=${other}`);
    await page.locator('#panel-differences tbody tr').first().waitFor();
    const sheet = page.getByRole('main', { name: 'Report' });
    await page.getByRole('button', { name: 'Report' }).click();
    await sheet
      .getByRole('heading', { name: /^Set-up: / })
      .nth(1)
      .waitFor();
    assert.equal(await sheet.getByRole('row', { name: /^Material bilinear/ }).count(), 2);
    await sheet.getByRole('region', { name: 'Differences' }).getByText('Force [N/mm]').waitFor();
    assert.equal(await sheet.getByLabel('Title').inputValue(), 'Press roll');
    assert.equal(await sheet.getByLabel('Part').inputValue(), '4711');
    await sheet.getByLabel('Author').fill('A. Engineer');
    await page.reload();
    await page.locator('#panel-differences tbody tr').first().waitFor();
    await page.getByRole('button', { name: 'Report' }).click();
    assert.equal(await sheet.getByLabel('Author').inputValue(), 'A. Engineer');
    await page.keyboard.press('Escape');
    const [file] = await Promise.all([page.waitForEvent('download'), taken(page, 'CSV: figures')]);
    assert.equal((await readFile(await file.path())).subarray(0, 3).toString('hex'), 'efbbbf');
  },
);

service.test(
  'a trace from right to left, off its middle and in micrometres is put right by a press each',
  async (page) => {
    await page.getByLabel('Shape').first().selectOption('profile');
    const points = page.getByLabel('Points x, height');
    await points.fill('');
    await points.evaluate((area) => {
      const clipboardData = new DataTransfer();
      clipboardData.setData('text', '9 -900\n6 -400\n4 0\n2 -400\n-1 -900\n');
      area.dispatchEvent(
        new ClipboardEvent('paste', { clipboardData, bubbles: true, cancelable: true }),
      );
    });
    const place = page.locator('[data-place="/upper/shape/points"]');
    await place.getByText('taken from the last to the first').waitFor();
    await place.getByRole('button', { name: 'Top to 0' }).click();
    await place.getByLabel('Heights are in').selectOption('µm');
    assert.equal(await points.inputValue(), '-5  -0.9\n-2  -0.4\n0  0\n2  -0.4\n5  -0.9');
    await points.fill('0 0\n2 -1\n1 -0.5\n1 -0.6');
    await place.getByRole('button', { name: 'Sort by x' }).click();
    assert.equal(await points.inputValue(), '0  0\n1  -0.5\n2  -1');
  },
);

test('Rockwell C becomes Vickers as in published tables', () => {
  // DIN 50150, table A.1; then ASTM E 140, another set of steels.
  for (const [rockwell, vickers] of [
    [21.3, 245],
    [31, 310],
    [41.8, 410],
    [48.4, 490],
    [53.6, 570],
    [56.8, 630],
  ])
    assert.ok(Math.abs(vickersOf(rockwell, 'HRC') / vickers - 1) < 0.005, `${rockwell} HRC`);
  for (const [rockwell, vickers] of [
    [30, 302],
    [40, 392],
    [45, 446],
    [50, 513],
    [55, 595],
  ])
    assert.ok(Math.abs(vickersOf(rockwell, 'HRC') / vickers - 1) < 0.01, `${rockwell} HRC`);
  for (let rockwell = 20.5; rockwell <= 68; rockwell += 0.1)
    assert.ok(vickersOf(rockwell, 'HRC') > vickersOf(rockwell - 0.1, 'HRC'), `${rockwell} HRC`);
  for (const beyond of [20, 69]) assert.ok(Number.isNaN(vickersOf(beyond, 'HRC')));
});

service.test(
  'a hardness on the Rockwell scale is taken by the table of ISO 18265',
  async (page) => {
    await page.getByRole('button', { name: 'From hardness…' }).first().click();
    const dialog = page.getByRole('dialog');
    await dialog.getByLabel('Hardness').fill('58');
    await dialog.getByLabel('Scale').selectOption('HRC');
    await dialog.getByRole('button', { name: 'Use' }).click();
    await dialog.getByText('20.3 to 56.3 HRC').waitFor();
    await dialog.getByLabel('Hardness').fill('40.8');
    await dialog.getByRole('button', { name: 'Use' }).click();
    // 400 HV.
    assert.equal(
      await page.getByLabel('Yield stress').first().inputValue(),
      String(Math.round(2.876 * 400 - 90.7)),
    );
  },
);

service.test('JSON with a key that no job has says so beside it', async (page) => {
  await page.getByRole('button', { name: 'JSON', exact: true }).click();
  const text = page.locator('#json-text');
  const job = JSON.parse(await text.inputValue());
  await text.fill(JSON.stringify({ ...job, loud: { force: 3 } }));
  await page.locator('#json-state').getByText('no job has “loud”').waitFor();
  await text.fill(JSON.stringify(job));
  await page.locator('#json-state').getByText('same job as in the form').waitFor();
});

service.test('remarks are short, with the rest behind them', async (page) => {
  await shown(page, { load: { force: 612.6106 }, solver: { theory: 'deformation' } });
  const remark = page.locator('#headline [data-code=deformation_theory]');
  await page.locator('#headline .remarks').evaluate((one) => one.setAttribute('open', ''));
  await remark.getByText('Plasticity by deformation theory').waitFor();
  const details = remark.locator('details');
  assert.match(
    (await details.textContent()) ?? '',
    /peak pressures of lines are at most .* %.*unloading/,
  );
  assert.equal(await details.getAttribute('open'), null);
});
