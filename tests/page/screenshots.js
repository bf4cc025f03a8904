/**
 * Pictures of every view: `npm run shots [folder]`, by default `docs/figures`, which takes those
 * of the documents alone.
 */

import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { launch, serve, visit } from './browser.js';
import { OF_DOCUMENTS, OTHERS } from './views.js';

const given = process.argv[2];
const folder = given ?? fileURLToPath(new URL('../../docs/figures', import.meta.url));

const [server, browser] = await Promise.all([serve(), launch()]);
try {
  for (const [name, options, show, fullPage] of given
    ? [...OF_DOCUMENTS, ...OTHERS]
    : OF_DOCUMENTS) {
    const { page, faults, close } = await visit(browser, server.url, options);
    await page.getByText('1500.0 MPa').waitFor();
    await show(page);
    await page.screenshot({ path: join(folder, `${name}.png`), fullPage });
    if (faults.length) throw new Error(faults.join('\n'));
    await close();
    console.log(`${name}.png`);
  }
} finally {
  await browser.close();
  await server.stop();
}
