/** A result that version 0.2.0 has stored (`tests/stored`), on the page of today. */

import assert from 'node:assert/strict';
import { copyFile, rm } from 'node:fs/promises';
import { join } from 'node:path';
import { suite } from '../browser.js';
import { draft } from '../jobs.js';

const STORED = new URL('../../stored/version_0_2.db', import.meta.url);

const service = suite();

service.test(
  'a result of 0.2.0 is said to be one of an older version, and its job is solved again',
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
    await page.getByText('Solved by an older version').waitFor();
    const { analysis, load, tags } = await draft(page);
    assert.deepEqual([analysis, tags], ['axisymmetric', jobs[0].tags]);
    // Whatever the form has come to, the job that is shown is solved.
    await page.getByLabel('Analysis', { exact: true }).selectOption('plane_strain');
    await page.getByRole('button', { name: 'Solve again' }).click();
    await page.locator('[data-status=succeeded]').waitFor();
    assert.deepEqual((await draft(page)).load, load);
    await page.locator('#headline .verdict-text').waitFor();
    assert.notEqual(page.url().split('#job=')[1], jobs[0].id);
  },
  { own: [] },
);
