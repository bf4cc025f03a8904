/**
 * A chart that is drawn as SVG as a PNG. The page may load no pictures but its own files, so that
 * it is painted part by part.
 */

import { h, pngOf } from '../lib/dom.js';

/**
 * @param {SVGSVGElement} drawing of `chart-svg.js`
 * @param {number} ratio of pixels
 * @returns {Promise<Blob | null>}
 */
export function chartPng(drawing, ratio) {
  const [width, height] = ['width', 'height'].map((name) => Number(drawing.getAttribute(name)));
  const canvas = h('canvas', {
    width: Math.round(width * ratio),
    height: Math.round(height * ratio),
  });
  const context = canvas.getContext('2d');
  if (!context) return Promise.resolve(null);
  context.scale(ratio, ratio);
  paint(context, drawing, width, height);
  return pngOf(canvas);
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Element} of whose parts are painted
 * @param {number} width
 * @param {number} height
 */
function paint(context, of, width, height) {
  for (const part of of.children) {
    const text = (/** @type {string} */ name) => part.getAttribute(name) ?? '';
    const number = (/** @type {string} */ name) => Number(text(name));
    const [fill, stroke] = [text('fill'), text('stroke')];
    context.save();
    context.fillStyle = fill;
    context.strokeStyle = stroke;
    context.lineWidth = number('stroke-width') || 1;
    context.setLineDash(text('stroke-dasharray').split(' ').filter(Boolean).map(Number));
    switch (part.tagName) {
      case 'g':
        clip(context, of, text('clip-path'));
        paint(context, part, width, height);
        break;
      case 'rect':
        context.fillRect(0, 0, width, height);
        break;
      case 'path':
        context.globalAlpha = Number(text('fill-opacity') || 1);
        if (fill && fill !== 'none') context.fill(new Path2D(text('d')));
        context.globalAlpha = 1;
        if (stroke) context.stroke(new Path2D(text('d')));
        break;
      case 'circle':
        context.beginPath();
        context.arc(number('cx'), number('cy'), number('r'), 0, 2 * Math.PI);
        context.fill();
        break;
      case 'text':
        write(context, part);
    }
    context.restore();
  }
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Element} root
 * @param {string} address of a clip path, as `url(#…)`
 */
function clip(context, root, address) {
  const box = root.querySelector(`[id="${address.slice(5, -1)}"] rect`);
  if (!box) return;
  const [x, y, width, height] = ['x', 'y', 'width', 'height'].map((name) =>
    Number(box.getAttribute(name)),
  );
  context.beginPath();
  context.rect(x, y, width, height);
  context.clip();
}

/** @param {CanvasRenderingContext2D} context @param {Element} part */
function write(context, part) {
  const text = (/** @type {string} */ name) => part.getAttribute(name) ?? '';
  const [, x, y, angle] = /translate\((\S+) (\S+)\) rotate\((\S+)\)/.exec(text('transform')) ?? [];
  if (x) {
    context.translate(Number(x), Number(y));
    context.rotate((Number(angle) * Math.PI) / 180);
  }
  context.font = `${text('font-weight')} ${text('font-size') || 11}px system-ui, sans-serif`;
  context.textAlign =
    { middle: /** @type {const} */ ('center'), end: /** @type {const} */ ('right') }[
      text('text-anchor')
    ] ?? 'left';
  const room = Number(text('textLength')) || undefined;
  const place = /** @type {const} */ ([
    part.textContent ?? '',
    Number(text('x')),
    Number(text('y')),
    room,
  ]);
  if (text('stroke')) context.strokeText(...place);
  context.fillText(...place);
}
