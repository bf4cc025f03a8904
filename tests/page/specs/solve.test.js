/** The way of most visitors: set up, solve, look. */

import assert from 'node:assert/strict';
import { suite } from '../browser.js';
import { follow, sent } from '../jobs.js';

const service = suite();

const SOLVED = '[data-status=succeeded]';

service.test('a form is filled, a contact solved, its pressure drawn', async (page) => {
  await page.getByLabel('Radius').first().fill('30');
  await page.getByLabel('Force P').fill('900');
  await page.getByText(/Yields: the force is/).waitFor();
  await page.getByRole('button', { name: 'Solve', exact: true }).click();
  await page.waitForSelector(SOLVED);
  const words = await page.locator('#panel-pressure .plot').getAttribute('aria-label');
  assert.match(
    words ?? '',
    /^Contact pressure over x: highest \d{4}(\.\d)? MPa, half-width 0\.\d+ mm; Hertz, elastic/,
  );
  // A curve is drawn with the frame after its words: on a busy machine that may be a while.
  await page.waitForFunction(inked, { within: '#panel-pressure', name: '--curve-1', pixels: 200 });
  assert.equal(
    await page.locator('#panel-pressure .legend li').count(),
    2,
    'this contact and Hertz',
  );
  for (const panel of ['field', 'depth']) await page.locator(`#panel-${panel}`).waitFor();
  await page.locator('.solver > summary').click();
  await page.locator('#panel-convergence').waitFor();
});

service.test(
  'what Hertz says and the JSON follow the form, and the form the JSON',
  async (page) => {
    const peak = page.locator('.hertz dd').nth(1);
    await page.getByText('1500.0 MPa').waitFor();
    await page.getByLabel('Force P').fill('272.27');
    await page.waitForFunction(() =>
      document.querySelectorAll('.hertz dd')[1]?.textContent?.startsWith('1000'),
    );
    assert.match((await peak.textContent()) ?? '', /MPa$/);
    await page.getByRole('button', { name: 'JSON', exact: true }).click();
    const text = page.locator('#json-text');
    const job = JSON.parse(await text.inputValue());
    assert.equal(job.load.force, 272.27);
    job.lower.shape = { type: 'block', width: 120, depth: 90 };
    await text.fill(JSON.stringify(job));
    await page.getByLabel('Width w').waitFor();
    assert.equal(await page.getByLabel('Width w').inputValue(), '120');
    await text.fill('{"analysis": ');
    await page.locator('#json-text[aria-invalid=true]').waitFor();
    assert.equal(
      await page.getByLabel('Width w').inputValue(),
      '120',
      'half a text changes nothing',
    );
  },
);

service.test('units change, the physics stays', async (page) => {
  await page.getByLabel('Units').selectOption('SI');
  await page.getByText('1.5000·10⁹ Pa').waitFor();
  assert.equal(await page.getByLabel('Radius').first().inputValue(), '0.02');
  assert.equal(await page.getByLabel('Force P').inputValue(), '612610.6');
});

service.test('a sweep has its curve, and every step can be seen', async (page) => {
  await page.getByLabel('Given').selectOption('forces');
  await page.locator('[data-place="/load/forces"] input').fill('100…600/6');
  await page.getByRole('button', { name: 'Solve', exact: true }).click();
  await page.waitForSelector(SOLVED);
  await page.locator('#panel-sweep').waitFor();
  assert.match(
    (await page.locator('#panel-sweep .plot').getAttribute('aria-label')) ?? '',
    /6 points up to 600/,
  );
  const force = page.locator('.steps output');
  assert.match((await force.textContent()) ?? '', /^6 of 6: 600\.0+ N\/mm/);
  await page.getByLabel('Step', { exact: true }).focus();
  await page.keyboard.press('Home');
  assert.match((await force.textContent()) ?? '', /^1 of 6: 100\.0/);
  assert.match(
    (await page.locator('#panel-pressure .plot').getAttribute('aria-label')) ?? '',
    /highest 60\d\.\d/,
    'elastic below first yield',
  );
});

/** Whether a chart has a line of this colour that is so long. @param {{within: string, name: string, pixels: number}} of */
function inked({ within, name, pixels }) {
  const colour = getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  const lines = /** @type {NodeListOf<SVGPathElement>} */ (
    document.querySelectorAll(`${within} .plot path[stroke="${colour}"]`)
  );
  return [...lines].some((line) => line.getTotalLength() > pixels);
}

service.test('figures follow a slider, and the last one wins', async (page, { note }) => {
  const place = page.locator('[data-place="/load/force"]');
  await place.getByRole('button', { name: 'Slider' }).click();
  const range = place.getByRole('slider');
  // The hand moves on whenever an answer is shown: so many answers are seen, whatever the machine.
  const seen = await range.evaluate(async (input) => {
    const slider = /** @type {HTMLInputElement} */ (input);
    const card = () => document.querySelectorAll('#headline .figure')[3]?.textContent ?? '';
    const forces = [];
    const begin = performance.now();
    for (let k = 0; k < 20; k++) {
      const last = card();
      slider.value = String(60 + 3 * k);
      slider.dispatchEvent(new Event('input', { bubbles: true }));
      const moved = performance.now();
      while (card() === last && performance.now() - moved < 20_000)
        await new Promise(requestAnimationFrame);
      forces.push(card());
    }
    return { forces, rate: 20e3 / (performance.now() - begin) };
  });
  assert.equal(new Set(seen.forces).size, 20);
  note(`${seen.rate.toFixed(1)} answers a second shown`);
  // Now faster than anything is solved: what is shown in the end is the last.
  await range.evaluate((input) => {
    const slider = /** @type {HTMLInputElement} */ (input);
    for (let k = 0; k < 100; k++) {
      slider.value = String(k);
      slider.dispatchEvent(new Event('input', { bubbles: true }));
    }
    slider.dispatchEvent(new Event('change', { bubbles: true }));
  });
  const last = Number(
    await page.locator('[data-place="/load/force"] input[type=text]').inputValue(),
  );
  await page.waitForFunction(
    (last) =>
      parseFloat(document.querySelectorAll('#headline .figure')[3]?.textContent ?? '') === last,
    last,
  );
  await page.locator('[data-status=live]').getByText('press Solve to keep it as a job').waitFor();
  await page.getByRole('button', { name: 'Solve', exact: true }).click();
  await page.waitForSelector(SOLVED);
});

