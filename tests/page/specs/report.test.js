/** What the sheet for a report says of each kind of job. */

import assert from 'node:assert/strict';
import { PHONE, suite } from '../browser.js';
import { drawn, follow, shown, solved } from '../jobs.js';

/** @typedef {import('playwright-core').Page} Page */

const service = suite();

/** @param {Page} page */
async function sheet(page) {
  await page.getByRole('button', { name: 'Report' }).click();
  const place = page.getByRole('main', { name: 'Report' });
  await place.locator('.answers').waitFor();
  return place;
}

service.test('every force of a sweep is written, and every load of a history', async (page) => {
  await shown(page, { load: { forces: [100, 150, 200, 280, 300] } });
  await (
    await sheet(page)
  )
    .getByRole('row', { name: 'Forces P 100 150 200 280 300 N/mm' })
    .waitFor();
  await page.keyboard.press('Escape');
  const history = [300, 0, 400, 0, 500, 0].map((force) => ({ force }));
  await shown(page, { load: { history }, solver: { theory: 'flow' } });
  const whole = await sheet(page);
  await whole
    .getByRole('row', { name: 'Loads in turn P 300 → 0 → 400 → 0 → 500 → 0 N/mm' })
    .waitFor();
});

service.test('a step without load has no columns of Hertz, and no stiffness', async (page) => {
  await shown(page, {
    load: { history: [{ force: 300 }, { force: 0 }] },
    solver: { theory: 'flow' },
    output: { contact_stiffness: true },
  });
  const stiffness = page.locator('#headline dl > div', { hasText: 'Contact stiffness' });
  await page.locator('#headline').getByText('Permanent approach').waitFor();
  assert.equal(await stiffness.count(), 0);
  const place = await sheet(page);
  assert.equal(await place.locator('.answers').getByText('elastic').count(), 0);
  await page.keyboard.press('Escape');
  await page.getByLabel('Step', { exact: true }).fill('0');
  await page.locator('#headline .rest summary').click();
  await page.locator('#headline').getByText('with the plastic flow that it brings').waitFor();
  assert.equal(
    await (
      await sheet(page)
    )
      .locator('.answers')
      .getByRole('columnheader', { name: 'beside elastic theory' })
      .count(),
    1,
  );
});

service.test('figures that were put in are written in all their digits', async (page) => {
  const material = { young_modulus: 210000, poisson_ratio: 0.3 };
  await shown(page, {
    upper: { shape: { type: 'cylinder', radius: 20 }, material },
    lower: { shape: { type: 'hole', radius: 20.00015, outer_radius: 100 }, material },
    load: { force: 20.000025 },
  });
  const place = await sheet(page);
  // A clearance of 0.15 µm would be 0.2 µm of a rounded radius.
  await place.getByRole('row', { name: 'Radius R 20 20.00015 mm' }).waitFor();
  await place.getByRole('row', { name: 'Force P 20.000025 N/mm' }).waitFor();
  await place.locator('.sketch').getByText('hole R 20.00015 mm').waitFor();
});

const HOLE = { type: 'hole', radius: 10.02, outer_radius: 100 };
const ELASTIC = { young_modulus: 210000, poisson_ratio: 0.3 };
for (const [analysis, name, force] of /** @type {const} */ ([
  ['plane_strain', 'pin in hole', 1000],
  ['axisymmetric', 'ball in socket', 1000],
]))
  service.test(`a ${name} is called so, and is seen in the sketch`, async (page) => {
    await shown(page, {
      analysis,
      upper: { shape: { type: 'cylinder', radius: 10 }, material: ELASTIC },
      lower: { shape: HOLE, material: ELASTIC },
      load: { force },
    });
    // The pin takes a good part of what is drawn around it.
    await page.waitForFunction(() => {
      const [pin, around] = ['.body:not(.around)', '.broken'].map(
        (part) => document.querySelector(`#sketch ${part}`)?.getBoundingClientRect().height,
      );
      return pin && around && pin > 0.4 * around;
    });
    const place = await sheet(page);
    assert.equal(
      (await place.getByRole('heading', { level: 1 }).textContent())?.toLowerCase(),
      name,
    );
  });

