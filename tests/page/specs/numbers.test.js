/**
 * Figures as people type and paste them: read right, or refused in words; never something else.
 */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { readNumber } from '../../../web/lib/number.js';
import { readTable } from '../../../web/lib/table.js';
import { differences, writeWhole } from '../../../web/jobs/names.js';
import { historyWords, readHistory } from '../../../web/setup/history.js';
import { readList, sweepWords } from '../../../web/setup/list.js';
import { suite } from '../browser.js';
import { allFields } from '../../../web/setup/fields.js';
import { described as ofTable, inWords } from '../../../web/setup/words.js';
import { draft, unfold } from '../jobs.js';

const service = suite();

test('spaces and apostrophes group digits by threes, or are refused', () => {
  for (const [text, read] of /** @type {[string, number | undefined][]} */ ([
    ['100 200', 100200],
    ['1\u00a0000\u00a0000,5', 1000000.5],
    ['-1’500.5', -1500.5],
    ['0,5', 0.5],
    ['4.5·10⁸', 4.5e8],
    ['10^-3', 1e-3],
    ['0.5 500', undefined],
    ['1.5\u00a0250', undefined],
    ['12 34', undefined],
    ['1 0000', undefined],
    ['1,234', undefined],
    ['1,234.5', undefined],
    ['1.234,5', undefined],
  ])) {
    const reading = readNumber(text);
    assert.equal('value' in reading ? reading.value : undefined, read, text);
  }
  assert.deepEqual(readNumber('1.234,5'), {
    problem: '“1.234,5” is not a number: write its thousands without a sign between them',
  });
});

test('a list is read as it is meant, or refused', () => {
  const unclear = /can be one number or several: put a space between numbers, none within/;
  for (const [text, read] of /** @type {[string, number[] | RegExp][]} */ ([
    ['100, 200 ,300; 400\t500', [100, 200, 300, 400, 500]],
    ['100,5 200,5', [100.5, 200.5]],
    ['1’000 2’000', unclear],
    ['100\u00a0200\u00a0300 N/mm', unclear],
    ['1 000 2 000', unclear],
    ['100,200,300', unclear],
    ['1000,500', unclear],
    ['100 N/mm; 200 N/mm', [100, 200]],
    ['0.1 0.2 0.3 kN/mm', [100, 200, 300]],
    ['100…600/6', [100, 200, 300, 400, 500, 600]],
    ['0.1 ... 0.3 kN/mm / 3', [100, 200, 300]],
    ['1000,5 2.000', /^number 2: “2.000” has a decimal point, and others have a decimal comma/],
    ['100,200 300', /^number 1: “100,200” can be read as 100\.200 or as 100200/],
    ['100 200 N/mm 300', /^write the unit behind each number, or behind the last one for all$/],
    ['100 0x10', /^number 2: “0x10” is not a number/],
    ['1e400', /^“1e400” is too large for a number$/],
    ['5 1e-400', /^number 2: “1e-400” is too close to 0/],
    ['600…100/0', /^a range has 2 to 1000 numbers, not 0$/],
    ['1…5000/5000', /^a range has 2 to 1000 numbers, not 5000$/],
    ['100…600', /^a range is written as 100…1200\/12/],
  ])) {
    const result = readList(text, 'line_force', 'mm_N_MPa');
    if (read instanceof RegExp)
      assert.match('problem' in result ? result.problem : JSON.stringify(result), read, text);
    else assert.deepEqual(result, { values: read }, text);
  }
});

test('a thousand numbers are a list', () => {
  const text = Array.from({ length: 1000 }, (_, k) => k + 1).join(' ');
  const result = readList(text, 'line_force', 'mm_N_MPa');
  assert.equal('values' in result && result.values.length, 1000);
});

test('loads in turn are read as they are meant, or refused', () => {
  for (const [text, read] of /** @type {[string, object[] | RegExp][]} */ ([
    ['600 → 0 → 600', [{ force: 600 }, { force: 0 }, { force: 600 }]],
    ['α 0.01 mm, 0', [{ approach: 0.01 }, { force: 0 }]],
    [
      '0.6 0 kN/mm α10 α20 µm',
      [{ force: 600 }, { force: 0 }, { approach: 0.01 }, { approach: 0.02 }],
    ],
    ['600,0', /can be one number or several/],
    ['600\u202f000\u202f0', /can be one number or several/],
    ['600 0 x', /^load 2: “x” is no unit known here/],
  ])) {
    const result = readHistory(text, 'line_force', 'mm_N_MPa');
    if (read instanceof RegExp)
      assert.match('problem' in result ? result.problem : JSON.stringify(result), read, text);
    else assert.deepEqual(result, { loads: read }, text);
  }
});

