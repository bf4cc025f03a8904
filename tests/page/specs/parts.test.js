/** Parts of the page that need no browser. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { locate, locateAll } from '../../../web/field/locate.js';
import { differences, names } from '../../../web/jobs/names.js';
import { figure } from '../../../web/lib/units.js';
import { layoutOf } from '../../../web/setup/layout.js';
import { nextSteps } from '../../../web/result/next.js';
import { progressOf } from '../../../web/result/progress.js';
import { NOTHING, after } from '../../../web/state.js';

/** @param {number[]} lengths iterations of each step @param {number} pace [ms] of a step */
const history = (lengths, pace) =>
  lengths.flatMap((length, step) =>
    Array.from({ length }, (_, k) => ({
      iteration: k + 1,
      elapsed_ms: 5000 + pace * step + k,
      equilibrium_residual: 1e-3,
    })),
  );

test('a sweep says which step it is at and what time is left', () => {
  const job = { load: { forces: [1, 2, 3, 4, 5, 6, 7, 8, 9, 10] } };
  const words = (/** @type {number[]} */ lengths, of = job) =>
    progressOf(/** @type {any} */ (history(lengths, 4000)), of).words;
  assert.equal(words([]), 'meshing and factorizing');
  assert.equal(words([3]), 'load 1 of 10');
  // Seven loads of 4 s are left of this one on.
  assert.equal(words([3, 5, 2, 2]), 'load 4 of 10, about 28 s left');
  assert.equal(words(Array(10).fill(2)), 'load 10 of 10, about 4 s left');
  assert.match(
    words(Array(13).fill(2)),
    /^load 10 of 10/,
    'of a mesh that grew all are done again',
  );
  assert.equal(words([3], /** @type {any} */ ({ load: { force: 1 } })), 'iteration 3');
  const increment = { load: 5, loads: 20, number: 1, count: 2 };
  const begun = { iteration: 4, elapsed_ms: 2000, equilibrium_residual: 1e-3, increment };
  const last = { ...begun, elapsed_ms: 6000 };
  const rolling = /** @type {any} */ ({ load: { rolling: { force: 1 } } });
  const { words: rolled, part } = progressOf(/** @type {any} */ ([begun, last]), rolling);
  assert.equal(rolled, 'pass 5 of 20, about 16 s left');
  assert.ok(Math.abs(part - 0.2) < 1e-12);
});

test('each decade of a residual is an equal part of the way', () => {
  const residuals = [1, 1e-1, 1e-3].map((equilibrium_residual, k) => ({
    iteration: k + 1,
    elapsed_ms: 10,
    equilibrium_residual,
  }));
  const { part } = progressOf(/** @type {any} */ (residuals), /** @type {any} */ ({}));
  assert.ok(Math.abs(part - 0.5) < 1e-12, String(part));
});

test('where a job has no answer the next one is offered', () => {
  const steel = { young_modulus: 200, poisson_ratio: 0.3 };
  const law = { law: 'bilinear', yield_stress: 1, tangent_modulus: 40 };
  const body = { material: { ...steel, plasticity: law } };
  const offered = (/** @type {any} */ load, /** @type {any[]} */ steps) =>
    nextSteps(
      /** @type {any} */ ({ upper: body, lower: body, load }),
      /** @type {any} */ ({ steps }),
      steps.length - 1,
    );
  const step = (/** @type {string} */ status, /** @type {number} */ force) => ({
    status,
    answers: [{ name: 'force', value: force }],
    verdict: { level: status },
  });
  assert.deepEqual(offered({ force: 9 }, [step('converged', 9)]), []);
  const [half] = offered({ force: 9 }, [step('not_converged', 9)]);
  assert.deepEqual(half.job.load, { force: 4.5 });
  const steps = [step('converged', 4), step('not_converged', 8)];
  const [largest, finer] = offered({ forces: [4, 8] }, steps);
  assert.deepEqual(largest.job.load, { force: 4 });
  assert.deepEqual(finer.job.load, { forces: [4, 5, 6, 7, 8] });
  const [longer, kinematic] = offered({ rolling: { force: 1, passes: 20 } }, [
    step('not_known', 1),
  ]);
  assert.equal(longer.job.load.rolling.passes, 40);
  assert.deepEqual(kinematic.job.upper.material.plasticity, {
    ...law,
    tangent_modulus: 0,
    backstress: [{ modulus: 50, rate: 0 }],
  });
});

