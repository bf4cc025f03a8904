/** Figures of the field: signs, extremes, limits of the colours, and the cut. */

import assert from 'node:assert/strict';
import { suite } from '../browser.js';
import { SI, drawn, follow, mises, shown, solved, taken } from '../jobs.js';

const service = suite();

/** @typedef {import('playwright-core').Page} Page */

const FIELDS = { output: { fields: true } };

/** Waits for a field of other numbers. @param {Page} page @param {RegExp} wanted */
const labelled = (page, wanted) =>
  page.waitForFunction(
    (wanted) =>
      new RegExp(wanted).test(document.querySelector('.over')?.getAttribute('aria-label') ?? ''),
    wanted.source,
  );

/** Words drawn on the field since this was called. @param {Page} page */
const drawnWords = (page) =>
  page.evaluate(() => {
    const words = /** @type {string[]} */ (/** @type {any} */ (globalThis).drawnWords ?? []);
    const { prototype } = CanvasRenderingContext2D;
    const { fillText } = prototype;
    prototype.fillText = function (text, x, y, room) {
      if (/** @type {HTMLCanvasElement} */ (this.canvas).className === 'over') words.push(text);
      fillText.call(this, text, x, y, room ?? Infinity);
    };
    /** @type {any} */ (globalThis).drawnWords = words;
  });

/** What the cut and the readout give. @param {Page} page */
const cutWords = async (page) =>
  (await page.locator('.cut .plot').getAttribute('aria-label')) ?? '';

/** @param {Page} page @param {string[]} ends */
async function typeCut(page, ends) {
  for (const [k, name] of ['from x', 'from y', 'to x', 'to y'].entries()) {
    await page.getByLabel(`Cut ${name}`).fill(ends[k]);
    await page.keyboard.press('Enter');
  }
}

service.test(
  'in axisymmetry shear and radial displacement are the same left of the axis as right of it',
  async (page) => {
    const id = await shown(page, { ...FIELDS, analysis: 'axisymmetric', load: { force: 4000 } });
    await drawn(page);
    const limits = await page.evaluate(async (id) => {
      const report = await (await fetch(`v1/jobs/${id}/result`)).json();
      const all = ['upper', 'lower'].flatMap((body) => report.steps[0].fields[body].tau_xy);
      return [Math.min(...all), Math.max(...all)];
    }, id);
    await page.getByLabel('Shown', { exact: true }).selectOption('tau_xy');
    await labelled(page, /^Field of τrz/);
    const [, low, high] =
      /from (\S+) to (\S+) MPa/.exec(
        (await page.locator('.over').getAttribute('aria-label')) ?? '',
      ) ?? [];
    for (const [said, value] of [
      [low, limits[0]],
      [high, limits[1]],
    ])
      assert.ok(
        Math.abs(Number(String(said).replace('−', '-')) - Number(value)) <
          2e-3 * Math.abs(Number(value)),
        `${said} ${value}`,
      );
    await page.locator('#panel-field .stage .over').scrollIntoViewIfNeeded();
    const box = await page.locator('#panel-field .stage .over').boundingBox();
    assert.ok(box);
    const readout = page.locator('#panel-field .readout');
    const read = async (/** @type {number} */ share) => {
      await page.mouse.move(box.x + share * box.width, box.y + 0.7 * box.height);
      await readout.getByText(/^lower body, r /).waitFor();
      return readout.textContent();
    };
    const right = await read(0.625);
    await page.mouse.move(box.x + 2, box.y + 2);
    const left = await read(0.375);
    assert.match(right ?? '', /τrz \d\d/);
    assert.equal(left, right);
    await page.mouse.move(box.x + box.width / 2, box.y + 0.7 * box.height);
    await readout.getByText(/r 0, .*τrz 0 /).waitFor();
  },
);

