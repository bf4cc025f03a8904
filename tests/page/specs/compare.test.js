/** Jobs laid over each other: what they differ in, and which can be compared at all. */

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { suite } from '../browser.js';
import { SI, follow, picture, shown, solved } from '../jobs.js';

const service = suite();
const ROWS = '#panel-differences tbody tr';

service.test(
  'jobs in other units differ in nothing but what they ask, which has its unit',
  async (page) => {
    const [mm, si] = [
      await solved(page, { load: { force: 300 } }),
      await solved(page, { ...SI, load: { force: 400e3 } }),
    ];
    await follow(page, `job=${mm}&with=${si}`);
    await page.locator(ROWS).first().waitFor();
    assert.deepEqual(await page.locator(`${ROWS} td`).allTextContents(), [
      'Force [N/mm]',
      '300',
      '400',
    ]);
    await page
      .locator('#panel-pressure .legend')
      .getByText('P 400 N/mm', { exact: true })
      .waitFor();
    await follow(page, `job=${si}&with=${mm}`);
    await page.locator(ROWS).getByText('Force [N/m]').waitFor();
    assert.deepEqual(await page.locator(`${ROWS} td`).allTextContents(), [
      'Force [N/m]',
      '400000',
      '300000',
    ]);
  },
);

service.test('the onset of yield is called so beside a force', async (page) => {
  const [one, onset] = [
    await solved(page, { load: { force: 300 } }),
    await solved(page, { load: { onset: true } }),
  ];
  await follow(page, `job=${one}&with=${onset}`);
  await page.locator(ROWS).first().waitFor();
  assert.deepEqual(await page.locator(`${ROWS} td`).allTextContents(), [
    'Load',
    'P 300 N/mm',
    'onset of yield',
  ]);
});

service.test(
  'a sweep beside a job of one load: each is called by its own name, and every yield stress is marked',
  async (page) => {
    const harder = structuredClone(SI);
    for (const body of ['upper', 'lower']) harder[body].material.plasticity.yield_stress = 800e6;
    const [one, other] = [
      await solved(page, { load: { force: 500 }, tags: { roll: 'A' } }),
      await solved(page, { ...harder, load: { forces: [100e3, 300e3] }, tags: { roll: 'B' } }),
    ];
    await follow(page, `job=${one}&with=${other}`);
    for (const name of ['A', 'B'])
      await page.locator('#panel-sweep .legend').getByText(name, { exact: true }).waitFor();
    const drawing = async (/** @type {string} */ panel) => {
      const file = await picture(page, panel);
      return readFile(await file.path(), 'utf8');
    };
    const sweep = await drawing('sweep');
    assert.match(sweep, />Sweep</);
    // The elastic bodies are the same, of which the second yields at 1.6² times the force.
    assert.match(sweep, />first yield, elastic theory 560\.\d N\/mm</);
    assert.match(sweep, />first yield, elastic theory 219\.\d N\/mm</);
    // A load of flow theory is solved in increments.
    assert.ok((sweep.match(/<circle [^>]*data-label="A"/g) ?? []).length > 2);
    const depth = await drawing('depth');
    for (const figure of ['500.0', '800.0'])
      assert.ok(depth.includes(`>yield ${figure} MPa<`), figure);
  },
);

service.test('an axisymmetric job is not laid over a plane one', async (page) => {
  const other = await solved(page, { analysis: 'axisymmetric', load: { force: 2000 } });
  const id = await shown(page, { load: { force: 300 } });
  await page.getByRole('button', { name: 'Jobs', exact: true }).click();
  const box = page.getByLabel(new RegExp(`^Compare .*${other.slice(-8)}`));
  await box.click();
  await page.getByText('An axisymmetric job and a plane one are not compared').waitFor();
  assert.equal(await box.isChecked(), false);
  assert.equal(await page.locator('#panel-figures tbody tr').count(), 1);
  assert.equal(new URL(page.url()).hash, `#job=${id}`);
});

