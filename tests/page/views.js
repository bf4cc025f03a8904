/** Every view of the page, as it is for pictures. */

import { PHONE as NARROW } from './browser.js';

/** @typedef {import('playwright-core').Page} Page */

const WIDE = { viewport: { width: 1440, height: 1000 }, few: true };
const PHONE = { ...NARROW, few: true };
const DARK = { ...WIDE, colorScheme: /** @type {const} */ ('dark') };

/** Waits for every field of the job that is shown: marks of the job before are gone with it. @param {Page} page */
const drawn = async (page) => {
  await page.waitForFunction(
    () =>
      performance.getEntriesByName('field-drawn').length > 0 &&
      ![...document.querySelectorAll('.stage.stale, .frame .waiting')].some((one) =>
        one.checkVisibility(),
      ),
  );
  await page.evaluate(
    () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))),
  );
};

/** @param {Page} page */
async function solve(page) {
  await page.getByText('1500.0 MPa').waitFor();
  await page.getByRole('button', { name: 'Solve', exact: true }).click();
  await page.locator('[data-status=succeeded]').waitFor();
  await page.locator('#panel-field select').first().selectOption('equivalent_plastic_strain');
  await drawn(page);
  await page.evaluate(() => {
    scrollTo(0, 0);
    document.querySelector('#setup')?.scrollTo(0, 0);
  });
}

/** @param {Page} page @param {object} change */
const made = (page, change) =>
  page.evaluate(async (change) => {
    const { examples } = await (await fetch('v1/examples')).json();
    const job = { ...examples[0].job, output: { fields: true }, ...change };
    const headers = { 'Content-Type': 'application/json', Prefer: 'wait=60' };
    const answer = await fetch('v1/jobs', { method: 'POST', headers, body: JSON.stringify(job) });
    return (answer.headers.get('content-location') ?? '').split('/')[3];
  }, change);

/** @param {Page} page */
async function sweep(page) {
  await page
    .locator('#example')
    .selectOption({ label: 'Bearing ball pressed into a steel plate, ten loads' });
  await page.getByRole('button', { name: 'Solve', exact: true }).click();
  await page.locator('[data-status=succeeded]').waitFor();
  await drawn(page);
  await page.getByLabel('Shown', { exact: true }).selectOption('sigma_z');
  await page.getByLabel('Isolines').check();
  await page.getByLabel('Cut', { exact: true }).check();
  await drawn(page);
}

/** @param {Page} page */
async function compared(page) {
  const ids = [];
  for (const force of [400, 600, 900]) ids.push(await made(page, { load: { force } }));
  await page.getByRole('button', { name: 'Jobs', exact: true }).click();
  await page.evaluate((hash) => {
    location.hash = hash;
  }, `job=${ids[0]}&with=${ids[1]},${ids[2]}`);
  await page.locator('#panel-differences tbody tr').first().waitFor();
  await drawn(page);
}

/** @param {Page} page */
async function form(page) {
  await page.locator('#example').selectOption({ label: 'Crowned face from measured points' });
  await page.getByLabel('Hardening').first().selectOption('table');
  await page.locator('[data-preview=upper-curve] svg').waitFor();
  await page.locator('#cost').getByText('equations').waitFor();
  await page.setViewportSize({ width: 1440, height: 1700 });
}

/** @param {string} example @returns {(page: Page) => Promise<void>} */
const part = (example) => async (page) => {
  await page.locator('#example').selectOption({ label: example });
  await page.locator('#cost').getByText('equations').waitFor();
  await page.getByRole('button', { name: 'Solve', exact: true }).click();
  await page.locator('[data-status=succeeded]').waitFor();
  await drawn(page);
  await page.setViewportSize({ width: 1440, height: 1900 });
};

/** @param {Page} page */
async function first(page) {
  await page.locator('.doors [aria-pressed=true]').waitFor();
  await page.locator('#panel-pressure .plot svg').waitFor();
  await page.evaluate(
    () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))),
  );
}

/** @param {Page} page @param {object} change of the reference problem, which is unloaded */
async function unloaded(page, change) {
  const id = await made(page, {
    load: { history: [{ force: 612.6106 }, { force: 0 }] },
    solver: { theory: 'flow' },
    ...change,
  });
  await page.evaluate((id) => {
    location.hash = `job=${id}`;
  }, id);
  await page.locator('#panel-figures tbody tr').first().waitFor();
  await drawn(page);
}

/** @param {Page} page */
const dent = (page) => unloaded(page, {});

/** @param {Page} page */
const ball = (page) =>
  unloaded(page, { analysis: 'axisymmetric', load: { history: [{ force: 5000 }, { force: 0 }] } });

/** @param {Page} page */
async function jobs(page) {
  for (const force of [400, 600]) await made(page, { load: { force }, output: {} });
  await page.getByRole('button', { name: 'Jobs', exact: true }).click();
  await page.locator('#jobs-list .peak').nth(1).waitFor();
}

/** @param {Page} page */
async function comparedReport(page) {
  await compared(page);
  await page.getByRole('button', { name: 'Report' }).click();
}

/** @param {Page} page */
async function reference(page) {
  await page.goto(new URL('docs', page.url()).href);
}

/** @param {Page} page */
async function report(page) {
  await solve(page);
  await page.getByRole('button', { name: 'Report' }).click();
}

/** @typedef {[name: string, options: import('playwright-core').BrowserContextOptions & {few?: boolean}, show: (page: Page) => Promise<void>, full?: boolean]} Seen `full`: down to the end of the page */
/** @type {Seen[]} */
export const OF_DOCUMENTS = [
  ['page', WIDE, solve],
  ['page-dark', DARK, solve],
  ['page-phone', PHONE, solve, true],
  ['page-report', WIDE, report, true],
];
/** @type {typeof OF_DOCUMENTS} */
export const OTHERS = [
  ['first', WIDE, first],
  ['first-dark', DARK, first],
  ['first-phone', PHONE, first, true],
  ['dent', WIDE, dent, true],
  ['dent-dark', DARK, dent],
  ['ball', WIDE, ball, true],
  ['raceway', WIDE, part('Ball in a raceway, in three dimensions'), true],
  ['roller', WIDE, part('Tilted roller with a logarithmic profile, in three dimensions'), true],
  [
    'roller-phone',
    PHONE,
    part('Tilted roller with a logarithmic profile, in three dimensions'),
    true,
  ],
  ['ellipse', WIDE, part('Dent of an ellipsoid, in three dimensions'), true],
  ['rough', WIDE, part('Rough patch pressed flat, in three dimensions'), true],
  ['case', WIDE, part('Case-hardened roller on a hardened block'), true],
  ['jobs', WIDE, jobs],
  ['compared-report', WIDE, comparedReport, true],
  ['interface', WIDE, reference],
  ['form', { ...WIDE, few: false }, form, true],
  ['hole', WIDE, part('Pin in a hole'), true],
  ['peened', WIDE, part('Shot-peened roller on a ground block'), true],
  ['steps', WIDE, part('Rigid roller on bronze, pressed in by steps'), true],
  ['sweep', WIDE, sweep, true],
  ['sweep-phone', PHONE, sweep, true],
  ['compared', DARK, compared, true],
];
