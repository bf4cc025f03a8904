/**
 * Tasks and eight questions from cold, as a new user does them: `node --test specs/tasks.test.js` says actions,
 * seconds and stumbles of each, which `docs/notes/page_tasks.md` has. An action is a press, a
 * choice, a text that is typed or pasted. A stumble is an answer that is not among the first
 * tiles, or not seen without scrolling, and a message that refuses something.
 */

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { suite } from '../browser.js';
import { draft } from '../jobs.js';

/** @typedef {import('playwright-core').Page} Page */
/** @typedef {import('playwright-core').Locator} Locator */

const service = suite();

/** Tiles among which the answer is looked for. */
const FIRST = 4;

/** One who sits before the page. */
class User {
  actions = 0;
  /** @type {string[]} */
  stumbles = [];
  begun = performance.now();

  /** @param {Page} page */
  constructor(page) {
    this.page = page;
  }

  /** What is refused, or has to be told by a passing message, is a stumble. */
  async #look() {
    this.actions += 1;
    for (const one of await this.page.locator('.error:visible, .said:visible').allInnerTexts())
      if (one.trim()) this.stumbles.push(one);
  }

  /** @param {string} name @param {import('playwright-core').Locator | Page} [within] */
  async press(name, within = this.page) {
    await within.getByRole('button', { name, exact: true }).click();
    await this.#look();
  }

  /** @param {string} name of a menu that is opened */
  async menu(name) {
    await this.page.getByText(name, { exact: true }).click();
    await this.#look();
  }

  /** @param {Locator} box */
  async tick(box) {
    await box.check();
    await this.#look();
  }

  /** @param {string} place pointer of the field @param {string} choice as it is read */
  async choose(place, choice) {
    await this.page.locator(`[data-place="${place}"] select`).selectOption({ label: choice });
    await this.#look();
  }

  /** @param {string} choice of the upper body */
  async material(choice) {
    await this.page.locator('[data-preset=upper]').selectOption({ label: choice });
    await this.#look();
  }

  /** @param {string} name of a picture of the first view */
  async door(name) {
    await this.page.locator(`[data-door=${name}]`).click();
    await this.#look();
  }

  /** @param {string} choice */
  async example(choice) {
    await this.page.locator('#example').selectOption({ label: choice });
    await this.#look();
  }

  /** @param {string} label of a choice beside the result @param {string | RegExp} choice as it is read */
  async pick(label, choice) {
    const select = this.page.getByLabel(label, { exact: true });
    const texts = await select.locator('option').allInnerTexts();
    const found = texts.find((text) =>
      typeof choice === 'string' ? text === choice : choice.test(text),
    );
    assert.ok(found, `${choice} is not among ${texts.join(', ')}`);
    await select.selectOption({ label: found });
    await this.#look();
  }

  /** @param {string} label @param {string} text */
  async enter(label, text) {
    await this.page.getByLabel(label, { exact: true }).fill(text);
    await this.#look();
  }

  /** @param {string} place @param {string} text typed in place of what is there */
  async type(place, text) {
    await this.page.locator(`[data-place="${place}"] input[type=text]`).click({ clickCount: 3 });
    await this.page.keyboard.type(text);
    await this.#look();
  }

  /** @param {string} place @param {string} text pasted in place of what is there */
  async paste(place, text) {
    const area = this.page.locator(`[data-place="${place}"] textarea`);
    await area.click();
    await this.page.keyboard.press('Control+A');
    await area.evaluate((area, text) => {
      const clipboardData = new DataTransfer();
      clipboardData.setData('text', text);
      area.dispatchEvent(
        new ClipboardEvent('paste', { clipboardData, bubbles: true, cancelable: true }),
      );
    }, text);
    await this.#look();
  }

  /** Answers a question about what was pasted. @param {string} label @param {string} answer */
  async answers(label, answer) {
    const field = this.page.getByLabel(label);
    const isChoice = await field.evaluate((one) => one.tagName === 'SELECT');
    await (isChoice ? field.selectOption(answer) : field.fill(answer));
    await this.#look();
  }

  async solve() {
    await this.press('Solve');
    await this.page.locator('[data-status=succeeded]').waitFor();
    await this.page.locator('#panel-figures tbody tr').first().waitFor();
  }

  /** Reads the tile of this name. @param {string} name @returns {Promise<string>} */
  async reads(name) {
    const tiles = this.page.locator('#headline dl > div');
    const names = await tiles.locator('dt').allInnerTexts();
    const at = names.findIndex((one) => one.startsWith(name));
    assert.ok(at >= 0, `“${name}” is not among ${names.join(', ')}`);
    if (at >= FIRST) this.stumbles.push(`“${name}” is tile ${at + 1}`);
    const box = await tiles.nth(at).boundingBox();
    const { height } = this.page.viewportSize() ?? { height: 0 };
    if (!box || box.y < 0 || box.y + box.height > height)
      this.stumbles.push(`“${name}” is not seen without scrolling`);
    return tiles.nth(at).innerText();
  }
}