service.test('two jobs that are chosen at once have colours of their own', async (page) => {
  const ids = [];
  for (const force of [300, 400, 500]) ids.push(await solved(page, { load: { force } }));
  await follow(page, `job=${ids[0]}`);
  await page.locator('#panel-figures tbody tr').first().waitFor();
  await page.getByRole('button', { name: 'Jobs', exact: true }).click();
  let letGo = () => {};
  const held = new Promise((resolve) => {
    letGo = () => resolve(undefined);
  });
  await page.route('**/result?**', async (route) => {
    await held;
    await route.continue();
  });
  for (const id of ids.slice(1))
    await page.getByLabel(new RegExp(`^Compare .*${id.slice(-8)}`)).check();
  letGo();
  await page.locator('#panel-figures tbody tr').nth(2).waitFor();
  const colours = await page
    .locator('#panel-pressure .legend .swatch path')
    .evaluateAll((all) => all.map((one) => /** @type {SVGPathElement} */ (one).style.stroke));
  assert.equal(new Set(colours.slice(0, 3)).size, 3, colours.join());
});

service.test('whoever solves again keeps the comparison, and the link has it', async (page) => {
  const [one, other] = [
    await solved(page, { load: { force: 300 } }),
    await solved(page, { load: { force: 400 } }),
  ];
  await follow(page, `job=${one}&with=${other}`);
  await page.locator(ROWS).first().waitFor();
  await page.getByLabel('Force P').fill('350');
  await page.getByRole('button', { name: 'Solve', exact: true }).click();
  await page.locator('#headline').getByText('350.00').waitFor();
  assert.match(new URL(page.url()).hash, new RegExp(`^#job=[-0-9a-f]+&with=${other}$`));
  await page.reload();
  await page.locator(`${ROWS} td`).getByText('350').waitFor();
});

service.test(
  'sweeps are compared at the same load, and their curves say at which',
  async (page) => {
    const [one, other] = [
      await solved(page, { load: { forces: [100, 300, 612] }, tags: { roll: 'A' } }),
      await solved(page, { load: { forces: [300, 200, 100] }, tags: { roll: 'B' } }),
    ];
    await follow(page, `job=${one}&with=${other}`);
    await page.locator(ROWS).first().waitFor();
    const legend = page.locator('#panel-pressure .legend');
    // The load of the last step is none of the other's: its last step is as good as any.
    await legend.getByText('A, step 3 of 3, 612.0 N/mm', { exact: true }).waitFor();
    await legend.getByText('B, step 3 of 3, 100.0 N/mm', { exact: true }).waitFor();
    await page.getByLabel('Step', { exact: true }).fill('1');
    await legend.getByText('A, step 2 of 3, 300.0 N/mm', { exact: true }).waitFor();
    await legend.getByText('B, step 1 of 3, 300.0 N/mm', { exact: true }).waitFor();
    const depth = page.locator('#panel-depth .legend');
    await depth.getByText('B, step 1 of 3, 300.0 N/mm: von Mises', { exact: true }).waitFor();
    // On grey paper jobs and components are told apart by their lines.
    const lines = await depth
      .locator('.swatch path')
      .evaluateAll((all) =>
        all.map((one) =>
          ['stroke-dasharray', 'stroke-width'].map((name) => one.getAttribute(name)).join(),
        ),
      );
    assert.ok(lines.length >= 4);
    assert.equal(new Set(lines).size, lines.length, lines.join(' | '));
    const file = await picture(page, 'pressure');
    const drawing = await readFile(await file.path(), 'utf8');
    assert.match(
      drawing,
      />Contact pressure<.*>A, step 2 of 3, 300\.0 N\/mm<.*>B, step 1 of 3, 300\.0 N\/mm</s,
    );
    await page.getByRole('button', { name: 'Report' }).click();
    await page
      .locator('#sheet')
      .getByText('A, step 2 of 3, 300.0 N/mm; B, step 1 of 3, 300.0 N/mm')
      .waitFor();
    // Names of jobs have room in the table, and it stays on the sheet.
    const [table, name] = [
      '#sheet .wide:has(thead .text)',
      '#sheet .wide td.text:first-child',
    ].map((one) => page.locator(one).first());
    assert.ok(await table.evaluate((one) => one.scrollWidth <= one.clientWidth));
    assert.ok(await name.evaluate((one) => one.getBoundingClientRect().width > 85));
  },
);

