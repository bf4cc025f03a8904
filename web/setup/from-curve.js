/**
 * The yield stress behind a record of an indentation: the one with which the indenter goes as deep
 * under the largest force. Every look is a job. Loaded when it is asked for.
 */

import { Problem } from '../api/client.js';
import { newRun, solveOne } from '../jobs/batch.js';
import { dialogue } from '../lib/dialogue.js';
import { h } from '../lib/dom.js';
import { readNumber } from '../lib/number.js';
import { convert, figure, unit } from '../lib/units.js';
import { valueIn } from '../result/rows.js';
import { search } from '../result/search.js';
import { inWords } from './words.js';

/** Size of the specimen, in depths of the dent. */
const [WIDE, DEEP] = [200, 100];
/** Where a material has no yield stress to begin with [MPa], and a hardening over Young's modulus. */
const [BEGIN, HARDENING] = [500, 0.01];

/**
 * @param {number[][]} points penetration and force, in the units of the job
 * @param {Record<string, any>} material that the specimen has but for its yield stress
 * @param {import('../lib/units.js').Units} units
 * @param {(plasticity: Record<string, any>) => void} use
 */
export function askMaterial(points, material, units, use) {
  const [depth, force] = points.reduce((most, point) => (point[1] > most[1] ? point : most));
  const ball = h('input', { type: 'text', inputmode: 'decimal', size: 7 });
  const size = h('label', { hidden: true }, 'Diameter ', ball, ` ${unit('length', units)}`);
  const indenter = h(
    'select',
    { onchange: () => (size.hidden = indenter.selectedIndex === 0) },
    ['Berkovich', 'Ball'].map((one) => h('option', {}, one)),
  );
  const said = h('p', { role: 'status' });
  const running = new AbortController();
  const before = material.plasticity;
  const law = before?.yield_stress > 0
    ? before
    : { law: 'bilinear', yield_stress: convert(BEGIN, 'stress', 'mm_N_MPa', units), tangent_modulus: HARDENING * material.young_modulus }; // prettier-ignore
  /** @type {Record<string, any> | undefined} */
  let found;
  const box = dialogue(
    'Material from an indentation',
    [
      h('p', {}, `${points.length} points: ${figure(force, 4)} ${unit('force', units)} at a depth of ${figure(depth, 4)} ${unit('length', units)}. Found is the yield stress with which the indenter goes as deep; Young’s modulus and hardening are those of the form. What the frame of the machine gives way is to be taken off before.`), // prettier-ignore
      h('p', { class: 'bar' }, h('label', {}, 'Indenter ', indenter), size),
      said,
    ],
    'Find',
    () => {
      if (found) {
        use(found);
        return '';
      }
      const isBall = indenter.selectedIndex === 1;
      const diameter = readNumber(ball.value);
      if (isBall && !('value' in diameter && diameter.value > 0))
        return 'The ball has a diameter.';
      const scale = isBall ? { scale: 'sphere', ball: 'value' in diameter && diameter.value } : { scale: 'berkovich' }; // prettier-ignore
      let count = 0;
      const run = newRun();
      let reason = '';
      const look = async (/** @type {number} */ at) => {
        count += 1;
        said.textContent = `Look ${count}: yield stress ${figure(at, 4)} ${unit('stress', units)}…`;
        const { report, problem } = await solveOne(
          {
            tags: { varied: `Yield stress ${figure(at, 4)} ${unit('stress', units)}` },
            units,
            lower: {
              shape: { type: 'block', width: WIDE * depth, depth: DEEP * depth },
              material: { ...material, plasticity: { ...law, yield_stress: at } },
            },
            load: { hardness: { ...scale, force } },
            output: { subsurface: false },
          },
          running.signal,
          run,
        );
        reason ||= problem ?? '';
        return (report && valueIn(report, 'indentation_depth')) ?? NaN;
      };
      search(look, law.yield_stress, depth, () => running.signal.aborted || reason !== '').then(
        ({ best, found: isFound }) => {
          said.textContent = isFound
            ? `Yield stress ${figure(best.at, 4)} ${unit('stress', units)} after ${count} looks.`
            : `Not found: ${inWords(reason) || `the nearest depth is ${figure(best.value, 4)} ${unit('length', units)}`}.`; // prettier-ignore
          if (isFound) box.querySelector('.primary')?.replaceChildren('Use it');
          if (isFound) found = { ...law, yield_stress: Number(best.at.toPrecision(4)) };
        },
        (error) => {
          if (running.signal.aborted) return;
          if (!(error instanceof Problem)) throw error;
          said.textContent = error.message;
        },
      );
      return true;
    },
    () => running.abort(),
  );
}
