/** Fields of large jobs: of the step that is shown, the arrays of what is shown. */

import assert from 'node:assert/strict';
import { suite } from '../browser.js';
import { drawn, follow, mises, solved, taken } from '../jobs.js';

/** @typedef {import('playwright-core').Page} Page */

const service = suite();
const SHAPE = ['nodes', 'elements', 'displacement'];
const STEPS = 10;

/** Whose fields of all steps are more than the page keeps. @param {Page} page @param {object} [change] */
const large = (page, change) =>
  solved(page, {
    mesh: { elements_per_half_width: 40 },
    load: { forces: Array.from({ length: STEPS }, (_, k) => 60 * (k + 1)) },
    output: { fields: true },
    ...change,
  });

/** What is asked of the fields from now on. @param {Page} page */
function asked(page) {
  const list = /** @type {{step: number, arrays: string[]}[]} */ ([]);
  page.on('request', (request) => {
    const { pathname, searchParams } = new URL(request.url());
    const [, step] = /\/fields\/(\d+)$/.exec(pathname) ?? [];
    if (step)
      list.push({ step: Number(step), arrays: (searchParams.get('arrays') ?? '').split(',') });
  });
  return { take: () => list.splice(0), list };
}

/** @param {Page} page */
const label = (page) => page.locator('#panel-field .stage .over').getAttribute('aria-label');

/** Waits until a field is named so, and nothing is on its way. @param {Page} page @param {string} begin */
const named = (page, begin) =>
  page.waitForFunction((begin) => {
    const words = document.querySelector('.over')?.getAttribute('aria-label') ?? '';
    return (
      words.startsWith(`Field of ${begin}`) &&
      !document.querySelector('.stage')?.classList.contains('stale')
    );
  }, begin);

/** Largest value on both bodies as the service has it. @param {Page} page @param {string} id @param {number} step @param {string} quantity */
const largest = (page, id, step, quantity) =>
  page.evaluate(async ([id, step, quantity]) => {
    const { readFields } = await import(/** @type {any} */ ('/web/api/npz.js'));
    const { valuesOf } = await import(/** @type {any} */ ('/web/field/quantities.js'));
    const fields = readFields(
      await (await fetch(`v1/jobs/${id}/fields/${step}`)).arrayBuffer(),
      [],
    );
    let most = 0;
    for (const body of [fields.upper, fields.lower])
      for (const value of body ? valuesOf(body, quantity, 0) : []) most = Math.max(most, value);
    return most;
  }, /** @type {const} */ ([id, step, quantity]));

/** @param {Page} page @param {number} most that its label should name */
async function reaches(page, most) {
  const [, said] = /to ([\d.]+) MPa/.exec((await label(page)) ?? '') ?? [];
  assert.ok(Math.abs(Number(said) - most) < 1e-3 * most, `${said} for ${most}`);
}