const UNITS = { force: 'N/mm', approach: 'mm' };

test('loads in turn are written with their letters, units and digits', () => {
  const forces = (/** @type {number[]} */ ...all) => all.map((force) => ({ force }));
  for (const [history, words] of /** @type {[object[], string][]} */ ([
    [forces(600, 0, 600.123456789), 'P 600 → 0 → 600.123456789 N/mm'],
    [[{ approach: 0.01 }, ...forces(800, 0)], 'α 0.01 mm → P 800 → 0 N/mm'],
    [
      [...forces(612.610612345678), { approach: 0.0212345678912 }],
      'P 612.610612346 N/mm → α 0.0212345678912 mm',
    ],
    [[1, 2, 1, 2, 1].map((k) => ({ approach: k / 100 })), 'α 5 loads up to 0.02 mm'],
    [
      [...forces(800, 200, 1200, 300), { approach: 0.05 }],
      '5 loads, P up to 1200 N/mm, α up to 0.05 mm',
    ],
    [forces(1, 0, 2, 0, 3), 'P 5 loads up to 3 N/mm'],
  ]))
    assert.equal(historyWords(history, UNITS), words);
  assert.equal(historyWords(forces(600, 0), UNITS, { is: ' = ' }), 'P = 600 → 0 N/mm');
});

test('a sweep is told by its ends where it goes from one to the other', () => {
  for (const [values, words] of /** @type {[number[], string][]} */ ([
    [[300], '300'],
    [[100, 300, 1000.12345678], '100 … 1000.12345678'],
    [[1000, 300, 100], '1000 … 100'],
    [[100, 1000, 300], '100, 1000, 300'],
    [[100, 1000, 300, 200, 500], '5 values, 100 … 1000'],
  ]))
    assert.equal(sweepWords(values), words);
});

test('rows of figures are written in the order of their columns, and are the same whatever the order of their keys', () => {
  const turned = [
    { sigma_z: -123, sigma_x: -200, depth: 0 },
    { sigma_z: 0, sigma_x: 0, depth: 0.3 },
  ];
  const straight = turned.map(({ depth, sigma_x, sigma_z }) => ({ depth, sigma_x, sigma_z }));
  assert.equal(writeWhole(turned), '0 −200 −123; 0.3 0 0');
  assert.equal(
    writeWhole([{ rate: 0.123456789, modulus: 20000.12345678 }]),
    '20000.1234568, 0.123456789',
  );
  const job = (/** @type {object[]} */ rows) => ({
    lower: { material: { initial_stress: rows } },
    load: { force: 1 },
  });
  assert.deepEqual(differences([job(turned), job(straight)]), []);
  const [found] = differences([job(turned), job([straight[0], { ...straight[1], sigma_x: 1 }])]);
  assert.deepEqual(found.texts, ['0 −200 −123; 0.3 0 0', '0 −200 −123; 0.3 1 0']);
});

/** @type {Record<string, [import('../../../web/lib/units.js').Quantity[], string[]]>} */
const TABLES = {
  profile: [['length', 'length'], ['x', 'height']], // prettier-ignore
  strength: [['strain', 'stress'], ['ε_p', 'q']], // prettier-ignore
  hardness: [['length', 'hardness'], ['z', 'HV']], // prettier-ignore
  factors: [['length', 'number'], ['z', 'factor']], // prettier-ignore
  stress: [['length', 'stress', 'stress'], ['z', 'σ_x', 'σ_z']], // prettier-ignore
  turned: [['length', 'stress', 'stress'], ['z', 'σ_r', 'σ_θ']], // prettier-ignore
};

/** @param {keyof TABLES} kind @param {string} text @param {number[][] | RegExp} read what comes of it, or how it is refused */
function reads(kind, text, read) {
  const result = readTable(text, TABLES[kind][0], 'mm_N_MPa', TABLES[kind][1]);
  if (read instanceof RegExp)
    assert.match('problem' in result ? result.problem : JSON.stringify(result), read, text);
  else assert.deepEqual('points' in result ? result.points : result, read, text);
}

