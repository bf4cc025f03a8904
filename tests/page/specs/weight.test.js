/**
 * What the page costs to begin with: bytes as they are sent, and the time until one can work with
 * it.
 */

import assert from 'node:assert/strict';
import { suite } from '../browser.js';

const service = suite();

/** Bytes [kB] of the whole page, compressed, files, time [ms] until it is usable, and delay [ms] of every answer. */
const [MOST, FILES, SOON, LATE] = [220, 12, 1500, 100];

service.test(
  'the page is below 220 kB, asks nobody else and is usable in 1.5 s at 100 ms of delay',
  async (page, { server, note }) => {
    const sent = /** @type {Promise<[string, number]>[]} */ ([]);
    page.on('requestfinished', (request) => {
      const size = request.sizes().then(({ responseBodySize }) => responseBodySize);
      sent.push(size.then((bytes) => [new URL(request.url()).pathname, bytes]));
    });
    const browser = await page.context().newCDPSession(page);
    const times = [];
    const slow = { offline: false, latency: LATE, downloadThroughput: -1, uploadThroughput: -1 };
    await browser.send('Network.enable');
    await browser.send('Network.emulateNetworkConditions', slow);
    for (let visit = 0; visit < 3; visit += 1) {
      await page.goto('about:blank');
      await browser.send('Network.clearBrowserCache');
      sent.length = 0;
      const begun = performance.now();
      await page.goto(server.url);
      await page.getByText('1500.0 MPa').waitFor();
      await page.locator('#panel-pressure .plot svg').waitFor();
      times.push(performance.now() - begun);
    }
    const sizes = (await Promise.all(sent)).filter(([path]) => !path.startsWith('/v1/'));
    const whole = sizes.reduce((sum, [, bytes]) => sum + bytes, 0) / 1000;
    note(
      `${sizes.length} files, ${whole.toFixed(1)} kB; usable after ${Math.min(...times).toFixed(0)} ms`,
    );
    assert.ok(
      sizes.length <= FILES && whole > 50 && whole < MOST,
      `${sizes.length} files, ${whole} kB`,
    );
    assert.ok(Math.min(...times) < SOON, times.join(', '));
  },
);

service.test('a reload asks for no file that has not changed', async (page, { note }) => {
  await page.reload();
  await page.locator('#panel-pressure .plot svg').waitFor();
  const [all, sent] = await page.evaluate(() => {
    const entries = /** @type {PerformanceResourceTiming[]} */ (
      performance.getEntriesByType('resource')
    ).filter(({ name }) => name.includes('/web/'));
    return [entries.length, entries.filter(({ transferSize }) => transferSize > 0).length];
  });
  note(`${sent} of ${all} files are asked for`);
  assert.ok(all > 4 && sent === 0, `${sent} of ${all}`);
});
