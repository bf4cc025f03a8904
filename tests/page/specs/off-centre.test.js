/** Contacts that lie beside x = 0, as those of profiles without symmetry do. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { frameOf } from '../../../web/field/frame.js';
import { surfaceOf } from '../../../web/field/lift.js';
import { outline } from '../../../web/setup/outline.js';
import { counted, touching } from '../../../web/setup/touching.js';
import { suite } from '../browser.js';
import { OFF_CENTRE, drawn, follow, mises, shown, solved } from '../jobs.js';

const service = suite();

/** @typedef {import('playwright-core').Page} Page */

/** Patches and half-width of the first step, as the service has them. @param {Page} page @param {string} id @returns {Promise<{patches: any[], half: number}>} */
const contactOf = (page, id) =>
  page.evaluate(async (id) => {
    const [{ contact, answers }] = (await (await fetch(`v1/jobs/${id}/result`)).json()).steps;
    const { value } = answers.find((/** @type {any} */ { name }) => name === 'half_width');
    return { patches: contact.patches, half: value };
  }, id);

/** The first drawing of the report: its curves and the box of its axes. @param {Page} page */
const firstDrawing = (page) =>
  page
    .locator('#sheet .sheet-drawings svg')
    .first()
    .evaluate((drawing) => {
      const rect = /** @type {Element} */ (drawing.querySelector('clipPath rect'));
      const [left, width, top, height] = ['x', 'width', 'y', 'height'].map((name) =>
        Number(rect.getAttribute(name)),
      );
      const curves = [...drawing.querySelectorAll('g[clip-path] path')].map((path) =>
        [...(path.getAttribute('d') ?? '').matchAll(/[ML](\S+) ([^ML]+)/g)].map(([, x, y]) => [
          Number(x),
          Number(y),
        ]),
      );
      const words = [...drawing.querySelectorAll('text')].map(
        ({ textContent }) => textContent ?? '',
      );
      return { box: { left, right: left + width, top, bottom: top + height }, curves, words };
    });

service.test('the pressure is in its chart wherever the contact lies', async (page) => {
  const id = await shown(page, OFF_CENTRE);
  const { patches, half } = await contactOf(page, id);
  assert.ok(patches[0].left > half, 'the contact is beside x = 0');
  const over = page.locator('#panel-pressure .plot .reach');
  const size = await over.boundingBox();
  assert.ok(size);
  await over.hover({ position: { x: size.width / 2, y: 20 } });
  const at = await page.locator('#panel-pressure .legend .at').textContent();
  const middle = (patches[0].left + patches[0].right) / 2;
  assert.ok(
    Math.abs(Number(/at (\S+) mm/.exec(at ?? '')?.[1]) - middle) < 0.2 * half,
    `${at} instead of ${middle}`,
  );
  await page.locator('#report').click();
  const { box, curves, words } = await firstDrawing(page);
  const pressed = curves[0].filter(([, y]) => y < box.bottom - 1).map(([x]) => x);
  assert.ok(pressed.length > 8, `${pressed.length} places`);
  assert.ok(
    Math.min(...pressed) > box.left && Math.max(...pressed) < box.right,
    'all of it is within the axes',
  );
  assert.ok(
    Math.max(...pressed) - Math.min(...pressed) > 0.5 * (box.right - box.left),
    'and takes most of them',
  );
  assert.ok(
    words.some((text) => /^a \d/.test(text)),
    words.join(' | '),
  );
});

service.test(
  'contacts of compared jobs are all in the chart, and none is shown where none of them touches',
  async (page) => {
    const [beside, middle] = [
      await solved(page, OFF_CENTRE),
      await solved(page, { load: { force: 300 } }),
    ];
    await follow(page, `job=${beside}&with=${middle}`);
    await page.locator('#panel-figures tbody tr').nth(1).waitFor();
    await page.locator('#report').click();
    const { box, curves } = await firstDrawing(page);
    for (const curve of curves.slice(0, 2)) {
      const pressed = curve.filter(([, y]) => y < box.bottom - 1).map(([x]) => x);
      assert.ok(Math.min(...pressed) > box.left && Math.max(...pressed) < box.right);
    }
    await page.keyboard.press('Escape');
    const unloaded = {
      load: { history: [{ force: 600 }, { force: 0 }] },
      solver: { theory: 'flow' },
    };
    const ids = [
      await solved(page, unloaded),
      await solved(page, { ...unloaded, load: { history: [{ force: 500 }, { force: 0 }] } }),
    ];
    await follow(page, `job=${ids[0]}&with=${ids[1]}`);
    await page.locator('#panel-figures tbody tr').nth(3).waitFor();
    assert.equal(await page.locator('#panel-pressure').isVisible(), false);
    await page.locator('.steps input').fill('0');
    await page.locator('#panel-pressure').waitFor();
  },
);

/** The first body of the same problem with another height of depth 0. @param {number} height */
const raised = (height) => {
  const { upper, lower } = structuredClone(OFF_CENTRE);
  for (const point of upper.shape.points) point[1] += height;
  return { upper, lower, load: { force: 1500 }, output: { fields: true } };
};

