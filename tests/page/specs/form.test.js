/** The form shows the draft, always: nothing else is ever solved than what it shows. */

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { suite } from '../browser.js';
import { draft, follow, sent, solved, steel, unfold } from '../jobs.js';

const service = suite();

/** @type {any[]} */
const RECORDS = JSON.parse(
  readFileSync(new URL('../../measured/tables.json', import.meta.url), 'utf8'),
);

const SOLVED = '[data-status=succeeded]';
const FORCE = '[data-place="/load/force"] input[type=text]';

/** @param {import('playwright-core').Page} page @param {string} text that the field is to show */
const shows = (page, text) =>
  page.waitForFunction(
    ([field, text]) =>
      /** @type {HTMLInputElement} */ (document.querySelector(field))?.value === text,
    [FORCE, text],
  );

service.test('a field that has the cursor follows the draft when one goes back', async (page) => {
  const force = page.locator(FORCE);
  await force.fill('612');
  await force.press('Control+Enter');
  await page.locator('#headline').getByText('612.00').waitFor();
  await force.fill('900');
  await force.press('Control+Enter');
  await page.locator('#headline').getByText('900.00').waitFor();
  await page.goBack();
  await page.locator('#headline').getByText('612.00').waitFor();
  await shows(page, '612');
  assert.equal(
    await force.evaluate((input) => input === document.activeElement),
    true,
    'the cursor stays',
  );
  assert.equal((await draft(page)).load.force, 612);
  await force.press('Control+Z');
  await shows(page, '900');
  await page.getByText('The set-up has changed since').waitFor();
});

service.test('a form that is built anew fills the field that has the cursor', async (page) => {
  const id = await sent(page, { analysis: 'axisymmetric', load: { force: 4321 } });
  await page.locator(FORCE).focus();
  await follow(page, `job=${id}`);
  await page
    .locator('[data-place="/upper/shape/type"] option')
    .getByText('Sphere')
    .waitFor({ state: 'attached' });
  await shows(page, '4321');
});

service.test('what is typed stays as it is typed until one leaves the field', async (page) => {
  const force = page.locator(FORCE);
  await force.click();
  await page.keyboard.press('Control+A');
  await page.keyboard.type('0,50');
  assert.equal(await force.inputValue(), '0,50');
  assert.equal((await draft(page)).load.force, 0.5);
  await page.keyboard.press('Tab');
  await shows(page, '0.5');
  await page.getByText('Mesh, solver, output, tags').click();
  const elements = page.getByLabel('Elements per half-width', { exact: true });
  await elements.fill('');
  assert.equal(
    await elements.inputValue(),
    '',
    'an emptied field is not filled while it is typed in',
  );
  await elements.blur();
  assert.equal(await elements.inputValue(), '20', 'and then shows what holds');
});

service.test('a thousand is never silently one', async (page) => {
  await page.locator(FORCE).fill('1,000');
  await page.getByText('“1,000” can be read as 1.000 or as 1000').waitFor();
  await page.getByRole('button', { name: 'Solve', exact: true }).click();
  await page.getByText('One field is wrong: the cursor is in it.').waitFor();
  assert.equal(await page.locator(SOLVED).count(), 0);
  for (const [typed, read] of [
    ['1,000,000', '1,000,000'],
    ['1.234,5', '1.234,5'],
    ['1,234.5', '1,234.5'],
    ['12 500', 12500],
    ['0,250', 0.25],
    ['−5e2', -500],
    ['0.2 kN/mm', 200],
  ]) {
    await page.locator(FORCE).fill(String(typed));
    assert.equal((await draft(page)).load.force, read, String(typed));
  }
});

service.test('what a job leaves out is shown as it holds', async (page) => {
  await page.locator('#example').selectOption({ label: 'Roller in a groove' });
  await page.getByLabel('Width w').waitFor();
  assert.equal((await draft(page)).upper.support, undefined);
  assert.equal(await page.getByLabel('Support').first().inputValue(), 'clamped');
  const empty = await page
    .locator('#form select')
    .evaluateAll(
      (all) =>
        all.filter((one) => /** @type {HTMLSelectElement} */ (one).selectedIndex < 0).length,
    );
  assert.equal(empty, 0, 'no choice is blank');
});