test('many points are found in one look where one by one finds them', () => {
  // A skewed grid of quadrilaterals.
  const [across, down] = [13, 9];
  const nodes = new Float32Array(2 * across * down);
  for (let j = 0; j < down; j++)
    for (let i = 0; i < across; i++)
      nodes.set([i + 0.2 * Math.sin(j), j + 0.15 * Math.cos(3 * i)], 2 * (across * j + i));
  const corners = [];
  for (let j = 0; j + 1 < down; j++)
    for (let i = 0; i + 1 < across; i++) {
      const a = across * j + i;
      corners.push(a, a + 1, a + across + 1, a + across);
    }
  const mesh = /** @type {any} */ ({
    nodes,
    displacement: new Float32Array(nodes.length),
    elements: Uint32Array.from(corners),
  });
  const points = Array.from(
    { length: 400 },
    (_, k) => /** @type {[number, number]} */ ([((k * 0.618) % 14) - 1, ((k * 0.414) % 10) - 1]),
  );
  const all = locateAll(mesh, points);
  assert.ok(all.filter(Boolean).length > 200 && all.includes(null));
  points.forEach(([x, y], k) => assert.deepEqual(all[k], locate(mesh, 0, 0, x, y)));
});

test('figures have five digits, whatever they round to', () => {
  for (const [value, text] of /** @type {[number, string][]} */ ([
    [999.9999999, '1000.0'],
    [0.099999999, '0.10000'],
    [1182.437, '1182.4'],
    [-0.017911, '−0.017911'],
    [999999.9, '1.0000·10⁶'],
    [0.000099999999, '0.00010000'],
    [34162.7, '34163'],
    [0, '0'],
    [NaN, '—'],
  ]))
    assert.equal(figure(value), text);
});

test('jobs with loads of different kinds are told apart by them', () => {
  const job = (/** @type {object} */ load) => ({
    load,
    mesh: { elements_per_half_width: 8 },
    solver: { tolerance: 1e-6 },
  });
  const jobs = [job({ forces: [100, 612] }), job({ force: 300 }), job({ approach: 0.01 })];
  assert.deepEqual(names(jobs.map((job, k) => ({ id: `job-${k}`, job }))), [
    'P 100 … 612 N/mm',
    'P 300 N/mm',
    'α 0.01 mm',
  ]);
  assert.deepEqual(
    differences(jobs).map(({ pointer }) => pointer),
    ['/load'],
  );
  const targets = [
    job({ target: { peak_pressure: 1200 } }),
    job({ target: { half_width: 0.3 } }),
    job({ onset: true }),
  ];
  assert.deepEqual(names(targets.map((job, k) => ({ id: `job-${k}`, job }))), [
    'P for peak pressure 1200 MPa',
    'P for half-width 0.3 mm',
    'onset of yield',
  ]);
  assert.deepEqual(
    differences([job({ force: 1 }), job({ force: 2 })]).map(({ label }) => label),
    ['Force'],
  );
});

