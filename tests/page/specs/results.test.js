/** What is taken home: tables, comparisons, pictures, the sheet for a report. */

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { suite } from '../browser.js';
import { drawn, follow, mises, picture, shown, solved, steel, taken } from '../jobs.js';

const service = suite();

const CLIPBOARD = { permissions: ['clipboard-read', 'clipboard-write'] };

/** @typedef {import('playwright-core').Page} Page */

/** @param {Page} page */
const clipboard = (page) => page.evaluate(() => navigator.clipboard.readText());

const SWEEP = { load: { forces: [100, 300, 612] } };

service.test(
  'every step stands in a table that spreadsheets, papers and reports take',
  async (page) => {
    await shown(page, SWEEP);
    const panel = page.locator('#panel-figures');
    assert.equal(await panel.locator('tbody tr').count(), 3);
    await taken(page, 'Copy: figures');
    await page.getByText('Table copied').waitFor();
    const lines = (await clipboard(page))
      .trim()
      .split('\n')
      .map((line) => line.split('\t'));
    assert.deepEqual(
      [lines.length, lines[0][1], lines[0][4]],
      [4, 'force [N/mm]', 'peak pressure [MPa]'],
    );
    assert.equal(Number(lines[3][1]), 612);
    assert.ok(lines[3][4].length > 10, 'figures go out in full');
    await taken(page, 'Markdown: figures');
    await page.getByText('Markdown copied').waitFor();
    assert.match(
      await clipboard(page),
      /^\| step \| force \[N\/mm\] \|.*\n\| --: \| --: \|.*\n\| 1 \| 100\.00 \|/,
    );
    await taken(page, 'LaTeX: figures');
    await page.getByText('LaTeX copied').waitFor();
    const latex = await clipboard(page);
    assert.match(latex, /\\begin\{tabular\}\{r+l\}\n\\toprule\nstep & force \[N\/mm\]/);
    assert.match(latex, /contact stiffness \[N\/mm\$\^\{2\}\$\]/);
    const [file] = await Promise.all([page.waitForEvent('download'), taken(page, 'CSV: figures')]);
    assert.equal((await readFile(await file.path(), 'utf8')).split('\n').length, 5);
    await panel.locator('tbody tr').first().click();
    await page.locator('.steps output').getByText('1 of 3').waitFor();
  },
  CLIPBOARD,
);

service.test('a sweep has every figure over its load', async (page) => {
  await shown(page, SWEEP);
  const panel = page.locator('#panel-sweep');
  for (const [choice, words] of [
    ['Peak', /^peak pressure over force, 3 points/],
    ['Half-width', /^half-width over force/],
    ['Strain', /^largest plastic strain over force/],
    ['dP/dα', /^contact stiffness over force, .* N\/mm²/],
  ]) {
    await panel.getByRole('radio', { name: String(choice), exact: true }).check();
    assert.match(
      (await panel.locator('.plot').getAttribute('aria-label')) ?? '',
      /** @type {RegExp} */ (words),
    );
  }
});

service.test('files are of the step that is shown', async (page) => {
  await shown(page, { ...SWEEP, output: { fields: true } });
  await page.getByLabel('Step', { exact: true }).focus();
  await page.keyboard.press('Home');
  for (const [name, file] of [
    ['Pressure, SVG', 'pressure.svg'],
    ['Field, VTU', 'field.vtu'],
  ]) {
    await page.getByText('Download', { exact: true }).click();
    const [request, download] = await Promise.all([
      page.waitForRequest((one) => one.url().includes(`/${file}`)),
      page.waitForEvent('download'),
      page.getByRole('button', { name }).click(),
    ]);
    assert.equal(new URL(request.url()).searchParams.get('step'), '1');
    assert.match(download.suggestedFilename(), /-step-1-/);
    await page.keyboard.press('Escape');
    assert.equal(await page.locator('details.menu[open]').count(), 0, 'Escape closes the menu');
  }
});