/** @type {[name: string, actions: number, work: (user: User, page: Page) => Promise<void>][]} */
const TASKS = [
  [
    'reference problem',
    1,
    async (user) => {
      await user.solve();
      assert.match(await user.reads('Peak pressure'), /11[45]\d/);
    },
  ],
  [
    'ball on flat, dent and residual stress',
    6,
    async (user, page) => {
      await user.choose('/analysis', 'Axisymmetric');
      await user.type('/upper/shape/radius', '5');
      await user.choose('/lower/shape/type', 'Block');
      await user.choose('/load/kind', 'History of loads');
      await user.type('/load/history', '2000 0');
      await user.solve();
      assert.match(await user.reads('Dent, lower'), /mm/);
      assert.match(await user.reads('Pile-up, lower'), /mm/);
      assert.match(await page.locator('#headline').innerText(), /Residual tension/);
      await page.locator('#panel-depth .legend').getByText('σθ', { exact: true }).waitFor();
    },
  ],
  [
    'case-hardened roller',
    2,
    async (user, page) => {
      await user.door('depth');
      await user.solve();
      assert.match(await user.reads('Utilization'), /%/);
      await page
        .locator('#panel-depth .legend')
        .getByText('utilization', { exact: true })
        .waitFor();
    },
  ],
  [
    'pasted profile',
    4,
    async (user, page) => {
      await user.choose('/upper/shape/type', 'Profile');
      // From right to left, off its middle, heights in micrometres.
      const trace = Array.from({ length: 81 }, (_, k) => [
        9 - k / 5,
        -1e3 * ((8 - k / 5 - 0.5) ** 2 / 60),
      ]);
      const rows = trace.map(([x, z]) => `${x.toFixed(2)}\t${z.toFixed(3)}`.replaceAll('.', ','));
      await user.paste('/upper/shape/points', `x [mm]\tz [µm]\n${rows.join('\n')}\n`);
      await user.press('Top to 0', page.locator('[data-place="/upper/shape/points"]'));
      await user.solve();
      const { points } = (await draft(page)).upper.shape;
      assert.equal(points.length, 81);
      assert.ok(points.some((/** @type {number[]} */ [x, z]) => x === 0 && z === 0));
      assert.match(await user.reads('Peak pressure'), /MPa/);
    },
  ],
  [
    'sweep of 20 and its table',
    5,
    async (user, page) => {
      await user.choose('/load/kind', 'Sweep of forces');
      await user.type('/load/forces', '50…1000/20');
      await user.solve();
      const download = page.waitForEvent('download');
      await user.menu('Download');
      await user.press('CSV: figures');
      const text = await readFile(await (await download).path(), 'utf8');
      assert.equal(text.trim().split('\n').length, 21);
    },
  ],
  [
    'force for a dent of 1e-4 D',
    4,
    async (user, page) => {
      await user.example('Static rating of a ball (ISO 76)');
      await user.choose('/load/target_kind', 'Depth of the dent');
      await user.type('/load/target/dent_depth', '0.001');
      await user.solve();
      assert.match(await user.reads('Force found'), /N/);
      assert.equal((await draft(page)).solver.theory, 'flow');
    },
  ],
  [
    'pin in hole',
    4,
    async (user) => {
      await user.type('/upper/shape/radius', '9.98');
      await user.choose('/lower/shape/type', 'Hole');
      await user.type('/lower/shape/radius', '10');
      await user.solve();
      assert.match(await user.reads('Peak pressure'), /MPa/);
    },
  ],
  [
    'two materials compared and reported',
    6,
    async (user, page) => {
      for (const material of ['Steel S355', 'Steel 42CrMo4 +QT']) {
        await user.material(material);
        await user.solve();
      }
      await user.press('Compare with the job before');
      await page.locator('#panel-differences tbody tr').first().waitFor();
      await user.press('Report');
      const sheet = page.getByRole('main', { name: 'Report' });
      await sheet.getByRole('region', { name: 'Differences' }).waitFor();
      for (const material of ['Steel S355', 'Steel 42CrMo4 +QT'])
        await sheet.getByText(material).first().waitFor();
    },
  ],
  [
    'ball in raceway',
    3,
    async (user, page) => {
      await user.door('raceway');
      await user.type('/load/force', '800');
      await user.solve();
      assert.match(await user.reads('Peak pressure'), /MPa/);
      await page.locator('#panel-map canvas[aria-label^="Map of the pressure"]').waitFor();
    },
  ],
  [
    'tilted roller',
    4,
    async (user, page) => {
      await user.example('Tilted roller with a logarithmic profile, in three dimensions');
      await user.type('/upper/shape/tilt', '2');
      await user.type('/load/force', '5000');
      await user.solve();
      assert.match(await user.reads('Edge pressure'), /MPa/);
      await page.locator('#panel-field canvas').first().waitFor();
    },
  ],
  [
    'dent map',
    2,
    async (user, page) => {
      await user.example('Dent of an ellipsoid, in three dimensions');
      await user.solve();
      assert.match(await user.reads('Dent, lower'), /mm/);
      await page.locator('#panel-map canvas[aria-label^="Map of the dent"]').waitFor();
    },
  ],
  [
    'rough patch',
    6,
    async (user) => {
      await user.door('surface');
      const wave = (/** @type {number} */ i, /** @type {number} */ j) =>
        1e-4 * (Math.cos(0.7 * i + 0.2 * j) + Math.cos(0.9 * j - 0.3 * i)) -
        2e-6 * ((i - 24) ** 2 + (j - 24) ** 2);
      const rows = Array.from({ length: 48 }, (_, i) =>
        Array.from({ length: 48 }, (_, j) => wave(i, j).toFixed(7)),
      );
      await user.paste('/upper/surface/heights', rows.map((row) => row.join('\t')).join('\n'));
      await user.answers('Unit of the heights', 'mm');
      await user.answers('Distance along x', '3 µm');
      await user.press('Take them');
      await user.solve();
      assert.match(await user.reads('Real contact area'), /%/);
    },
  ],
  [
    'a rail under a driven wheel',
    2,
    async (user, page) => {
      await user.door('rolling');
      await user.solve();
      await page.locator('#panel-passes svg').first().waitFor();
    },
  ],
  [
    'rolled roller, by both rules of hardening',
    3,
    async (user, page) => {
      await user.choose('/load/kind', 'Rolling');
      await user.type('/load/rolling/passes', '12');
      await user.solve();
      await page.locator('[data-status=succeeded]').waitFor();
      await page.locator('#headline').getByText('with kinematic hardening').first().waitFor();
      await page.locator('#panel-passes svg').first().waitFor();
    },
  ],
  [
    'Brinell number of a steel',
    2,
    async (user) => {
      await user.door('hardness');
      await user.solve();
      assert.match(await user.reads('HBW 10/3000'), /^HBW 10\/3000\s*2\d\d/);
    },
  ],
];

