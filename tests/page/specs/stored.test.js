/** A result that version 0.2.0 has stored (`tests/stored`), on the page of today. */

import assert from 'node:assert/strict';
import { copyFile, rm } from 'node:fs/promises';
import { join } from 'node:path';
import { suite } from '../browser.js';

const STORED = new URL('../../stored/version_0_2.db', import.meta.url);

const service = suite();

service.test(
  'a result of 0.2.0 is shown with its figures, its field and its line over depth',
  async (page, { server }) => {
    await server.kill();
    for (const rest of ['brinell.db-wal', 'brinell.db-shm'])
      await rm(join(server.data, rest), { force: true });
    await copyFile(STORED, join(server.data, 'brinell.db'));
    await server.again();
    const { jobs } = await (await fetch(`${server.url}/v1/jobs`)).json();
    assert.deepEqual(jobs[0].tags, { part: 'ball' });
    await page.goto(`${server.url}/#job=${jobs[0].id}`);
    await page.reload();
    // Its figures are in the table, whatever later results say besides.
    await page.locator('#headline').getByText('Of an older result').waitFor();
    await page.locator('#panel-dent .plot[aria-label*="0.002746 mm deep"]').waitFor();
    const table = page.locator('#panel-figures');
    await table
      .getByText(/^0\.0054\d/)
      .first()
      .waitFor();
    await page.getByLabel('Step', { exact: true }).fill('0');
    await table
      .getByText(/^13\d\d/)
      .first()
      .waitFor();
    await page.waitForFunction(() =>
      document.querySelector('.over')?.getAttribute('aria-label')?.startsWith('Field of'),
    );
    await page.locator('.plot').first().waitFor();
  },
  { own: [] },
);