test('figures of a table are read, or the first line at fault is said', () => {
  for (const [text, read] of /** @type {[string, number[][] | RegExp][]} */ ([
    ['0,5\t2', [[0.5, 2]]],
    ['1\u202f234,5\t2', [[1234.5, 2]]],
    [
      '0, 1.5\n2, 3',
      [
        [0, 1.5],
        [2, 3],
      ],
    ],
    [
      '0.1,5\n0.2,6',
      [
        [0.1, 5],
        [0.2, 6],
      ],
    ],
    [
      '0.250;2\n1.0;3',
      [
        [0.25, 2],
        [1, 3],
      ],
    ],
    [
      '1.000;2,5\n2.000;3,5',
      /^line 1: “1.000” has a decimal point, and others have a decimal comma/,
    ],
    ['0.1 mm\t5 µm', [[0.1, 0.005]]],
    ['0.1 mm\t5 N', /^line 1: “5 N” is not a number/],
    ['0x10 5', /^line 1: “0x10” is not a number/],
    ['0 1e400', /^line 1: “1e400” is too large/],
    ['0\t500\n0.1 600\t700', /^line 2: “0.1 600” is not a number$/],
    ['x;height\n0;1;500', /^line 2 has 3 columns, not two/],
    ['0;500\n;600', /^line 2: “” is not a number$/],
    [
      '0;500\n# end of the trace\n1;600',
      [
        [0, 500],
        [1, 600],
      ],
    ],
  ]))
    // prettier-ignore
    reads('profile', text, read);
});

test('names and units above a table are known, or refused', () => {
  for (const [kind, header, read] of /** @type {[keyof TABLES, string, number[] | RegExp][]} */ ([
    ['profile', 'x (mm)\th (µm)', [1, 0.005]],
    ['profile', 'x / mm\th/µm', [1, 0.005]],
    ['profile', 'x, mm\ty, μm', [1, 0.005]],
    ['profile', 'x in mm\theight in µm', [1, 0.005]],
    ['profile', 'x in mm\tdepth in µm', /^line 1: “depth in µm” is not known here/],
    ['profile', 'x_mm\th_um', [1, 0.005]],
    ['profile', 'x\th\nmm\tµm', [1, 0.005]],
    ['profile', '# x [mm]\th [µm]', [1, 0.005]],
    ['profile', 'h [µm]\tx [mm]', [5, 0.001]],
    ['strength', 'strain %\tstress N/mm2', [0.01, 5]],
    ['strength', 'ε_p in ‰\tσ/MPa', [0.001, 5]],
    ['strength', 'plastic strain [mm/mm]\ttrue stress', [1, 5]],
    ['strength', '%\tN/mm²', [0.01, 5]],
    ['strength', 'Stress [MPa]\tStrain [%]', [0.05, 1]],
    ['hardness', 'Depth [mm]\tHV1', [1, 5]],
    ['hardness', 'Depth\t[HV10]', [1, 5]],
    ['hardness', 'Depth (µm)\tHardness [HV0.5]', [0.001, 5]],
    ['hardness', 'z\tHV 0.3', [1, 5]],
    ['hardness', 'HV1\tDepth [µm]', [0.005, 1]],
    ['factors', 'depth\tfactor', [1, 5]],
    [
      'profile',
      'x [mm]\th [\ufffdm]',
      /^line 1: “\ufffdm” is no unit known here for column 2\. The names of the columns are x \[mm\], height \[mm\]/,
    ],
    ['profile', 'x\tσ [MPa]', /^line 1: “σ \[MPa\]” is not known here/],
    ['profile', 'x\th [N]', /^line 1: “N” is no unit known here for column 2/],
    ['profile', 'x [mm]\th [mm]\nmm\tµm', /^line 2: “µm” is not “mm” as in a line above/],
    ['profile', '# stylus\nTrace (left)\nx\th', [1, 5]],
    ['profile', '# stylus x50\nx\th', /^line 1: “stylus x50” is not known here/],
    ['profile', 'Run 7\nx\th', [1, 5]],
    ['profile', 'Run 7, 2.5\nx\th', /^line 1: /],
    ['profile', 'All lengths in µm', /^line 1: “All lengths in µm” is not known here/],
    ['strength', 'eps x1000\tsigma', /^line 1: “eps x1000” is not known here/],
    ['strength', 'strain*1e3\tstress', /^line 1: “strain\*1e3” is not known here/],
    ['strength', 'ε_p · 10³\tq', /^line 1: “ε_p · 10³” is not known here/],
    ['strength', 'ε_p [10⁻³]\tq [MPa]', /^line 1: “10⁻³” is no unit known here/],
    ['strength', '10^3 strain\tstress', /^line 1: “10\^3 strain” is not a number/],
    ['strength', 'eng. strain\teng. stress', /^the unit of “eng. strain” is not said: choose it/],
    ['strength', 'total strain\tstress', /^the unit of “total strain” is not said/],
    ['strength', 'stress\tTotal strain', /^the unit of “Total strain” is not said/],
    ['strength', 'yield\tstress', /^line 1: “yield” is not known here/],
    ['factors', 'z\t%', /^line 1: “%” is no unit known here for column 2/],
    [
      'hardness',
      'Depth [mm]\tHRB',
      /^line 1: “HRB” is another scale, .* Vickers hardness HV: convert/,
    ],
    ['hardness', 'z\tHardness_HB', /“HB” is another scale/],
    ['hardness', 'z\tHBW 2.5/187.5', /“HBW” is another scale/],
    ['hardness', 'z\tHK0.5', /“HK” is another scale/],
    ['hardness', 'z\tRockwell C', [1, 5]],
    ['hardness', 'Hardness in HRC\nz\tHV', /“HRC” is another scale/],
  ]))
    // prettier-ignore
    reads(kind, `${header}\n1\t5`, read instanceof RegExp ? read : [read]);
  reads('hardness', '0\t60 HRC', /^line 1: “60 HRC” is not a number/);
});