service.test(
  'the least and the largest value of what has a sign are marked, each by its name',
  async (page) => {
    const id = await shown(page, { ...FIELDS, load: { force: 612 } });
    await drawn(page);
    await drawnWords(page);
    await page.getByLabel('Shown', { exact: true }).selectOption('sigma_x');
    await labelled(page, /^Field of σx/);
    const ends = await page.evaluate(async (id) => {
      const report = await (await fetch(`v1/jobs/${id}/result`)).json();
      const all = ['upper', 'lower'].flatMap((body) => report.steps[0].fields[body].sigma_x);
      return { max: Math.max(...all), min: Math.min(...all) };
    }, id);
    assert.ok(ends.max > 0 && -ends.min > ends.max);
    const { figure } = await import('../../../web/lib/units.js');
    for (const [name, value] of Object.entries(ends)) {
      const words = `${name} ${figure(value, 3)} MPa`;
      await page.waitForFunction(
        (words) => /** @type {any} */ (globalThis).drawnWords.includes(words),
        words,
      );
    }
  },
);

service.test('an extreme that is not in the picture has no word there', async (page) => {
  await shown(page, { ...FIELDS, load: { force: 612 } });
  await drawn(page);
  await drawnWords(page);
  const over = page.locator('#panel-field .stage .over');
  await over.focus();
  await page.keyboard.press('ArrowLeft');
  const words = (/** @type {string} */ word) =>
    page.evaluate(
      (word) =>
        /** @type {any} */ (globalThis).drawnWords.filter((/** @type {string} */ one) =>
          one.startsWith(word),
        ),
      word,
    );
  await page.waitForFunction(() => /** @type {any} */ (globalThis).drawnWords.length > 0);
  assert.ok((await words('max ')).length > 0);
  for (let k = 0; k < 12; k++) await page.keyboard.press('+');
  for (let k = 0; k < 20; k++) await page.keyboard.press('ArrowLeft');
  await page.evaluate(
    () => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))),
  );
  await page.evaluate(() => {
    /** @type {any} */ (globalThis).drawnWords.length = 0;
  });
  await page.keyboard.press('ArrowLeft');
  await page.waitForFunction(() => /** @type {any} */ (globalThis).drawnWords.length > 0);
  assert.deepEqual(await words('max '), []);
});

service.test(
  'there are isolines where values change, and none where they are the same',
  async (page) => {
    const elastic = { young_modulus: 210e3, poisson_ratio: 0.3 };
    const body = { shape: { type: 'cylinder', radius: 20 }, material: elastic };
    const history = [{ force: 300 }, { force: 0 }];
    await shown(page, {
      ...FIELDS,
      upper: body,
      lower: body,
      load: { history },
      solver: { theory: 'flow' },
    });
    await drawn(page);
    await page.getByLabel('Shown', { exact: true }).selectOption('sigma_x');
    await labelled(page, /^Field of σx/);
    const stage = page.locator('#panel-field .stage');
    const both = async () => {
      const pictures = [];
      for (const on of [false, true]) {
        await page.getByLabel('Isolines').setChecked(on);
        await page.mouse.move(1, 1);
        await page.evaluate(
          () =>
            new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))),
        );
        pictures.push((await stage.screenshot()).toString('base64'));
      }
      return pictures;
    };
    const [plain, lined] = await both();
    assert.equal(lined, plain, 'without load there is no stress that changes');
    await page.locator('.steps input').fill('0');
    await labelled(page, /^Field of σx, from −\d\d\d/);
    const [before, after] = await both();
    assert.notEqual(after, before);
  },
);

service.test(
  'limits of the colours are taken as they are written, or refused in words',
  async (page) => {
    await shown(page, { ...FIELDS, load: { force: 612 } });
    await mises(page);
    const [least, largest] = [
      page.getByLabel('Least value coloured'),
      page.getByLabel('Largest value coloured'),
    ];
    const choice = page.getByLabel('Colours', { exact: true });
    const legend = page.locator('#panel-field .colours');
    const before = await legend.textContent();
    for (const [text, words] of /** @type {[string, RegExp][]} */ ([
      ['abc', /“abc” is not a number/],
      ['1e400', /too large/],
      ['1,200', /can be read as/],
      ['0', /the least value is the largest one too/],
      ['3 parsec', /no unit known/],
    ])) {
      await largest.fill(text);
      await largest.press('Enter');
      await page.locator('.tools .fault').getByText(words).waitFor();
      assert.equal(await choice.inputValue(), 'step', text);
      assert.equal(await legend.textContent(), before, text);
      assert.equal(await largest.getAttribute('aria-invalid'), 'true');
    }
    await largest.fill('456.789');
    await largest.press('Enter');
    await least.fill('0.1234567 GPa');
    await least.press('Enter');
    assert.equal(await choice.inputValue(), 'fixed');
    assert.equal(await page.locator('.tools .fault').textContent(), '');
    assert.match((await legend.textContent()) ?? '', /^456\.789.*123\.457MPa$/);
    assert.deepEqual(
      [await least.inputValue(), await largest.inputValue()],
      ['123.457', '456.789'],
    );
    await least.fill('');
    await least.press('Enter');
    assert.equal(await choice.inputValue(), 'step');
    assert.equal(await legend.textContent(), before);
  },
);

