/** Flow theory: histories of loads, what they leave behind. */

import assert from 'node:assert/strict';
import { suite } from '../browser.js';
import { draft, shown } from '../jobs.js';

const service = suite();

service.test('a history of loads is typed, brought back to 0 and undone', async (page) => {
  await page.getByLabel('Given').selectOption('history');
  assert.deepEqual((await draft(page)).load, { history: [{ force: 612.6106 }, { force: 0 }] });
  const loads = page.getByLabel('Loads in turn');
  await loads.fill('500 α0.02 300');
  assert.deepEqual((await draft(page)).load.history, [
    { force: 500 },
    { approach: 0.02 },
    { force: 300 },
  ]);
  await page.getByRole('button', { name: 'and back to 0' }).click();
  assert.equal(await loads.inputValue(), '500 α0.02 300 0');
  await page.getByLabel('Units').selectOption('SI');
  assert.deepEqual((await draft(page)).load.history.slice(0, 2), [
    { force: 500000 },
    { approach: 0.00002 },
  ]);
  await loads.fill('500 oops');
  await page
    .locator('[data-place="/load/history"] .error')
    .getByText('“oops” is no unit known here for this figure')
    .waitFor();
  for (let k = 0; k < 8; k++) await page.keyboard.press('Control+Z');
  assert.equal((await draft(page)).load.force, 612.6106);
});

service.test('nothing is said of the highest force before it is known', async (page) => {
  await page.getByLabel('Given').selectOption('history');
  const loads = page.getByLabel('Loads in turn');
  const check = page.locator('#check');
  await loads.fill('150 50 0');
  await check.getByText('Elastic: 68.5 % of the force of first yield').waitFor();
  await loads.fill('150 α0.05 0');
  await check.locator('.verdict').waitFor({ state: 'detached' });
  await check.getByText('first yield at').waitFor();
  assert.equal(await check.getByText('peak pressure').count(), 0);
});

service.test('unloading leaves a dent, a loop and residual stresses', async (page) => {
  await page.getByText('Mesh, solver, output, tags').click();
  await page.getByLabel('Elements per half-width', { exact: true }).fill('8');
  await page.getByLabel('Given').selectOption('history');
  await page.getByRole('button', { name: 'Solve', exact: true }).click();
  await page.locator('[data-status=succeeded]').waitFor({ timeout: 120_000 });
  const dent = page.locator('#panel-dent');
  assert.match(
    (await dent.locator('.plot').getAttribute('aria-label')) ?? '',
    /^Residual height of the surfaces: Dent 0\.00\d+ mm/,
  );
  await page.locator('#headline').getByText('Dissipated work').waitFor();
  await page.locator('#panel-sweep .plot svg').waitFor();
  assert.match(
    (await page.locator('#panel-depth .plot').getAttribute('aria-label')) ?? '',
    /highest von Mises stress \d/,
  );
  await page.locator('#headline').getByText('Residual tension').waitFor();
  assert.equal(await page.locator('#panel-field select').first().inputValue(), 'sigma_x');
  for (const name of ['σx', 'σz'])
    await page.locator('#panel-depth .legend').getByText(name, { exact: true }).waitFor();
});

