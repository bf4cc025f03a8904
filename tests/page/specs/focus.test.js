/**
 * The focus is never lost: whatever is built anew, who works by keyboard goes on where they were.
 */

import assert from 'node:assert/strict';
import { suite } from '../browser.js';
import { shown, solved } from '../jobs.js';

/** @typedef {import('playwright-core').Page} Page */

const service = suite();

/** What has the focus. @param {Page} page */
const at = (page) =>
  page.evaluate(() => {
    const one = /** @type {HTMLElement} */ (document.activeElement);
    const place = /** @type {HTMLElement | null} */ (one.closest('[data-place], [data-key]'));
    return [
      place?.dataset.place ?? '',
      one.dataset.preset ?? '',
      one.id.replace(/^entry-\d+$/, ''),
      one.matches('button') ? one.textContent : one.tagName,
    ]
      .filter(Boolean)
      .join(' ');
  });

service.test('by undo and by choices that build the form anew', async (page) => {
  const shape = page.locator('[data-place="/upper/shape/type"] select');
  await shape.focus();
  await shape.selectOption('block');
  assert.equal(await at(page), '/upper/shape/type SELECT');
  await page.keyboard.press('Control+z');
  assert.equal(await at(page), '/upper/shape/type SELECT');
  const width = page.locator('[data-place="/upper/shape/width"] input[type=text]');
  await shape.selectOption('block');
  await width.fill('70');
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  assert.notEqual(await at(page), 'BODY', 'the field is gone: the one in its place has the focus');
  const preset = page.locator('[data-preset=upper]');
  await preset.focus();
  await preset.selectOption('Bearing steel, elastic');
  assert.equal(await at(page), 'upper SELECT');
  await page.locator('[data-place="/upper/shape/type"] select').selectOption('block');
  const same = page.getByRole('button', { name: 'same as lower' });
  await same.focus();
  await page.keyboard.press('Enter');
  assert.equal(await at(page), 'same as lower');
  await page.getByRole('button', { name: 'From hardness…' }).last().focus();
  await page.keyboard.press('Enter');
  // It is loaded when it is opened.
  await page.getByRole('dialog').waitFor();
  await page.keyboard.type('300');
  await page.keyboard.press('Enter');
  await page.getByRole('dialog').waitFor({ state: 'detached' });
  assert.equal(await at(page), 'From hardness…');
});

service.test('at buttons that have nothing more to do', async (page) => {
  await page.getByLabel('Force P').fill('500');
  const undo = page.getByRole('button', { name: 'Undo' });
  await undo.focus();
  await page.keyboard.press('Enter');
  assert.equal(await undo.getAttribute('aria-disabled'), 'true');
  assert.equal(await at(page), 'undo ↶');
  await page.locator('#solve').focus();
  await page.keyboard.press('Enter');
  await page.locator('[data-status=succeeded]').waitFor();
  assert.equal(await at(page), 'solve Solve');
  await page.getByLabel('Force P').fill('400');
  await page.locator('#restore').focus();
  await page.keyboard.press('Enter');
  await page.locator('#stale').waitFor({ state: 'hidden' });
  assert.equal(await at(page), 'result SECTION');
  await page.locator('[data-preset=upper]').selectOption('Steel S235');
  await page.getByRole('button', { name: 'Keep as own…' }).first().click();
  await page.getByLabel('Name', { exact: true }).fill('Mine');
  await page.keyboard.press('Enter');
  await page.locator('[data-forget=upper]').focus();
  await page.keyboard.press('Enter');
  await page.getByRole('dialog').getByRole('button', { name: 'Forget' }).press('Enter');
  await page.getByRole('dialog').waitFor({ state: 'detached' });
  assert.equal(await at(page), 'upper SELECT');
});

