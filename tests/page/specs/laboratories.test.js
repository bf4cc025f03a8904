/** Tables as laboratories' programs write them, those of `tests/measured/tables.json`. No browser. */

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { readTable } from '../../../web/lib/table.js';

/** @type {any[]} */
const CASES = JSON.parse(readFileSync(new URL('../../measured/tables.json', import.meta.url), 'utf8')); // prettier-ignore
/** @type {Record<string, [import('../../../web/lib/units.js').Quantity[], string[]]>} */
const KINDS = {
  curve: [['strain', 'stress'], ['ε_p', 'q']], // prettier-ignore
  hardness: [['length', 'hardness'], ['z', 'HV']], // prettier-ignore
};

/** @param {any} one @param {import('../../../web/lib/record.js').Choice} [choice] */
const read = ({ kind, text }, choice) =>
  readTable(text, KINDS[kind][0], 'mm_N_MPa', KINDS[kind][1], { choice });

/** @param {number[]} found @param {number[]} wanted @param {string} what */
function near(found, wanted, what) {
  for (const [k, value] of wanted.entries())
    assert.ok(
      Math.abs(found[k] - value) <= 1e-9 * Math.abs(value),
      `${what}: ${found}, ${wanted}`,
    );
}

for (const one of CASES)
  test(one.name, () => {
    const asked = read(one);
    if (one.asks) assert.match('problem' in asked ? asked.problem : 'taken', new RegExp(one.asks));
    if (!one.points) return;
    const table = one.given ? read(one, one.given) : asked;
    if ('problem' in table) assert.fail(table.problem);
    assert.equal(table.points.length, one.points);
    assert.equal(table.record?.measure, one.measure);
    assert.equal(table.scale || undefined, one.scale);
    near(table.points[0], one.first, 'first');
    near(table.points[one.points - 1], one.last, 'last');
  });
