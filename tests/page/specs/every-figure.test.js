/** Every figure that is shown comes from the service: cards, sentence and table of twelve examples. */

import assert from 'node:assert/strict';
import { suite } from '../browser.js';

const service = suite();

/** Of the twelve, those whose usual mesh takes a debug build long are made coarser. */
const MANY = 12;

/** Signs that a figure is written with, and what it stands for. @param {string} text @returns {{value: number, last: number}[]} `last`: half of its last place, zeros before the point being none */
function figuresIn(text) {
  const found = text
    .replaceAll('\u202f', '')
    .matchAll(/([−-]?)(\d+(?:\.(\d+))?)(?:·10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+))?/g);
  return [...found].map(([, sign, digits, places = '', power = '']) => {
    const exponent = Number(
      [...power].map((one) => (one === '⁻' ? '-' : '⁰¹²³⁴⁵⁶⁷⁸⁹'.indexOf(one))).join('') || 0,
    );
    const scale = 10 ** exponent;
    const zeros = /^[1-9]\d*?(0*)$/.exec(digits)?.[1].length ?? 0;
    return {
      value: (sign ? -1 : 1) * Number(digits) * scale,
      last: 0.5000001 * 10 ** (places ? -places.length : zeros) * scale,
    };
  });
}

/** Whether one of the numbers is what stands there. @param {{value: number, last: number}} figure @param {number[]} numbers */
const among = ({ value, last }, numbers) =>
  numbers.some((one) => Math.abs(Math.abs(one) - Math.abs(value)) <= last);

for (let example = 0; example < MANY; example += 1)
  service.test(
    `every figure of example ${example + 1} is in the answer of the service`,
    async (page, { note }) => {
      const options = page.locator('#example option');
      assert.ok((await options.count()) > MANY);
      const label = (await options.nth(example + 1).textContent()) ?? '';
      await page.locator('#example').selectOption({ label });
      await page.locator('#cost').getByText('equations').waitFor();
      const elements = page.getByLabel('Elements per half-width');
      const three = (await page.getByLabel('Analysis').inputValue()) === 'three_dimensional';
      await elements.fill(three ? '6' : '10');
      await page.getByLabel('Stress field on the mesh').uncheck();
      await page.getByRole('button', { name: 'Solve', exact: true }).click();
      await page.locator('[data-status=succeeded]').waitFor();
      await page.locator('#headline .figures').first().waitFor();
      const id = /job=([\w-]+)/.exec(page.url())?.[1];
      const report = await page.evaluate(
        async (id) => (await fetch(`v1/jobs/${id}/result?fields=summary`)).json(),
        id,
      );
      // A force that was looked for is read under it, before the load is taken off.
      const isSought = report.answers.some(
        (/** @type {any} */ { name }) => name === 'force_found',
      );
      const step = report.steps.at(isSought ? 0 : -1);
      const all = [...report.answers, ...step.answers];
      const answers = [false, true].flatMap((is) => all.filter(({ detail }) => detail === is));
      const of = await page.locator('.steps output').textContent();
      assert.match(of ?? '', new RegExp(`^${report.steps.indexOf(step) + 1} of `));
      assert.equal(
        await page.locator('#headline .verdict-text span:last-child').textContent(),
        step.verdict.text,
      );
      await page.locator('#headline .rest summary').click();
      const cards = await page.locator('#headline [data-row]').evaluateAll((all) =>
        all.map((one) => {
          const [value, unit, ...words] = [...one.querySelectorAll('td')].map(
            (cell) => cell.textContent,
          );
          const name = /** @type {HTMLElement} */ (one).dataset.row;
          return { name, figure: `${value} ${unit}`, words: words.join(' ; ') };
        }),
      );
      assert.deepEqual(
        cards.map(({ name }) => name),
        answers.map(({ name }) => name),
      );
      let count = 0;
      cards.forEach(({ figure, words }, k) => {
        const {
          value,
          error,
          elastic,
          place,
          text,
          quantity,
          at_least: least,
          at_most: most,
        } = answers[k];
        const share = ['strain', 'ratio'].includes(quantity) ? 100 : 1;
        const shown = figuresIn(figure.replace(/(mm|N|MPa|%|mrad).*$/, ''));
        if (value === null) assert.ok(figure.startsWith('—'), figure);
        else
          assert.ok(
            shown.length === 1 && among(shown[0], [value * share, most * share]),
            `${figure} is not ${value}`,
          );
        const numbers = [
          100 * error * (share > 1 ? Math.abs(value) : 1),
          elastic * share,
          least * share,
          value / elastic,
          place?.x,
          place?.y,
          place?.depth,
          ...figuresIn(text).map(({ value }) => value),
        ].filter(Number.isFinite);
        for (const one of figuresIn(words)) {
          assert.ok(
            among(one, numbers),
            `${one.value} of “${words}” is not in ${JSON.stringify(answers[k])}`,
          );
          count += 1;
        }
        count += 1;
      });
      const rows = await page
        .locator('#panel-figures tbody tr')
        .evaluateAll((all) =>
          all.map((row) => [...row.children].map((cell) => cell.textContent ?? '')),
        );
      assert.equal(rows.length, report.steps.length);
      rows.forEach((cells, k) => {
        const of = report.steps[k];
        const numbers = [k + 1];
        // Of a share the error is one.
        for (const { error, value } of of.answers)
          if (typeof error === 'number') numbers.push(100 * error * Math.abs(value));
        const walk = (/** @type {any} */ part) => {
          if (typeof part === 'number') numbers.push(part, 100 * part);
          else if (
            part &&
            typeof part === 'object' &&
            !(Array.isArray(part) && part.length > 8 && typeof part[0] === 'number')
          )
            Object.values(part).forEach(walk);
        };
        walk(of);
        for (const cell of cells)
          for (const one of figuresIn(cell)) {
            assert.ok(among(one, numbers), `${cell} of step ${k + 1}`);
            count += 1;
          }
      });
      note(`${label}: ${count} figures`);
      assert.ok(count > 15);
    },
  );
