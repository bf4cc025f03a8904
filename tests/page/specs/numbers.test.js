/** Figures as people type and paste them: read right, or refused in words; never something else. */

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
import { draft } from '../jobs.js';

const service = suite();

test('spaces and apostrophes group digits by threes, or are refused', () => {
  for (const [text, read] of /** @type {[string, number | undefined][]} */ ([
    ['100 200', 100200],
    ['1\u00a0000\u00a0000,5', 1000000.5],
    ['-1’500.5', -1500.5],
    ['0.123 456', 0.123456],
    ['0,123 4', 0.1234],
    ['0.5 500', undefined],
    ['1.5\u00a0250', undefined],
    ['12 34', undefined],
    ['1000 500', undefined],
    ['1 0000', undefined],
  ])) {
    const reading = readNumber(text);
    assert.equal('value' in reading ? reading.value : undefined, read, text);
  }
});

test('a list is read as it is meant, or refused', () => {
  for (const [text, read] of /** @type {[string, number[] | RegExp][]} */ ([
    ['100 200 300', [100, 200, 300]],
    ['100, 200 ,300; 400\t500', [100, 200, 300, 400, 500]],
    ['100,5 200,5', [100.5, 200.5]],
    ['1’000 2\u202f000 3\u00a0000', [1000, 2000, 3000]],
    ['100\u00a0200\u00a0300', /can be one number or several: put plain spaces/],
    ['100\u00a0200\u00a0300 N/mm', /can be one number or several: put plain spaces/],
    ['10\u00a020\u00a030', [10, 20, 30]],
    ['100\u202f200\u202f300', /can be one number or several: put plain spaces/],
    ['100\u2009200 N/mm', /can be one number or several: put plain spaces/],
    ['100 N/mm; 200 N/mm', [100, 200]],
    ['0.1 0.2 0.3 kN/mm', [100, 200, 300]],
    ['100…600/6', [100, 200, 300, 400, 500, 600]],
    ['0.1 ... 0.3 kN/mm / 3', [100, 200, 300]],
    ['100,200,300', /^“100,200,300” can be one number or several/],
    ['1000,500', /^“1000,500” can be one number or two: write 1000\.500, or 1000 500$/],
    ['1 000 2 000', /^number 2: “1 000” can be one number or two: write 1000 without a space/],
    ['1.000,5 2.500,5', [1000.5, 2500.5]],
    ['1.000,5 2.000', /^number 2: “2.000” can be read as 2,000 or as 2000, where commas are decimal/],
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
    if (read instanceof RegExp) assert.match('problem' in result ? result.problem : JSON.stringify(result), read, text);
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
    ['0.6 0 kN/mm α10 α20 µm', [{ force: 600 }, { force: 0 }, { approach: 0.01 }, { approach: 0.02 }]],
    ['600,0', /^“600,0” can be one number or two: write 600\.0, or 600 0$/],
    ['100,200,300', /can be one number or several/],
    ['600\u202f000\u202f0', /can be one number or several: put plain spaces/],
    ['600 0 x', /^load 2: “x” is no unit known here/],
  ])) {
    const result = readHistory(text, 'line_force', 'mm_N_MPa');
    if (read instanceof RegExp) assert.match('problem' in result ? result.problem : JSON.stringify(result), read, text);
    else assert.deepEqual(result, { loads: read }, text);
  }
});

const UNITS = { force: 'N/mm', approach: 'mm' };