test('stresses are taken by the names of their directions', () => {
  for (const [kind, header, point] of /** @type {[keyof TABLES, string, number[] | RegExp][]} */ ([
    ['stress', 'depth\tsigma_z\tsigma_x', [0.1, 3, 2]],
    ['stress', 'z [mm]\tσz [MPa]\tσx [MPa]', [0.1, 3, 2]],
    ['stress', 'z [mm]\tS33\tS11', [0.1, 3, 2]],
    ['stress', 'z\tσxx [GPa]\tσzz', [0.1, 2000, 3]],
    ['stress', 'z\tσzz [GPa]\tσxx', [0.1, 3, 2000]],
    ['turned', 'z mm\tσθ MPa\tσr MPa', [0.1, 3, 2]],
    ['turned', 'z mm\tσz MPa\tσr MPa', /^line 1: “σz MPa” is not known here/],
    ['stress', 'z\tσ_x\tσ_y', /^line 1: “σ_y” is not known here/],
    ['stress', 'z\tσ_x\tσ_xx', /^line 1: “σ_xx” is not known here/],
    ['stress', 'z\tleft\tright', /^line 1: “left” is not known here/],
  ]))
    // prettier-ignore
    reads(kind, `${header}\n0.1\t2\t3`, point instanceof RegExp ? point : [point]);
});

test('every hyphen before a digit is a minus, and no line of figures is taken for a header', () => {
  for (const minus of ['-', '−', '–', '\u2010', '\u2011', '\u2012', '\ufe63', '\uff0d']) {
    reads('profile', `${minus}10\t${minus}2.5\n0\t0`, [[-10, -2.5], [0, 0]]); // prettier-ignore
    assert.deepEqual(
      readList(`${minus}10 5 ${minus}2`, undefined, 'mm_N_MPa'),
      { values: [-10, 5, -2] },
      minus,
    );
    assert.deepEqual(readNumber(`${minus}1.5e${minus}2`), { value: -0.015 }, minus);
  }
  for (const sign of ['\u2014', '\u2015', '~', '±', '<'])
    reads('profile', `${sign}10\t${sign}2.5\n0\t0`, /^line 1: “.10” is not a number/);
});

service.test(
  'a hardness typed in another scale is refused, in its own it is read',
  async (page) => {
    await unfold(page);
    await page
      .locator('[data-place="/lower/material/plasticity/depth_kind"] select')
      .selectOption('case');
    const place = page.locator(
      '[data-place="/lower/material/plasticity/over_depth/hardness/surface"]',
    );
    await place.locator('input[type=text]').fill('60 HRC');
    await place.getByText('“HRC” is no unit known here for this figure').waitFor();
    await place.locator('input[type=text]').fill('700 HV10');
    assert.equal((await draft(page)).lower.material.plasticity.over_depth.hardness.surface, 700);
  },
);

