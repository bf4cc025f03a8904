/**
 * Choosing another kind of a shape, a hardening or a load: from the draft as it is, without losing
 * what was given.
 */

import assert from 'node:assert/strict';
import { suite } from '../browser.js';
import { draft, follow, sent, unfold } from '../jobs.js';

/** @typedef {import('playwright-core').Page} Page */

const service = suite();

/** @param {Page} page @param {string} place @returns the field there */
const field = (page, place) =>
  page.locator(`[data-place="${place}"] :is(input[type=text], select, textarea)`);

/** @param {Page} page @param {string} place @param {string} value */
const choose = async (page, place, value) => {
  await unfold(page);
  await field(page, place).selectOption(value);
};

service.test('typical figures are in the units that the job has now', async (page) => {
  const millimetres = /** @type {Record<string, any>} */ ({});
  const shapes = ['block', 'groove', 'hole', 'profile', 'wedge', 'parabola', 'ellipse', 'power'];
  for (const shape of shapes) {
    await choose(page, '/lower/shape/type', shape);
    millimetres[shape] = (await draft(page)).lower.shape;
  }
  await choose(page, '/lower/material/plasticity/depth_kind', 'case');
  // The curve beside the law is not that of every depth.
  await page.getByText('dashed: engineering; at each depth times the factor there').waitFor();
  await page.evaluate(() => sessionStorage.clear());
  await page.reload();
  await page.getByText('1500.0 MPa').waitFor();
  await choose(page, '/units', 'SI');
  for (const shape of shapes) {
    await choose(page, '/lower/shape/type', shape);
    const { type, points, interpolation, exponent, angle, ...lengths } = (await draft(page)).lower
      .shape;
    for (const [key, value] of Object.entries(lengths))
      assert.ok(
        Math.abs(value / (millimetres[shape][key] / 1000) - 1) < 1e-6,
        `${shape}: ${key} ${value} m`,
      );
    if (points)
      assert.ok(Math.abs(points[0][0] + 0.02) < 1e-9, `${type}, ${interpolation}: ${points[0]}`);
    assert.equal(angle ?? exponent, millimetres[shape].angle ?? millimetres[shape].exponent);
  }
  await choose(page, '/lower/material/plasticity/depth_kind', 'case');
  assert.equal(
    (await draft(page)).lower.material.plasticity.over_depth.hardness.case_depth,
    0.001,
  );
  await page.evaluate(() => {
    const job = JSON.parse(sessionStorage.getItem('draft') ?? '');
    job.upper.material = { rigid: true };
    sessionStorage.setItem('draft', JSON.stringify(job));
  });
  await page.reload();
  await choose(page, '/upper/material/law', 'bilinear');
  const { young_modulus, plasticity } = (await draft(page)).upper.material;
  assert.deepEqual([young_modulus, plasticity.yield_stress], [210e9, 500e6]);
});

service.test('“same as” copies the other body as it is now', async (page) => {
  const radius = field(page, '/upper/shape/radius');
  const lower = async () => {
    await page.getByRole('button', { name: 'same as upper' }).click();
    const { shape, material } = (await draft(page)).lower;
    return [shape.radius, material.young_modulus];
  };
  // It follows the upper no longer.
  await field(page, '/lower/shape/radius').fill('21');
  await radius.fill('25');
  await page.getByRole('button', { name: 'Undo' }).click();
  await radius.fill('33');
  await field(page, '/upper/material/young_modulus').fill('100000');
  assert.deepEqual(await lower(), [33, 100000], 'after undo');
  const { upper } = await draft(page);
  upper.shape.radius = 50;
  upper.material.young_modulus = 70000;
  const id = await sent(page, { upper });
  await follow(page, `job=${id}`);
  await page.waitForFunction(
    () => JSON.parse(sessionStorage.getItem('draft') ?? '{}').upper.shape.radius === 50,
  );
  await choose(page, '/lower/shape/type', 'parabola');
  assert.equal(
    (await draft(page)).lower.shape.radius,
    20,
    'of the lower body of the job that was opened',
  );
  assert.deepEqual(await lower(), [50, 70000], 'after a link');
  await page.getByRole('button', { name: 'JSON', exact: true }).click();
  const text = page.locator('#json-text');
  await text.fill((await text.inputValue()).replace('50', '44'));
  await page.getByText('same job as in the form').waitFor();
  await page.waitForFunction(
    () => JSON.parse(sessionStorage.getItem('draft') ?? '{}').upper.shape.radius === 44,
  );
  assert.deepEqual(await lower(), [44, 70000], 'after the JSON');
  await choose(page, '/units', 'SI');
  const { shape, material } = (await draft(page)).lower;
  assert.deepEqual([shape.radius, material.young_modulus], [0.044, 70e9], 'in other units');
});

