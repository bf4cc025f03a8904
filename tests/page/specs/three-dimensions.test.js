/** Contacts in three dimensions: semi-axes, both sections, the map in place of the field. */

import assert from 'node:assert/strict';
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
  const stage = page.locator('#panel-map .stage');
  await stage.scrollIntoViewIfNeeded();
  const box = await stage.boundingBox();
  assert.ok(box);
  await page.mouse.move(box.x + box.width * across, box.y + box.height * down);
}

const readout = (/** @type {Page} */ page) => page.locator('#panel-map .readout');

service.test('a ball in its raceway has two semi-axes, two sections and a map', async (page) => {
  await shown(page, BALL);
  await drawn(page);
  /** @type {[string, RegExp][]} */
  const tiles = [
    ['Shorter semi-axis', /0\.120\d* ?mm/],
    ['Longer semi-axis', /1\.1\d* ?mm/],
  ];
  for (const [name, figure] of tiles)
    assert.match(await page.locator('.figures > div', { hasText: name }).innerText(), figure);
  assert.equal(await page.locator('#panel-field').isVisible(), false);
  assert.equal(await page.locator('#sketch').isVisible(), false);
  await page.locator('#panel-pressure').getByText('along y').waitFor();
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
  // The middle of the drawn rectangle, beside the room of the colours.
  await point(page, 0.48, 0.46);
  await readout(page)
    .getByText(/^x -?0\.0\d*, y -?0\.\d* mm:  p 1[67]\d\d(\.\d)? MPa · gap /)
    .waitFor();
  await point(page, 0.13, 0.08);
  await readout(page)
    .getByText(/p 0 MPa · gap 0\.0\d* mm$/)
    .waitFor();
  await page.locator('#panel-map').getByRole('radio', { name: 'Gap', exact: true }).check();
  await page.locator('#panel-map canvas[aria-label^="Map of the gap"]').waitFor();
});

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
    await point(page, 0.48, 0.46);
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

service.test('a cylinder becomes a sphere where three dimensions are chosen, and a cylinder again', async (page) => {
  const analysis = page.getByLabel('Analysis', { exact: true });
  const shapes = page.getByLabel('Shape', { exact: true });
  const types = () => Promise.all([shapes.nth(0), shapes.nth(1)].map((one) => one.inputValue()));
  await analysis.selectOption({ label: 'Three dimensions' });
  assert.deepEqual(await types(), ['sphere', 'sphere']);
  await page.getByRole('button', { name: 'Solve', exact: true }).click();
  await page.locator('.figures > div', { hasText: 'Longer semi-axis' }).waitFor();
  await analysis.selectOption({ label: 'Axisymmetric' });
  assert.deepEqual(await types(), ['cylinder', 'cylinder']);
  await page.getByRole('button', { name: 'Solve', exact: true }).click();
  await page.locator('.figures > div', { hasText: 'Contact radius' }).waitFor();
});