service.test('half a JSON beside the form is not solved around', async (page) => {
  await page.getByRole('button', { name: 'JSON', exact: true }).click();
  const text = page.locator('#json-text');
  const whole = await text.inputValue();
  await text.fill(whole.replace('612.6106', '612.6106,,'));
  await page.keyboard.press('Control+Enter');
  await page.getByText('The JSON beside is not a job').waitFor();
  assert.equal(await page.locator('.state').count(), 0, 'nothing was sent');
  await text.fill(whole.replace('612.6106', '500'));
  await page.keyboard.press('Control+Enter');
  await page.locator('#headline').getByText('500.00').waitFor();
});

service.test(
  'the note of a conversion goes when it is undone, and what was pasted stays',
  async (page) => {
    await page.getByLabel('Hardening').first().selectOption('table');
    const place = page.locator('[data-place="/upper/material/plasticity/points"]');
    await paste(place.locator('textarea'), '0 0\n0.001 210\n0.002 420\n0.01 500\n0.1 600');
    await place.getByText('5 points read').waitFor();
    await place.getByText('are no hardening curve yet: press').waitFor();
    await page.getByRole('button', { name: 'From total strain' }).first().click();
    await place.getByText('The test rises with 210000 MPa').waitFor();
    await page.getByRole('button', { name: 'Undo' }).click();
    assert.match((await draft(page)).upper.material.plasticity.points, /^engineering strain/);
    assert.equal(await place.locator('.note').textContent(), '');
  },
);

service.test('changes are undone and done again', async (page) => {
  await page.locator(FORCE).fill('777');
  await unfold(page);
  await page.getByLabel('Support').first().selectOption('roller');
  await page.getByLabel('Units').selectOption('SI');
  await shows(page, '777000');
  await page.getByRole('button', { name: 'Undo' }).click();
  await shows(page, '777');
  await page.getByRole('button', { name: 'Undo' }).click();
  assert.equal(await page.getByLabel('Support').first().inputValue(), 'clamped');
  await page.getByRole('button', { name: 'Undo' }).click();
  await shows(page, '612.6106');
  for (let k = 0; k < 3; k++) await page.getByRole('button', { name: 'Redo' }).click();
  await shows(page, '777000');
  assert.equal(await page.getByRole('button', { name: 'Redo' }).isDisabled(), true);
});

/** Chooses a profile as the upper shape. @param {import('playwright-core').Page} page */
async function profile(page) {
  await page.getByText('1500.0 MPa').waitFor();
  await page.getByLabel('Shape').first().selectOption('profile');
  return page.getByLabel('Points x, height');
}

/** Pastes as a spreadsheet does. @param {import('playwright-core').Locator} field @param {string} text */
const paste = (field, text) =>
  field.evaluate((input, text) => {
    const data = new DataTransfer();
    data.setData('text/plain', text);
    /** @type {HTMLTextAreaElement} */ (input).focus();
    /** @type {HTMLTextAreaElement} */ (input).select();
    const event = new ClipboardEvent('paste', {
      clipboardData: data,
      bubbles: true,
      cancelable: true,
    });
    if (!input.dispatchEvent(event)) return;
    /** @type {HTMLTextAreaElement} */ (input).value = text;
    input.dispatchEvent(new InputEvent('input', { bubbles: true }));
  }, text);

service.test('tables are pasted as spreadsheets have them', async (page) => {
  const points = await profile(page);
  for (const [text, read] of /** @type {[string, number[][]][]} */ ([
    [
      '-1,5\t-0,2\n0\t0\n1,5\t-0,2',
      [
        [-1.5, -0.2],
        [0, 0],
        [1.5, -0.2],
      ],
    ],
    [
      'x [mm];h [µm]\n-1;-250\n0;0\n1,25;-250',
      [
        [-1, -0.25],
        [0, 0],
        [1.25, -0.25],
      ],
    ],
    [
      '# stylus\nx, height\n-1, -0.3\n0, 0\n1, -0.3\n',
      [
        [-1, -0.3],
        [0, 0],
        [1, -0.3],
      ],
    ],
    [
      '-1,000\t-0,500\n0,000\t0,000\n1,000\t-0,500',
      [
        [-1, -0.5],
        [0, 0],
        [1, -0.5],
      ],
    ],
    [
      '−1  −0.3\n0 0\n1 −0.3',
      [
        [-1, -0.3],
        [0, 0],
        [1, -0.3],
      ],
    ],
  ])) {
    await paste(points, text);
    assert.deepEqual((await draft(page)).upper.shape.points, read, text);
  }
  await page.locator('[data-place="/upper/shape/points"]').getByText('3 points read').waitFor();
  await page.getByRole('button', { name: 'Flip heights' }).click();
  assert.deepEqual((await draft(page)).upper.shape.points, [
    [-1, 0.3],
    [0, 0],
    [1, 0.3],
  ]);
  await page.locator('.preview svg[aria-label="Profile, 3 points"]').waitFor();
});