service.test(
  'compared jobs have names that tell them apart, dashes, a table of differences, and a link',
  async (page) => {
    const ids = [];
    for (const force of [300, 400, 500]) ids.push(await solved(page, { load: { force } }));
    await follow(page, `job=${ids[0]}&with=${ids[1]},${ids[2]}`);
    const legend = page.locator('#panel-pressure .legend');
    for (const force of [300, 400, 500])
      await legend.getByText(`P ${force} N/mm`, { exact: true }).waitFor();
    const dashes = await legend
      .locator('.swatch path')
      .evaluateAll((all) => all.map((one) => one.getAttribute('stroke-dasharray')));
    assert.equal(new Set(dashes).size, dashes.length, dashes.join(' | '));
    assert.equal(await page.locator('#panel-differences tbody tr').count(), 1);
    assert.deepEqual(await page.locator('#panel-differences tbody td').allTextContents(), [
      'Force [N/mm]',
      '300',
      '400',
      '500',
    ]);
    assert.equal(await page.locator('#panel-figures tbody tr').count(), 3);
    await page.getByRole('button', { name: 'Jobs', exact: true }).click();
    await page.locator('#jobs-list .peak').getByText('peak 10').first().waitFor();
    await page.getByLabel(new RegExp(`^Compare .*${ids[2].slice(-8)}`)).uncheck();
    assert.equal(new URL(page.url()).hash, `#job=${ids[0]}&with=${ids[1]}`);
  },
);

service.test('results are shown in other units than the job has', async (page) => {
  await shown(page, { load: { force: 612.6106 }, output: { fields: true } });
  await mises(page);
  await page.getByText('Units shown').click();
  await page.getByLabel('Unit of length').selectOption('µm');
  await page.getByLabel('Unit of stress').selectOption('GPa');
  await page.getByLabel('Unit of force').selectOption('kN');
  const cards = page.locator('#headline .figure');
  const texts = await cards.allTextContents();
  // Digits follow the error.
  assert.match(texts[0], /^1\.1[56]\d?GPa$/);
  assert.match(texts[1], /^3[01]\dµm$/);
  assert.match(texts[3], /^0\.61261kN\/mm$/);
  assert.match(
    (await page.locator('#panel-field .stage .over').getAttribute('aria-label')) ?? '',
    /to 0\.5\d+ GPa\.$/,
  );
  assert.match(
    (await page.locator('#panel-depth .plot').getAttribute('aria-label')) ?? '',
    /GPa, at a depth of \d+(\.\d+)? µm/,
  );
  await page.getByLabel('Unit of length').selectOption('in');
  assert.match((await cards.nth(3).textContent()) ?? '', /^15\.560kN\/in$/);
  assert.equal(
    await page.locator('[data-place="/load/force"] input[type=text]').inputValue(),
    '612.6106',
    'the job stays',
  );
});