/** Questions of an engineer, each from cold in six actions at most. @type {typeof TASKS} */
const QUESTIONS = [
  [
    'what load? the force for a margin of 2',
    5,
    async (user, page) => {
      await user.solve();
      await user.pick('Answer', 'Margin to first yield');
      await user.enter('Wanted value', '2');
      await user.enter('From', '100');
      await user.press('Find the number');
      const words = page.locator('#panel-vary .readout');
      await words
        .getByText(/^With force = 109\.\d* N\/mm, Margin to first yield is 2\./)
        .waitFor();
      // One job, and so one row of the list.
      await page.locator('#panel-vary').getByText('Put it into the form').waitFor();
    },
  ],
  [
    'what if everything is 5 % off?',
    2,
    async (user, page) => {
      await user.solve();
      await user.press('± tolerances');
      await page
        .locator('#panel-vary .readout')
        .getByText(/matters most/)
        .waitFor();
      await page.locator('#panel-vary tbody tr').nth(3).waitFor();
    },
  ],
  [
    'is it safe?',
    1,
    async (user, page) => {
      await user.solve();
      await page
        .locator('#headline .verdict-text.attention')
        .getByText(/^Yields/)
        .waitFor();
    },
  ],
  [
    'which crown?',
    6,
    async (user, page) => {
      await user.example('Tilted roller with a logarithmic profile, in three dimensions');
      await user.choose('/upper/shape/profile', 'Crowned by an arc');
      await user.solve();
      await user.pick('Number that is varied', /crown radius$/);
      await user.enter('How many', '4');
      await user.press('Sweep');
      await page.locator('#panel-vary tbody tr').nth(3).waitFor();
    },
  ],
  [
    'how deep a case?',
    6,
    async (user, page) => {
      await user.example('Case-hardened roller on a hardened block');
      await user.solve();
      await user.pick('Number that is varied', /case depth$/);
      await user.pick('Answer', /^Core utilization/);
      await user.enter('How many', '5');
      await user.press('Sweep');
      await page.locator('#panel-vary tbody tr').nth(4).waitFor();
      await page.locator('#panel-vary').getByText('limit', { exact: true }).waitFor();
    },
  ],
  [
    'what do 10 % more or less do?',
    2,
    async (user, page) => {
      await user.solve();
      await user.press('± 10 %');
      await page.locator('#headline .others li').nth(1).waitFor();
      assert.match(await user.reads('Peak pressure'), /−\d.*%[^]*\+\d.*%/);
      await page.locator('#panel-pressure .legend').getByText('between both').waitFor();
    },
  ],
  [
    'what was it last week?',
    3,
    async (user, page) => {
      await user.solve();
      await user.press('Jobs');
      await page.locator('#jobs-list .open').first().waitFor();
      await user.enter('Search jobs', 'cylinder');
      await page.locator('#jobs-list .open').first().waitFor();
    },
  ],
  [
    'send it',
    3,
    async (user, page) => {
      await user.solve();
      await user.press('Report');
      const [file] = await Promise.all([
        page.waitForEvent('download'),
        user.press('Save as one HTML file'),
      ]);
      const text = await readFile(await file.path(), 'utf8');
      assert.match(file.suggestedFilename(), /\.html$/);
      assert.doesNotMatch(text, /(?:src|href)="(?!data:|#)[^"]/, 'it asks for nothing');
      assert.match(text, /"peak_pressure":1\d\d\d/);
    },
  ],
];

for (const [name, actions, work] of [...TASKS, ...QUESTIONS]) {
  const task = async (
    /** @type {Page} */ page,
    /** @type {{note: (text: string) => void}} */ { note },
  ) => {
    const user = new User(page);
    await work(user, page);
    const seconds = (performance.now() - user.begun) / 1000;
    note(
      `| ${name} | ${user.actions} | ${seconds.toFixed(1)} s | ${user.stumbles.join('; ') || 'none'} |`,
    );
    assert.deepEqual(user.stumbles, []);
    assert.equal(user.actions, actions);
  };
  service.test(name, task, { few: true });
}