service.test('a long trace of a stylus is levelled and filtered', async (page) => {
  await profile(page);
  const place = page.locator('[data-place="/upper/shape/points"]');
  const lines = Array.from({ length: 12_000 }, (_, k) => {
    const x = 5e-4 * k;
    const height = 40 * x - 30 * (x - 3) ** 2 + Math.sin(2100 * x) + Math.cos(571 * x);
    return `${x.toFixed(4)};${height.toFixed(3)}`;
  });
  const text = `x [mm];z [µm]\n${lines.join('\n')}`.replaceAll('.', ',');
  await place
    .locator('input[type=file]')
    .setInputFiles({ name: 'trace.csv', mimeType: 'text/csv', buffer: Buffer.from(text) });
  await place
    .getByText(/12000 points read; .*12\u202f000 points thinned to 6\u202f001;/)
    .waitFor();
  await page.getByRole('button', { name: 'Level', exact: true }).click();
  await place.getByText(/levelled: a slope of 0.0[34]/).waitFor();
  await place.getByLabel(/^Long waves/).selectOption('0.8 mm');
  await place.getByText(/ISO 16610-21, λ_c 0.800 mm: shorter waves are taken away/).waitFor();
  await page.getByRole('button', { name: 'Top to 0' }).click();
  /** @type {[number, number][]} */
  const points = (await draft(page)).upper.shape.points;
  assert.ok(points.length > 50 && points.length < 80, `${points.length}`);
  const top = points.find(([x]) => x === 0);
  assert.equal(top?.[1], 0);
  // The roughness is gone: the curvature of the parabola is left, 0.06 /mm.
  const near = points.filter(([x]) => Math.abs(x) < 1);
  const [[x0], [x1]] = near;
  near.slice(1, -1).forEach(([, z], k) => {
    const bend = (near[k][1] - 2 * z + near[k + 2][1]) / (x1 - x0) ** 2;
    assert.ok(Math.abs(bend + 0.06) < 0.006, `${bend}`);
  });
});

service.test('a smooth profile is drawn smooth, one of straight lines straight', async (page) => {
  const points = await profile(page);
  await points.fill('-10 -2.5\n-4 -0.4\n0 0\n4 -0.4\n10 -2.5');
  const corners = async () => {
    const path = (await page.locator('[data-preview=upper-shape] .curve').getAttribute('d')) ?? '';
    return path.split('L').length;
  };
  await page.locator('.preview svg[aria-label="Profile, 5 points"]').waitFor();
  assert.ok((await corners()) > 100);
  await page.getByLabel('Between points').selectOption('linear');
  assert.equal(await corners(), 5);
});

service.test('a faulty table is one message with its line', async (page) => {
  const points = await profile(page);
  const rows = Array.from(
    { length: 21 },
    (_, k) => `${k - 10} ${k === 4 ? 'oops' : k === 6 ? '1 2' : 0}`,
  );
  await paste(points, rows.join('\n'));
  const error = page.locator('[data-place="/upper/shape/points"] .error');
  await error.getByText('line 5: “oops” is not a number (and 1 more line)').waitFor();
  assert.equal(await page.locator('#setup .error:visible').count(), 1);
  assert.equal(await points.inputValue(), rows.join('\n'), 'the text stays to be put right');
  await paste(points, '1,000\t0\n2,000\t0');
  await error.getByText('line 1: “1,000” can be read as 1.000 or as 1000').waitFor();
  await paste(points, '0 0\n1 0\n0.5 0\n0.2 0\n0.1 0');
  await page.waitForFunction(() =>
    document
      .querySelector('[data-place="/upper/shape/points"] .error')
      ?.textContent?.includes('line 3'),
  );
  assert.equal(await page.locator('#setup .error:visible').count(), 1);
});

