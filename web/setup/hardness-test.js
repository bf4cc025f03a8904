/**
 * A hardness test of the material of a body: asked for in a dialogue, solved at once by the service,
 * answered in the dialogue. Loaded when it is asked for.
 */

import { solveNow } from '../api/result.js';
import { h } from '../lib/dom.js';
import { figure, unit } from '../lib/units.js';
import { Chart } from '../result/chart.js';

/** @typedef {import('../wire.js').HardnessResult} Found */

/** Tests by name, each with the thickness of a specimen [mm]; its width is twice that. */
const TESTS = /** @type {Record<string, number>} */ ({
  'HBW 10/3000': 40,
  'HBW 10/500': 40,
  'HBW 5/750': 20,
  'HBW 2.5/187.5': 10,
  'HV 30': 11,
  'HV 10': 6.5,
  'HV 1': 2,
  HRC: 8,
  HRB: 8,
});

/** @param {Record<string, any>} material of the specimen, in mm, N, MPa */
export function askTest(material) {
  const scale = h(
    'select',
    {},
    Object.keys(TESTS).map((name) => h('option', { value: name }, name)),
  );
  const measure = h('button', { type: 'submit', class: 'primary' }, 'Measure');
  const answer = h('div', { role: 'status' });
  const hangUp = new AbortController();
  const box = h(
    'dialog',
    { 'aria-labelledby': 'test-title' },
    h(
      'form',
      {
        onsubmit: async (/** @type {SubmitEvent} */ event) => {
          event.preventDefault();
          measure.disabled = true;
          answer.replaceChildren(`${scale.value} is solved…`);
          try {
            const report = await solveNow(jobOf(scale.value, material), hangUp.signal);
            answer.replaceChildren(...answered(report));
          } catch (error) {
            const { errors = [], message } = /** @type {any} */ (error);
            answer.replaceChildren(errors[0]?.detail ?? message);
          }
          measure.disabled = false;
        },
      },
      h('h2', { id: 'test-title' }, 'Hardness test'),
      h('p', {}, `Of ${material.name ?? 'this material'}, with a thick specimen.`),
      h('p', { class: 'bar' }, h('label', {}, 'Scale ', scale), measure),
      answer,
      h(
        'div',
        { class: 'bar' },
        h('button', { type: 'button', onclick: () => box.close() }, 'Close'),
      ),
    ),
  );
  box.addEventListener('close', () => {
    hangUp.abort();
    box.remove();
  });
  document.body.append(box);
  box.showModal();
}

/** @param {string} name @param {Record<string, any>} material @returns {import('../types.js').Job} */
function jobOf(name, material) {
  const depth = TESTS[name];
  return /** @type {any} */ ({
    lower: { shape: { type: 'block', width: 2 * depth, depth }, material },
    load: { hardness: name },
    output: { subsurface: false },
  });
}

/** @param {import('../types.js').Report} report @returns {(Node | string)[]} */
function answered(report) {
  const { hardness: found, load_approach: curve } = report;
  if (!found || found.number === null)
    return [
      found?.remarks.find(({ code }) => code === 'no_dent')?.message ??
        'The loads did not converge, so that there is no number: with small strains the body may not bear this force.',
    ];
  const percent = (/** @type {number | null} */ part) => figure(part && 100 * part, 2);
  const of = (/** @type {number | null} */ value, /** @type {'length' | 'stress'} */ kind) =>
    `${figure(value, 4)} ${unit(kind, report.units)}`;
  const rows = [
    ['Depth under load', of(found.depth, 'length')],
    ['Depth that is left', of(found.permanent_depth, 'length')],
    [found.pile_up < 0 ? 'Sink-in' : 'Pile-up', of(Math.abs(found.pile_up), 'length')],
    ['Mean pressure', of(found.mean_pressure, 'stress')],
    ['Mean pressure over flow stress (Tabor)', figure(found.constraint, 3)],
    [
      'Bias against large strains',
      found.bias === null ? 'not known' : `${found.bias < 0 ? '' : '+'}${percent(found.bias)} %`,
    ],
  ];
  const points = found.number_error === null ? '' : ` ± ${figure(found.number_error, 2)}`;
  const bar = found.relative_error === null ? points : ` ± ${percent(found.relative_error)} %`;
  const chart = new Chart(220);
  chart.show({
    x: `displacement  [${unit('length', report.units)}]`,
    y: `force  [${unit('force', report.units)}]`,
    turns: true,
    curves: curve
      ? [{ label: found.test, colour: '--curve-1', x: curve.approach, y: curve.force }]
      : [],
    words: `Force over displacement of ${found.test}, up to ${of(found.depth, 'length')}.`,
  });
  return [
    h('p', {}, h('strong', {}, `${found.test}: ${figure(found.number, 4)}`), bar),
    h(
      'table',
      {},
      h(
        'tbody',
        {},
        rows.map(([name, value]) =>
          h('tr', {}, h('th', { scope: 'row' }, name), h('td', {}, value)),
        ),
      ),
    ),
    chart.element,
    ...(found.bias_source ? [h('p', { class: 'quiet' }, found.bias_source)] : []),
    ...found.remarks.map(({ message }) => h('p', { class: 'quiet' }, message)),
  ];
}
