/** A force that rolls: set up, solved, and what is said of its passes. */

import assert from 'node:assert/strict';
import { suite } from '../browser.js';
import { draft, unfold } from '../jobs.js';

const service = suite();

service.test('a force that rolls is set up, solved and drawn', async (page) => {
  await page.getByText('1500.0 MPa').waitFor();
  await unfold(page);
  const field = (/** @type {string} */ place) =>
    page.locator(`[data-place="${place}"] :is(input[type=text], select, textarea)`);
  await field('/load/kind').selectOption('rolling');
  const { load, solver } = await draft(page);
  assert.deepEqual([load, solver.theory], [{ rolling: { force: 612.6106 } }, 'flow']);
  await field('/load/rolling/friction').fill('-0.1');
  await field('/load/rolling/passes').fill('12');
  await page.getByText('N/mm rolling, μ −0.1').waitFor();
  await page.getByRole('button', { name: 'Solve', exact: true }).click();
  const verdict = page.locator('#headline .verdict-text');
  await verdict.getByText(/shakedown of a perfectly plastic body/).waitFor();
  assert.deepEqual((await draft(page)).load, {
    rolling: { force: 612.6106, friction: -0.1, passes: 12 },
  });
  await page.locator('#panel-passes svg').first().waitFor();
  assert.equal(await page.locator('#panel-field').isHidden(), true);
  assert.equal(await page.locator('#panel-depth').isVisible(), true);
  const cards = await page.locator('#headline dl.figures').first().innerText();
  assert.match(cards, /Strain of a steady pass/);
  assert.match(cards, /Depth of the track/);
  assert.doesNotMatch(await page.locator('#headline').innerText(), /NaN|undefined|null/);
});

service.test('figures stay when the load rolls no more', async (page) => {
  await page.getByText('1500.0 MPa').waitFor();
  await unfold(page);
  const kind = page.locator('[data-place="/load/kind"] select');
  await kind.selectOption('rolling');
  await kind.selectOption('force');
  const { load, solver } = await draft(page);
  assert.deepEqual([load, solver.theory], [{ force: 612.6106 }, 'deformation']);
});