service.test(
  'a file of points is read in the letters it is written in, or leaves the points as they are',
  async (page) => {
    const points = await profile(page);
    const place = page.locator('[data-place="/upper/shape/points"]');
    const file = (/** @type {string} */ name, /** @type {Buffer} */ buffer) =>
      place.locator('input[type=file]').setInputFiles({ name, mimeType: 'text/csv', buffer });
    const read = [
      [-1, -0.005],
      [0, 0],
      [1, -0.005],
    ];
    const text = 'x [mm];h [µm]\n-1;-5\n0;0\n1;-5\n';
    for (const letters of [
      Buffer.from(text, 'latin1'),
      Buffer.from(`\ufeff${text}`, 'utf16le'),
      Buffer.from(`\ufeff${text}`),
    ]) {
      await points.fill('0 0\n1 0');
      await file('heights.csv', letters);
      await place
        .getByText('3 points read; 1 header line read; column 2 converted from µm')
        .waitFor();
      assert.deepEqual((await draft(page)).upper.shape.points, read);
    }
    for (const [name, content, said] of /** @type {[string, Buffer, string][]} */ ([
      [
        'heights.xlsx',
        Buffer.from([0x50, 0x4b, 3, 4, 0, 0, 8]),
        'Not taken: “heights.xlsx” is no text',
      ],
      ['none.csv', Buffer.from('\n'), 'Not taken: no figures in it'],
      [
        'long.csv',
        Buffer.from('0;0\n'.repeat(200_000)),
        'Not taken: 200000 lines of figures: at most 10000',
      ],
      ['huge.csv', Buffer.alloc(5e6, '0;0\n'), 'Not taken: “huge.csv” is too large'],
    ])) {
      await file(name, content);
      await place.getByText(said).waitFor();
      assert.deepEqual((await draft(page)).upper.shape.points, read, name);
    }
    await file('words.csv', Buffer.from('x;h\n1;x\n'));
    await place.getByText('“x” is not a number').waitFor();
    assert.equal(await place.locator('.note').textContent(), '', 'no word of another file');
  },
);

service.test('a tensile test becomes a hardening table', async (page) => {
  await page.getByLabel('Hardening').first().selectOption('table');
  const chooser = page.waitForEvent('filechooser');
  await page.getByRole('button', { name: 'Open CSV…' }).first().click();
  const csv = 'strain [%];stress [MPa]\n0;0\n0,1;210\n0,2;420\n1;500\n5;560\n10;580\n';
  await (
    await chooser
  ).setFiles({ name: 'tensile.csv', mimeType: 'text/csv', buffer: Buffer.from(csv) });
  const place = page.locator('[data-place="/upper/material/plasticity/points"]');
  await place
    .getByText('6 points read; along: “strain [%]” in %; up: “stress [MPa]” in MPa')
    .waitFor();
  await page.getByRole('button', { name: 'From engineering values' }).first().click();
  await place.getByText('The test rises with 210').waitFor();
  const { points } = (await draft(page)).upper.material.plasticity;
  // The last point: ε = ln 1.1, σ = 580 · 1.1, ε_p = ε − σ/E.
  const [strain, stress] = points.at(-1);
  assert.ok(Math.abs(stress - 638) < 1e-3, `${stress}`);
  assert.ok(Math.abs(strain - (Math.log(1.1) - 638 / 210000)) < 1e-5, `${strain}`);
  assert.equal(points[0][0], 0);
  await page.locator('.preview svg[aria-label="Hardening curve"]').first().waitFor();
});

service.test(
  'hardness tests of a material are jobs, several scales in one run, however long they take',
  async (page) => {
    await page.locator('[data-preset=lower]').selectOption('Steel S355');
    await page.getByRole('button', { name: 'Hardness test…' }).last().click();
    const dialog = page.getByRole('dialog', { name: 'Hardness test of this material' });
    for (const scale of ['HBW 10/3000', 'HV 10', 'HRC'])
      await dialog.getByLabel(scale, { exact: true }).uncheck();
    await dialog.getByRole('button', { name: 'Measure' }).click();
    await dialog.getByText('Choose a scale.').waitFor();
    for (const scale of ['HBW 2.5/187.5', 'HRC'])
      await dialog.getByLabel(scale, { exact: true }).check();
    await dialog.getByRole('button', { name: 'Measure' }).click();
    const rows = dialog.locator('tbody tr');
    await rows.nth(1).getByRole('button', { name: 'Show' }).waitFor({ timeout: 240_000 });
    await rows.first().getByRole('button', { name: 'Show' }).waitFor();
    const [number, diameter] = await rows.first().locator('td').allTextContents();
    assert.match(number, /^1\d\d(\.\d)? ±/, 'some 1.0 to 1.5 times three of 355 MPa');
    const millimetres = Number(diameter.replace(' mm', ''));
    assert.ok(millimetres > 0.8 && millimetres < 1.5, diameter);
    await rows.nth(1).getByText('The scale HRC is for 20 to 70 by its standard.').waitFor();
    await rows.nth(1).getByRole('button', { name: 'Show' }).click();
    await page
      .locator('#headline')
      .getByText(/^Keep in mind: .*outside scale/)
      .waitFor();
  },
);

