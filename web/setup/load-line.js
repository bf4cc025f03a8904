/** The load as one line of a sketch. */

import { svg } from '../lib/dom.js';
import { exact, forceOf, unit, unitsOf } from '../lib/units.js';
import { TARGETS, loadOf, targetOf } from './fields.js';
import { historyWords } from './history.js';
import { sweepWords } from './list.js';

/** Width of a sketch. */
export const WIDTH = 380;
/** Width of a letter, on average. */
export const LETTER = 6.4;
/** The same of a bold one. */
export const BOLD = 7.2;

/** A force that rolls. @param {any} rolling @param {string} unit @returns {string} */
export function rollingWords(rolling, unit) {
  const friction = rolling?.friction ? `, μ ${exact(Number(rolling.friction))}` : '';
  return `${exact(Number(rolling?.force))} ${unit} rolling${friction}`;
}

/** The way of a load that rolls, beside the arrow of its force; there and back it has two heads. @param {import('../types.js').Job} job @param {number} x @param {number} y of that arrow @returns {SVGElement[]} */
export const travel = ({ load }, x, y) =>
  load?.rolling
    ? [
        svg('path', {
          class: 'arrow',
          'data-travel': '',
          d: `M${x - 38} ${y}h26m-5 -3.5l5 3.5l-5 3.5${load.rolling.alternating ? 'm-16 -7l-5 3.5l5 3.5' : ''}`,
        }),
      ]
    : [];

/** What presses the bodies, as short as there is room. @param {import('../types.js').Job} job @returns {string} */
export function loadLine(job) {
  const kind = loadOf(job.load);
  const value = job.load?.[kind];
  if (kind === 'onset' || kind === 'target') {
    const wanted = TARGETS[targetOf(job.load)].label.toLowerCase();
    return `P = ? (${kind === 'onset' ? 'first yield' : wanted})`;
  }
  if (kind === 'hardness') return value.scale ?? value;
  const [force, approach] = [unit(forceOf(job), unitsOf(job)), unit('length', unitsOf(job))];
  if (kind === 'rolling') return `P = ${rollingWords(value, force)}`;
  if (kind === 'history') {
    const words = [undefined, 0].map((few) =>
      historyWords(value, { force, approach }, { is: ' = ', few }),
    );
    return words.find((one) => BOLD * one.length < WIDTH - 8) ?? `${value.length} loads`;
  }
  /** @type {number[]} */
  const list = [value].flat().filter((one) => Number.isFinite(one));
  const [letter, name] = kind.startsWith('approach') ? ['α', approach] : ['P', force];
  return `${letter} = ${list.length > 1 ? sweepWords(list) : exact(list[0])} ${name}`;
}
