/**
 * The iteration as it runs: what is left to do on a log axis, approach and peak pressure as they
 * settle.
 */

import { h, pngOf, svg } from '../lib/dom.js';
import { figure, unit } from '../lib/units.js';
import { Chart } from './chart.js';
import { Panel } from './panel.js';

/** @typedef {import('../types.js').Iteration} Iteration */

const SETTLING = 'Approach and peak pressure';

/** One drawing below the other. @param {(SVGSVGElement | null)[]} drawings of the same width */
function stackedDrawing(drawings) {
  const parts = drawings.filter((one) => one !== null);
  if (parts.length === 0) return null;
  let height = 0;
  for (const part of parts) {
    part.setAttribute('y', String(height));
    height += Number(part.getAttribute('height'));
  }
  const width = Number(parts[0].getAttribute('width'));
  return svg(
    'svg',
    { xmlns: 'http://www.w3.org/2000/svg', viewBox: `0 0 ${width} ${height}`, width, height },
    parts,
  );
}

/** @param {(Blob | null)[]} pictures @returns {Promise<Blob | null>} */
async function stackedPicture(pictures) {
  const parts = await Promise.all(
    pictures.filter((one) => one !== null).map((one) => createImageBitmap(one)),
  );
  const width = Math.max(...parts.map((part) => part.width));
  const canvas = h('canvas', { width, height: parts.reduce((sum, part) => sum + part.height, 0) });
  const context = canvas.getContext('2d');
  if (!context || parts.length === 0) return null;
  let top = 0;
  for (const part of parts) {
    context.drawImage(part, 0, top);
    top += part.height;
  }
  return pngOf(canvas);
}

export class ConvergencePanel {
  constructor() {
    this.residual = new Chart(200);
    this.settling = new Chart(140);
    this.panel = new Panel(
      'convergence',
      'Convergence',
      [this.residual.element, this.settling.element],
      {
        chart: {
          picture: async (title) =>
            stackedPicture([
              await this.residual.picture(title),
              await this.settling.picture(SETTLING),
            ]),
          drawing: (title) =>
            stackedDrawing([this.residual.drawing(title), this.settling.drawing(SETTLING)]),
        },
      },
    );
  }

  /**
   * @param {Iteration[]} history of all steps, one after the other
   * @param {import('../lib/units.js').Units | import('../lib/units.js').UnitSet} units
   * @param {number} tolerance
   */
  show(history, units, tolerance) {
    this.panel.show(history.length > 0);
    if (history.length === 0) return;
    const x = history.map((_, k) => k + 1);
    const column = (/** @type {import('../types.js').IterationFigure} */ key) =>
      history.map((record) => record[key]);
    const positive = (/** @type {import('../types.js').IterationFigure} */ key) =>
      column(key).map((value) => (value > 0 ? value : null));
    const last = history[history.length - 1];
    const points = history.length < 60;
    const iterations = `${history.length} iteration${history.length === 1 ? '' : 's'}`;
    this.residual.show({
      x: 'iteration',
      y: 'relative',
      log: true,
      curves: [
        {
          label: 'out-of-balance force',
          colour: '--curve-1',
          x,
          y: positive('equilibrium_residual'),
          points,
        },
        {
          label: 'displacement change',
          colour: '--hertz',
          x,
          y: positive('displacement_change'),
          points,
        },
        // 0 has no place on the axis.
      ].filter(({ y }) => y.some((value) => value !== null)),
      marks: [{ across: 'y', at: tolerance, text: 'tolerance', left: true }],
      words: `After ${iterations} the out-of-balance force is ${figure(last.equilibrium_residual, 3)} of the load; the tolerance is ${figure(tolerance, 1)}.`,
    });
    const pressure = `peak p  [${unit('stress', units)}]`;
    const approach = { label: 'approach', colour: '--curve-2', x, y: column('approach'), points };
    const peak = {
      ...approach,
      label: 'peak pressure',
      colour: '--curve-1',
      y: column('peak_pressure'),
    };
    // A load that rolls has no approach.
    const sinks = approach.y.some((value) => value !== 0);
    this.settling.show({
      x: 'iteration',
      y: sinks ? `α  [${unit('length', units)}]` : pressure,
      right: sinks ? pressure : undefined,
      curves: sinks ? [approach, { ...peak, right: true }] : [peak],
      words: `${sinks ? `Approach ${figure(last.approach)} ${unit('length', units)}, peak` : 'Peak'} pressure ${figure(last.peak_pressure)} ${unit('stress', units)} after the last iteration.`,
    });
  }
}