service.test('a record of an indentation stays one, and leads to its material', async (page) => {
  await page.getByLabel('Hardening').first().selectOption('table');
  const place = page.locator('[data-place="/upper/material/plasticity/points"]');
  const fischer = RECORDS.find(({ name }) => name.startsWith('Fischer'));
  await paste(place.locator('textarea'), fischer.text);
  await place.getByText('31 points read').waitFor();
  await place.locator('.error').getByText('an indentation is no hardening curve').waitFor();
  await place.getByRole('button', { name: 'Material from this curve…' }).click();
  const dialog = page.getByRole('dialog', { name: 'Material from an indentation' });
  await dialog.getByText('31 points: 0.06800 N at a depth of 0.001000 mm').waitFor();
  await dialog.getByLabel('Indenter').selectOption('Ball');
  await dialog.getByRole('button', { name: 'Find' }).click();
  await dialog.getByText('The ball has a diameter.').waitFor();
});

service.test(
  'a record of a testing machine becomes a curve, and gives E and R_p0.2',
  async (page) => {
    await page.getByLabel('Hardening').first().selectOption('table');
    const place = page.locator('[data-place="/upper/material/plasticity/points"]');
    const [, , zwick] = RECORDS;
    // The sample lines go.
    await paste(place.locator('textarea'), zwick.text);
    await place.getByText('force over travel: the section').waitFor();
    await place.getByLabel('Diameter [mm]').fill('10');
    await place.getByLabel('Diameter [mm]').press('Tab');
    await place.getByLabel('Gauge length [mm]').fill('50');
    await place.getByLabel('Gauge length [mm]').press('Tab');
    await place.getByText('26 points read').waitFor();
    await place
      .getByText('engineering strain and stress of a test are no hardening curve')
      .waitFor();
    await place.getByRole('button', { name: 'From engineering values' }).click();
    await place.getByText('The test rises with').waitFor();
    await place.getByRole('button', { name: /^Take E = 20[45]\d{3} MPa/ }).click();
    const { young_modulus: modulus } = (await draft(page)).upper.material;
    assert.ok(Math.abs(modulus / 205000 - 1) < 0.002, `${modulus}`);
  },
);

service.test('a hardness test that is served shows its number and its specimen', async (page) => {
  const lower = {
    shape: { type: 'block', width: 20, depth: 10 },
    material: steel(500, 2000),
  };
  const none = { analysis: undefined, upper: undefined, solver: undefined, mesh: undefined };
  const id = await solved(page, { ...none, lower, load: { hardness: 'HBW 2.5/187.5' } });
  await follow(page, `#job=${id}`);
  await page
    .locator('#headline')
    .getByText(/HBW 2.5\/187.5: \d+/)
    .waitFor();
  assert.equal(await page.locator('legend', { hasText: 'Upper body' }).isVisible(), false);
  assert.equal(
    await page.locator('[data-place="/load/hardness"] input').inputValue(),
    'HBW 2.5/187.5',
  );
  assert.equal(
    await page.locator('[data-place="/lower/shape/width"] input').first().inputValue(),
    '20',
  );
});