service.test(
  'limits that are held are the same stresses of a job in other units, and its figures are read back',
  async (page) => {
    const si = await solved(page, { ...SI, ...FIELDS, load: { force: 612e3 } });
    await shown(page, { ...FIELDS, load: { force: 612 } });
    await mises(page);
    const [least, largest] = [
      page.getByLabel('Least value coloured'),
      page.getByLabel('Largest value coloured'),
    ];
    for (const [box, value] of /** @type {const} */ ([
      [least, '100'],
      [largest, '400'],
    ])) {
      await box.fill(value);
      await box.press('Enter');
    }
    await follow(page, `job=${si}`);
    await labelled(page, / Pa\.$/);
    assert.deepEqual([await least.inputValue(), await largest.inputValue()], ['10⁸', '4·10⁸']);
    await largest.fill('4.5·10⁸');
    await largest.press('Enter');
    assert.equal(await largest.inputValue(), '4.5·10⁸');
    assert.match(
      (await page.locator('#panel-field .colours').textContent()) ?? '',
      /^4\.5·10⁸.*10⁸Pa$/,
    );
    // The cut, near whose surface every figure has a power of ten.
    await page.getByLabel('Cut', { exact: true }).check();
    await typeCut(page, ['0', '0', '0', '-0.00005']);
    await page.getByRole('img', { name: /^von Mises stress along the cut/ }).waitFor();
    await page.evaluate(
      () => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))),
    );
    const short = await cutWords(page);
    assert.equal(await page.getByLabel('Cut to y').inputValue(), '-0.00005');
    // Through the place of the largest stress, beside a figure that the page has written.
    await page.getByLabel('Cut from y').fill('-0.0006');
    await page.keyboard.press('Enter');
    await page.waitForFunction(
      (before) => document.querySelector('.cut .plot')?.getAttribute('aria-label') !== before,
      short,
    );
    assert.equal(await page.getByLabel('Cut to y').inputValue(), '-5·10⁻⁵');
  },
);

service.test(
  'a cut is of the bodies, however much their displacements are exaggerated, and says when there is none',
  async (page) => {
    await shown(page, { ...FIELDS, load: { force: 612 } });
    await mises(page);
    await page.getByLabel('Cut', { exact: true }).check();
    await typeCut(page, ['0', '-0.6', '0', '0.6']);
    const curves = () =>
      page.evaluate(
        () =>
          document.querySelector('.cut .plot svg') &&
          document.querySelector('.cut .plot')?.getAttribute('aria-label'),
      );
    await page
      .getByRole('img', { name: /^von Mises stress along the cut, at most 5\d\d/ })
      .waitFor();
    const before = await curves();
    const picture = page.locator('.cut .plot svg');
    const drawing = () => picture.evaluate((one) => one.outerHTML.replace(/clip-\d+/g, ''));
    const drawnBefore = await drawing();
    await page.getByLabel('Displacement').selectOption('20');
    await page.evaluate(
      () => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))),
    );
    assert.equal(await curves(), before);
    assert.equal(await drawing(), drawnBefore);
    await typeCut(page, ['50', '1', '60', '1']);
    await page.locator('.cut').getByText('The cut misses the bodies.').waitFor();
    assert.equal(await page.locator('.cut .chart').isVisible(), false);
    await typeCut(page, ['1', '-1', '1', '-1']);
    await page.locator('.cut').getByText('The cut has no length').waitFor();
    await page.getByLabel('Cut to x').fill('one');
    await page.keyboard.press('Enter');
    await page.locator('.cut').getByText('“one” is not a number').waitFor();
  },
);