service.test(
  'a report of jobs compared is no wider than the narrowest phone',
  async (page) => {
    const ids = [];
    for (const force of [300, 400])
      ids.push(await solved(page, { load: { forces: [100, 200, force] } }));
    await follow(page, `job=${ids[0]}&with=${ids[1]}`);
    await page.locator('#panel-differences tbody tr').first().waitFor();
    await sheet(page);
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 320);
    const beyond = await page
      .locator('#sheet table.inputs :is(td, th)')
      .evaluateAll(
        (all) => all.filter((one) => one.getBoundingClientRect().right > innerWidth).length,
      );
    assert.equal(beyond, 0);
  },
  { ...PHONE, viewport: { width: 320, height: 700 } },
);

service.test('a report is no wider for what its tags say', async (page) => {
  await shown(page, { load: { force: 300 }, tags: { ['k'.repeat(40)]: 'v'.repeat(200) } });
  const place = await sheet(page);
  assert.deepEqual(await place.evaluate((one) => one.scrollWidth - one.clientWidth), 0);
});

service.test(
  'the report of an unloaded step has what the load has left, and every figure of the page',
  async (page) => {
    await shown(page, {
      load: { history: [{ force: 600 }, { force: 0 }] },
      solver: { theory: 'flow' },
    });
    const cards = await page.locator('#headline dl dt').allTextContents();
    const place = await sheet(page);
    const rows = await place.locator('.answers tbody th').allTextContents();
    // The bodies are alike.
    assert.deepEqual(rows.slice(0, 5), [
      'Dent',
      'Pile-up',
      'Permanent approach',
      'Residual tension',
      'Largest plastic strain',
    ]);
    assert.deepEqual(cards, rows);
    // Bodies that are apart have no pressure, width or stiffness.
    const none = [
      'Peak pressure',
      'Half-width',
      'Mean pressure',
      'Contact stiffness',
      'Unloading stiffness',
    ];
    for (const name of none) assert.ok(!rows.includes(name), name);
    const depth = await place
      .locator('.answers tbody tr')
      .first()
      .locator('td')
      .first()
      .textContent();
    assert.ok(Number(depth?.replace(/·10.*/, '')) > 0, `${depth}`);
    await page.keyboard.press('Escape');
    await shown(page, {
      analysis: 'axisymmetric',
      load: { target: { max_plastic_strain: 0.002 } },
    });
    await (
      await sheet(page)
    )
      .getByText(/^for an? .*plastic strain of (0\.002|0\.2 %); it is /)
      .waitFor();
    await page.locator('#sheet .answers').getByText('Force found').waitFor();
  },
);