service.test(
  'a strength follows from hardness, and materials of one’s own are kept with their source',
  async (page) => {
    await page.getByRole('button', { name: 'From hardness…' }).first().click();
    const dialog = page.getByRole('dialog');
    await dialog.getByLabel('Hardness', { exact: true }).fill('900');
    await dialog.getByRole('button', { name: 'Use' }).click();
    await dialog.getByText('The line stands for').waitFor();
    await dialog.getByLabel('Hardness', { exact: true }).fill('285');
    await dialog.getByLabel('Scale').selectOption('HBW');
    await dialog.getByRole('button', { name: 'Use' }).click();
    // 285 HBW are 300 HV: 2.876 · 300 − 90.7.
    assert.equal((await draft(page)).upper.material.plasticity.yield_stress, 772);
    await page.getByRole('button', { name: 'Keep as own…' }).first().click();
    await dialog.getByLabel('Name', { exact: true }).fill('Race of pump P-12');
    await dialog.getByLabel('Source of its figures').fill('hardness test 2026-11');
    await dialog.getByRole('button', { name: 'Keep' }).click();
    await page.locator('[data-source=upper]').getByText('hardness test 2026-11').waitFor();
    await page.reload();
    await page.locator('[data-preset=lower]').selectOption('Race of pump P-12');
    assert.equal((await draft(page)).lower.material.plasticity.yield_stress, 772);
    await page.getByLabel('Units').selectOption('SI');
    assert.equal(
      await page.locator('[data-preset=lower]').inputValue(),
      'Race of pump P-12',
      'in other units too',
    );
    await page.locator('[data-forget=lower]').click();
    await dialog.getByRole('button', { name: 'Forget' }).click();
    assert.equal(await page.locator('[data-preset=lower]').inputValue(), '');
    assert.equal(
      await page.locator('[data-preset=lower] option').getByText('Race of pump P-12').count(),
      0,
    );
  },
);

service.test('figures of another draft are not seen', async (page) => {
  let letGo = () => {};
  const held = new Promise((resolve) => {
    letGo = () => resolve(undefined);
  });
  await page.route('**/v1/hertz', async (route) => {
    await held;
    await route.continue();
  });
  const seen = () => page.locator('#check').getByText('1500.0 MPa').isVisible();
  assert.equal(await seen(), true);
  await page.locator(FORCE).fill('272.27');
  assert.equal(await seen(), false);
  assert.equal(
    await page.locator('#panel-pressure .plot').isVisible(),
    false,
    'nor is their curve',
  );
  letGo();
  await page.locator('#check').getByText('1000.0 MPa').waitFor();
  assert.equal(await page.locator('#panel-pressure .plot').isVisible(), true);
});

service.test(
  'steels of the library say where their figures are from, and convert with the units',
  async (page) => {
    const choice = page.locator('[data-preset=lower]');
    const source = page.locator('[data-source=lower]');
    for (const name of await choice.locator('option').allTextContents()) {
      if (name === 'own figures') continue;
      await choice.selectOption(name);
      assert.match(
        (await source.textContent()) ?? '',
        /EN |ISO|Pavlina|Jiang|static rating/,
        name,
      );
    }
    await choice.selectOption({ label: 'Gear steel 18CrNiMo7-6, case 1 mm' });
    await source.getByText('the least of ISO 6336-5').waitFor();
    assert.equal((await draft(page)).lower.material.plasticity.over_depth.hardness.case_depth, 1);
    await page.getByLabel('Units').selectOption('SI');
    assert.equal(
      (await draft(page)).lower.material.plasticity.over_depth.hardness.case_depth,
      0.001,
    );
    assert.equal(await choice.inputValue(), 'Gear steel 18CrNiMo7-6, case 1 mm');
    await page.locator('[data-place="/lower/material/law"] select').selectOption('voce');
    assert.equal(
      (await draft(page)).lower.material.plasticity.over_depth.hardness.core,
      266,
      'another law, the same case',
    );
  },
);

