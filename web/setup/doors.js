/**
 * What the page is for, in six pictures, each of which fills the form; and the ways to what there
 * is already: a job in a file, the last results.
 */

import { button, h, svg, toast } from '../lib/dom.js';
import { isObject } from '../lib/kept.js';
import { textOf } from '../lib/text-file.js';
import { doorOf } from './layout.js';

/** @typedef {import('../types.js').Job} Job */
/** @typedef {import('./layout.js').Door} Door */
/** @typedef {{title: string, words: string, example: string, bodies: string, lines: string, marks: string}} Picture paths: filled, drawn, and in the colour of what is meant */

/** @type {Record<Door, Picture>} */
const DOORS = {
  press: {
    title: 'Press two bodies',
    words: 'Rollers, blocks, pins, spheres: pressure, yield, the dent that is left',
    example: 'two_cylinders',
    bodies: 'M34 6h52a26 26 0 0 1-52 0zM34 58h52a26 26 0 0 0-52 0z',
    lines: 'M34 6h52M34 58h52',
    marks: 'M50 27a10 5 0 0 1 20 0zM50 37a10 5 0 0 0 20 0z',
  },
  raceway: {
    title: 'Ball or roller in a raceway',
    words: 'Curved bodies in three dimensions: ellipse, tilt, edge pressure',
    example: 'ball_in_raceway',
    bodies: 'M42 29a18 18 0 0 1 36 0a18 18 0 0 1-36 0zM12 30q48 34 96 0v30h-96z',
    lines: 'M12 30q48 34 96 0',
    marks: 'M48 46a12 3.500 0 0 1 24 0a12 3.500 0 0 1-24 0z',
  },
  rolling: {
    title: 'Roll it',
    words: 'Pass by pass: shakedown or ratcheting, the groove, the stress that stays',
    example: 'rail_under_driven_wheel',
    bodies: 'M22 24a20 20 0 0 1 40 0a20 20 0 0 1-40 0zM8 44h104v16h-104z',
    lines: 'M42 4v40M22 24h40M8 44h104',
    marks: 'M70 21h26v-5l12 8l-12 8v-5h-26zM14 49h92v3h-92z',
  },
  hardness: {
    title: 'Hardness and indentation',
    words: 'Brinell, Vickers, Rockwell of a flow curve: number, dent, pile-up',
    example: 'brinell_test',
    bodies:
      'M41 22a19 19 0 0 1 38 0a19 19 0 0 1-38 0zM8 34h28q6-5 9-2q15 18 30 0q3-3 9 2h28v26h-104z',
    lines: 'M8 34h28q6-5 9-2q15 18 30 0q3-3 9 2h28',
    marks: 'M42 41q18 22 36 0q-4 3-8 3q-10 5-20 0q-4 0-8-3z',
  },
  surface: {
    title: 'Measured surface',
    words: 'Heights from a profiler: real contact area, where asperities yield',
    example: 'rough_patch',
    bodies:
      'M8 4h104v16h-104zM8 36l8-6 7 8 9-18 7 14 8-4 7 8 9-18 8 15 7-6 8 9 9-16 8 12 7-6V60H8z',
    lines: 'M8 36l8-6 7 8 9-18 7 14 8-4 7 8 9-18 8 15 7-6 8 9 9-16 8 12 7-6M8 20h104',
    marks: 'M28 20h8l-4 9zM67 20h8l-4 9z',
  },
  depth: {
    title: 'Case depth and residual stress',
    words: 'Hardness over depth, peening, grinding: does the core hold?',
    example: 'case_hardened_roller',
    bodies: 'M12 4h52a26 26 0 0 1-52 0zM8 30h62v30h-62z',
    lines: 'M80 8v50h34M80 14h6c12 0 6 30 28 32',
    marks: 'M8 30h62v8h-62z',
  },
};

export class Doors {
  /**
   * @param {import('./draft.js').Draft} draft
   * @param {Promise<import('./examples.js').Example[]>} examples
   * @param {() => void} last called to show the last results
   */
  constructor(draft, examples, last) {
    const use = async (/** @type {string} */ name) => {
      const job = (await examples).find((one) => one.name === name)?.job;
      if (job) draft.replace(job, 'example');
      if (innerWidth <= 900) document.getElementById('setup')?.scrollIntoView();
    };
    const doors = Object.entries(DOORS).map(([door, picture]) =>
      h(
        'button',
        { type: 'button', 'data-door': door, onclick: () => use(picture.example) },
        drawing(picture),
        h('b', {}, picture.title),
        h('span', {}, picture.words),
      ),
    );
    const file = h('input', {
      type: 'file',
      accept: '.json,application/json',
      hidden: true,
      onchange: async () => {
        const job = file.files?.[0] && (await jobIn(file.files[0]));
        if (job) draft.replace(job, 'link');
        file.value = '';
      },
    });
    this.element = h(
      'div',
      { class: 'doors' },
      h(
        'p',
        {},
        h('b', {}, 'Two bodies in contact, beyond yield.'),
        ' Pressure, stress below the surface, the dent that stays, each with its error. Begin with a picture: it fills the form.',
      ),
      h('div', { class: 'six' }, doors),
      h(
        'div',
        { class: 'bar' },
        button('Open a job…', () => file.click()),
        file,
        button('Last results', last),
        h('span', { class: 'quiet' }, 'a JSON file, as Download saves it'),
      ),
    );
    draft.addEventListener('change', () => {
      const door = doorOf(draft.job);
      for (const one of doors) one.setAttribute('aria-pressed', String(one.dataset.door === door));
    });
  }
}

/** @param {Picture} picture */
const drawing = ({ bodies, lines, marks }) =>
  svg(
    'svg',
    { viewBox: '0 0 120 64', 'aria-hidden': 'true' },
    svg('path', { class: 'body', d: bodies }),
    svg('path', { class: 'line', d: lines }),
    svg('path', { class: 'mark', d: marks }),
  );

/** @param {File} file @returns {Promise<Job | undefined>} its job, or nothing after it has been said why */
async function jobIn(file) {
  const read = await textOf(file, 64e6);
  if ('problem' in read) return void toast(read.problem);
  try {
    const job = JSON.parse(read.text.replace(/^\ufeff/, ''));
    if (isObject(job) && 'load' in job) return job;
  } catch {
    // Said below.
  }
  return void toast(`“${file.name}” is not a job: Download saves one as “Job, JSON”`);
}