service.test(
  'a list at fault is refused at its field, stays as it is typed, and may be left for another load',
  async (page) => {
    await page.getByLabel('Given').selectOption('forces');
    const place = page.locator('[data-place="/load/forces"]');
    await place.locator('input').fill('100,200,300');
    await place.getByText('“100,200,300” can be one number or several').waitFor();
    await page.getByRole('button', { name: 'Solve', exact: true }).click();
    await page.getByText('One field is wrong: the cursor is in it.').waitFor();
    await page.getByLabel('Radius').first().focus();
    assert.equal(await place.locator('input').inputValue(), '100,200,300');
    await place.locator('input').fill('100; 200 N/mm');
    await page.waitForFunction(
      () => document.querySelectorAll('[aria-invalid=true]').length === 0,
    );
    assert.deepEqual((await draft(page)).load.forces, [100, 200]);
    await page.getByLabel('Given').selectOption('history');
    await page.locator('[data-place="/load/history"] input').fill('600,0');
    await page
      .locator('[data-place="/load/history"]')
      .getByText('can be one number or several')
      .waitFor();
    await page.getByLabel('Units').selectOption('SI');
    await page.getByLabel('Given').selectOption('approach');
    assert.deepEqual((await draft(page)).load, { approach: 2e-5 });
  },
);

service.test(
  'what is no figure is not drawn as one, and is no place for a slider',
  async (page) => {
    const place = page.locator('[data-place="/upper/shape/radius"]');
    await place.locator('input').fill('0x10');
    await place.getByText('“0x10” is not a number').waitFor();
    assert.doesNotMatch((await page.locator('#sketch').textContent()) ?? '', /R 16/);
    await place.getByRole('button', { name: 'Slider' }).click();
    assert.equal(await place.getByRole('slider').count(), 0);
    await page.getByRole('button', { name: 'JSON', exact: true }).click();
    const text = page.locator('#json-text');
    await text.fill((await text.inputValue()).replace('612.6106', '1e400'));
    await page.locator('#json-state').getByText('“force” is too large for a number').waitFor();
  },
);

service.test('a message goes with the figure that it is about', async (page) => {
  const place = page.locator('[data-place="/load/force"]');
  const force = place.locator('input[type=text]');
  await force.fill('-5');
  await place.getByText('must be greater than 0').waitFor();
  let letGo = () => {};
  const held = new Promise((resolve) => {
    letGo = () => resolve(undefined);
  });
  await page.route('**/v1/validate', async (route) => {
    await held;
    await route.continue().catch(() => {});
  });
  await force.fill('5');
  assert.equal(await place.locator('.error').isVisible(), false);
  assert.equal(await force.getAttribute('aria-invalid'), 'false');
  letGo();
});

service.test('an open slider follows its field, and the units of the job', async (page) => {
  const place = page.locator('[data-place="/upper/shape/radius"]');
  const radius = place.locator('input[type=text]');
  const value = async () => Number(await radius.inputValue());
  await place.getByRole('button', { name: 'Slider' }).click();
  const slider = place.getByRole('slider');
  await page.getByLabel('Units', { exact: true }).selectOption('SI');
  await slider.press('ArrowRight');
  assert.ok(Math.abs((await value()) - 0.0202) < 1e-9, `${await value()} m`);
  await page.getByLabel('Units', { exact: true }).selectOption('mm_N_MPa');
  await radius.fill('5');
  await slider.press('ArrowRight');
  assert.ok(Math.abs((await value()) - 5.06) < 0.02, `${await value()} mm`);
  await slider.press('Control+Z');
  assert.equal(await value(), 5);
  assert.equal(await slider.getAttribute('aria-valuetext'), '5');
  await slider.press('ArrowRight');
  assert.ok(Math.abs((await value()) - 5.06) < 0.02, `${await value()} mm after undo`);
  await radius.fill('five');
  assert.equal(await slider.count(), 0, 'what is no figure has no slider');
});

service.test(
  'a slider beside a figure that is refused moves among those that are taken',
  async (page) => {
    const place = page.locator('[data-place="/upper/shape/radius"]');
    await place.locator('input[type=text]').fill('-5');
    await place.locator('input[aria-invalid=true]').waitFor();
    await place.getByRole('button', { name: 'Slider' }).click();
    await place.getByRole('slider').press('Home');
    assert.equal((await draft(page)).upper.shape.radius, 6.67);
    await page.locator('[data-status=live]').getByText('solved in').waitFor();
  },
);

