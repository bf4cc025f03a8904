/** What lies over the field: outline of the plastic zones, ends of the contact, a scale, the cross of the probe. */

import { colour } from '../lib/theme.js';
import { plain } from '../lib/units.js';

/**
 * @typedef {object} Over
 * @property {import('./camera.js').Camera} camera
 * @property {number} deformation
 * @property {{polygons: {x: number, y: number, u: number, v: number}[][], shift: number}[]} zones
 * @property {number[]} ends of the contact
 * @property {[number, number] | null} cross in pixels
 * @property {string} length unit
 */

/** @param {HTMLCanvasElement} canvas @param {Over} over */
export function drawOverlay(canvas, { camera, deformation, zones, ends, cross, length }) {
  const context = canvas.getContext('2d');
  if (!context) return;
  const ratio = canvas.width / camera.width;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, camera.width, camera.height);
  for (const { polygons, shift } of zones) outline(context, camera, polygons, deformation, shift);
  context.font = '11px system-ui, sans-serif';
  scale(context, camera, length);
  context.strokeStyle = colour('--ink');
  context.lineWidth = 1;
  for (const x of ends) {
    const [px, py] = camera.toScreen(x, 0);
    line(context, px, py - 14, px, py + 14);
  }
  if (cross) {
    line(context, cross[0] - 8, cross[1], cross[0] + 8, cross[1]);
    line(context, cross[0], cross[1] - 8, cross[0], cross[1] + 8);
  }
}

/** @param {CanvasRenderingContext2D} context @param {Over['camera']} camera @param {Over['zones'][0]['polygons']} polygons @param {number} deformation @param {number} shift */
function outline(context, camera, polygons, deformation, shift) {
  const path = new Path2D();
  for (const polygon of polygons) {
    polygon.forEach(({ x, y, u, v }, k) => {
      const [px, py] = camera.toScreen(x + deformation * u, y + deformation * (v + shift));
      if (k === 0) path.moveTo(px, py);
      else path.lineTo(px, py);
    });
    path.closePath();
  }
  for (const [style, width] of /** @type {[string, number][]} */ ([
    ['#0009', 3],
    ['#fff', 1.25],
  ])) {
    context.strokeStyle = style;
    context.lineWidth = width;
    context.stroke(path);
  }
}

/** @param {CanvasRenderingContext2D} context @param {Over['camera']} camera @param {string} unit */
function scale(context, camera, unit) {
  const rough = 70 / camera.scale;
  const power = 10 ** Math.floor(Math.log10(rough));
  const size = power * ([5, 2, 1].find((step) => step * power <= rough) ?? 1);
  const [x, y, width] = [12, camera.height - 12, size * camera.scale];
  const text = `${plain(size)} ${unit}`;
  context.fillStyle = colour('--panel');
  context.globalAlpha = 0.85;
  context.fillRect(x - 6, y - 20, Math.max(width, context.measureText(text).width) + 12, 27);
  context.globalAlpha = 1;
  context.strokeStyle = context.fillStyle = colour('--ink');
  context.lineWidth = 1.5;
  context.beginPath();
  context.moveTo(x, y - 4);
  context.lineTo(x, y);
  context.lineTo(x + width, y);
  context.lineTo(x + width, y - 4);
  context.stroke();
  context.fillText(text, x, y - 7);
}

/** @param {CanvasRenderingContext2D} context @param {number} x0 @param {number} y0 @param {number} x1 @param {number} y1 */
function line(context, x0, y0, x1, y1) {
  context.beginPath();
  context.moveTo(x0, y0);
  context.lineTo(x1, y1);
  context.stroke();
}