service.test(
  'what is dissipated is on a card, and a loop says where nothing is solved',
  async (page) => {
    const history = [{ force: 600 }, { force: 0 }, { force: 600 }, { force: 0 }];
    const id = await shown(page, { load: { history }, solver: { theory: 'flow' } });
    const energies = await page.evaluate(async (id) => {
      const { steps } = await (await fetch(`v1/jobs/${id}/result`)).json();
      return steps.map((/** @type {any} */ { answers }) =>
        Object.fromEntries(answers.map((/** @type {any} */ { name, value }) => [name, value])),
      );
    }, id);
    // What has come back as the force fell is no loss, and is put in again.
    const [up, down, again, end] = energies;
    const loss = (100 * end.dissipated_work) / (up.work + again.work - down.work);
    assert.ok(loss > 1 && loss < 20, `${loss} %`);
    const card = page.locator('#headline [data-answer=dissipated_work] .figure');
    const said = parseFloat((await card.textContent()) ?? '');
    assert.ok(
      Math.abs(said / end.dissipated_work - 1) < 1e-3,
      `${said} instead of ${end.dissipated_work}`,
    );
    await page
      .locator('#panel-sweep .legend')
      .getByText('force, straight between solved loads')
      .waitFor();
    // Those pieces begin and end at points that are solved.
    const [solid, dashed] = await page
      .locator('#panel-sweep .plot g[clip-path] path')
      .evaluateAll((all) => all.map((one) => one.getAttribute('d') ?? ''));
    const points = (/** @type {string} */ path) => path.split(/[ML]/).filter(Boolean);
    assert.ok(points(dashed).length >= 4);
    for (const point of points(dashed)) assert.ok(points(solid).includes(point), point);
  },
);

/** Points of the chart over the load: place, force and figure. @param {import('playwright-core').Page} page */
const points = (page) =>
  page.locator('#panel-sweep .plot svg circle').evaluateAll((all) =>
    all.map((one) => {
      const { x, y, label } = /** @type {SVGElement} */ (one).dataset;
      return { x: Number(x), y: Number(y), label };
    }),
  );

service.test(
  'what a history has over its load is drawn at every increment, from the first loading on',
  async (page) => {
    const history = [{ force: 600 }, { force: 0 }, { force: 900 }, { force: 0 }];
    const id = await shown(page, { load: { history }, solver: { theory: 'flow' } });
    const report = await page.evaluate(
      async (id) => (await fetch(`v1/jobs/${id}/result`)).json(),
      id,
    );
    const solved = report.steps.flatMap((/** @type {any} */ { increments }) =>
      increments.force.map((/** @type {number} */ force, /** @type {number} */ k) => ({
        force,
        k,
        increments,
      })),
    );
    const panel = page.locator('#panel-sweep');
    for (const [choice, key] of [
      ['Peak', 'peak_pressure'],
      ['Half-width', 'half_width'],
    ]) {
      await panel.getByRole('radio', { name: choice, exact: true }).check();
      const [rest, ...drawn] = await points(page);
      assert.deepEqual([rest.x, rest.y], [0, 0]);
      assert.equal(drawn.length, solved.length);
      for (const [k, { force, increments, k: at }] of solved.entries()) {
        assert.ok(Math.abs(drawn[k].x - force) <= 1e-9 * 900, `${drawn[k].x} instead of ${force}`);
        const value = increments[key][at];
        assert.ok(
          Math.abs(drawn[k].y - value) <= 1e-6 * Math.abs(value),
          `${choice} at ${force}: ${drawn[k].y}, ${value}`,
        );
      }
      await panel.locator('.legend').getByText(', straight between solved loads').waitFor();
    }
    await panel.getByRole('radio', { name: 'dP/dα', exact: true }).check();
    const slopes = await points(page);
    const ends = report.steps.map((/** @type {any} */ { answers }) =>
      ['force', 'contact_stiffness'].map(
        (name) => answers.find((/** @type {any} */ one) => one.name === name)?.value ?? null,
      ),
    );
    for (const [force, slope] of ends)
      assert.ok(
        slopes.some(({ x, y }) => x === force && (y === slope || slope === null)),
        `${force} ${slope}`,
      );
    assert.ok(slopes.length > ends.length + 5, `${slopes.length} points`);
    // Of increments the result has no strain.
    await panel.getByRole('radio', { name: 'Strain', exact: true }).check();
    assert.equal((await points(page)).length, 1 + history.length);
    await panel
      .locator('.legend')
      .getByText('largest plastic strain, known at the ends of loads alone')
      .waitFor();
  },
);

