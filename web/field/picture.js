/**
 * The field as a picture by itself: title, quantity with its unit, and the scale of colours beside
 * it.
 */

import { h } from '../lib/dom.js';
import { limitOf } from './palette.js';

const [HEAD, SIDE, BAND] = [42, 96, 20];

/**
 * @param {HTMLCanvasElement[]} layers
 * @param {import('./palette.js').Bands} bands
 * @param {{title: string, quantity: string, colours: (name: string) => string}} words `colours` by name
 * @returns {HTMLCanvasElement | null}
 */
export function compose(layers, bands, { title, quantity, colours: ink }) {
  const ratio = devicePixelRatio;
  const [width, height] = [layers[0].width / ratio, layers[0].height / ratio];
  const copy = h('canvas', { width: (width + SIDE) * ratio, height: (height + HEAD) * ratio });
  const context = copy.getContext('2d');
  if (!context) return null;
  context.fillStyle = ink('--panel');
  context.fillRect(0, 0, copy.width, copy.height);
  for (const layer of layers) context.drawImage(layer, 0, HEAD * ratio);
  context.scale(ratio, ratio);
  context.fillStyle = ink('--ink');
  context.font = 'bold 12px system-ui, sans-serif';
  context.fillText(title, 8, 16, width + SIDE - 16);
  context.font = '11px system-ui, sans-serif';
  context.fillText(quantity, 8, 33);
  const { colours } = bands;
  const top = HEAD + 12;
  [...colours].reverse().forEach((rgb, k) => {
    context.fillStyle = `rgb(${rgb.map((c) => Math.round(255 * c)).join(' ')})`;
    context.fillRect(width + 10, top + BAND * k, 16, BAND);
  });
  context.fillStyle = ink('--ink');
  for (let k = 0; k <= colours.length; k++)
    context.fillText(limitOf(bands, colours.length - k), width + 32, top + BAND * k + 4);
  return copy;
}