service.test('the curve of a cut is broken where the line leaves the body', async (page) => {
  const broken = await page.evaluate(async () => {
    const { cut, curveOf } = await import(/** @type {any} */ ('/web/field/cut.js'));
    // Two squares of side 1 with a gap of 1 between them, each of two elements.
    const nodes = [0, 0.5, 1, 2, 2.5, 3].flatMap((x) => [x, 0, x, 1]);
    const element = (/** @type {number} */ k) => [2 * k, 2 * k + 2, 2 * k + 3, 2 * k + 1];
    const mesh = {
      nodes: Float32Array.from(nodes),
      displacement: new Float32Array(nodes.length).fill(7),
      elements: Uint32Array.from([0, 1, 3, 4].flatMap(element)),
    };
    const values = Float32Array.from(nodes.filter((_, k) => k % 2 === 0));
    return curveOf(cut({ mesh, lift: 0 }, values, 20, 1, 1, [0.25, 0.4], [2.75, 0.4]));
  });
  const gap = broken.y.indexOf(null);
  assert.ok(gap > 0, JSON.stringify(broken));
  assert.equal(broken.y.lastIndexOf(null), gap);
  assert.ok(
    Math.abs(broken.x[gap - 1] - 0.75) < 1e-6 && Math.abs(broken.x[gap + 1] - 1.75) < 1e-6,
    broken.x.join(),
  );
  assert.deepEqual([broken.x[0], broken.x.at(-1)], [0, 2.5]);
  broken.x.forEach((/** @type {number} */ at, /** @type {number} */ k) => {
    if (k !== gap) assert.ok(Math.abs(broken.y[k] - at - 0.25) < 1e-5, `${broken.y[k]} at ${at}`);
  });
});

service.test(
  'a field whose graphics the browser takes back says so, and is drawn again',
  async (page) => {
    await shown(page, { ...FIELDS, load: { force: 612 } });
    await drawn(page);
    await page.evaluate(() => {
      const surface = /** @type {HTMLCanvasElement} */ (document.querySelector('.stage .surface'));
      /** @type {any} */ (globalThis).taken = surface
        .getContext('webgl2')
        ?.getExtension('WEBGL_lose_context');
      /** @type {any} */ (globalThis).taken.loseContext();
    });
    const words = page.getByText('The browser has stopped the graphics');
    await words.waitFor();
    await taken(page, 'Save field as PNG');
    await page.getByText('There is no picture of it yet').waitFor();
    await page.evaluate(() => /** @type {any} */ (globalThis).taken.restoreContext());
    await words.waitFor({ state: 'hidden' });
    await page.locator('#panel-field .stage:not(.stale)').waitFor();
  },
);

service.test(
  'one cannot go so close or so far that there is nothing left to see',
  async (page) => {
    await shown(page, { ...FIELDS, load: { force: 612 } });
    await drawn(page);
    const scale = await page.evaluate(async () => {
      const { Camera } = await import(/** @type {any} */ ('/web/field/camera.js'));
      const camera = Object.assign(new Camera(), { width: 400, height: 300 });
      camera.home(0.5);
      const whole = camera.scale;
      return [1.25, 0.8].map((factor) => {
        for (let k = 0; k < 500; k++) camera.zoom(factor);
        return camera.scale / whole;
      });
    });
    assert.ok(
      scale[0] <= 1e4 && scale[0] > 100 && scale[1] >= 1e-4 && scale[1] < 0.1,
      scale.join(),
    );
  },
);

service.test('without load a cut begins as long as the largest contact was', async (page) => {
  await shown(page, {
    ...FIELDS,
    load: { history: [{ force: 600 }, { force: 0 }] },
    solver: { theory: 'flow' },
  });
  await drawn(page);
  await page.getByLabel('Cut', { exact: true }).check();
  await page.getByRole('img', { name: /^σx along the cut, at most \d+/ }).waitFor();
});