service.test(
  'a sweep that is cancelled says which of its loads are solved, on the page and in its report',
  async (page) => {
    const forces = Array.from({ length: 400 }, (_, k) => 100 + k);
    const solver = { theory: 'deformation' };
    const id = await sent(page, {
      load: { forces },
      mesh: { elements_per_half_width: 20 },
      solver,
    });
    await page.evaluate(() => {
      const said = /** @type {string[]} */ (/** @type {any} */ (globalThis).said = []);
      new MutationObserver(() =>
        said.push(document.querySelector('#headline .so-far span:last-child')?.textContent ?? ''),
      ).observe(/** @type {Node} */ (document.querySelector('#headline')), {
        childList: true,
        subtree: true,
        characterData: true,
      });
    });
    await follow(page, `job=${id}`);
    await page.getByText(/^Load [3-9]\d* of 400/).waitFor();
    await page.getByRole('button', { name: 'Cancel' }).click();
    await page.locator('[data-status=cancelled]').waitFor();
    const words = page.locator('[data-status=cancelled] .words');
    await words.getByText(/^\d+ of 400 loads are solved(; step \d+ is not an answer)?$/).waitFor();
    const said = (await words.textContent()) ?? '';
    const many = await page.locator('#panel-figures tbody tr').count();
    const done = await page
      .locator('#panel-figures tbody tr')
      .getByText('converged', { exact: true })
      .count();
    assert.equal(Number(/^\d+/.exec(said)), done);
    assert.ok(done >= 2 && many < 400, said);
    const steps = await page.evaluate(() =>
      /** @type {any} */ (globalThis).said.flatMap(
        (/** @type {string} */ text) => Number(/^Load (\d+) of/.exec(text)?.[1] ?? []) || [],
      ),
    );
    assert.deepEqual(
      steps,
      [...steps].sort((a, b) => a - b),
      'steps are not counted from the beginning again',
    );
    await page.locator('#headline').getByText('Ended early', { exact: true }).waitFor();
    await page.getByRole('button', { name: 'Report' }).click();
    const sheet = page.getByRole('main', { name: 'Report' });
    await sheet.getByText(`${said}.`).waitFor();
    await sheet.getByText(`step ${many} of ${many} solved, of 400 asked for`).waitFor();
  },
);

service.test('a key of the form solves nothing behind a dialogue or a report', async (page) => {
  let count = 0;
  page.on('request', (request) => {
    if (request.method() === 'POST' && request.url().endsWith('/v1/jobs')) count += 1;
  });
  await page.getByRole('button', { name: 'Keep as own…' }).first().click();
  await page.getByLabel('Name', { exact: true }).press('Control+Enter');
  await page.getByRole('dialog').getByRole('button', { name: 'Cancel' }).click();
  await page.keyboard.press('Control+Enter');
  await page.locator(SOLVED).waitFor();
  await page.getByRole('button', { name: 'Report' }).click();
  await page.getByLabel('Force P').evaluate((one) => one.dispatchEvent(new Event('input')));
  await page.keyboard.press('Control+Enter');
  await page.keyboard.press('Escape');
  assert.equal(count, 1);
});

service.test('what a slider has solved is no job of the list', async (page) => {
  const place = page.locator('[data-place="/load/force"]');
  const removed = page.waitForResponse((response) => response.request().method() === 'DELETE');
  await place.getByRole('button', { name: 'Slider' }).click();
  await place.getByRole('slider').press('ArrowRight');
  await page.locator('[data-status=live]').getByText('solved in').waitFor();
  const response = await removed;
  assert.equal(response.ok(), true);
  const id = new URL(response.url()).pathname.split('/').at(-1);
  assert.equal(await page.evaluate(async (id) => (await fetch(`v1/jobs/${id}`)).status, id), 404);
});

service.test(
  'a slider says what it leaves running, and that the finest answer is under way',
  async (page) => {
    const id = await sent(page, {
      mesh: { elements_per_half_width: 40 },
      load: { forces: Array.from({ length: 400 }, (_, k) => 100 + k) },
    });
    await follow(page, `job=${id}`);
    await page.locator('[data-status=running]').waitFor();
    await page.getByLabel('Given', { exact: true }).selectOption('approach');
    await page.route('**/v1/solve', (route) => {
      // The coarse one alone is answered.
      if (route.request().postDataJSON().mesh.elements_per_half_width === 10) route.continue();
    });
    const place = page.locator('[data-place="/upper/shape/radius"]');
    await place.getByRole('button', { name: 'Slider' }).click();
    await place.getByRole('slider').press('ArrowRight');
    await page.locator('#toast').getByText('The job before goes on').waitFor();
    await page.locator('[data-status=live]').getByText('solving on 40 elements').waitFor();
    await page.goBack();
    await page.locator('[data-status=running]').getByRole('button', { name: 'Cancel' }).click();
    await page.locator('[data-status=cancelled]').waitFor();
  },
);
