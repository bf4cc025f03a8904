/** Contacts in three dimensions: semi-axes, both sections, the map in place of the field. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { planesOf } from '../../../web/field/layers.js';
import { suite } from '../browser.js';
import { drawn, follow, shown } from '../jobs.js';

/** @typedef {import('playwright-core').Page} Page */

const service = suite();

const STEEL = { young_modulus: 210000, poisson_ratio: 0.3 };
/** A ball in the groove of a raceway, on few cells. */
const BALL = {
  analysis: 'three_dimensional',
  upper: { shape: { type: 'sphere', radius: 5 }, material: STEEL },
  lower: { shape: { type: 'curved', radius_x: 20, radius_y: -5.2 }, material: STEEL },
  load: { force: 500 },
  mesh: { elements_per_half_width: 6 },
  output: { fields: true },
};

/** Moves the pointer to a part of the map. @param {Page} page @param {number} across @param {number} down */
async function point(page, across, down) {
  const canvas = page.locator('#panel-map canvas.map');
  await canvas.scrollIntoViewIfNeeded();
  const [left, top, width, height] = ((await canvas.getAttribute('data-box')) ?? '')
    .split(' ')
    .map(Number);
  const box = await canvas.boundingBox();
  assert.ok(box);
  await page.mouse.move(box.x + left + across * width, box.y + top + down * height);
}

const readout = (/** @type {Page} */ page) => page.locator('#panel-map .readout');

service.test('a ball in its raceway has two semi-axes, two sections and a map', async (page) => {
  await shown(page, BALL);
  await drawn(page);
  /** @type {[string, RegExp][]} */
  const tiles = [
    ['Shorter semi-axis', /0\.12\d ?mm/],
    ['Longer semi-axis', /1\.1\d* ?mm/],
  ];
  for (const [name, figure] of tiles)
    assert.match(await page.locator('.figures > div', { hasText: name }).innerText(), figure);
  assert.match(
    String(await page.locator('#sketch svg').getAttribute('aria-label')),
    /^Sections .* along x and along y/,
  );
  // The cuts are drawn once, below the map.
  await page.locator('#panel-map').getByText('along y').first().waitFor();
  assert.equal(await page.locator('#panel-pressure:visible').count(), 0);
  // Stresses below an ellipse have no closed form: Hertz's lines are those of the pressure alone.
  assert.equal(
    await page
      .locator('#panel-depth')
      .getByText(/elastic/)
      .count(),
    0,
  );

  await readout(page)
    .getByText(/Dashed: Hertz, elastic/)
    .waitFor();
  // Beside the middle, where both figures have digits.
  await point(page, 0.45, 0.48);
  await readout(page)
    .getByText(/^x 0\.00\d*, y −0\.1\d* mm:\s+p 1[67]\d\d(\.\d)? MPa · gap /)
    .waitFor();
  await point(page, 0.02, 0.03);
  await readout(page)
    .getByText(/p 0 MPa · gap 0\.0\d* mm$/)
    .waitFor();
  await page.locator('#panel-map').getByRole('radio', { name: 'Gap', exact: true }).check();
  await page.locator('#panel-map canvas[aria-label^="Map of the gap"]').waitFor();
});

/** Moves the pointer into the field. @param {Page} page @param {number} across @param {number} down */
async function pointField(page, across, down) {
  const stage = page.locator('#panel-field .stage');
  await stage.scrollIntoViewIfNeeded();
  const box = await stage.boundingBox();
  assert.ok(box);
  await page.mouse.move(box.x + box.width * across, box.y + box.height * down);
}

service.test(
  'the field is seen in the planes y = 0 and x = 0, stresses under their names there',
  async (page) => {
    await shown(page, BALL);
    await drawn(page);
    const field = page.locator('#panel-field');
    await pointField(page, 0.6, 0.6);
    await field.getByText(/^lower body, x 0\.\d*, z 0\.\d* mm: .*· τxz /).waitFor();
    await field.getByRole('radio', { name: 'x = 0', exact: true }).check();
    await pointField(page, 0.6, 0.52);
    await field.getByText(/^lower body, y 0\.\d*, z 0\.\d* mm: .*· τyz /).waitFor();
    assert.deepEqual(
      (await field.locator('select').first().locator('option').allInnerTexts()).slice(-4),
      ['σy', 'σz', 'σx', 'τyz'],
    );
  },
);

/** A rigid ellipsoid that has been pressed into a plane. */
const DENT = {
  analysis: 'three_dimensional',
  upper: { shape: { type: 'curved', radius_x: 10, radius_y: 50 }, material: { rigid: true } },
  lower: {
    shape: { type: 'flat' },
    material: {
      ...STEEL,
      plasticity: { law: 'bilinear', yield_stress: 500, tangent_modulus: 10500 },
    },
  },
  load: { history: [{ force: 317.1424 }, { force: 0 }] },
  mesh: { elements_per_half_width: 5 },
  solver: { theory: 'flow' },
  output: { fields: true },
};