service.test('in the list of jobs, which is fetched again and again', async (page) => {
  const one = await solved(page);
  await shown(page, { load: { force: 300 } });
  await page.getByRole('button', { name: 'Jobs', exact: true }).click();
  for (const part of ['button.open', 'input']) {
    // The list may be built anew between two steps of the test: each step is whole in the page.
    const place = `[data-key="${one}"] ${part}`;
    await page.locator(place).waitFor();
    const before = await page.evaluateHandle((place) => {
      const had = /** @type {HTMLElement} */ (document.querySelector(place));
      had.focus();
      document.querySelector('#jobs-filter select')?.dispatchEvent(new Event('change'));
      return had;
    }, place);
    await page.waitForFunction((had) => !had.isConnected, before);
    assert.ok(
      await page.evaluate(
        (place) => document.querySelector(place) === document.activeElement,
        place,
      ),
      part,
    );
  }
});

service.test(
  'on the choice that one walks through, though fields come and go above it',
  async (page) => {
    const given = page.locator('[data-place="/load/kind"] select');
    await given.focus();
    for (const kind of ['forces', 'approach', 'approaches', 'history', 'onset', 'target']) {
      await page.keyboard.press('ArrowDown');
      assert.equal(await at(page), '/load/kind SELECT');
      assert.equal(await given.inputValue(), kind);
    }
    const poisson = page.locator('[data-place="/lower/material/poisson_ratio"] input[type=text]');
    const law = page.locator('[data-place="/upper/material/law"] select');
    await law.selectOption('elastic');
    await poisson.focus();
    await page.keyboard.press('Control+z');
    assert.ok((await law.inputValue()) !== 'elastic');
    assert.equal(
      await at(page),
      '/lower/material/poisson_ratio INPUT',
      'fields above are there again',
    );
  },
);

service.test('choices are typed by their whole names', async (page) => {
  for (const [place, typed, value] of [
    ['[data-place="/load/kind"] select', 'Sweep of a', 'approaches'],
    ['[data-place="/load/kind"] select', 'Force for', 'target'],
    ['[data-place="/upper/shape/type"] select', 'Power', 'power'],
    ['[data-place="/upper/shape/type"] select', 'Par', 'parabola'],
    ['[data-preset=upper]', 'Bearing steel 1', 'Bearing steel 100Cr6, 58 HRC'],
  ]) {
    const choice = page.locator(place);
    await choice.focus();
    await page.keyboard.type(typed);
    assert.equal(await choice.inputValue(), value, typed);
    // The browser begins another word after a second.
    await page.locator('[data-place="/units"] select').focus();
  }
});

service.test('never behind the bar with Solve', async (page) => {
  for (const height of [900, 800]) {
    await page.setViewportSize({ width: 1440, height });
    await page.locator('#example').focus();
    for (let stop = 0; stop < 100; stop++) {
      await page.keyboard.press('Tab');
      const { id, hidden, name } = await page.evaluate(() => {
        const one = /** @type {HTMLElement} */ (document.activeElement);
        const bar = document.querySelector('.submit')?.getBoundingClientRect();
        return {
          id: one.id,
          name: `${one.closest('[data-place]')?.getAttribute('data-place')} ${one.tagName}`,
          hidden: !one.closest('.submit') && one.getBoundingClientRect().bottom > (bar?.top ?? 0),
        };
      });
      if (id === 'solve') break;
      assert.ok(stop < 99, 'Solve is never reached');
      assert.ok(!hidden, name);
    }
  }
});

service.test('on a button before a field that is gone', async (page) => {
  const law = page.locator('[data-place^="/lower"][data-place$="/law"] select');
  await law.focus();
  await law.selectOption('ludwik');
  await page.keyboard.press('Control+z');
  await page
    .locator('[data-place="/lower/material/plasticity/tangent_modulus"] input')
    .first()
    .focus();
  const before = await page.evaluate(() => sessionStorage.getItem('draft'));
  await page.keyboard.press('Control+y');
  const after = await page.evaluate(() => sessionStorage.getItem('draft'));
  assert.notEqual(after, before, 'the field is gone');
  await page.keyboard.type('7');
  assert.equal(
    await page.evaluate(() => sessionStorage.getItem('draft')),
    after,
    'what is typed goes into no other',
  );
});