service.test('typing and sliding are undone one after the other', async (page) => {
  const place = page.locator('[data-place="/upper/shape/radius"]');
  const radius = place.locator('input[type=text]');
  await radius.fill('5');
  await place.getByRole('button', { name: 'Slider' }).click();
  await place.getByRole('slider').press('ArrowRight');
  await radius.fill('7');
  const seen = [];
  for (let k = 0; k < 3; k++) {
    await page.getByRole('button', { name: 'Undo' }).click();
    seen.push(Number(await radius.inputValue()));
  }
  assert.equal(seen[1], 5);
  assert.equal(seen[2], 20);
  assert.notEqual(seen[0], 7);
});

service.test('what is far too long is cut, said briefly, and not asked again', async (page) => {
  const radius = page.locator('[data-place="/upper/shape/radius"]');
  // As it is pasted: what the keyboard gives is cut to what a field takes.
  await radius.locator('input[type=text]').focus();
  await page.keyboard.press('Control+a');
  await page.keyboard.insertText('lorem ipsum 1,2;3 '.repeat(50_000));
  await radius.getByText('is not a number').waitFor();
  assert.ok((await radius.locator('.error').innerText()).length < 100);
  assert.ok(JSON.stringify(await draft(page)).length < 10_000);
  await page.getByRole('button', { name: 'Undo' }).click();
  await page.getByLabel('Given').selectOption('forces');
  const forces = page.locator('[data-place="/load/forces"]');
  await forces.locator('input').fill('1 '.repeat(2000));
  await forces.getByText('2000 numbers: at most 1000 are taken').waitFor();
  await forces.locator('input').focus();
  await page.keyboard.press('Control+a');
  await page.keyboard.insertText('1 '.repeat(150_000));
  await forces.getByText('too long: at most 1000 numbers are taken').waitFor();
  await page.getByLabel('Hardening').first().selectOption('table');
  const points = page.locator('[data-place="/upper/material/plasticity/points"]');
  await points.locator('textarea').fill('1 2 '.repeat(250_000));
  await points.getByText('line 1 has 1000000 letters: a point has a line of its own').waitFor();
  await points.locator('textarea').fill('0 500');
  await page.getByRole('button', { name: 'JSON', exact: true }).click();
  const text = page.locator('#json-text');
  const { tags, ...job } = await draft(page);
  await text.fill(JSON.stringify({ ...job, tags: { ...tags, long: 'x'.repeat(1.2e6) } }));
  await page.getByText('This is too large for the service: try fewer points or loads.').waitFor();
  assert.equal(await page.getByText('It is asked again').count(), 0);
});

service.test('the words at a history and at a figure', async (page) => {
  await page.locator('[data-place="/upper/shape/radius"] input[type=text]').fill('0x10');
  await page.getByText('“0x10” is not a number').first().waitFor();
  await page.getByLabel('Given').selectOption('history');
  const history = page.locator('[data-place="/load/history"]');
  await history.locator('input').fill('600 -> 0 => 700');
  assert.deepEqual((await draft(page)).load.history, [
    { force: 600 },
    { force: 0 },
    { force: 700 },
  ]);
  await page.locator('[data-place="/upper/shape/radius"] input[type=text]').fill('20');
  await history.locator('input').fill('600 0 -1');
  await history.getByText('load 3: must be 0 or greater, got -1').waitFor();
});

test('what the service tells programs is told to people in their words', () => {
  assert.equal(
    inWords(
      'a punch is rigid (`{"rigid": true}`), because its contact reaches to the edge of its face; give a face that deforms as a `profile`',
    ),
    'a punch is rigid (Rigid under Hardening), because its contact reaches to the edge of its face; give a face that deforms as a profile',
  );
  assert.equal(
    inWords('ends within about 3.62e-2 mm: must be between 1e-6 and 1e8 mm'),
    'ends within about 0.0362 mm: must be between 10⁻⁶ and 10⁸ mm',
  );
  assert.equal(
    inWords(
      'at x = 0.000000 mm of a profile: set its `interpolation` to "linear" if this is a corner',
    ),
    'at x = 0 mm of a profile: set “Between points” to “linear” if this is a corner',
  );
  const described = allFields().map(({ description = '' }) => ofTable(description));
  assert.deepEqual(
    described.filter((one) => one.includes('`') || (one && one.split(' ').length < 2)),
    [],
  );
});
