/**
 * What lies over the field: outline of the plastic zones, ends of the contact, a scale, the cross
 * of the probe.
 */

import { plain } from '../lib/units.js';

/**
 * @typedef {object} Over
 * @property {import('./camera.js').Camera} camera
 * @property {number} deformation
 * @property {{polygons: {x: number, y: number, u: number, v: number}[][], lift: number}[]} zones
 * @property {{at: [number, number], across: [number, number]}[]} edges ends of the contact, and the normal of the surface there
 * @property {{x: number, y: number, u: number, v: number, lift: number, text: string}[]} ends where the quantity is largest, and least
 * @property {[[number, number], [number, number]][]} path pieces of the cut
 * @property {[number, number] | null} cross in pixels
 * @property {(name: string) => string} colours by name, of the page or of paper
 * @property {string} length unit
 * @property {number} factor from lengths of the job to those shown
 */

/** Width that the scale of colours takes. */
const SCALE = 84;
/** Half of the length of a line at the end of the contact. */
const EDGE = 14;
/** Height of a row of words. */
const ROW = 14;

/** @param {HTMLCanvasElement} canvas @param {Over} over */
export function drawOverlay(
  canvas,
  { camera, deformation, zones, edges, ends, path, cross, colours, length, factor },
) {
  const context = canvas.getContext('2d');
  if (!context) return;
  const ratio = canvas.width / camera.width;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, camera.width, camera.height);
  for (const { polygons, lift } of zones) outline(context, camera, polygons, deformation, lift);
  context.font = '11px system-ui, sans-serif';
  scale(context, camera, colours, length, factor);
  context.strokeStyle = colours('--ink');
  context.lineWidth = 1;
  for (const { at, across } of edges) {
    const [px, py] = camera.toScreen(...at);
    const [dx, dy] = across.map((part) => EDGE * part);
    line(context, px - dx, py + dy, px + dx, py - dy);
  }
  // The first of two words that would cover each other stays where it is.
  let before = /** @type {[number, number] | undefined} */ (undefined);
  for (const end of ends) before = marked(context, camera, end, deformation, colours, before);
  for (const [style, width] of /** @type {[string, number][]} */ ([
    ['#000', 3],
    ['#fff', 1.25],
  ])) {
    context.strokeStyle = style;
    context.lineWidth = width;
    context.beginPath();
    for (const [from, to] of path) {
      context.moveTo(...camera.toScreen(...from));
      context.lineTo(...camera.toScreen(...to));
    }
    context.stroke();
  }
  context.strokeStyle = colours('--ink');
  context.lineWidth = 1;
  if (cross) {
    line(context, cross[0] - 8, cross[1], cross[0] + 8, cross[1]);
    line(context, cross[0], cross[1] - 8, cross[0], cross[1] + 8);
  }
}

/** @param {CanvasRenderingContext2D} context @param {Over['camera']} camera @param {Over['zones'][0]['polygons']} polygons @param {number} deformation @param {number} lift */
function outline(context, camera, polygons, deformation, lift) {
  const path = new Path2D();
  for (const polygon of polygons) {
    polygon.forEach(({ x, y, u, v }, k) => {
      const [px, py] = camera.toScreen(x + deformation * u, y + deformation * v + lift);
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

/**
 * A node where the quantity is largest, or least; its figure stands on the ground of the page, so
 * that it is read on every colour.
 * @param {CanvasRenderingContext2D} context
 * @param {Over['camera']} camera
 * @param {Over['ends'][0]} end
 * @param {number} deformation
 * @param {Over['colours']} colours
 * @param {[number, number]} [before] where the word of another one stands
 * @returns {[number, number] | undefined} where its word stands, if the node is in the picture
 */
function marked(context, camera, { x, y, u, v, lift, text }, deformation, colours, before) {
  const [px, py] = camera.toScreen(x + deformation * u, y + deformation * v + lift);
  if (!(px >= 0 && px <= camera.width && py >= 0 && py <= camera.height)) return before;
  const [ink, ground] = [colours('--ink'), colours('--panel')];
  context.lineWidth = 3;
  for (const style of [ground, ink]) {
    context.strokeStyle = style;
    context.beginPath();
    context.arc(px, py, 4, 0, 2 * Math.PI);
    context.stroke();
    context.lineWidth = 1.25;
  }
  // Beside the scale of colours there is no room.
  const { width } = context.measureText(text);
  const edge = camera.width - SCALE;
  const left = Math.min(px - 9, edge) - width;
  const at = px + 9 + width > edge && left > 0 ? left : px + 9;
  const covers = before && Math.abs(before[1] - py - 4) < ROW && Math.abs(before[0] - at) < width;
  const line = py + 4 + (covers ? (before[1] > py + 4 ? -ROW : ROW) : 0);
  context.globalAlpha = 0.85;
  context.fillStyle = ground;
  context.fillRect(at - 3, line - 11, width + 6, 15);
  context.globalAlpha = 1;
  context.fillStyle = ink;
  context.fillText(text, at, line);
  return [at, line];
}

/** @param {CanvasRenderingContext2D} context @param {Over['camera']} camera @param {Over['colours']} colours @param {string} unit @param {number} factor */
function scale(context, camera, colours, unit, factor) {
  const rough = (70 / camera.scale) * factor;
  const power = 10 ** Math.floor(Math.log10(rough));
  const size = power * ([5, 2, 1].find((step) => step * power <= rough) ?? 1);
  const [x, y, width] = [12, camera.height - 12, (size / factor) * camera.scale];
  const text = `${plain(size)} ${unit}`;
  context.fillStyle = colours('--panel');
  context.globalAlpha = 0.85;
  context.fillRect(x - 6, y - 20, Math.max(width, context.measureText(text).width) + 12, 27);
  context.globalAlpha = 1;
  context.strokeStyle = context.fillStyle = colours('--ink');
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