service.test(
  'a report is one sheet with inputs, figures, error bars, remarks and where it comes from',
  async (page) => {
    const id = await shown(page, {
      load: { force: 612.6106 },
      output: { fields: true },
      tags: { pump: 'P-12' },
    });
    await drawn(page);
    await page.locator('.remarks > summary').click();
    await page.locator('.remarks').getByRole('button', { name: 'Explanation' }).click();
    await page.getByText('an infinitely fine mesh').first().waitFor();
    await page.keyboard.press('Escape');
    await page.getByRole('button', { name: 'Report' }).click();
    const sheet = page.getByRole('main', { name: 'Report' });
    const text = (await sheet.textContent()) ?? '';
    for (const part of [
      /Brinell 0\.\d+\.\d+/,
      new RegExp(id),
      /pump: P-12/,
      /± 0\.\d+ %/,
      /diametral plane/,
      /Theoryflow theory/,
      /612\.61N\/mm/,
      new RegExp(`#job=${id}`),
    ])
      assert.match(text, part);
    assert.doesNotMatch(text, /`/, 'remarks speak the language of the form');
    assert.ok((await sheet.locator('.sheet-drawings > *').count()) >= 3);
    assert.equal(await sheet.locator('.sketch svg').count(), 1);
    assert.equal(await page.locator('#setup').isVisible(), false);
    await page.emulateMedia({ media: 'print' });
    assert.equal(await sheet.getByRole('button', { name: 'Print' }).isVisible(), false);
    const pdf = await page.pdf({ preferCSSPageSize: true });
    const pages = pdf.toString('latin1').match(/\/Type\s*\/Page\b/g)?.length;
    assert.equal(pages, 1, 'one sheet of paper');
    await page.emulateMedia({ media: 'screen' });
    await sheet.getByRole('button', { name: 'Back' }).click();
    assert.equal(await page.locator('#setup').isVisible(), true);
  },
);

service.test('charts go out as vector drawings with legend and units', async (page) => {
  await shown(page, {});
  for (const [panel, parts] of /** @type {[string, RegExp[]][]} */ ([
    ['pressure', [/Hertz, elastic/, /p\s+\[MPa\]/, /x\s+\[mm\]/, /Contact pressure, /]],
    ['depth', [/von Mises, elastic/, /depth at x = 0\s+\[mm\]/, /plastic strain \(right\)/]],
  ])) {
    const file = await picture(page, panel);
    const drawing = await readFile(await file.path(), 'utf8');
    for (const part of parts) assert.match(drawing, part);
    assert.doesNotMatch(drawing, /NaN|var\(/);
  }
});

service.test(
  'the title of a drawing stays within it, however long the name of the job',
  async (page) => {
    const title = await page.evaluate(async () => {
      const { chartSvg } = await import(/** @type {any} */ ('/web/result/chart-svg.js'));
      const plot = {
        x: 'x',
        y: 'y',
        curves: [{ label: 'one', colour: '--curve-1', x: [0, 1], y: [0, 1] }],
        words: '',
      };
      const drawing = chartSvg(plot, `Contact pressure, ${'W'.repeat(60)}, 612.6 N/mm`, 520, 240);
      document.body.append(drawing);
      const { right } = drawing.querySelector('text').getBoundingClientRect();
      const end = drawing.getBoundingClientRect().right;
      drawing.remove();
      return [right, end];
    });
    assert.ok(title[0] > 0 && title[0] <= title[1], title.join(' of '));
  },
);

service.test('a job that did not converge has no error bars', async (page) => {
  await shown(page, { solver: { max_iterations: 2, tolerance: 1e-12 } });
  await page.locator('[data-status=not_converged]').waitFor();
  assert.equal(await page.locator('#headline').getByText('±').count(), 0);
  assert.match(await page.title(), /, Not converged · Brinell$/);
});

service.test('a sweep with one answer has no curve', async (page) => {
  await shown(page, {
    load: { forces: [1, 612] },
    solver: { max_iterations: 2, tolerance: 1e-9 },
  });
  const states = await page.locator('#panel-figures tbody tr').allTextContents();
  assert.equal(
    states.filter((row) => !row.includes('not converged')).length,
    1,
    states.join(' | '),
  );
  assert.equal(await page.locator('#panel-sweep').isVisible(), false);
});

service.test('an elastic job has no axis for plastic strain', async (page) => {
  await shown(page, { load: { force: 100 } });
  await page.locator('#panel-depth .legend').getByText('von Mises', { exact: true }).waitFor();
  assert.equal(await page.locator('#panel-depth .legend').getByText('plastic strain').count(), 0);
});

service.test('in axisymmetry directions are r, θ and z', async (page) => {
  await shown(page, { analysis: 'axisymmetric', load: { force: 2000 }, output: { fields: true } });
  await drawn(page);
  const names = await page
    .getByLabel('Shown', { exact: true })
    .locator('option')
    .allTextContents();
  for (const name of ['σr', 'σz', 'σθ', 'τrz', 'displacement ur', 'displacement uz'])
    assert.ok(names.includes(name), name);
  assert.ok(!names.includes('σx'));
  const chips = await page.locator('#panel-depth .chips label').allTextContents();
  assert.deepEqual(chips.slice(2, 5), ['σr', 'σz', 'σθ']);
});

service.test('files name the job, its units and its step', async (page) => {
  const id = await shown(page, SWEEP);
  await page.getByText('Units shown').click();
  await page.getByLabel('Unit of length').selectOption('µm');
  await page.keyboard.press('Escape');
  const named = async (/** @type {string} */ button) => {
    const [file] = await Promise.all([page.waitForEvent('download'), taken(page, button)]);
    return file.suggestedFilename().replace(id.slice(-8), 'id');
  };
  await page.getByLabel('Step', { exact: true }).fill('0');
  assert.equal(await named('Save stress over depth as SVG'), 'id-µm-step-1-depth.svg');
  assert.equal(await named('CSV: figures'), 'id-µm-figures.csv');
});

service.test('what is found has an error bar, what is prescribed has none', async (page) => {
  const barred = async () => {
    const table = page.locator('#headline .rest details');
    if ((await table.getAttribute('open')) === null) await table.locator('summary').click();
    const rows = table.locator('tbody tr', { hasText: '±' });
    await rows.first().waitFor();
    return rows.locator('th').allTextContents();
  };
  const columns = async () => {
    const head = await page.locator('#panel-figures thead th').allTextContents();
    return head.filter((_, k) => head[k + 1]?.startsWith('±'));
  };
  await shown(page, { load: { approach: 0.01 } });
  // Details are behind those that answer the job.
  assert.deepEqual((await barred()).slice(0, 5), [
    'Peak pressure',
    'Half-width',
    'Force',
    'Mean pressure',
    'Largest plastic strain',
  ]);
  assert.match(
    (await columns()).join(),
    /^force N\/mm,peak pressure MPa,half-width mm,mean pressure MPa/,
  );
  // What is prescribed says so, and no card is silent.
  assert.equal(await page.locator('#headline .bar-of-error', { hasText: 'given' }).count(), 1);
  await shown(page, { load: { force: 300 }, output: { contact_stiffness: true } });
  assert.deepEqual((await barred()).slice(0, 6), [
    'Peak pressure',
    'Half-width',
    'Approach',
    'Mean pressure',
    'Largest plastic strain',
    'Contact stiffness',
  ]);
  assert.match(
    (await columns()).join(),
    /^approach mm,peak pressure MPa,half-width mm,mean pressure MPa,largest plastic strain %,contact/,
  );
});

service.test('initial stresses in the chart have the unit of its axis', async (page) => {
  const id = await solved(page, {
    load: { force: 300 },
    lower: {
      shape: { type: 'cylinder', radius: 20 },
      material: {
        young_modulus: 210000,
        poisson_ratio: 0.3,
        initial_stress: [
          { depth: 0, sigma_x: -200, sigma_z: -200 },
          { depth: 0.3, sigma_x: 0, sigma_z: 0 },
        ],
        plasticity: { law: 'bilinear', yield_stress: 500, tangent_modulus: 10500 },
      },
    },
  });
  await follow(page, `job=${id}`);
  await page.locator('#panel-depth').getByRole('radio', { name: 'Lower' }).check();
  await page.locator('#panel-depth .legend').getByText('σx before the load').waitFor();
  // What the closed form leaves out is said.
  await page.locator('#panel-depth .legend').getByText('von Mises, Hertz alone').waitFor();
  await page.getByText('Units shown').click();
  await page.getByLabel('Unit of stress').selectOption('GPa');
  await page.keyboard.press('Escape');
  const plot = page.locator('#panel-depth .plot .reach');
  await plot.hover({ position: { x: 3, y: 30 } });
  const before = page
    .locator('#panel-depth .legend li', { hasText: 'before the load' })
    .locator('b');
  await before.getByText(/^−0\.\d+ GPa$/).waitFor();
  await page
    .locator('#panel-depth .legend')
    .getByText(/^at 0\.?\d* mm$/)
    .waitFor();
});

service.test('what a sweep has over its load follows the order of a history', async (page) => {
  const history = [600, 0, 650, 100].map((force) => ({ force }));
  await shown(page, { load: { history }, solver: { theory: 'flow' } });
  const panel = page.locator('#panel-sweep');
  await panel.getByRole('radio', { name: 'Strain', exact: true }).check();
  const [rest, ...places] = await panel
    .locator('.plot svg circle')
    .evaluateAll((all) =>
      all.map((one) => [Number(one.getAttribute('cx')), Number(one.getAttribute('cy'))]),
    );
  assert.equal(places.length, 4);
  assert.equal(rest[0], places[1][0], 'from the bodies at rest on');
  assert.ok(
    places[1][0] < places[3][0] && places[3][0] < places[0][0] && places[0][0] < places[2][0],
    'in turn',
  );
  // Plastic strain never falls: upward is a smaller place.
  for (let k = 1; k < 4; k++)
    assert.ok(places[k][1] <= places[k - 1][1] + 1e-6, JSON.stringify(places));
});

service.test('a part of a chart that was dragged up is not kept for another job', async (page) => {
  const [one, other] = [
    await solved(page, { load: { force: 300 } }),
    await solved(page, { load: { force: 600 } }),
  ];
  const pixels = () =>
    page.evaluate(() =>
      document.querySelector('#panel-pressure .plot svg')?.outerHTML.replace(/clip-\d+/g, ''),
    );
  const words = (/** @type {string} */ force) =>
    page.locator('#headline').getByText(`${force}.00`, { exact: false }).first().waitFor();
  const settle = () =>
    page.evaluate(
      () => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))),
    );
  await follow(page, `job=${one}`);
  await words('300');
  await follow(page, `job=${other}`);
  await words('600');
  await settle();
  const whole = await pixels();
  await follow(page, `job=${one}`);
  await words('300');
  const box = await page.locator('#panel-pressure .plot .reach').boundingBox();
  assert.ok(box);
  await page.mouse.move(box.x + box.width / 2, box.y + 50);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + 60, box.y + 60);
  await page.mouse.up();
  await page.mouse.move(1, 1);
  await settle();
  await follow(page, `job=${other}`);
  await words('600');
  await page.waitForFunction(
    (whole) =>
      document.querySelector('#panel-pressure .plot svg')?.outerHTML.replace(/clip-\d+/g, '') ===
      whole,
    whole,
  );
});

service.test(
  'the loop of a history is read out point by point, and a radius begins at the axis',
  async (page) => {
    await shown(page, {
      analysis: 'axisymmetric',
      load: { history: [{ force: 4000 }, { force: 0 }] },
      solver: { theory: 'flow' },
    });
    const file = await picture(page, 'dent');
    const drawing = await readFile(await file.path(), 'utf8');
    assert.match(drawing, />r {2}\[mm\]</);
    const ticks = [...drawing.matchAll(/text-anchor="middle"[^>]*>([−\d.]+)</g)].map(
      ([, text]) => text,
    );
    assert.ok(ticks.length > 2 && ticks.every((text) => !text.startsWith('−')), ticks.join());
    const panel = page.locator('#panel-sweep');
    const dot = panel.locator('.plot circle').nth(2);
    await dot.scrollIntoViewIfNeeded();
    const box = await dot.boundingBox();
    assert.ok(box);
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await panel
      .locator('.legend')
      .getByText(/^at 0\.\d+ mm$/)
      .waitFor();
    await panel
      .locator('.legend')
      .getByText(/^[\d.]+ N$/)
      .waitFor();
  },
);

service.test('places on the surface of a hole are said to be along its arc', async (page) => {
  await shown(page, {
    upper: { shape: { type: 'cylinder', radius: 10 }, material: { rigid: true } },
    lower: {
      shape: { type: 'hole', radius: 10.05, outer_radius: 40 },
      material: steel(300, 2100),
    },
    load: { history: [{ force: 1500 }, { force: 0 }] },
    solver: { theory: 'flow' },
  });
  const file = await picture(page, 'dent');
  assert.match(await readFile(await file.path(), 'utf8'), />along the arc {2}\[mm\]</);
});

service.test('files of figures in other units have names of their own', async (page) => {
  await shown(page, { load: { forces: [300, 400] } });
  const named = async () => {
    const [file] = await Promise.all([
      page.waitForEvent('download'),
      taken(page, 'Save contact pressure as SVG'),
    ]);
    return file.suggestedFilename().slice(8);
  };
  assert.equal(await named(), '-step-2-pressure.svg');
  await page.getByText('Units shown').click();
  await page.getByLabel('Unit of length').selectOption('in');
  await page.keyboard.press('Escape');
  assert.equal(await named(), '-in-step-2-pressure.svg');
  await page.getByText('Download').click();
  await page.getByText('in the units of the job').waitFor();
});
