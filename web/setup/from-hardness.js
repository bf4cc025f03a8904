/** Strengths from a hardness. Loaded when it is asked for. */

import { dialogue } from '../lib/dialogue.js';
import { h } from '../lib/dom.js';
import { readNumber } from '../lib/number.js';
import { ROCKWELL } from './tables.js';

/**
 * Yield strength of a steel from its Vickers hardness: Pavlina and Van Tyne, J. Mater. Eng.
 * Perform. 17 (2008) 888, a line through some 150 steels from 300 to 1700 MPa. [MPa]
 * @param {number} hardness
 */
const strengthOf = (hardness) => -90.7 + 2.876 * hardness;

/** Hardnesses for which the line stands. */
const [SOFTEST, HARDEST] = [136, 622];
/** Brinell over Vickers hardness, ISO 18265. */
const BRINELL = 0.95;
/** @param {number} value @param {string} scale @returns {number} Vickers hardness; nothing where the table has none */
export function vickersOf(value, scale) {
  if (scale === 'HBW') return value / BRINELL;
  if (scale !== 'HRC') return value;
  const next = ROCKWELL.findIndex(([rockwell]) => rockwell >= value);
  if (next < 1) return value === ROCKWELL[0][0] ? ROCKWELL[0][1] : NaN;
  const [[c0, v0], [c1, v1]] = [ROCKWELL[next - 1], ROCKWELL[next]];
  return v0 + ((v1 - v0) * (value - c0)) / (c1 - c0);
}

/** @param {(material: Record<string, any>) => void} use */
export function askHardness(use) {
  const figure = h('input', { type: 'text', inputmode: 'decimal' });
  const scale = h(
    'select',
    {},
    h('option', { value: 'HV' }, 'HV'),
    h('option', { value: 'HBW' }, 'HBW'),
    h('option', { value: 'HRC' }, 'HRC'),
  );
  dialogue(
    'Yield stress from hardness',
    [
      h(
        'p',
        { class: 'bar' },
        h('label', {}, 'Hardness ', figure),
        h('label', {}, 'Scale ', scale),
      ),
      h(
        'p',
        { class: 'quiet' },
        'σy = 2.876 HV − 90.7 MPa, Pavlina and Van Tyne 2008: a line through steels of 300 to 1700 MPa. Rails go by hardness: R260 has 260–300 HBW, R350HT 350–390 HBW (EN 13674-1). HBW and HRC become HV by ISO 18265, table A.1.',
      ),
    ],
    'Use',
    () => {
      const reading = readNumber(figure.value);
      if ('problem' in reading) return reading.problem;
      const vickers = vickersOf(reading.value, scale.value);
      if (!(vickers >= SOFTEST && vickers <= HARDEST)) {
        const is =
          scale.value !== 'HV' && vickers
            ? `${reading.value} ${scale.value} is ${Math.round(vickers)} HV. `
            : '';
        return `${is}The line stands for ${SOFTEST} to ${HARDEST} HV${scale.value === 'HRC' ? ', 20.3 to 56.3 HRC' : ''}.`;
      }
      use({
        young_modulus: 210000,
        poisson_ratio: 0.3,
        plasticity: {
          law: 'bilinear',
          yield_stress: Math.round(strengthOf(vickers)),
          tangent_modulus: 2100,
        },
      });
      return '';
    },
  );
}