test('loads in turn are written with their letters, units and digits', () => {
  const forces = (/** @type {number[]} */ ...all) => all.map((force) => ({ force }));
  for (const [history, words] of /** @type {[object[], string][]} */ ([
    [forces(600, 0, 600.123456789), 'P 600 → 0 → 600.123456789 N/mm'],
    [[{ approach: 0.01 }, ...forces(800, 0)], 'α 0.01 mm → P 800 → 0 N/mm'],
    [[...forces(612.610612345678), { approach: 0.0212345678912 }], 'P 612.610612346 N/mm → α 0.0212345678912 mm'],
    [[1, 2, 1, 2, 1].map((k) => ({ approach: k / 100 })), 'α 5 loads up to 0.02 mm'],
    [[...forces(800, 200, 1200, 300), { approach: 0.05 }], '5 loads, P up to 1200 N/mm, α up to 0.05 mm'],
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
  assert.equal(writeWhole([{ rate: 0.123456789, modulus: 20000.12345678 }]), '20000.1234568, 0.123456789');
  const job = (/** @type {object[]} */ rows) => ({ lower: { material: { initial_stress: rows } }, load: { force: 1 } });
  assert.deepEqual(differences([job(turned), job(straight)]), []);
  const [found] = differences([job(turned), job([straight[0], { ...straight[1], sigma_x: 1 }])]);
  assert.deepEqual(found.texts, ['0 −200 −123; 0.3 0 0', '0 −200 −123; 0.3 1 0']);
});

test('cells of a table have their units, or those of the header', () => {
  for (const [text, read] of /** @type {[string, number[][] | RegExp][]} */ ([
    [
      '0.1 mm\t5 µm\n0.2 mm\t6 µm',
      [
        [0.1, 0.005],
        [0.2, 0.006],
      ],
    ],
    [
      'x [mm];h [µm]\n0;0\n1,5;250 nm',
      [
        [0, 0],
        [1.5, 0.00025],
      ],
    ],
    ['1\u202f234,5\t2', [[1234.5, 2]]],
    ['0\t5 µm\n1\t6', /^line 2: “6” has no unit, and others of its column have one$/],
    ['0.1 N\t5', /^line 1: “N” is no unit known here/],
    ['0x10 5', /^line 1: “0x10” is not a number/],
    ['0 1e400', /^line 1: “1e400” is too large/],
    ['0\t500\n0.1 600\t700', /^line 2: “0.1 600” is not a number$/],
    ['0.5\u00a0500\t2', /^line 1: “0.5\u00a0500” is not a number$/],
    ['x;;h\n0;1;500\n0,1;;600', /^line 2 has 3 columns, not two/],
    [
      ';0;;500;\n;0,1;;600',
      [
        [0, 500],
        [0.1, 600],
      ],
    ],
    ['0;500\n;600', /^line 2: column 1 is empty$/],
  ])) {
    const result = readTable(text, ['length', 'length'], 'mm_N_MPa');
    if (read instanceof RegExp) assert.match('problem' in result ? result.problem : JSON.stringify(result), read, text);
    else assert.deepEqual('points' in result && result.points, read, text);
  }
});

test('points that may group thousands among decimal commas are refused', () => {
  for (const [text, read] of /** @type {[string, number[][] | RegExp][]} */ ([
    ['1.000;2,5\n2.000;3,5', /^line 1: “1.000” can be read as 1,000 or as 1000, where commas are decimal/],
    ['1.000\t2\n1.000,5\t3', /^line 1: “1.000” can be read as/],
    [
      '0.250;2,5\n1.0;3,5',
      [
        [0.25, 2.5],
        [1, 3.5],
      ],
    ],
    ['1.000\t2', [[1, 2]]],
  ])) {
    const result = readTable(text, ['length', 'length'], 'mm_N_MPa');
    if (read instanceof RegExp) assert.match('problem' in result ? result.problem : JSON.stringify(result), read, text);
    else assert.deepEqual('points' in result && result.points, read, text);
  }
});

test('a unit in the header of a table is converted, or refused where it is not known', () => {
  const strength = /** @type {const} */ (['strain', 'stress']);
  const heights = /** @type {const} */ (['length', 'length']);
  const converted = /** @type {[string, number[]][]} */ ([
    ['x (mm)\th (µm)', [1, 0.005]],
    ['x / mm\th/µm', [1, 0.005]],
    ['x, mm\th, μm', [1, 0.005]],
    ['x in mm\tdepth in µm', [1, 0.005]],
    ['x_mm\th_um', [1, 0.005]],
    ['x mm\tmicrons', [1, 0.005]],
    ['x\th\nmm\tµm', [1, 0.005]],
    ['# x [mm]\th [µm]', [1, 0.005]],
    ['Profile (left)\nx measured\tHeight, mean [µm]', [1, 0.005]],
    ['Sample 1\tSample 2', [1, 5]],
    ['x ["]\th ["]', [25.4, 127]],
  ]);
  for (const [header, point] of converted) {
    const result = readTable(`${header}\n1\t5`, [...heights], 'mm_N_MPa');
    assert.deepEqual('points' in result ? result.points : result, [point], header);
  }
  const strengths = /** @type {[string, number[]][]} */ ([
    ['strain %;stress N/mm2', [0.01, 5]],
    ['ε_p in ‰;σ/MPa', [0.001, 5]],
    ['strain [µε];stress [kN/mm²]', [1e-6, 5000]],
    ['plastic strain [mm/mm];true stress', [1, 5]],
    ['%;N/mm²', [0.01, 5]],
  ]);
  for (const [header, point] of strengths) {
    const result = readTable(`${header}\n1;5`, [...strength], 'mm_N_MPa');
    assert.deepEqual('points' in result ? result.points : result, [point], header);
  }
  for (const [header, problem] of /** @type {[string, RegExp][]} */ ([
    [
      'x [mm];h [\ufffdm]',
      /^line 1, column 2: “\ufffdm” is no unit known here for this column\. Write a unit such as mm/,
    ],
    ['Run 7\nx;h [furlong]', /^line 2, column 2: “furlong” is no unit/],
    ['x;σ [MPa]', /^line 1, column 2: “MPa” is no unit/],
    ['x;h N', /^line 1, column 2: “N” is no unit/],
    ['mm;dm', /^line 1, column 2: “dm” is no unit/],
    ['x [mm];h [mm]\nmm;µm', /^line 2, column 2: “µm”, and “mm” in a line above$/],
    ['All lengths in µm', /^line 1: it cannot be told which of the two columns “µm” is the unit of$/],
    ['x;mm;h;µm', /^line 1: it cannot be told which/],
    ['h [µm];x [mm]', /^line 1: “x \[mm\]” is the second column, and places x belong in the first$/],
    ['y;x', /^line 1: “x” is the second column/],
  ])) {
    const result = readTable(`${header}\n1;5`, [...heights], 'mm_N_MPa');
    assert.match('problem' in result ? result.problem : JSON.stringify(result), problem, header);
  }
});

test('a factor in the header of a table is refused, and so is a unit that stands alone and is none of its column', () => {
  for (const header of [
    'eps x1000\tsigma',
    'strain*1e3\tstress',
    'strain × 1000\tstress',
    'ε_p · 10³\tq',
    'ε_p [10⁻³]\tq [MPa]',
    '10^3 strain\tstress',
    'strain (x1000)\tstress',
  ]) {
    const result = readTable(`${header}\n0\t500\n1\t600`, ['strain', 'stress'], 'mm_N_MPa', ['ε_p', 'q']);
    assert.match('problem' in result ? result.problem : JSON.stringify(result), /^line 1/, header);
  }
  const spaced = readTable('eps x1000 sigma\n0 500\n1 600', ['strain', 'stress'], 'mm_N_MPa');
  assert.match('problem' in spaced ? spaced.problem : '', /^line 1: “eps x1000 sigma” has a factor: write the figures/);
  const factors = readTable('z\t%\n0\t180\n1\t100', ['length', 'number'], 'mm_N_MPa', ['z', 'factor']);
  assert.match('problem' in factors ? factors.problem : '', /^line 1, column 2: “%” is no unit known here/);
  for (const header of ['x1\ty1', 'x10\tx20', '# lens x50', 'x\t-', 'Sample 1\tSample 2']) {
    const result = readTable(`${header}\n1\t5`, ['length', 'length'], 'mm_N_MPa');
    assert.deepEqual('points' in result ? result.points : result, [[1, 5]], header);
  }
});

test('every hyphen before a digit is a minus, and no line of figures is taken for a header', () => {
  for (const minus of ['-', '−', '–', '\u2010', '\u2011', '\u2012', '\ufe63', '\uff0d']) {
    const result = readTable(`${minus}10\t${minus}2.5\n0\t0`, ['length', 'length'], 'mm_N_MPa');
    assert.deepEqual('points' in result ? result.points : result, [[-10, -2.5], [0, 0]], minus); // prettier-ignore
    assert.deepEqual(readList(`${minus}10 5 ${minus}2`, undefined, 'mm_N_MPa'), { values: [-10, 5, -2] }, minus);
    assert.deepEqual(readNumber(`${minus}1.5e${minus}2`), { value: -0.015 }, minus);
  }
  for (const sign of ['\u2014', '\u2015', '~', '±', '<']) {
    const result = readTable(`${sign}10\t${sign}2.5\n0\t0`, ['length', 'length'], 'mm_N_MPa');
    assert.match('problem' in result ? result.problem : JSON.stringify(result), /^line 1: “.10” is not a number/, sign);
  }
});

test('a hardness is of the scale of Vickers, and one of another scale is refused', () => {
  const read = (/** @type {string} */ text) => readTable(text, ['length', 'hardness'], 'mm_N_MPa', ['z', 'HV']);
  for (const header of [
    'Depth [mm]\tHV1',
    'Depth\t[HV10]',
    'Depth (mm)\tHardness [HV0.5]',
    'z\tHV',
    'Depth [mm]\tHV 0.3',
    'Depth\tHardness, HV10/15',
  ]) {
    const result = read(`${header}\n0\t700\n1\t500`);
    assert.deepEqual('points' in result ? result.points : result, [[0, 700], [1, 500]], header); // prettier-ignore
  }
  const swapped = read('HV1\tDepth [µm]\n700\t0\n500\t100');
  assert.deepEqual('points' in swapped ? swapped.points : swapped, [[0, 700], [0.1, 500]]); // prettier-ignore
  for (const [header, scale] of [
    ['Depth [mm]\tHRC', 'HRC'],
    ['Depth (µm)\tHRC', 'HRC'],
    ['z\tHardness HRC', 'HRC'],
    ['z\tHardness_HB', 'HB'],
    ['z\tHBW 2.5/187.5', 'HBW'],
    ['z\tHK0.5', 'HK'],
    ['z\tRockwell C', 'Rockwell'],
    ['z\t[HRC]', 'HRC'],
    ['Hardness in HRC\nz\tvalue', 'HRC'],
  ]) {
    const result = read(`${header}\n0\t60\n1\t50`);
    assert.match('problem' in result ? result.problem : JSON.stringify(result), new RegExp(`“${scale}.*HV`), header);
  }
  assert.ok('problem' in read('0\t60 HRC\n1\t50 HRC'));
});

test('columns that are named are taken by their names', () => {
  const stress = (/** @type {string} */ header) =>
    readTable(`${header}\n0.1\t2\t3`, ['length', 'stress', 'stress'], 'mm_N_MPa', ['z', 'σ_x', 'σ_z']);
  for (const [header, point] of /** @type {[string, number[]][]} */ ([
    ['depth\tsigma_z\tsigma_x', [0.1, 3, 2]],
    ['z [mm]\tσz [MPa]\tσx [MPa]', [0.1, 3, 2]],
    ['z [mm]\tS33\tS11', [0.1, 3, 2]],
    ['z mm\tσθ MPa\tσz MPa', [0.1, 2, 3]],
    ['z\tσ_x\tσ_z', [0.1, 2, 3]],
    ['z\tσxx [GPa]\tσzz', [0.1, 2000, 3]],
    ['z\tσzz [GPa]\tσxx', [0.1, 3, 2000]],
    ['Depth\tσ_x\tσ_y', [0.1, 2, 3]],
    ['Depth\tleft\tright', [0.1, 2, 3]],
  ])) {
    const result = stress(header);
    assert.deepEqual('points' in result ? result.points : result, [point], header);
  }
  for (const header of ['σz\tz\tstress', 'z\tσ_z\tσ_y', 'z\tσ_x\tσ_xx']) assert.ok('problem' in stress(header), header);
  const turned = readTable('Stress [MPa];Strain [%]\n500;1', ['strain', 'stress'], 'mm_N_MPa', ['ε_p', 'q']);
  assert.deepEqual('points' in turned ? turned.points : turned, [[0.01, 500]]);
});

service.test('a hardness typed in another scale is refused, in its own it is read', async (page) => {
  await page.locator('[data-place="/lower/material/plasticity/depth_kind"] select').selectOption('case');
  const place = page.locator('[data-place="/lower/material/plasticity/over_depth/hardness/surface"]');
  await place.locator('input[type=text]').fill('60 HRC');
  await place.getByText('“HRC” is no unit known here for this figure').waitFor();
  await place.locator('input[type=text]').fill('700 HV10');
  assert.equal((await draft(page)).lower.material.plasticity.over_depth.hardness.surface, 700);
});

service.test(
  'a list at fault is refused at its field, stays as it is typed, and may be left for another load',
  async (page) => {
    await page.getByLabel('Given').selectOption('forces');
    const place = page.locator('[data-place="/load/forces"]');
    await place.locator('input').fill('100,200,300');
    await place.getByText('“100,200,300” can be one number or several: put spaces between numbers').waitFor();
    await page.getByRole('button', { name: 'Solve', exact: true }).click();
    await page.getByText('One field is wrong: the cursor is in it.').waitFor();
    await page.getByLabel('Radius').first().focus();
    assert.equal(await place.locator('input').inputValue(), '100,200,300');
    await place.locator('input').fill('100; 200 N/mm');
    await page.waitForFunction(() => document.querySelectorAll('[aria-invalid=true]').length === 0);
    assert.deepEqual((await draft(page)).load.forces, [100, 200]);
    await page.getByLabel('Given').selectOption('history');
    await page.locator('[data-place="/load/history"] input').fill('600,0');
    await page.locator('[data-place="/load/history"]').getByText('can be one number or two').waitFor();
    await page.getByLabel('Units').selectOption('SI');
    await page.getByLabel('Given').selectOption('approach');
    assert.deepEqual((await draft(page)).load, { approach: 2e-5 });
  },
);

service.test('what is no figure is not drawn as one, and is no place for a slider', async (page) => {
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
});

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

service.test('a slider beside a figure that is refused moves among those that are taken', async (page) => {
  const place = page.locator('[data-place="/upper/shape/radius"]');
  await place.locator('input[type=text]').fill('-5');
  await place.locator('input[aria-invalid=true]').waitFor();
  await place.getByRole('button', { name: 'Slider' }).click();
  await place.getByRole('slider').press('Home');
  assert.equal((await draft(page)).upper.shape.radius, 6.67);
  await page.locator('[data-status=live]').getByText('solved in').waitFor();
});

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
  await page.getByText('“0x10” is not a number').waitFor();
  await page.getByLabel('Given').selectOption('history');
  const history = page.locator('[data-place="/load/history"]');
  await history.locator('input').fill('600 -> 0 => 700');
  assert.deepEqual((await draft(page)).load.history, [{ force: 600 }, { force: 0 }, { force: 700 }]);
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
    inWords('at x = 0.000000 mm of a profile: set its `interpolation` to "linear" if this is a corner'),
    'at x = 0 mm of a profile: set “Between points” to “linear” if this is a corner',
  );
  const described = allFields().map(({ description = '' }) => ofTable(description));
  assert.deepEqual(
    described.filter((one) => one.includes('`') || (one && one.split(' ').length < 2)),
    [],
  );
});