service.test(
  'arrays are fetched when something on the page is made of them, and once',
  async (page) => {
    const requests = asked(page);
    const id = await large(page);
    const came = page.waitForResponse(/fields\/10\?/);
    await follow(page, `job=${id}`);
    await came;
    await drawn(page);
    assert.deepEqual(requests.take(), [
      { step: STEPS, arrays: [...SHAPE, 'equivalent_plastic_strain'] },
    ]);
    const sizes = [[...SHAPE, 'equivalent_plastic_strain'], null].map((arrays) =>
      page.evaluate(
        async ([id, query]) =>
          (await (await fetch(`v1/jobs/${id}/fields/10${query}`)).arrayBuffer()).byteLength,
        [id, arrays ? `?arrays=${arrays}` : ''],
      ),
    );
    const [bytes, whole] = await Promise.all(sizes);
    requests.take();
    assert.ok(bytes < 0.7 * whole, `${bytes} of ${whole}`);

    const shown = page.getByLabel('Shown', { exact: true });
    await shown.selectOption('tau_max');
    await named(page, 'largest shear');
    assert.deepEqual(requests.take(), [
      { step: STEPS, arrays: ['sigma_x', 'sigma_y', 'sigma_z', 'tau_xy'] },
    ]);
    await reaches(page, await largest(page, id, STEPS, 'tau_max'));
    requests.take();
    for (const quantity of ['sigma_1', 'mean_stress', 'displacement_y', 'tau_max'])
      await shown.selectOption(quantity);
    await named(page, 'largest shear');
    assert.deepEqual(requests.take(), [], 'what these are made of is here');

    await page.locator('#panel-field .stage .over').scrollIntoViewIfNeeded();
    const box = await page.locator('#panel-field .stage .over').boundingBox();
    assert.ok(box);
    await page.mouse.move(box.x + box.width / 2, box.y + box.height * 0.75);
    await page
      .getByText(/^lower body, x .* von Mises .* τmax .* MPa · plastic strain \d.* %$/)
      .waitFor();
    assert.deepEqual(requests.take(), [{ step: STEPS, arrays: ['von_mises'] }]);
    await page.mouse.move(0, 0);
    await shown.selectOption('von_mises');
    await named(page, 'von Mises');
    assert.deepEqual(requests.take(), [], 'what was read is here');
    await reaches(page, await largest(page, id, STEPS, 'von_mises'));
    await shown.selectOption('tau_max');
    await named(page, 'largest shear');
    requests.take();

    await page.getByLabel('Step', { exact: true }).focus();
    await page.keyboard.press('Home');
    await page.locator('.steps output').getByText(`1 of ${STEPS}`).waitFor();
    await named(page, 'largest shear');
    assert.deepEqual(requests.take(), [
      { step: 1, arrays: [...SHAPE, 'sigma_x', 'sigma_y', 'sigma_z', 'tau_xy'] },
    ]);
    await reaches(page, await largest(page, id, 1, 'tau_max'));
    requests.take();
    // The cut, isolines and edges are made of what is drawn.
    await page.getByLabel('Cut', { exact: true }).check();
    await page
      .locator('.cut .plot[aria-label^="largest shear stress τmax along the cut"]')
      .waitFor();
    for (const flag of ['Isolines', 'Mesh']) await page.getByLabel(flag, { exact: true }).check();
    assert.deepEqual(requests.take(), []);
  },
);

service.test('one body, round: what is shown and read is fetched', async (page) => {
  const id = await large(page, {
    analysis: 'axisymmetric',
    lower: {
      shape: { type: 'block', width: 120, depth: 90 },
      material: {
        young_modulus: 210000,
        poisson_ratio: 0.3,
        plasticity: { law: 'bilinear', yield_stress: 500, tangent_modulus: 0 },
      },
    },
    upper: { shape: { type: 'cylinder', radius: 20 }, material: { rigid: true } },
    load: { forces: Array.from({ length: 20 }, (_, k) => 200 * (k + 1)) },
  });
  const requests = asked(page);
  await follow(page, `job=${id}`);
  await drawn(page);
  await page.getByLabel('Shown', { exact: true }).selectOption({ label: 'σθ' });
  await named(page, 'σθ');
  await page.locator('#panel-field .stage .over').scrollIntoViewIfNeeded();
  const box = await page.locator('#panel-field .stage .over').boundingBox();
  assert.ok(box);
  await page.mouse.move(box.x + box.width / 2, box.y + box.height * 0.75);
  await page.getByText(/^lower body, r .* σr .* τrz .* plastic strain .* %$/).waitFor();
  // The largest plastic strain has no limit here: its tile is that of the mean.
  const tile = page.locator('.figures > div', { hasText: /^Mean plastic strain/ });
  assert.match(await tile.innerText(), /[1-9]\d*%/);
  assert.deepEqual(
    requests.list.flatMap(({ arrays }) => arrays).sort(),
    [
      ...SHAPE,
      'von_mises',
      'sigma_x',
      'sigma_y',
      'sigma_z',
      'tau_xy',
      'equivalent_plastic_strain',
    ].sort(),
  );
});

