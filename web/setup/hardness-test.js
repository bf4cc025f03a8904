/** Hardness tests of a material, several scales in one run. Loaded when it is asked for. */

import { Problem } from '../api/client.js';
import { solveAll } from '../jobs/batch.js';
import { jobFragment } from '../jobs/link.js';
import { dialogue } from '../lib/dialogue.js';
import { h, plainButton } from '../lib/dom.js';
import { convert } from '../lib/units.js';
import { toldOf, wholeOf } from '../result/answers.js';
import { rowOf } from '../result/rows.js';
import { inWords } from './words.js';

const SCALES = ['HBW 10/3000', 'HBW 2.5/187.5', 'HV 30', 'HV 10', 'HRC', 'HRB'];
const USUAL = ['HBW 10/3000', 'HV 10', 'HRC'];

/** @param {Record<string, any>} material of the specimen @param {import('../lib/units.js').Units} units */
export function askTests(material, units) {
  const boxes = SCALES.map((scale) =>
    h('input', { type: 'checkbox', value: scale, checked: USUAL.includes(scale) }),
  );
  const rows = h('tbody');
  const table = h('table', { hidden: true }, h('thead', {}, HEADS), rows);
  let running = new AbortController();
  const [width, depth] = [80, 40].map((size) => convert(size, 'length', 'mm_N_MPa', units));
  const jobOf = (/** @type {string} */ scale) => ({
    units,
    lower: { shape: { type: 'block', width, depth }, material },
    load: { hardness: scale },
    output: { fields: true },
  });
  const box = dialogue(
    'Hardness test of this material',
    [
      h('p', { class: 'bar' }, boxes.map((one) => h('label', {}, one, ` ${one.value}`))), // prettier-ignore
      h('p', { class: 'quiet' }, 'A thick specimen. Each test is a job, of some seconds each where nobody else waits; closing this cancels those that have not ended.'), // prettier-ignore
      table,
    ],
    'Measure',
    () => {
      const scales = boxes.filter(({ checked }) => checked).map(({ value }) => value);
      if (!scales.length) return 'Choose a scale.';
      running.abort();
      const { signal } = (running = new AbortController());
      table.hidden = false;
      const show = (/** @type {import('../jobs/batch.js').Trial[]} */ trials) => {
        if (!signal.aborted)
          rows.replaceChildren(...trials.map((one, k) => row(scales[k], one, () => box.close())));
      };
      rows.replaceChildren(...scales.map((scale) => h('tr', {}, h('th', {}, scale), h('td', { colspan: 3 }, 'sent…')))); // prettier-ignore
      solveAll(scales.map(jobOf), signal, show).catch((error) => {
        if (signal.aborted) return;
        if (!(error instanceof Problem)) throw error;
        rows.replaceChildren(h('tr', {}, h('td', { colspan: 4 }, error.errors[0]?.detail ?? error.message))); // prettier-ignore
      });
      return true;
    },
    () => running.abort(),
  );
}

const HEADS = ['test', 'number', 'diameter or diagonal', ''].map((text) =>
  h('th', { scope: 'col' }, text),
);

/** @param {string} scale @param {import('../jobs/batch.js').Trial} trial @param {() => void} close */
function row(scale, { id, report, problem, done }, close) {
  const found = report && rowOf(report, 'diameter');
  const show = plainButton('Show', () => {
    close();
    location.hash = jobFragment(id);
  });
  const number = report && rowOf(report, 'hardness');
  const cells = found
    ? [
        [
          number ? wholeOf(number) : 'none: it has not yielded',
          ...(report.validity ?? []).map(({ message }) =>
            h('p', { class: 'quiet' }, inWords(message)),
          ),
        ],
        toldOf(found),
      ]
    : [done ? inWords(problem ?? 'no result') : 'runs…', ''];
  return h(
    'tr',
    {},
    h('th', { scope: 'row' }, scale),
    cells.map((text) => h('td', {}, text)),
    h('td', {}, found ? show : ''),
  );
}