service.test(
  'what a load has left is a map of the dent, as deep as its tile says',
  async (page) => {
    await shown(page, DENT);
    await drawn(page);
    await page.locator('#panel-map canvas[aria-label^="Map of the dent"]').waitFor();
    const tile = await page.locator('.figures > div', { hasText: /^Dent/ }).innerText();
    const deep = Number(/0\.\d+/.exec(tile)?.[0]);
    await point(page, 0.5, 0.5);
    await readout(page)
      .getByText(/dent 0\.\d* mm$/)
      .waitFor();
    const seen = Number(/dent (0\.\d+) mm/.exec(await readout(page).innerText())?.[1]);
    assert.ok(Math.abs(seen / deep - 1) < 0.02, `${seen}, ${deep}`);
  },
);

service.test(
  'a roller has the fields of its profile alone, its edge pressure and its load along the axis',
  async (page) => {
    await page.getByLabel('Analysis', { exact: true }).selectOption('three_dimensional');
    await page.getByLabel('Shape', { exact: true }).first().selectOption('roller');
    await page.getByLabel('Shape', { exact: true }).nth(1).selectOption('flat');
    const profile = page.getByLabel('Profile', { exact: true });
    await profile.selectOption('crowned');
    await page.getByLabel(/^Crown radius/).fill('500');
    assert.equal(await page.getByLabel(/^Design force/).count(), 0);
    await profile.selectOption('logarithmic');
    await page.getByLabel(/^Design force/).waitFor();
    await profile.selectOption('crowned');
    assert.equal(await page.getByLabel(/^Crown radius/).inputValue(), '500');
    await page.getByLabel(/^Tilt/).fill('1');
    await page.getByLabel('Force P').fill('20000');
    // An end far beyond yield takes flow theory minutes on the default grid.
    await page.locator('[data-place="/solver/theory"] select').selectOption('deformation');
    await page.locator('[data-place="/mesh/elements_per_half_width"] input').fill('6');
    await page.getByRole('button', { name: 'Solve', exact: true }).click();
    await page.locator('.figures > div', { hasText: 'Edge pressure' }).waitFor();
    await page.locator('.figures > div', { hasText: 'Moment' }).waitFor();
    assert.match(
      (await page.locator('#panel-spread .plot').getAttribute('aria-label')) ?? '',
      /edge pressure .*, pressure in the middle .*, moment .*, tilt 1(\.0+)? mrad/,
    );
    await page.getByLabel('Misalignment').selectOption('moment');
    const field = (/** @type {string} */ key) =>
      page.locator(`[data-place="/upper/shape/${key}"] input`);
    assert.equal(await field('tilt').count(), 0);
    await field('moment').fill('20000');
    await page.getByRole('button', { name: 'Solve', exact: true }).click();
    const tile = page.locator('.figures > div', { hasText: 'Moment' });
    await tile.getByText(/^20000/).waitFor();
    await page.locator('.figures > div', { hasText: /^Tilt/ }).getByText('mrad').waitFor();
    await page.getByLabel('Misalignment').selectOption('tilt');
    assert.equal(await field('tilt').inputValue(), '1');
    assert.equal(await field('moment').count(), 0);
  },
);

service.test('rollers and heights leave dents that are seen as maps', async (page) => {
  const roller = { type: 'roller', radius: 10, length: 4, profile: 'iso_16281', moment: 200 };
  const rolled = { ...DENT, upper: { shape: roller, material: { rigid: true } } };
  const load = { history: [{ force: 3000 }, { force: 0 }] };
  const heights = { heights: cap(16), spacing_x: 0.01, spacing_y: 0.01 };
  const rough = {
    ...DENT,
    upper: { shape: { type: 'flat' }, material: { rigid: true }, surface: heights },
  };
  for (const job of [
    { ...rolled, load, mesh: { elements_per_half_width: 4 } },
    { ...rough, load: { history: [{ force: 30 }, { force: 0 }] } },
  ]) {
    await shown(page, job);
    await page.locator('#panel-map canvas[aria-label^="Map of the dent"]').waitFor();
    const tile = await page.locator('.figures > div', { hasText: /^Dent/ }).innerText();
    const deep = Number(/[\d.]+(e-?\d+)?(?= ?mm)/.exec(tile)?.[0]);
    await page.locator('#panel-map .colours li').first().waitFor();
    const most = await page.locator('#panel-map .colours').innerText();
    assert.ok(deep > 0 && Number(/[\d.]+/.exec(most)?.[0]) >= 0.9 * deep, `${tile} ${most}`);
  }
});