service.test(
  'a report is one sheet of A4 or Letter, and lies as the printer has it',
  async (page) => {
    const job = await page.evaluate(async () => {
      const { examples } = await (await fetch('v1/examples')).json();
      return examples.find((/** @type {{name: string}} */ { name }) => name === 'ramberg_osgood')
        .job;
    });
    await shown(page, { ...job, mesh: { elements_per_half_width: 8 }, output: { fields: true } });
    await drawn(page);
    const place = await sheet(page);
    await place.locator('canvas').waitFor();
    await page.emulateMedia({ media: 'print' });
    for (const format of ['A4', 'Letter']) {
      const pdf = (await page.pdf({ format, preferCSSPageSize: true })).toString('latin1');
      assert.equal(pdf.match(/\/Type\s*\/Page\b/g)?.length, 1, format);
    }
    const wide = (
      await page.pdf({ format: 'Letter', landscape: true, preferCSSPageSize: true })
    ).toString('latin1');
    assert.match(wide, /\/MediaBox\s*\[0 0 79\d(\.\d+)? 61\d/);
  },
);

service.test(
  'no figure of a report is broken on a phone',
  async (page) => {
    await shown(page, { load: { forces: [100, 300, 612] } });
    const place = await sheet(page);
    const broken = await place.locator('.answers td, .wide td').evaluateAll((cells) =>
      cells
        .filter((cell) => {
          if (!/\d/.test(cell.textContent ?? '')) return false;
          const range = document.createRange();
          range.selectNodeContents(cell);
          return new Set([...range.getClientRects()].map(({ top }) => Math.round(top))).size > 1;
        })
        .map((cell) => cell.textContent),
    );
    assert.deepEqual(broken, []);
    assert.ok(
      await place
        .locator('.wide')
        .last()
        .evaluate((one) => one.scrollWidth > one.clientWidth),
      'it is moved, not squeezed',
    );
  },
  PHONE,
);

service.test(
  'a report calls the half-width of a round contact its radius, and has no empty rows',
  async (page) => {
    const examples = await page.evaluate(
      async () => (await (await fetch('v1/examples')).json()).examples,
    );
    const { job } = examples.find(
      (/** @type {{name: string}} */ { name }) => name === 'pin_in_hole',
    );
    await shown(page, { ...job, analysis: 'axisymmetric', load: { forces: [100, 200] } });
    const place = await sheet(page);
    await place.getByRole('columnheader', { name: /^contact radius/ }).waitFor();
    assert.equal(await place.getByRole('columnheader', { name: /^half-width/ }).count(), 0);
    for (const row of await place.locator('.inputs tbody tr').all())
      assert.doesNotMatch(await row.innerText(), /—\s+—/, 'a figure that neither body has');
  },
);

service.test('every example is a report of one page', async (page) => {
  const names = await page.evaluate(async () => {
    const { examples } = await (await fetch('v1/examples')).json();
    return examples.map((/** @type {{name: string}} */ { name }) => name);
  });
  for (const name of names) {
    const id = await page.evaluate(async (name) => {
      const { examples } = await (await fetch('v1/examples')).json();
      const { job } = examples.find((/** @type {{name: string}} */ one) => one.name === name);
      const coarse = {
        ...job,
        mesh: { elements_per_half_width: 6 },
        output: { ...job.output, fields: true },
      };
      const headers = { 'Content-Type': 'application/json' };
      const answer = await fetch('v1/jobs', {
        method: 'POST',
        headers,
        body: JSON.stringify(coarse),
      });
      const { id } = await answer.json();
      await fetch(`v1/jobs/${id}?wait=100`);
      performance.clearMarks();
      return id;
    }, name);
    await follow(page, `job=${id}`);
    await page
      .locator('[data-status]:is([data-status=succeeded], [data-status=not_converged])')
      .waitFor();
    // A track has no field.
    await ([
      'rail_under_driven_wheel',
      'rolled_hardened_roller',
      'ball_runs_in',
      'deep_rolling',
    ].includes(name)
      ? page.locator('#panel-passes svg').first().waitFor()
      : drawn(page));
    await sheet(page);
    const pdf = await page.pdf({ format: 'A4' });
    assert.equal(pdf.toString('latin1').match(/\/Type\s*\/Page[^s]/g)?.length, 1, name);
    await page.keyboard.press('Escape');
  }
});

service.test('a reference stress is not called a yield stress', async (page) => {
  const plasticity = { law: 'ramberg_osgood', reference_stress: 500, offset: 0.3, exponent: 5 };
  const material = { young_modulus: 210000, poisson_ratio: 0.3, plasticity };
  const body = { shape: { type: 'cylinder', radius: 20 }, material };
  await shown(page, { upper: body, lower: body, load: { force: 300 } });
  await page.locator('#check').getByText('from the first load on').waitFor();
  const words = (await sheet(page)).locator('.sheet-drawings text');
  await words.getByText('reference stress 500').waitFor();
  assert.equal(await words.getByText(/^yield/).count(), 0);
});