service.test('the field begins at the contact, and so does a cut', async (page) => {
  for (const height of [0, 5]) {
    const { upper, lower, ...rest } = raised(height);
    const id = await shown(
      page,
      height ? { upper: lower, lower: upper, ...rest } : { upper, lower, ...rest },
    );
    await drawn(page);
    const { patches } = await contactOf(page, id);
    const over = page.locator('#panel-field .stage .over');
    await over.scrollIntoViewIfNeeded();
    const box = await over.boundingBox();
    assert.ok(box);
    const readout = page.locator('#panel-field .readout');
    const middle = (patches[0].left + patches[0].right) / 2;
    for (const [share, name] of /** @type {const} */ ([
      [0.45, 'upper'],
      [0.55, 'lower'],
    ])) {
      await page.mouse.move(box.x + box.width / 2, box.y + share * box.height);
      await readout.getByText(new RegExp(`^${name} body, x`)).waitFor();
      const [, x] = / x (\S+), /.exec((await readout.textContent()) ?? '') ?? [];
      assert.ok(
        Math.abs(Number(x) - middle) < 0.05 * (patches[0].right - patches[0].left),
        `${x} instead of ${middle}`,
      );
    }
    await page.mouse.move(box.x + 5, box.y + 5);
    await page.mouse.down();
    await page.mouse.move(box.x + 300, box.y + 200);
    await page.mouse.up();
    await page.getByRole('button', { name: 'Whole contact' }).click();
    await page.mouse.move(box.x + box.width / 2, box.y + 0.45 * box.height);
    await readout.getByText(/^upper body, x/).waitFor();
    await mises(page);
    await page.getByLabel('Cut', { exact: true }).check();
    await page
      .getByRole('img', { name: /^von Mises stress along the cut, at most \d+/ })
      .waitFor();
    assert.ok(
      Math.abs(Number(await page.getByLabel('Cut from x').inputValue()) - middle) < 1e-3 * middle,
    );
    assert.equal(await page.locator('.cut .legend li').count(), 2, 'it crosses both bodies');
    await page.getByLabel('Cut', { exact: true }).uncheck();
  }
});

service.test(
  'the plastic zone lies in its body, whatever height its profile counts from',
  async (page) => {
    const highest = [];
    for (const height of [0, 5]) {
      const id = await solved(page, raised(height));
      highest.push(
        await page.evaluate(async (id) => {
          const { frameOf } = await import(/** @type {any} */ ('/web/field/frame.js'));
          const [report, job] = await Promise.all(
            ['result', 'request'].map(async (part) =>
              (await fetch(`v1/jobs/${id}/${part}`)).json(),
            ),
          );
          const [{ fields, plasticity }] = report.steps;
          const frame = frameOf(job, 'upper', { nodes: fields.upper.nodes.flat() });
          const heights = plasticity.upper.outline
            .flat()
            .map((/** @type {number[]} */ [along, depth]) => frame.point(along, depth)[1]);
          return [Math.min(...heights), Math.max(...heights)];
        }, id),
      );
    }
    const [[low, high], other] = highest;
    assert.ok(low > -0.5 && high > low && high < 5, `${low} … ${high}`);
    for (const [k, value] of [low, high].entries())
      assert.ok(Math.abs(other[k] - value) < 0.02, `${other[k]} ${value}`);
  },
);

test('the ends of a contact go with the surface that they are on', () => {
  const mesh = {
    nodes: Float32Array.from([0, 0, 1, 0, 2, 0, 0, -1, 1, -1, 2, -1]),
    displacement: Float32Array.from([0, -3, 0, -2, 0.5, -1, 9, 9, 9, 9, 9, 9]),
    elements: new Uint32Array(),
  };
  const body = { shape: { type: 'block', width: 4, depth: 1 } };
  const surface = surfaceOf(
    { mesh, frame: frameOf({ upper: body, lower: body }, 'lower', mesh) },
    [-1, 0, 1, 2],
  );
  // The mesh may be given back.
  mesh.displacement.fill(NaN);
  assert.deepEqual(surface(1.5), { x: 1.5, y: 0, u: 0.25, v: -1.5 });
  assert.deepEqual(surface(2), { x: 2, y: 0, u: 0.5, v: -1 });
});

test('bodies are brought together where they touch first', () => {
  const block = outline({ type: 'block', width: 60, depth: 30 });
  const profile = (/** @type {number[][]} */ points) =>
    outline({ type: 'profile', points, depth: 10, interpolation: 'linear' });
  for (const [points, raise, places] of /** @type {[number[][], number, number[][]][]} */ ([
    [[[-6, -1.9], [3, 1.5], [6, 0]], 1.5, [[3, 0]]], // prettier-ignore
    [[[-6, -4], [0, -2.5], [6, -4]], -2.5, [[0, 0]]], // prettier-ignore
    [[[-6, -1], [-4, 0], [0, -1], [4, 0], [6, -1]], 0, [[-4, 0], [4, 0]]], // prettier-ignore
    [[[-6, -1], [1, 0], [5, 0], [6, -1]], 0, [[3, 0]]], // prettier-ignore
  ])) {
    const upper = profile(points);
    assert.ok(upper && block);
    const found = touching(upper, block);
    assert.deepEqual(found, { raise, places });
    assert.equal(Math.max(...counted(upper, raise).surface.map(([, height]) => height)), 0);
  }
  const [cylinder, groove] = [
    { type: 'cylinder', radius: 10 },
    { type: 'groove', radius: 12, width: 10, depth: 20 },
  ].map(outline);
  assert.ok(cylinder && groove);
  assert.deepEqual(touching(cylinder, groove).places, [[0, 0]]);
});
