/** A force that rolls: set up, solved, and what is said of its passes. */

import assert from 'node:assert/strict';
import { suite } from '../browser.js';
import { draft, shown, steel, unfold } from '../jobs.js';

const service = suite();

service.test('a force that rolls is set up, solved and drawn', async (page) => {
  await page.getByText('1500.0 MPa').waitFor();
  await unfold(page);
  const field = (/** @type {string} */ place) =>
    page.locator(`[data-place="${place}"] :is(input[type=text], select, textarea)`);
  await field('/load/kind').selectOption('rolling');
  assert.deepEqual((await draft(page)).load, { rolling: { force: 612.6106 } });
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
  assert.match(cards, /Strain per pass/);
  assert.match(cards, /Depth of the track/);
  assert.doesNotMatch(await page.locator('#headline').innerText(), /NaN|undefined|null/);
});

service.test('figures stay when the load rolls no more', async (page) => {
  await page.getByText('1500.0 MPa').waitFor();
  await unfold(page);
  const kind = page.locator('[data-place="/load/kind"] select');
  await kind.selectOption('rolling');
  await kind.selectOption('force');
  assert.deepEqual((await draft(page)).load, { force: 612.6106 });
});

service.test(
  'a ball that rolls shows its way, its groove, what is left and the map of shakedown',
  async (page) => {
    await page.getByText('1500.0 MPa').waitFor();
    assert.equal(await page.locator('#sketch [data-travel]').count(), 0);
    await page.locator('#example').selectOption('Ball that runs in, in three dimensions');
    await page.locator('#sketch [data-travel]').waitFor();
    await page.getByRole('button', { name: 'Solve', exact: true }).click();
    await page.locator('#panel-groove svg').first().waitFor();
    const words = (/** @type {string} */ panel) =>
      page.locator(`#panel-${panel} .plot`).getAttribute('aria-label');
    assert.match((await words('groove')) ?? '', /^\d+ passes: .* mm \(lower, groove\)/);
    assert.match((await words('groove')) ?? '', /\(lower, pile-up\)/);
    assert.match((await words('shakedown')) ?? '', /This job is at μ 0 and \d\.\d+ k\./);
    const legend = page.locator('#panel-shakedown .legend');
    for (const name of ['first yield', 'perfectly plastic', 'kinematic hardening', 'this job'])
      await legend.getByText(name).waitFor();
    // Residual stress is what one looks at.
    const chosen = page.locator('#panel-depth [data-component]:has(input:checked)');
    assert.deepEqual(
      await chosen.evaluateAll((all) => all.map((one) => one.getAttribute('data-component'))),
      ['sigma_x', 'sigma_z', 'equivalent_plastic_strain'],
    );
    await page.getByRole('button', { name: 'Report' }).click();
    const drawings = page.locator('.sheet-drawings');
    for (const title of ['Passes', 'Groove', 'Shakedown map'])
      await drawings.getByText(title).first().waitFor();
  },
);

service.test('limits of fatigue have a curve, a sentence, a mark and a file', async (page) => {
  const material = { ...steel(2000), fatigue: { torsion: 480, bending: 800 } };
  const body = { shape: { type: 'cylinder', radius: 20 }, material };
  await shown(page, {
    upper: body,
    lower: body,
    load: { rolling: { force: 612.6106, passes: 1 } },
  });
  await page.locator('#panel-fatigue svg').first().waitFor();
  const words = await page.locator('#panel-fatigue .plot').getAttribute('aria-label');
  // Hertz's 1500 MPa.
  assert.match(
    words ?? '',
    /^lower body: largest utilization 0\.5\d+ \(Dang Van\), 0\.\d+ \(Cross/,
  );
  const verdict = await page.locator('#headline .verdict-text').innerText();
  assert.match(verdict, /Endures by all three criteria of fatigue \(utilization /);
  const legend = page.locator('#panel-shakedown .legend');
  await legend.getByText('fatigue of elastic bodies').waitFor();
  await page.getByText('Download', { exact: true }).click();
  await page.getByText('Fatigue over depth, CSV').waitFor();
});