test('sections have the outline of what has yielded in them', () => {
  const names = ['xx', 'yy', 'zz', 'xy', 'xz', 'yz'].map((name) => `sigma_${name}`);
  const zeros = new Float64Array(3 * 5 * 4);
  const strain = zeros.map((_, k) => (k === (1 * 5 + 2) * 4 + 1 ? 0.01 : 0));
  const lower = {
    x: [-2, -1, 0, 1, 2],
    y: [-3, -1, 1, 3],
    z: [0.5, 1.5, 2.5],
    ...Object.fromEntries([...names, 'von_mises'].map((name) => [name, zeros])),
    equivalent_plastic_strain: strain,
  };
  const { x, y } = planesOf({ upper: null, lower });
  const lines = [x.lower, y.lower].map((of) => /** @type {any} */ (of).outline);
  // Around the one node, half-way to its neighbours.
  const corners = lines.map((/** @type {any[][]} */ of) =>
    of.flat().map(({ x, y }) => `${x} ${y}`),
  );
  assert.deepEqual([...new Set(corners[0])].sort(), ['-0.5 -1.5', '0 -1', '0 -2', '0.5 -1.5']);
  assert.equal(corners[0].length, 8);
  assert.deepEqual([...new Set(corners[1])].sort(), ['-1 -1', '-1 -2', '-2 -1.5', '0 -1.5']);
});

/** A cap of heights [mm], a line for each x. @param {number} many */
const cap = (many) =>
  Array.from({ length: many }, (_, i) =>
    Array.from(
      { length: many },
      (_, j) => -1e-5 * ((i - (many - 1) / 2) ** 2 + (j - (many - 1) / 2) ** 2),
    ),
  );

service.test(
  'heights are pasted, opened from a file of NumPy, refused with their line, and solved',
  async (page) => {
    await page.getByLabel('Analysis', { exact: true }).selectOption('three_dimensional');
    for (const k of [0, 1])
      await page.getByLabel('Shape', { exact: true }).nth(k).selectOption('flat');
    await page.getByLabel('Surface', { exact: true }).first().selectOption('given');
    const box = page.getByLabel('Heights h', { exact: true });
    await box.fill('0 1\n2 x');
    await page.getByText('line 2 has a height that is no number').first().waitFor();
    await box.fill(
      cap(8)
        .map((row) => row.join(' '))
        .join('\n'),
    );
    await box.blur();
    await page.getByText('8 × 8 heights read, not taken yet.').waitFor();
    await page.getByRole('button', { name: 'Leave it', exact: true }).click();
    await page.getByText('Not taken', { exact: true }).waitFor();
    const rows = cap(16);
    const text = rows.map((row) => row.join('\t')).join('\n');
    await box.fill('');
    await box.evaluate((input, text) => {
      const clipboardData = new DataTransfer();
      clipboardData.setData('text', text);
      input.dispatchEvent(
        new ClipboardEvent('paste', { clipboardData, bubbles: true, cancelable: true }),
      );
    }, text);
    await page.getByText('16 × 16 heights read, not taken yet.').waitFor();
    await page.getByText('The file says no unit of its heights and no distance').waitFor();
    const take = page.getByRole('button', { name: 'Take them', exact: true });
    await take.click();
    await page.getByText('Choose the unit of the heights').waitFor();
    await page.getByLabel('Unit of the heights').selectOption('mm');
    await take.click();
    await page.getByText('Give the distance of neighbouring heights').waitFor();
    await page.getByLabel('Distance along x').fill('10 µm');
    await take.click();
    await page.getByText('16 × 16 heights read, 0.01 × 0.01 mm apart.').waitFor();
    const head =
      `{'descr': '<f8', 'fortran_order': False, 'shape': (20, 20), }`.padEnd(117) + '\n';
    const file = Buffer.concat([
      Buffer.from([0x93, 0x4e, 0x55, 0x4d, 0x50, 0x59, 1, 0, head.length, 0]),
      Buffer.from(head),
      Buffer.from(Float64Array.from(cap(20).flat()).buffer),
    ]);
    await page
      .locator('[data-place="/upper/surface/heights"] input[type=file]')
      .setInputFiles({ name: 'cap.npy', mimeType: 'application/octet-stream', buffer: file });
    await page.getByLabel('Unit of the heights').selectOption('mm');
    await page.getByLabel('Distance along x').fill('0.01');
    await take.click();
    await page.getByText('20 × 20 heights read, 0.01 × 0.01 mm apart.').waitFor();
    await page.getByLabel(/^Force P/).fill('0.5');
    await page.getByRole('button', { name: 'Solve', exact: true }).click();
    const area = page.locator('.figures > div', { hasText: 'Real contact area' });
    assert.match(await area.innerText(), /\d+\.\d+ ?%/);
    await page.locator('#panel-spread .plot[aria-label*="real contact area"]').waitFor();
  },
);

