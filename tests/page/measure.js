/**
 * What the page owes to those who wait, measured: `BRINELL_BIN=target/release/brinell npm run
 * measure`.
 *
 * A slider at 10 elements per half-width: answers shown in a second. A sweep of 20 loads with
 * fields on 160 elements per half-width: time from the end of the job to its figures and to its
 * first field, and the most memory of the renderer. The last of these of a ball in its raceway and
 * of heights, too.
 */

import { spawn } from 'node:child_process';
import { mkdtemp, readFile, readdir, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { chromiumPath, flags, serve } from './browser.js';

const [ELEMENTS, STEPS] = [Number(process.env.ELEMENTS ?? 160), 20];

/**
 * A browser that is only told to evaluate: Playwright listens to the network, and then the
 * renderer keeps what came by it.
 * @param {string} url
 */
async function bare(url) {
  const profile = await mkdtemp(join(tmpdir(), 'brinell-measure-'));
  const child = spawn(
    chromiumPath(),
    [
      '--headless',
      '--remote-debugging-pipe',
      `--user-data-dir=${profile}`,
      '--window-size=1440,900',
      ...flags,
    ],
    { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] },
  );
  const [to, from] =
    /** @type {[import('node:stream').Writable, import('node:stream').Readable]} */ (
      child.stdio.slice(3)
    );
  const waiting = /** @type {Map<number, (message: any) => void>} */ (new Map());
  let rest = '';
  from.on('data', (chunk) => {
    const messages = (rest + chunk).split('\0');
    rest = messages.pop() ?? '';
    for (const message of messages.map((text) => JSON.parse(text)))
      waiting.get(message.id)?.(message);
  });
  let count = 0;
  /** @param {string} method @param {object} params @param {string} [sessionId] @returns {Promise<any>} */
  const ask = (method, params, sessionId) =>
    new Promise((resolve, reject) => {
      const id = ++count;
      waiting.set(id, ({ result, error }) =>
        error ? reject(new Error(error.message)) : resolve(result),
      );
      to.write(`${JSON.stringify({ id, method, params, sessionId })}\0`);
    });
  const { targetId } = await ask('Target.createTarget', { url });
  const { sessionId } = await ask('Target.attachToTarget', { targetId, flatten: true });
  const there = {
    expression: `document.readyState === 'complete' && location.href !== 'about:blank'`,
  };
  while (!(await ask('Runtime.evaluate', there, sessionId)).result.value)
    await new Promise((resolve) => setTimeout(resolve, 50));
  return {
    /** @template T @template A @param {(given: A) => T | Promise<T>} work in the page @param {A} given @returns {Promise<T>} */
    run: async (work, given) => {
      const expression = `(${work})(${JSON.stringify(given)})`;
      const options = { expression, awaitPromise: true, returnByValue: true };
      const { result, exceptionDetails: fault } = await ask(
        'Runtime.evaluate',
        options,
        sessionId,
      );
      if (fault) throw new Error(fault.exception?.description ?? fault.text);
      return result.value;
    },
    /** Most memory [MB] that a renderer has had. */
    memory: async () => {
      let most = 0;
      for (const pid of (await readdir('/proc')).filter((name) => /^\d+$/.test(name))) {
        const line = await readFile(`/proc/${pid}/cmdline`, 'utf8').catch(() => '');
        if (!line.includes('--type=renderer') || !line.includes(profile)) continue;
        const status = await readFile(`/proc/${pid}/status`, 'utf8').catch(() => '');
        most = Math.max(most, Number(/VmHWM:\s*(\d+)/.exec(status)?.[1] ?? 0) / 1024);
      }
      return Math.round(most);
    },
    close: async () => {
      const ended = new Promise((resolve) => child.once('exit', resolve));
      child.kill();
      await ended;
      await rm(profile, { recursive: true, maxRetries: 5 });
    },
  };
}

/** Puts a change of the first example into the form. @param {object} change */
async function enter(change) {
  const { examples } = await (await fetch('v1/examples')).json();
  const text = /** @type {HTMLTextAreaElement} */ (document.getElementById('json-text'));
  while (!text.value) await new Promise(requestAnimationFrame);
  text.value = JSON.stringify({ ...examples[0].job, ...change });
  text.dispatchEvent(new Event('input'));
  await new Promise((resolve) => setTimeout(resolve, 1000));
}

