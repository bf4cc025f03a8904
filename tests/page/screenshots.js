/** Pictures of the page: `npm run shots [folder]`, by default `docs/figures`. */

import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { launch, serve, visit } from './browser.js';

const folder = process.argv[2] ?? fileURLToPath(new URL('../../docs/figures', import.meta.url));
const WIDE = { viewport: { width: 1440, height: 1000 } };

/** @type {[name: string, options: import('playwright-core').BrowserContextOptions, full?: boolean][]} */
const PICTURES = [
  ['page', WIDE],
  ['page-dark', { ...WIDE, colorScheme: 'dark' }],
  ['page-phone', { viewport: { width: 390, height: 844 }, deviceScaleFactor: 1, hasTouch: true, isMobile: true }, true],
];

const [server, browser] = await Promise.all([serve(), launch()]);
try {
  for (const [name, options, fullPage] of PICTURES) {
    const { page, faults, close } = await visit(browser, server.url, options);
    await page.getByText('1500.0 MPa').waitFor();
    await page.getByRole('button', { name: 'Solve', exact: true }).click();
    await page.locator('[data-status=succeeded]').waitFor();
    await page.locator('#panel-field select').first().selectOption('equivalent_plastic_strain');
    await page.waitForFunction(() => performance.getEntriesByName('field-drawn').length > 1);
    await page.evaluate(() => new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn))));
    await page.evaluate(() => scrollTo(0, 0));
    await page.screenshot({ path: join(folder, `${name}.png`), fullPage });
    if (faults.length) throw new Error(faults.join('\n'));
    await close();
    console.log(`${name}.png`);
  }
} finally {
  await browser.close();
  await server.stop();
}