service.test(
  'a body keeps its size, and its figures, when its shapes are looked through',
  async (page) => {
    await field(page, '/upper/shape/radius').fill('27');
    const shape = field(page, '/upper/shape/type');
    await shape.focus();
    const count = await shape.locator('option').count();
    for (const key of ['ArrowDown', 'ArrowUp'])
      for (let k = 1; k < count; k++) {
        await page.keyboard.press(key);
        const { type, ...figures } = (await draft(page)).upper.shape;
        const lengths = Object.values(figures).filter((one) => typeof one === 'number');
        assert.ok(Math.max(...lengths) <= 270, `${type} ${JSON.stringify(figures)}`);
      }
    assert.deepEqual((await draft(page)).upper.shape, { type: 'cylinder', radius: 27 });
    await choose(page, '/upper/shape/type', 'block');
    await field(page, '/upper/shape/width').fill('31');
    await choose(page, '/upper/shape/type', 'groove');
    await choose(page, '/upper/shape/type', 'block');
    assert.equal((await draft(page)).upper.shape.width, 31);
  },
);

service.test('what was given of another load is there when one comes back to it', async (page) => {
  const kind = (/** @type {string} */ value) => choose(page, '/load/kind', value);
  const load = async () => (await draft(page)).load;
  await field(page, '/load/force').fill('777');
  await kind('approach');
  await field(page, '/load/approach').fill('0.031');
  await kind('onset');
  await kind('force');
  assert.deepEqual(await load(), { force: 777 });
  await kind('target');
  await choose(page, '/load/target_kind', 'half_width');
  await field(page, '/load/target/half_width').fill('0.44');
  await choose(page, '/load/target_kind', 'dent_depth');
  await choose(page, '/load/target_kind', 'half_width');
  await choose(page, '/units', 'SI');
  await kind('force');
  assert.deepEqual(await load(), { force: 777000 });
  await kind('target');
  assert.deepEqual(await load(), { target: { half_width: 0.00044 } });
  await choose(page, '/units', 'mm_N_MPa');
  await kind('approach');
  assert.deepEqual(await load(), { approach: 0.031 });
  await page.locator('#example').selectOption({ index: 1 });
  await kind('onset');
  await kind('force');
  assert.notEqual((await load()).force, 777, 'of another job nothing is kept');
});

service.test(
  'what was given of another hardening is there when one comes back to it',
  async (page) => {
    const law = (/** @type {string} */ value) => choose(page, '/lower/material/law', value);
    const material = async () => (await draft(page)).lower.material;
    await field(page, '/lower/material/plasticity/tangent_modulus').fill('2100');
    await choose(page, '/lower/material/plasticity/depth_kind', 'case');
    await field(page, '/lower/material/plasticity/over_depth/hardness/surface').fill('700');
    await choose(page, '/lower/material/plasticity/depth_kind', 'uniform');
    await choose(page, '/lower/material/plasticity/depth_kind', 'case');
    const before = await material();
    assert.equal(before.plasticity.over_depth.hardness.surface, 700);
    for (const other of ['swift', 'elastic', 'rigid']) {
      await law(other);
      await law('bilinear');
      assert.deepEqual(await material(), before, other);
    }
    await law('swift');
    await page.locator('[data-preset=lower]').selectOption('Steel S235');
    await law('swift');
    assert.equal(
      (await material()).plasticity.yield_stress,
      235,
      'of another material nothing is kept',
    );
  },
);

service.test('every shape that is offered is solvable as it comes', async (page) => {
  for (const analysis of ['plane_strain', 'axisymmetric']) {
    await choose(page, '/analysis', analysis);
    const offered = await field(page, '/upper/shape/type')
      .locator('option')
      .evaluateAll((all) => all.map((one) => /** @type {HTMLOptionElement} */ (one).value));
    assert.equal(offered.includes('wedge'), analysis !== 'axisymmetric');
    assert.equal(offered.includes('cone'), analysis === 'axisymmetric');
    for (const shape of offered.filter((one) => !['groove', 'hole'].includes(one))) {
      await choose(page, '/upper/shape/type', shape);
      await page.waitForFunction(() => !document.body.dataset.check);
      assert.deepEqual(
        await page.locator('#setup .error:visible').allInnerTexts(),
        [],
        `${analysis} ${shape}`,
      );
      assert.equal(Boolean((await draft(page)).upper.material.rigid), shape === 'punch');
    }
  }
  await choose(page, '/upper/shape/type', 'cone');
  await choose(page, '/analysis', 'plane_strain');
  assert.equal((await draft(page)).upper.shape.type, 'wedge');
});