service.test(
  'initial stress is a table over depth, drawn and checked line by line',
  async (page) => {
    const kind = page.locator('[data-place="/lower/material/stress_kind"] select');
    const place = page.locator('[data-place="/lower/material/initial_stress"]');
    const rows = async () => (await draft(page)).lower.material.initial_stress;
    await unfold(page);
    await kind.selectOption('given');
    await page.locator('[data-preview=lower-stress] svg').waitFor();
    const typical = await rows();
    assert.equal(typical.length, 5);
    // The material yields at 500 MPa, and the stress by itself does not.
    assert.ok(
      typical.every(
        (/** @type {any} */ row) => Math.abs(row.sigma_x) <= 300 && row.sigma_z === row.sigma_x,
      ),
    );
    await place.locator('textarea').fill('0 -200\n0,1 -100 -100');
    await place.locator('.error').getByText('line 1 has 2 columns, not three').waitFor();
    await place.locator('textarea').fill('0 -200 -150\n0,1 -100 -100\n0,1 -150 -120');
    await place
      .locator('.error')
      .getByText('line 3: must be greater than the depth before')
      .waitFor();
    await place.locator('textarea').fill('0 -900 0\n0.3 0 0');
    await place.locator('.error').getByText('yields by itself').waitFor();
    await paste(place.locator('textarea'), 'depth [µm];σ_x [MPa];σ_z [MPa]\n0;-200;-150\n300;0;0');
    await place
      .getByText('2 points read; 1 header line read; column 1 converted from µm')
      .waitFor();
    assert.deepEqual(await rows(), [
      { depth: 0, sigma_x: -200, sigma_z: -150 },
      { depth: 0.3, sigma_x: 0, sigma_z: 0 },
    ]);
    await page.getByLabel('Units').selectOption('SI');
    assert.deepEqual((await rows())[1], { depth: 0.0003, sigma_x: 0, sigma_z: 0 });
    assert.deepEqual((await rows())[0], { depth: 0, sigma_x: -2e8, sigma_z: -1.5e8 });
    await page.locator('[data-place="/lower/material/law"] select').selectOption('voce');
    assert.equal((await rows()).length, 2, 'another law, the same stress');
    await page.getByLabel('Analysis').selectOption('axisymmetric');
    await place.locator('.error').getByText('line 1: must equal').waitFor();
    await place.locator('textarea').fill('');
    await place.locator('.error').getByText('is empty').waitFor();
    assert.equal(
      await place.locator('textarea').evaluate((area) => area === document.activeElement),
      true,
    );
    await paste(place.locator('textarea'), '0 -1e8 -1e8\n0.0003 0 0');
    assert.equal((await rows()).length, 2, 'another table is pasted where one was taken out');
    await kind.selectOption('none');
    assert.equal(await rows(), undefined);
    assert.equal(await place.count(), 0);
  },
);

service.test('terms of the backstress are a table', async (page) => {
  const terms = page.getByLabel('Backstress C, γ').first();
  await terms.fill('60000 400\n5000; 0');
  await page
    .locator('[data-place="/upper/material/plasticity/backstress"] .error')
    .getByText('line 1')
    .waitFor();
  await terms.fill('60000 400\n5000 0');
  const upper = async () => (await draft(page)).upper.material.plasticity.backstress;
  assert.deepEqual(await upper(), [
    { modulus: 60000, rate: 400 },
    { modulus: 5000, rate: 0 },
  ]);
  await page.getByLabel('Units').selectOption('SI');
  assert.deepEqual((await upper())[0], { modulus: 6e10, rate: 400 });
  assert.equal(await terms.inputValue(), '60000000000  400\n5000000000  0');
  await terms.fill('1e9 -3');
  await page
    .locator('[data-place="/upper/material/plasticity/backstress"] .error')
    .getByText('line 1: ')
    .waitFor();
  await terms.fill('');
  assert.equal(await upper(), undefined);
});

service.test(
  'a slider begins at nothing too, and a choice that is not made says so',
  async (page) => {
    const place = page.locator('[data-place="/upper/material/plasticity/tangent_modulus"]');
    await place.locator('input').fill('0');
    await place.getByRole('button', { name: 'Slider' }).click();
    await place.getByRole('slider').press('End');
    assert.equal((await draft(page)).upper.material.plasticity.tangent_modulus, 10500);
    await page.getByLabel('Shape').first().selectOption('profile');
    const between = page.getByLabel('Between points');
    assert.equal(await between.locator('option:checked').textContent(), 'smooth');
    await between.selectOption('automatic');
    assert.equal((await draft(page)).upper.shape.interpolation, undefined);
    await page.locator('#example').focus();
    assert.equal(await between.locator('option:checked').textContent(), 'automatic');
    await between.selectOption('linear');
    assert.equal((await draft(page)).upper.shape.interpolation, 'linear');
  },
);

service.test('a force is looked for by what it does', async (page) => {
  await page.getByLabel('Given').selectOption('target');
  assert.deepEqual((await draft(page)).load, { target: { peak_pressure: 1200 } });
  await page.getByLabel('Figure', { exact: true }).selectOption('dent_depth');
  await page.getByLabel('Units').selectOption('SI');
  assert.deepEqual((await draft(page)).load, { target: { dent_depth: 1e-6 } });
  await page.getByRole('button', { name: 'Undo' }).click();
  await page.getByLabel('Theory').selectOption('deformation');
  await page
    .locator('[data-place="/load/target/dent_depth"] .error')
    .getByText('unloading')
    .waitFor();
  await page.getByLabel('Figure', { exact: true }).selectOption('half_width');
  await page.getByText('Mesh, solver, output, tags').click();
  await page.getByLabel('Elements per half-width', { exact: true }).fill('8');
  await page.getByLabel('Half-width a').fill('0.2');
  await page.getByRole('button', { name: 'Solve', exact: true }).click();
  await page.locator('[data-status=succeeded]').waitFor();
  const found = page.locator('#headline > dl > div', { hasText: 'Force found' });
  assert.match((await found.textContent()) ?? '', /^Force found3\d\dN\/mm ± /);
});

