/** Jobs beside the form: the reference problem with changes, and the draft that the form shows. */

/** @typedef {import('playwright-core').Page} Page */

/** What makes the reference problem one in SI, without its load. @type {Record<string, any>} */
export const SI = {
  units: 'SI',
  ...Object.fromEntries(
    ['upper', 'lower'].map((body) => [
      body,
      {
        shape: { type: 'cylinder', radius: 0.02 },
        material: {
          young_modulus: 210e9,
          poisson_ratio: 0.3,
          plasticity: { law: 'bilinear', yield_stress: 500e6, tangent_modulus: 10.5e9 },
        },
      },
    ]),
  ),
};

/** Steel that hardens by a straight line. @param {number} [yield_stress] @param {number} [tangent_modulus] */
export const steel = (yield_stress = 500, tangent_modulus = 10500) => ({
  young_modulus: 210e3,
  poisson_ratio: 0.3,
  plasticity: { law: 'bilinear', yield_stress, tangent_modulus },
});

/** What makes the reference problem one whose contact lies to the right of x = 0. */
export const OFF_CENTRE = {
  upper: {
    shape: {
      type: 'profile',
      points: [
        [-6, -1.9],
        [-3, -0.3],
        [0, -0.02],
        [3.2, 0],
        [6, -0.4],
        [9, -2.5],
      ],
      depth: 30,
      interpolation: 'smooth',
    },
    material: steel(),
  },
  lower: { shape: { type: 'block', width: 60, depth: 30 }, material: steel() },
};

/**
 * Sends the reference problem, with changes, on a coarse mesh.
 * @param {Page} page at a service
 * @param {object} [change]
 * @param {boolean} [wait] for its end
 * @returns {Promise<string>} its id
 */
export const sent = (page, change, wait = false) =>
  page.evaluate(
    async ([change, wait]) => {
      const { examples } = await (await fetch('v1/examples')).json();
      const { job } = examples.find(
        (/** @type {{name: string}} */ { name }) => name === 'two_cylinders',
      );
      const body = JSON.stringify({ ...job, mesh: { elements_per_half_width: 8 }, ...change });
      const headers = { 'Content-Type': 'application/json' };
      const { id } = await (await fetch('v1/jobs', { method: 'POST', headers, body })).json();
      if (wait) await fetch(`v1/jobs/${id}?wait=60`);
      return id;
    },
    /** @type {const} */ ([change ?? {}, wait]),
  );

/** The same, solved. @param {Page} page @param {object} [change] @returns {Promise<string>} its id */
export const solved = (page, change) => sent(page, change, true);

/** Follows a link within the page. @param {Page} page @param {string} hash */
export const follow = (page, hash) =>
  page.evaluate((hash) => {
    location.hash = hash;
  }, hash);

/** Shows a job, solved from the reference problem with changes. @param {Page} page @param {object} [change] @returns {Promise<string>} its id */
export async function shown(page, change) {
  const id = await solved(page, change);
  // What is there of a job before is not taken for this one's.
  await page.evaluate(() => {
    for (const child of document.querySelectorAll('#headline > *'))
      child.setAttribute('data-before', '');
  });
  await follow(page, `job=${id}`);
  await page.locator('#headline > [data-before]').first().waitFor({ state: 'detached' });
  await page
    .locator('[data-status]:is([data-status=succeeded], [data-status=not_converged])')
    .waitFor();
  await page.locator('#panel-figures tbody tr').first().waitFor();
  return id;
}

/** Shows every field of the form. @param {Page} page */
export const unfold = (page) =>
  page.locator('#form .more').evaluate((more) => {
    if (more.getAttribute('aria-expanded') === 'false') /** @type {HTMLElement} */ (more).click();
  });

/** Takes something along by the menu of the result. @param {Page} page @param {string} name of the button */
export async function taken(page, name) {
  await page.getByText('Download', { exact: true }).click();
  await page.getByRole('button', { name, exact: true }).click();
  await page.keyboard.press('Escape');
}

/** The file of a panel's picture. @param {Page} page @param {string} panel by its id @param {'PNG' | 'SVG'} [kind] */
export async function picture(page, panel, kind = 'SVG') {
  await page.getByText('Download', { exact: true }).click();
  const button = page.locator(`[data-of=${panel}]`, { hasText: kind });
  const [file] = await Promise.all([page.waitForEvent('download'), button.click()]);
  await page.keyboard.press('Escape');
  return file;
}

/** Waits until the field is drawn. @param {Page} page */
export const drawn = (page) =>
  page.waitForFunction(() => performance.getEntriesByName('field-drawn').length > 0);

/** Shows the von Mises stress, whatever the field begins with. @param {Page} page */
export async function mises(page) {
  await drawn(page);
  await page.getByLabel('Shown', { exact: true }).selectOption('von_mises');
}

/** The draft as it is kept. @param {Page} page @returns {Promise<any>} */
export const draft = async (page) =>
  JSON.parse((await page.evaluate(() => sessionStorage.getItem('draft'))) ?? '{}');