service.test(
  'what differs is written so that it is seen, and shapes are called by their names',
  async (page) => {
    const lower = (/** @type {string} */ type, /** @type {number} */ stress) => ({
      shape: { type, radius: 20, ...(type === 'parabola' && { width: 30, depth: 20 }) },
      material: {
        ...SI.lower.material,
        young_modulus: 210000,
        plasticity: { law: 'bilinear', yield_stress: 500, tangent_modulus: 10500 },
        initial_stress: [0, 0.2, 3].map((depth, k) => ({
          depth,
          sigma_x: k ? 0 : stress,
          sigma_z: 0,
        })),
      },
    });
    const [one, other] = [
      await solved(page, { load: { force: 100 }, lower: lower('cylinder', -100) }),
      await solved(page, { load: { force: 100 }, lower: lower('parabola', -50) }),
    ];
    await follow(page, `job=${one}&with=${other}`);
    await page.locator(ROWS).first().waitFor();
    await page.locator(ROWS).filter({ hasText: 'Lower shape' }).getByText('parabola').waitFor();
    const cells = await page
      .locator(ROWS)
      .filter({ hasText: 'initial stress' })
      .locator('td')
      .allTextContents();
    assert.match(cells[1], /−100/);
    assert.match(cells[2], /−50/);
    await page.locator('#panel-pressure .legend').getByText('parabola', { exact: true }).waitFor();
  },
);

service.test(
  'loads of different kinds have their own letters and units in names and differences',
  async (page) => {
    const jobs = [];
    for (const load of [
      { force: 300 },
      { approach: 0.01 },
      { forces: [100, 300] },
      { target: { half_width: 0.2 } },
    ])
      jobs.push(await solved(page, { load }));
    await follow(page, `job=${jobs[0]}&with=${jobs.slice(1).join()}`);
    await page.locator(ROWS).first().waitFor();
    const texts = ['P 300 N/mm', 'α 0.01 mm', 'P 100 … 300 N/mm', 'P for half-width 0.2 mm'];
    await page.waitForFunction(
      () => document.querySelectorAll('#panel-differences thead th').length === 5,
    );
    assert.deepEqual(await page.locator(`${ROWS} td`).allTextContents(), ['Load', ...texts]);
    assert.deepEqual(
      (await page.locator('#panel-differences thead th').allTextContents()).slice(1),
      texts,
    );
  },
);

service.test(
  'a yield stress that not all jobs have is in the colours of those that have it',
  async (page) => {
    const lower = (/** @type {object} */ plasticity) => ({
      shape: { type: 'cylinder', radius: 20 },
      material: { young_modulus: 210000, poisson_ratio: 0.3, ...plasticity },
    });
    const law = { law: 'bilinear', yield_stress: 500, tangent_modulus: 10500 };
    const graded = { ...law, over_depth: [[0, 1.8], [0.5, 1.6], [1.5, 1]] }; // prettier-ignore
    const ids = [];
    for (const body of [lower({ plasticity: graded }), lower({ plasticity: law })])
      ids.push(await solved(page, { load: { force: 300 }, lower: body }));
    await follow(page, `job=${ids[0]}&with=${ids[1]}`);
    await page.locator(ROWS).first().waitFor();
    const legend = page.locator('#panel-depth .legend');
    await page.locator('#panel-depth').getByRole('radio', { name: 'Lower' }).check();
    await legend.getByText(': yield stress').waitFor();
    await page.locator('#report').click();
    const colours = await page
      .locator('#sheet .sheet-drawings svg', { hasText: 'depth' })
      .evaluate((drawing) => {
        const [one] = [...drawing.querySelectorAll('text')].filter((text) =>
          /^yield 500/.test(text.textContent ?? ''),
        );
        const curves = [...drawing.querySelectorAll('g[clip-path] path')].map((path) =>
          path.getAttribute('stroke'),
        );
        return { mark: one?.getAttribute('fill'), curves };
      });
    assert.ok(colours.curves.includes(colours.mark ?? ''), JSON.stringify(colours));
  },
);
