/** Results in other units: every figure of a report is converted by what it is. No browser. */

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { readNumber, readShown } from '../../../web/lib/number.js';
import { figure, plain } from '../../../web/lib/units.js';
import { LEFT, QUANTITIES, inUnits } from '../../../web/result/converted.js';
import { inWords } from '../../../web/setup/words.js';

const { schemas } = JSON.parse(
  readFileSync(new URL('../../../api/openapi.json', import.meta.url), 'utf8'),
).components;

/** What the interface says of a unit, and what the page makes of it. @type {[RegExp, string | undefined][]} */
const SAID = [
  [/Unit: mm \(SI: m\)/, 'length'],
  [/Unit: MPa \(SI: Pa\)/, 'stress'],
  [/Unit: N\/mm \(SI: N\/m\) of thickness; N in axisymmetry/, 'load'],
  [/Unit: N\/mm² \(SI: N\/m²\); in axisymmetry and three dimensions N\/mm/, 'slope'],
  [/Unit: mm² \(SI: m²\)/, 'area'],
  [/Unit: mm³ \(SI: m³\)/, 'volume'],
  [/Unit: N \(SI: N\) of thickness, force times length/, 'energy'],
  [/Unit: degree|Unit: mrad|Unit: ms|Without unit/, undefined],
];

/**
 * Every number of a report with its key and what is said of it.
 * @param {any} node @param {string} key @param {string} said @param {string[]} seen
 * @returns {Generator<[string, string]>}
 */
function* numbers(node, key, said, seen = []) {
  if (node.$ref) {
    const name = node.$ref.split('/').pop();
    // A row says what it is, and what its course is; tests below convert them.
    if (name !== 'Answer' && name !== 'Course' && !seen.includes(name))
      yield* numbers(schemas[name], key, node.description ?? schemas[name].description ?? said, [
        ...seen,
        name,
      ]);
    return;
  }
  const text = node.description ?? said;
  if ([node.type].flat().some((type) => type === 'number')) yield [key, text];
  for (const [name, one] of Object.entries(node.properties ?? {}))
    if (!LEFT.has(name)) yield* numbers(one, name, '', seen);
  for (const part of [node.items, node.additionalProperties])
    if (part?.type || part?.$ref) yield* numbers(part, key, text, seen);
  for (const part of [node.oneOf, node.anyOf, node.allOf, node.prefixItems].flat())
    if (part) yield* numbers(part, key, text, seen);
}

test('every figure of a report has the kind of unit that the interface names', () => {
  let count = 0;
  for (const [key, text] of numbers(schemas.Report, '', '')) {
    const [, kind] = SAID.find(([said]) => said.test(text)) ?? [null, 'no unit that is known'];
    assert.equal(QUANTITIES[key], kind, `${key}: ${text}`);
    count += 1;
  }
  assert.ok(count > 60, `${count} figures`);
});

test('initial stresses and the figures of passes come in the units that are shown', () => {
  const set = { length: 'µm', per: 'mm', stress: 'GPa', force: 'kN' };
  const pile_up = { value: [0.5, 0.25], error: [0.1, null] };
  const part = {
    answers: [{ name: 'pile_up', quantity: 'length', unit: 'mm', value: 0.25, place: null }],
    subsurface: { lower: { initial_sigma_x: [-204], initial_sigma_z: [10] } },
    passes: { number: [1, 2], contact: {}, lower: { pile_up } },
    mesh: { passes: 2 },
  };
  const converted = inUnits(part, { analysis: 'plane_strain', units: 'mm_N_MPa' }, set);
  const rounded = JSON.parse(
    JSON.stringify(converted, (_, value) =>
      typeof value === 'number' ? Number(value.toPrecision(12)) : value,
    ),
  );
  assert.deepEqual(rounded, {
    answers: [{ ...part.answers[0], value: 250, unit: 'µm' }],
    subsurface: { lower: { initial_sigma_x: [-0.204], initial_sigma_z: [0.01] } },
    passes: { ...part.passes, lower: { pile_up: { ...pile_up, value: [500, 250] } } },
    mesh: { passes: 2 },
  });
});

test('an answer comes in the unit of its own quantity', () => {
  const set = { length: 'µm', per: 'mm', stress: 'GPa', force: 'kN' };
  const of = { analysis: 'plane_strain', units: /** @type {const} */ ('mm_N_MPa') };
  const place = { body: 'both', x: 0.5, depth: 0.25 };
  /** @param {string} quantity @param {string} unit @returns {any} */
  const answer = (quantity, unit) => ({
    quantity,
    unit,
    value: 2,
    elastic: null,
    place,
  });
  const { answers } = inUnits(
    {
      answers: [
        { ...answer('length', 'mm'), elastic: 1, at_least: 1, at_most: 3 },
        answer('stress', 'MPa'),
        answer('area', 'mm²'),
        answer('ratio', ''),
        answer('angle', 'mrad'),
        answer('number', ''),
      ],
    },
    of,
    set,
  );
  assert.deepEqual(
    answers.map(({ value, unit }) => [value, unit]),
    [
      [2000, 'µm'],
      [0.002, 'GPa'],
      [2e6, 'µm²'],
      [2, ''],
      [2, 'mrad'],
      [2, ''],
    ],
  );
  assert.deepEqual(
    [answers[0].elastic, answers[0].at_least, answers[0].at_most, answers[0].place],
    [1000, 1000, 3000, { ...place, x: 500, depth: 250 }],
  );
});

test('what the page writes, it can read', () => {
  for (const value of [4.5e8, -5e-5, 1e8, -1e-7, 5.5e8, 1.23456e12, -0.25, 612.6, 3e-20, 0])
    for (const write of [plain, (/** @type {number} */ one) => figure(one, 6)]) {
      const reading = readNumber(write(value));
      assert.ok(
        'value' in reading && Math.abs(reading.value - value) <= 1e-5 * Math.abs(value),
        write(value),
      );
    }
  for (const [text, value] of /** @type {[string, number][]} */ ([
    ['4.5·10⁸', 4.5e8],
    ['4.5×10^8', 4.5e8],
    ['10⁻⁵', 1e-5],
    ['−10⁸', -1e8],
    ['450 MPa', 4.5e8],
    ['0.45 GPa', 4.5e8],
  ])) {
    const reading = readShown(text, 'stress', 'SI', 1);
    assert.equal('value' in reading && reading.value, value, text);
  }
  assert.deepEqual(readShown('0.2', 'stress', 'mm_N_MPa', 1e-3), { value: 200 });
  for (const text of ['·10⁸', '4.5·10', '10^', '1.5·9⁸', '4·10⁸·10⁸'])
    assert.ok('problem' in readShown(text, 'stress', 'SI', 1), text);
});

test('remarks have the words of the form, and no keys', () => {
  for (const [message, words] of [
    ['above that of flow theory (`solver.theory`) by 3 %', 'above that of flow theory by 3 %'],
    ['choose the theory `flow`.', 'choose flow theory.'],
    ['Raise `solver.max_iterations`.', 'Raise “Iterations at most”.'],
    ['small strains; see `collapse`.', 'small strains; see the remark “Collapse”.'],
    ['see `contact_at_edge`', 'see the remark “Contact at edge”'],
    ['remark `coarse_mesh`', 'remark “Coarse mesh”'],
    ['`nonsense` is not known', '“nonsense” is not known'],
    ['`load.onset` looks for it', '“Onset of yield” as the load looks for it'],
    ['give `strain_unit`', 'give unit of the strains'],
  ])
    assert.equal(inWords(message), words);
});
