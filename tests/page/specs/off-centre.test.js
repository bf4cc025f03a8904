/** Contacts that lie beside x = 0, as those of profiles without symmetry do. */

import assert from 'node:assert/strict';
import { suite } from '../browser.js';
import { OFF_CENTRE, follow, shown, solved } from '../jobs.js';

const service = suite();

/** @typedef {import('playwright-core').Page} Page */

/** The contact of the first step, as the service has it. @param {Page} page @param {string} id @returns {Promise<any>} */
const contactOf = (page, id) =>
  page.evaluate(async (id) => (await (await fetch(`v1/jobs/${id}/result`)).json()).steps[0].contact, id);

/** The first drawing of the report: its curves and the box of its axes. @param {Page} page */
const firstDrawing = (page) =>
  page
    .locator('#sheet .sheet-drawings svg')
    .first()
    .evaluate((drawing) => {
      const rect = /** @type {Element} */ (drawing.querySelector('clipPath rect'));
      const [left, width, top, height] = ['x', 'width', 'y', 'height'].map((name) => Number(rect.getAttribute(name)));
      const curves = [...drawing.querySelectorAll('g[clip-path] path')].map((path) =>
        [...(path.getAttribute('d') ?? '').matchAll(/[ML](\S+) ([^ML]+)/g)].map(([, x, y]) => [Number(x), Number(y)]),
      );
      const words = [...drawing.querySelectorAll('text')].map(({ textContent }) => textContent ?? '');
      return { box: { left, right: left + width, top, bottom: top + height }, curves, words };
    });

service.test('the pressure is in its chart wherever the contact lies', async (page) => {
  const id = await shown(page, OFF_CENTRE);
  const { patches, half_width: half } = await contactOf(page, id);
  assert.ok(patches[0].left > half, 'the contact is beside x = 0');
  const over = page.locator('#panel-pressure .u-over');
  const size = await over.boundingBox();
  assert.ok(size);
  await over.hover({ position: { x: size.width / 2, y: 20 } });
  const at = await page.locator('#panel-pressure .legend .at').textContent();
  const middle = (patches[0].left + patches[0].right) / 2;
  assert.ok(Math.abs(Number(/at (\S+) mm/.exec(at ?? '')?.[1]) - middle) < 0.2 * half, `${at} instead of ${middle}`);
  await page.locator('#report').click();
  const { box, curves, words } = await firstDrawing(page);
  const pressed = curves[0].filter(([, y]) => y < box.bottom - 1).map(([x]) => x);
  assert.ok(pressed.length > 8, `${pressed.length} places`);
  assert.ok(Math.min(...pressed) > box.left && Math.max(...pressed) < box.right, 'all of it is within the axes');
  assert.ok(Math.max(...pressed) - Math.min(...pressed) > 0.5 * (box.right - box.left), 'and takes most of them');
  assert.ok(
    words.some((text) => /^a \d/.test(text)),
    words.join(' | '),
  );
});

service.test(
  'contacts of compared jobs are all in the chart, and none is shown where none of them touches',
  async (page) => {
    const [beside, middle] = [await solved(page, OFF_CENTRE), await solved(page, { load: { force: 300 } })];
    await follow(page, `job=${beside}&with=${middle}`);
    await page.locator('#panel-figures tbody tr').nth(1).waitFor();
    await page.locator('#report').click();
    const { box, curves } = await firstDrawing(page);
    for (const curve of curves.slice(0, 2)) {
      const pressed = curve.filter(([, y]) => y < box.bottom - 1).map(([x]) => x);
      assert.ok(Math.min(...pressed) > box.left && Math.max(...pressed) < box.right);
    }
    await page.keyboard.press('Escape');
    const unloaded = { load: { history: [{ force: 600 }, { force: 0 }] }, solver: { theory: 'flow' } };
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