/** A hand that goes to and fro for six seconds. @returns {Promise<number>} answers shown in a second, from the first one on */
async function slide() {
  const place = document.querySelector('[data-place="/load/force"]');
  /** @type {HTMLElement} */ (place?.querySelector('button.slide')).click();
  const slider = /** @type {HTMLInputElement} */ (place?.querySelector('input[type=range]'));
  const [until, seen] = [performance.now() + 6000, { count: 0, begin: 0, last: '' }];
  for (let k = 0; performance.now() < until; k++) {
    slider.value = String(100 + Math.round(60 * Math.sin(k / 20)));
    slider.dispatchEvent(new Event('input', { bubbles: true }));
    await new Promise(requestAnimationFrame);
    const now = document.querySelector('#headline')?.textContent ?? '';
    if (now === seen.last || !document.querySelector('#headline .figure')) continue;
    seen.last = now;
    seen.begin ||= performance.now();
    seen.count += 1;
  }
  return (1000 * (seen.count - 1)) / (performance.now() - seen.begin);
}

/** Solves what is in the form. @returns {Promise<Record<string, number>>} times [ms] from its end to figures and field */
async function solve() {
  /** @type {HTMLElement} */ (document.getElementById('solve')).click();
  const seen = { figures: 0, field: 0 };
  while (!seen.field) {
    await new Promise(requestAnimationFrame);
    if (document.querySelector('#headline .figure')) seen.figures ||= Date.now();
    if (performance.getEntriesByName('field-drawn').length) seen.field ||= Date.now();
  }
  const job = await (await fetch(`v1/jobs/${location.hash.slice(5)}/events`)).text();
  const ended = [...job.matchAll(/"finished_at":"([^"]+)"/g)].at(-1)?.[1] ?? '';
  const begun = [...job.matchAll(/"started_at":"([^"]+)"/g)].at(-1)?.[1] ?? '';
  const end = Date.parse(ended);
  return { solved: end - Date.parse(begun), figures: seen.figures - end, field: seen.field - end };
}

/** Looks at every step, from the first on. */
async function play() {
  const slider = /** @type {HTMLInputElement} */ (document.querySelector('.steps input'));
  for (let step = 0; step <= Number(slider.max); step++) {
    slider.value = String(step);
    slider.dispatchEvent(new Event('input', { bubbles: true }));
    do await new Promise(requestAnimationFrame);
    while (document.querySelector('.stage')?.classList.contains('stale'));
  }
}

const server = await serve();
try {
  let browser = await bare(server.url);
  await browser.run(enter, { mesh: { elements_per_half_width: 10 } });
  const rate = await browser.run(slide, null);
  console.log(`slider: ${rate.toFixed(1)} solves a second shown at 10 elements per half-width`);
  await browser.close();

  browser = await bare(server.url);
  const forces = Array.from({ length: STEPS }, (_, k) => 35 * (k + 1));
  await browser.run(enter, {
    load: { forces },
    mesh: { elements_per_half_width: ELEMENTS },
    output: { fields: true },
  });
  console.log(`renderer before: ${await browser.memory()} MB`);
  const { solved, figures, field } = await browser.run(solve, null);
  const seconds = (/** @type {number} */ ms) => `${(ms / 1000).toFixed(2)} s`;
  console.log(
    `${STEPS} loads on ${ELEMENTS} elements per half-width: solved in ${seconds(solved)}`,
  );
  console.log(`after its end: figures ${seconds(figures)}, first field ${seconds(field)}`);
  console.log(`renderer at most ${await browser.memory()} MB`);
  await browser.run(play, null);
  console.log(`renderer at most ${await browser.memory()} MB when all steps have been looked at`);
  await browser.close();

  const [elastic, sphere] = [
    { young_modulus: 210000, poisson_ratio: 0.3 },
    { type: 'sphere', radius: 5 },
  ];
  const waves = (/** @type {number} */ i, /** @type {number} */ j) =>
    1e-4 * (Math.cos(0.7 * i + 0.2 * j) + Math.cos(0.9 * j - 0.3 * i)) -
    3e-7 * ((i - 64) ** 2 + (j - 64) ** 2);
  const heights = Array.from({ length: 128 }, (_, i) =>
    Array.from({ length: 128 }, (_, j) => waves(i, j)),
  );
  const raceway = { shape: { type: 'curved', radius_x: 20, radius_y: -5.2 }, material: elastic };
  const plane = { shape: { type: 'flat' }, material: elastic };
  const rough = { ...plane, surface: { heights, spacing_x: 0.002, spacing_y: 0.002 } };
  const solids = {
    'ball in raceway, five loads': {
      upper: { shape: sphere, material: elastic },
      lower: raceway,
      load: { forces: [100, 200, 300, 400, 500] },
    },
    'heights, 128 × 128': { upper: rough, lower: plane, load: { force: 2 } },
  };
  for (const [name, job] of Object.entries(solids)) {
    browser = await bare(server.url);
    await browser.run(enter, { analysis: 'three_dimensional', output: { fields: true }, ...job });
    const { solved } = await browser.run(solve, null);
    if ('forces' in job.load) await browser.run(play, null);
    console.log(
      `${name}: solved in ${seconds(solved)}, renderer at most ${await browser.memory()} MB`,
    );
    await browser.close();
  }
} finally {
  await server.stop();
}