service.test('what is not solved has dots of its own, the same there and back', async (page) => {
  const history = [{ force: 600 }, { force: 0 }, { force: 600 }, { force: 0 }];
  await shown(page, { load: { history }, solver: { theory: 'flow' } });
  const panel = page.locator('#panel-sweep');
  for (const choice of ['Approach', 'Peak']) {
    await panel.getByRole('radio', { name: choice, exact: true }).check();
    await panel.locator('.legend').getByText(', straight between solved loads').waitFor();
    const between = panel.locator('.plot g[clip-path] path').nth(1);
    const pieces = ((await between.getAttribute('d')) ?? '').split('M').filter(Boolean);
    assert.ok(pieces.length >= 3, `${pieces.length} pieces`);
    for (const piece of pieces) {
      const [[x0, y0], [x1, y1]] = piece.split('L').map((point) => point.split(' ').map(Number));
      assert.ok(choice === 'Approach' ? y0 > y1 : x0 < x1, `${piece} begins at its lower force`);
    }
  }
  const dash = await panel
    .locator('.plot g[clip-path] path')
    .nth(1)
    .getAttribute('stroke-dasharray');
  const main = await (await page.request.get(`${service.url}/web/main.js`)).text();
  const dashes = JSON.parse(`[${/DASHES = \[undefined, (.*)\];/.exec(main)?.[1]}]`);
  assert.equal(dashes.length, 5);
  assert.ok(!dashes.some((/** @type {number[]} */ one) => one.join(' ') === dash), `${dash}`);
});

service.test(
  'figures at the ends of the axes and points on the frame are drawn whole',
  async (page) => {
    const history = [{ force: 5000 }, { force: 0 }];
    await shown(page, { analysis: 'axisymmetric', load: { history }, solver: { theory: 'flow' } });
    const panel = page.locator('#panel-sweep');
    for (const choice of ['Approach', 'Peak', 'Half-width', 'Strain', 'dP/dα']) {
      await panel.getByRole('radio', { name: choice, exact: true }).check();
      const drawing = panel.locator('.plot svg');
      const cut = await drawing.evaluate((one) => {
        const { left, right } = one.getBoundingClientRect();
        return [...one.querySelectorAll('text, circle')].flatMap((part) => {
          const box = part.getBoundingClientRect();
          const clipped = part.closest('[clip-path]') !== null;
          return clipped || box.left < left || box.right > right
            ? [part.textContent || part.outerHTML]
            : [];
        });
      });
      assert.deepEqual(cut, [], choice);
    }
  },
);

service.test('bodies that stay elastic have no loop of force over approach', async (page) => {
  const history = [{ force: 150 }, { force: 50 }, { force: 0 }];
  await shown(page, { load: { history }, solver: { theory: 'flow' } });
  const sweep = page.locator('#panel-sweep');
  await sweep.locator('.plot svg').waitFor();
  assert.equal(await sweep.locator('.legend li').count(), 1, 'one curve, no way back');
  await shown(page, {
    load: { history: [{ force: 600 }, { force: 0 }] },
    solver: { theory: 'flow' },
  });
  await sweep.locator('.plot svg').waitFor();
});

service.test(
  'beside dented bodies Hertz’s figures are said to be of undented ones',
  async (page) => {
    const history = [{ force: 600 }, { force: 0 }, { force: 700 }, { force: 100 }];
    await shown(page, { load: { history }, solver: { theory: 'flow' } });
    const [headline, legend] = [
      page.locator('#headline'),
      page.locator('#panel-pressure .legend'),
    ];
    await headline.locator('.rest summary').click();
    await headline.getByText('elastic bodies without a dent').first().waitFor();
    await legend.getByText('Hertz, undented bodies').waitFor();
    await page.locator('#panel-depth .legend').getByText(', elastic, undented').first().waitFor();
    await page.locator('#report').click();
    await page.locator('#sheet .answers').getByText('without a dent').first().waitFor();
    await page.keyboard.press('Escape');
    // Under a load beyond all before it the dent makes no difference.
    for (const step of [0, 2]) {
      await page.locator('.steps input').fill(String(step));
      await legend.getByText('Hertz, elastic').waitFor();
      assert.equal(await headline.getByText('without a dent').count(), 0);
    }
  },
);