test('the state of the page follows what happens, and keeps what was', () => {
  const shown = (/** @type {string} */ id) => /** @type {any} */ ({ id, label: '' });
  const all = (/** @type {any[]} */ ...events) => events.reduce(after, NOTHING);
  const opened = all({ type: 'opened', id: 'a', job: {} }, { type: 'solved', shown: shown('a') });
  assert.deepEqual([opened.current?.id, opened.first?.id], ['a', 'a']);
  assert.equal(after(opened, { type: 'opened', id: 'b', job: {} }).first, undefined);
  assert.equal(opened.first?.id, 'a', 'the state before is as it was');
  const compared = [
    { type: 'chosen', id: 'b' },
    { type: 'laid', shown: shown('b') },
    { type: 'chosen', id: 'c' },
    { type: 'laid', shown: shown('c') },
  ].reduce((state, event) => after(state, /** @type {any} */ (event)), opened);
  assert.deepEqual([...compared.compared.keys()], ['b', 'c']);
  assert.deepEqual([...after(compared, { type: 'dropped', ids: ['b'] }).compared.keys()], ['c']);
  const only = after(compared, { type: 'only', ids: ['c'] });
  assert.deepEqual([[...only.compared.keys()], only.chosen.size], [['c'], 0]);
  const removed = after(opened, { type: 'removed', id: 'a' });
  assert.equal(removed.first?.removed, true);
  assert.equal(after(opened, { type: 'removed', id: 'b' }), opened);
  const left = after(compared, { type: 'left' });
  assert.deepEqual([left.current, left.first, left.compared.size], [undefined, undefined, 2]);
});

test('the layout of the form is a function of the job', () => {
  const places = (/** @type {any} */ job) =>
    layoutOf(job)
      .filter(({ field }) => field)
      .map(({ place }) => place);
  const steel = { young_modulus: 210000, poisson_ratio: 0.3 };
  const law = { law: 'bilinear', yield_stress: 500, tangent_modulus: 0 };
  const body = {
    shape: { type: 'cylinder', radius: 20 },
    material: { ...steel, plasticity: law },
  };
  const job = { analysis: 'plane_strain', upper: body, lower: body, load: { force: 600 } };
  const plain = places(job);
  assert.ok(plain.includes('/upper/material/plasticity/yield_stress'));
  assert.ok(plain.includes('/lower/material/plasticity/backstress'), 'flow theory answers');
  assert.equal(new Set(plain).size, plain.length, 'no place is there twice');
  // Other figures are no other layout.
  const heavier = { ...job, load: { force: 900 }, upper: { ...body, support: 'roller' } };
  assert.deepEqual(layoutOf(/** @type {any} */ (heavier)), layoutOf(/** @type {any} */ (job)));
  /** @param {any} change @param {string[]} more @param {string[]} fewer */
  const changes = (change, more, fewer = []) => {
    const now = places({ ...job, ...change });
    for (const place of more) assert.ok(now.includes(place) && !plain.includes(place), place);
    for (const place of fewer) assert.ok(!now.includes(place) && plain.includes(place), place);
  };
  const upper = (/** @type {any} */ material) => ({ upper: { ...body, material } });
  changes(
    upper({ rigid: true }),
    [],
    ['/upper/material/young_modulus', '/upper/material/stress_kind'],
  );
  changes(upper({ ...steel, plasticity: { ...law, over_depth: [[0, 1]] } }), [
    '/upper/material/plasticity/over_depth',
  ]);
  changes(upper({ ...body.material, initial_stress: [] }), ['/upper/material/initial_stress']);
  changes({ load: { rolling: { force: 1 } } }, ['/load/rolling/friction'], ['/load/force']);
  changes(
    { load: { target: { dent_depth: 1 } } },
    ['/load/target_kind', '/load/target/dent_depth'],
    ['/load/force'],
  );
  const ball = { shape: { type: 'sphere', radius: 5 }, material: steel };
  const roller = { shape: { type: 'roller', radius: 5, length: 9, moment: 3 }, material: steel };
  changes(
    { analysis: 'three_dimensional', upper: roller, lower: ball },
    ['/upper/shape/tilt_kind', '/upper/shape/moment', '/lower/surface_kind'],
    ['/upper/support', '/lower/support'],
  );
});
