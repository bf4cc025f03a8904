/**
 * Every view beside a picture of it, a quarter as wide and high: what moves, wraps or vanishes is
 * seen, letters are not. `BRINELL_WRITE=1 node --test specs/screens.test.js` takes the pictures
 * anew; look at them before they are committed.
 */

import assert from 'node:assert/strict';
import { mkdir, readFile, writeFile } from 'node:fs/promises';
import { suite } from '../browser.js';
import { OF_DOCUMENTS, OTHERS } from '../views.js';

const FOLDER = new URL('../screens/', import.meta.url);
/** Part of the page's size that pictures have. */
const SIZE = 0.25;
/** Difference in brightness, of 255, and share of the pixels that may differ by more. */
const [BRIGHTNESS, SHARE] = [48, 0.01];

const service = suite();

/** The first picture that the next one equals: a busy machine draws late. @param {() => Promise<Buffer>} take @returns {Promise<Buffer>} */
async function settled(take) {
  let [before, now] = [await take(), await take()];
  for (let again = 0; again < 20 && !before.equals(now); again += 1)
    [before, now] = [now, await take()];
  return now;
}

/** The picture in little. @param {import('playwright-core').Page} page @param {Buffer} png @returns {Promise<Buffer>} */
async function little(page, png) {
  const text = await page.evaluate(
    async ([png, size]) => {
      const image = await createImageBitmap(
        await (await fetch(`data:image/png;base64,${png}`)).blob(),
      );
      const canvas = new OffscreenCanvas(
        Math.round(image.width * size),
        Math.round(image.height * size),
      );
      const context = /** @type {OffscreenCanvasRenderingContext2D} */ (canvas.getContext('2d'));
      context.imageSmoothingQuality = 'high';
      context.drawImage(image, 0, 0, canvas.width, canvas.height);
      const blob = await canvas.convertToBlob({ type: 'image/webp', quality: 0.8 });
      return btoa(
        Array.from(new Uint8Array(await blob.arrayBuffer()), (byte) =>
          String.fromCharCode(byte),
        ).join(''),
      );
    },
    /** @type {const} */ ([png.toString('base64'), SIZE]),
  );
  return Buffer.from(text, 'base64');
}

/** @param {import('playwright-core').Page} page @param {Buffer[]} pictures @returns {Promise<{sizes: string[], differ: number}>} `differ`: share of the pixels */
const compared = (page, pictures) =>
  page.evaluate(
    async ([texts, brightness]) => {
      const images = [];
      for (const text of texts)
        images.push(
          await createImageBitmap(await (await fetch(`data:image/webp;base64,${text}`)).blob()),
        );
      const sizes = images.map(({ width, height }) => `${width} × ${height}`);
      const [width, height] = [images[0].width, Math.min(...images.map((image) => image.height))];
      const [one, other] = images.map((image) => {
        const context = /** @type {OffscreenCanvasRenderingContext2D} */ (
          new OffscreenCanvas(width, height).getContext('2d')
        );
        context.drawImage(image, 0, 0);
        return context.getImageData(0, 0, width, height).data;
      });
      let count = 0;
      for (let k = 0; k < one.length; k += 4)
        if (
          [0, 1, 2].some((channel) => Math.abs(one[k + channel] - other[k + channel]) > brightness)
        )
          count += 1;
      return { sizes, differ: count / (width * height) };
    },
    /** @type {const} */ ([pictures.map((one) => one.toString('base64')), BRIGHTNESS]),
  );

for (const [name, options, show, fullPage] of [...OF_DOCUMENTS, ...OTHERS])
  service.test(
    `the view “${name}” is as it was`,
    async (page) => {
      await show(page);
      // How far a form has scrolled depends on how fast its answers came.
      await page.evaluate(() => {
        for (const element of document.querySelectorAll('*')) element.scrollTop = 0;
      });
      const png = await settled(() => page.screenshot({ fullPage, animations: 'disabled' }));
      const blank = await page.context().newPage();
      const now = await little(blank, png);
      const file = new URL(`${name}.webp`, FOLDER);
      if (process.env.BRINELL_WRITE) {
        await mkdir(FOLDER, { recursive: true });
        await writeFile(file, now);
        return;
      }
      const { sizes, differ } = await compared(blank, [await readFile(file), now]);
      const [wide, high] = [0, 1].map((k) => sizes.map((size) => Number(size.split(' × ')[k])));
      assert.ok(
        wide[0] === wide[1] && Math.abs(high[0] - high[1]) <= 0.02 * high[0] + 2,
        sizes.join(', '),
      );
      assert.ok(differ < SHARE, `${(100 * differ).toFixed(2)} % of the pixels differ`);
    },
    // An unloaded job on the usual mesh takes its time in a debug build.
    options,
  );