service.test('every example converges', async (page) => {
  const states = await page.evaluate(async () => {
    const { examplesOf } = await import(/** @type {any} */ ('/web/setup/examples.js'));
    const { examples } = await (await fetch('v1/examples')).json();
    const states = /** @type {string[]} */ ([]);
    for (const { title, job } of examplesOf(examples)) {
      const body = JSON.stringify({ ...job, mesh: { elements_per_half_width: 6 }, output: {} });
      const headers = { 'Content-Type': 'application/json' };
      const answer = await (await fetch('v1/solve', { method: 'POST', headers, body })).json();
      // A long solve is answered as a job.
      for (let job = answer; job.done === false;) {
        job = await (await fetch(`v1/jobs/${answer.id}?wait=30`)).json();
        if (job.done) answer.result = await (await fetch(`v1/jobs/${answer.id}/result`)).json();
      }
      const codes = (answer.result?.steps ?? []).flatMap((/** @type {any} */ step) =>
        step.validity.map((/** @type {any} */ one) => one.code),
      );
      states.push(
        `${title}: ${answer.result?.status ?? JSON.stringify(answer)} ${[...new Set(codes)].join(' ')}`,
      );
    }
    return states;
  });
  assert.ok(states.length >= 8);
  for (const state of states) assert.match(state, /: converged/);
});

service.test('a profile that is chosen is one that is taken', async (page) => {
  for (const body of ['upper', 'lower']) {
    const answered = page.waitForResponse((response) => response.url().endsWith('/validate'));
    await page.locator(`[data-place="/${body}/shape/type"] select`).selectOption('profile');
    assert.equal((await answered).status(), 200);
    assert.equal(await page.locator('#form [aria-invalid=true]').count(), 0);
  }
});

service.test(
  'a body is copied as it is, not as it was when the form was put together',
  async (page) => {
    await page.locator('[data-place="/lower/shape/radius"] input[type=text]').fill('33');
    await page.locator('#example').focus();
    await page.keyboard.press('Control+z');
    await page.keyboard.press('Control+y');
    await page.locator('[data-place="/lower/shape/radius"] input[type=text]').fill('44');
    await page.getByRole('button', { name: 'same as lower' }).click();
    assert.equal((await draft(page)).upper.shape.radius, 44);
  },
);

service.test(
  'shapes, strengths and laws that are chosen after other units are as large',
  async (page) => {
    const lower = async () => (await draft(page)).lower;
    const choose = (/** @type {string} */ place, /** @type {string} */ value) =>
      page.locator(`[data-place="/lower${place}"] select`).selectOption(value);
    await page.locator('[data-place="/units"] select').selectOption('SI');
    const shapes = await page
      .locator('[data-place="/lower/shape/type"] option')
      .evaluateAll((options) =>
        options.map((option) => /** @type {HTMLOptionElement} */ (option).value),
      );
    for (const type of shapes) {
      await choose('/shape/type', 'cylinder');
      await page.locator('[data-place="/lower/shape/radius"] input[type=text]').fill('0.02');
      await choose('/shape/type', type);
      for (const [key, value] of Object.entries((await lower()).shape))
        if (typeof value === 'number' && !['exponent', 'angle'].includes(key))
          assert.ok(value < 1, `${type}: ${key} ${value} m`);
    }
    await unfold(page);
    for (const kind of ['factors', 'hardness']) {
      await choose('/material/plasticity/depth_kind', kind);
      const { over_depth: given } = (await lower()).material.plasticity;
      const rows = Array.isArray(given) ? given : given.hardness.profile;
      assert.ok(rows.at(-1)[0] < 0.1, JSON.stringify(given));
    }
    await choose('/material/plasticity/depth_kind', 'case');
    assert.equal((await lower()).material.plasticity.over_depth.hardness.case_depth, 0.001);
    await choose('/material/law', 'rigid');
    await choose('/material/law', 'bilinear');
    const { young_modulus: modulus, plasticity } = (await lower()).material;
    assert.equal(modulus, 2.1e11);
    assert.equal(plasticity.yield_stress, 5e8);
  },
);