service.test(
  'a map of an instrument is taken with its units, and its holes are named',
  async (page) => {
    await page.getByLabel('Analysis', { exact: true }).selectOption('three_dimensional');
    for (const k of [0, 1])
      await page.getByLabel('Shape', { exact: true }).nth(k).selectOption('flat');
    await page.getByLabel('Surface', { exact: true }).first().selectOption('given');
    const place = page.locator('[data-place="/upper/surface/heights"]');
    const head = ['# Channel: ZSensor', '# Width: 10.00 µm', '# Height: 10.00 µm'];
    const rows = cap(16).map((row) => row.map((one) => one.toExponential(4)));
    for (const j of [3, 4]) rows[5][j] = '-9999';
    const buffer = (/** @type {string[]} */ lines) =>
      Buffer.from([...head, ...lines, ...rows.map((row) => row.join('\t'))].join('\r\n'));
    const open = (/** @type {string[]} */ lines) =>
      place
        .locator('input[type=file]')
        .setInputFiles({ name: 'map.txt', mimeType: 'text/plain', buffer: buffer(lines) });
    await open(['# Scale: 1e-9']);
    await place.getByText('“Scale: 1e-9” is not understood').waitFor();
    await open(['# Value units: m']);
    await place.getByText('2 of 256 heights are -9999').waitFor();
    await place.getByRole('button', { name: 'Make holes of them' }).click();
    await place.getByText('2 of 256 heights are missing.').waitFor();
    await place.getByRole('button', { name: 'Fill the holes from their rims' }).click();
    await place.getByText(/16 × 16 heights read, 0.000625 × 0.000625 mm apart/).waitFor();
    const job = JSON.parse(await page.locator('#json-text').inputValue());
    const { heights, spacing_x: spacing } = job.upper.surface;
    assert.equal(spacing, 0.000625);
    // The first line is at the largest y; metres are millimetres now.
    assert.ok(Math.abs(heights[0][15] - 1000 * cap(16)[0][0]) < 1e-9, `${heights[0][15]}`);
  },
);

service.test('a job without maps offers to make them', async (page) => {
  await shown(page, { ...BALL, output: { fields: false } });
  await page.getByText('This job did not ask for the maps of its contact.').waitFor();
  await page.getByRole('button', { name: 'Solve again with them' }).click();
  await readout(page)
    .getByText(/Dashed: Hertz, elastic/)
    .waitFor();
});

service.test('each load of a sweep has its map, in the units that are shown', async (page) => {
  const id = await shown(page, { ...BALL, load: { forces: [100, 500] } });
  await drawn(page);
  const middle = async () => {
    await point(page, 0.5, 0.5);
    await readout(page)
      .getByText(/: {2}p /)
      .waitFor();
    return Number(/p ([\d.]+) (MPa|GPa)/.exec(await readout(page).innerText())?.[1]);
  };
  const high = await middle();
  await page.getByLabel('Step', { exact: true }).focus();
  await page.keyboard.press('Home');
  await page.mouse.move(0, 0);
  await page
    .locator('#panel-map .readout')
    .getByText(/Dashed/)
    .waitFor();
  const low = await middle();
  assert.ok(Math.abs(low / high - Math.cbrt(1 / 5)) < 0.02, `${low}, ${high}`);
  await follow(page, `job=${id}`);
});

service.test(
  'a cylinder becomes a sphere in three dimensions and in revolution, and a cylinder again',
  async (page) => {
    const analysis = page.getByLabel('Analysis', { exact: true });
    const shapes = page.getByLabel('Shape', { exact: true });
    const types = () => Promise.all([shapes.nth(0), shapes.nth(1)].map((one) => one.inputValue()));
    await analysis.selectOption({ label: 'Three dimensions' });
    assert.deepEqual(await types(), ['sphere', 'sphere']);
    await page.getByRole('button', { name: 'Solve', exact: true }).click();
    // By flow theory on the default grid.
    const timeout = 240_000;
    await page.locator('.figures > div', { hasText: 'Longer semi-axis' }).waitFor({ timeout });
    await analysis.selectOption({ label: 'Axisymmetric' });
    assert.deepEqual(await types(), ['sphere', 'sphere']);
    await page.getByRole('button', { name: 'Solve', exact: true }).click();
    await page.locator('.figures > div', { hasText: 'Contact radius' }).waitFor();
    await analysis.selectOption({ label: 'Plane strain' });
    assert.deepEqual(await types(), ['cylinder', 'cylinder']);
  },
);