service.test(
  'what cannot be loaded is said on the picture, which stays what it was, and can be tried again',
  async (page) => {
    const id = await large(page);
    await follow(page, `job=${id}`);
    await drawn(page);
    let broken = 'refuse';
    await page.route('**/fields/**', (route) => {
      if (broken === 'refuse')
        return route.fulfill({ status: 500, json: { detail: 'the store is damaged' } });
      if (broken === 'cut') return route.abort();
      return route.continue();
    });
    const before = await label(page);
    await page.getByLabel('Shown', { exact: true }).selectOption('sigma_y');
    const said = page.locator('#panel-field .waiting');
    await said.getByText('Could not load σy: the store is damaged.').waitFor();
    const [message, stage] = [
      await said.boundingBox(),
      await page.locator('#panel-field .stage').boundingBox(),
    ];
    assert.ok(
      message &&
        stage &&
        message.y > stage.y &&
        message.y + message.height < stage.y + stage.height,
    );
    assert.equal(await label(page), before, 'the picture is still of the other quantity');
    assert.equal(await page.locator('#panel-field .stage.stale').count(), 1);
    await taken(page, 'Save field as PNG');
    await page.getByText('There is no picture of it yet').waitFor();
    broken = '';
    await said.getByRole('button', { name: 'Try again' }).click();
    await named(page, 'σy');

    // A connection that breaks is tried again without a click.
    broken = 'cut';
    await page.getByLabel('Step', { exact: true }).focus();
    await page.keyboard.press('Home');
    await said
      .getByText('Could not load the field of this step: the service does not answer.')
      .waitFor();
    broken = '';
    await named(page, 'σy');
    await reaches(page, await largest(page, id, 1, 'sigma_y'));

    // So is what is read.
    broken = 'refuse';
    await page.locator('#panel-field .stage .over').scrollIntoViewIfNeeded();
    const box = await page.locator('#panel-field .stage .over').boundingBox();
    assert.ok(box);
    await page.mouse.move(box.x + box.width / 2, box.y + box.height * 0.75);
    await page
      .getByText(
        /^lower body, x .* σy .* MPa · the others could not be loaded: the store is damaged$/,
      )
      .waitFor();
    broken = '';
    await page.mouse.move(0, 0);
    await page.mouse.move(box.x + box.width / 2, box.y + box.height * 0.7);
    await page.getByText(/^lower body, x .* von Mises .* plastic strain .* %$/).waitFor();
  },
  { amiss: true },
);

service.test(
  'the step that was chosen last is the one that is shown, and the others are no longer fetched',
  async (page) => {
    const id = await large(page);
    await follow(page, `job=${id}`);
    await mises(page);
    await named(page, 'von Mises');
    const failed = /** @type {string[]} */ ([]);
    page.on('requestfailed', (request) =>
      failed.push(new URL(request.url()).pathname.split('/').at(-1) ?? ''),
    );
    let letGo = () => {};
    const held = new Promise((resolve) => {
      letGo = () => resolve(undefined);
    });
    await page.route('**/fields/**', async (route) => {
      if (!/fields\/7(\?|$)/.test(route.request().url())) await held;
      await route.continue().catch(() => {});
    });
    const slider = page.getByLabel('Step', { exact: true });
    for (const step of [1, 2, 3, 6])
      await slider.evaluate((input, step) => {
        /** @type {HTMLInputElement} */ (input).value = String(step);
        input.dispatchEvent(new Event('input', { bubbles: true }));
      }, step);
    await named(page, 'von Mises');
    await reaches(page, await largest(page, id, 7, 'von_mises'));
    letGo();
    await page.locator('#panel-field .waiting').waitFor({ state: 'hidden' });
    await reaches(page, await largest(page, id, 7, 'von_mises'));
    assert.ok(!failed.includes('7'));
    assert.equal(await page.locator('#panel-field .waiting').isVisible(), false);
  },
  { amiss: true },
);

service.test(
  'steps are played one after the other, each with its field, and a report waits for its own',
  async (page) => {
    const id = await large(page);
    let letGo = () => {};
    let held = Promise.resolve();
    await page.route('**/fields/**', async (route) => {
      await held;
      await route.continue();
    });
    await follow(page, `job=${id}`);
    await mises(page);
    await named(page, 'von Mises');
    const range = page.getByLabel('Colours', { exact: true }).locator('option').nth(1);
    assert.equal(await range.textContent(), 'the steps seen', 'not all of them are kept');
    const requests = asked(page);
    const play = page.getByRole('button', { name: 'Play through the steps' });
    await play.click();
    await page.locator('.steps output').getByText(`${STEPS} of ${STEPS}`).waitFor();
    await named(page, 'von Mises');
    assert.deepEqual(
      requests.take().map(({ step }) => step),
      Array.from({ length: STEPS }, (_, k) => k + 1),
      'every step, once',
    );
    held = new Promise((resolve) => {
      letGo = () => resolve(undefined);
    });
    await page.getByLabel('Step', { exact: true }).focus();
    await page.keyboard.press('Home');
    await page.getByRole('button', { name: 'Report' }).click();
    await page.getByRole('button', { name: 'Print or save as PDF' }).waitFor();
    assert.equal(
      await page.locator('#sheet .sheet-drawings canvas').count(),
      0,
      'no picture of another step',
    );
    letGo();
    await page.locator('#sheet .sheet-drawings canvas').waitFor();
  },
);
