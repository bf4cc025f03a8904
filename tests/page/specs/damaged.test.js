/** Whatever a job, a link or this browser says, the page stays, and says what is wrong. */

import assert from 'node:assert/strict';
import { suite } from '../browser.js';
import { draft, follow, solved } from '../jobs.js';

const service = suite();

service.test('jobs of any form are shown as far as they go', async (page) => {
  await page.getByRole('button', { name: 'JSON', exact: true }).click();
  const text = page.locator('#json-text');
  const base = JSON.parse(await text.inputValue());
  const steel = base.upper.material;
  const by = (/** @type {any} */ plasticity) => ({
    ...base.upper,
    material: { ...steel, plasticity },
  });
  for (const change of [
    {
      upper: null,
      lower: 5,
      load: null,
      mesh: 5,
      solver: [],
      output: 'x',
      tags: [1],
      units: 7,
      analysis: {},
    },
    { upper: { shape: { type: 'constructor' } }, lower: by({ law: 'toString' }), load: 5 },
    {
      upper: { shape: 5, material: 7 },
      lower: by(5),
      load: { history: [5, null, { force: 'x' }] },
    },
    {
      upper: {
        ...base.upper,
        shape: { type: 'profile', points: [[1], [null, 2], 'x'], depth: 'q' },
      },
    },
    { upper: { ...base.upper, shape: { type: '__proto__', points: 5 } }, load: { forces: {} } },
    {
      upper: by({ law: 'table', points: null }),
      lower: by({ law: 'table', points: [] }),
      load: { history: 5 },
    },
    { upper: by({ ...steel.plasticity, over_depth: 5, backstress: 7 }) },
    {
      upper: by({ ...steel.plasticity, over_depth: { hardness: 3 }, backstress: [null, 5] }),
      load: { forces: [null] },
    },
    { upper: { ...base.upper, material: { ...steel, initial_stress: 5 } } },
    {
      upper: { ...base.upper, material: { ...steel, initial_stress: [null, { depth: 'x' }, 7] } },
    },
    {
      upper: { ...base.upper, shape: { type: 'cylinder', radius: 1e308 } },
      load: { force: -1e308 },
    },
    { load: { force: 'x' } },
    { load: { forces: [] } },
    { load: { approaches: ['x', null] } },
  ]) {
    const changed = { ...base, ...change };
    await text.fill(JSON.stringify(changed));
    await page.waitForFunction(
      (wanted) => JSON.stringify(JSON.parse(sessionStorage.getItem('draft') ?? 'null')) === wanted,
      JSON.stringify(changed),
    );
    await page.getByLabel('Units').first().selectOption('SI');
    await page.locator('#form .error:visible, #check .error').first().waitFor();
    const sketch = page.locator('#sketch');
    assert.doesNotMatch(
      (await sketch.textContent()) ?? '',
      /NaN|Infinity|undefined/,
      JSON.stringify(change),
    );
  }
  await text.fill(JSON.stringify(base));
  await page.getByText('1500.0 MPa').waitFor();
});

service.test('figures of any size are refused in words', async (page) => {
  await page.getByText('Mesh, solver, output, tags').click();
  for (const junk of ['9'.repeat(400), '1e999', '∞', '0x10', '<b>x</b>', '1 mm mm', ''])
    for (const field of await page.locator('#form input[type=text]').all()) await field.fill(junk);
  await page.locator('#form .error:visible').first().waitFor();
});

for (const [what, kept] of /** @type {[string, Record<string, string>][]} */ ([
  ['no JSON', { draft: '{', materials: '[', 'display-units': '{', theme: '{' }],
  ['nothing', { draft: 'null', materials: 'null', 'display-units': 'null', theme: 'null' }],
  [
    'something else',
    { draft: '[]', materials: '[5, null, {"name": 3}]', 'display-units': '{"length": "parsec"}' },
  ],
]))
  service.test(`a browser that has kept ${what} begins anew`, async (page) => {
    await page.evaluate((kept) => {
      for (const storage of [sessionStorage, localStorage])
        for (const [key, value] of Object.entries(kept)) storage.setItem(key, value);
    }, kept);
    await page.reload();
    await page.getByText('1500.0 MPa').waitFor();
    await page.getByRole('button', { name: 'Solve', exact: true }).click();
    await page.locator('#headline').getByText('612.61').waitFor();
  });

for (const hash of [
  '#job=garbage',
  '#draft=%%%',
  '#draft=AAAA',
  '#job=0197e1f0-0000-7000-8000-000000000000&with=zzz,,',
])
  service.test(
    `the link ${hash} says what is wrong with it`,
    async (page) => {
      await page
        .getByText(/This link is damaged|This link leads to|not an? |must be/)
        .first()
        .waitFor();
      await page.locator('[data-place="/load/force"]').waitFor();
    },
    { hash, amiss: true },
  );

service.test(
  'a thousand steps are gone through without building their table anew',
  async (page) => {
    const forces = Array.from({ length: 1000 }, (_, k) => k + 1);
    const id = await solved(page, { mesh: { elements_per_half_width: 4 }, load: { forces } });
    await follow(page, `job=${id}`);
    const rows = page.locator('#panel-figures tbody tr');
    await rows.nth(999).waitFor();
    const first = await rows.first().elementHandle();
    await page.getByLabel('Step', { exact: true }).focus();
    await page.keyboard.press('Home');
    await page.locator('.steps output').getByText('1 of 1000').waitFor();
    assert.equal(await first?.getAttribute('aria-current'), 'step', 'the same row');
    assert.equal(await page.locator('#panel-figures [aria-current]').count(), 1);
    assert.equal((await draft(page)).load.forces.length, 1000);
  },
);
