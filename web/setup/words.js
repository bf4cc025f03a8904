/** Keys of the job in messages of the service, as the form calls them. */

import { plain } from '../lib/units.js';
import { lowered } from './field.js';
import { LOADS, SHAPES, allFields } from './fields.js';

const PLAIN = ['analysis', 'units', 'support', 'theory', 'shape', 'material', 'load'];
const LABELS = new Map([
  ...PLAIN.map((key) => /** @type {[string, string]} */ ([key, key])),
  ['law', 'hardening'],
  ['type', 'shape'],
  ...Object.keys(SHAPES).map((key) => /** @type {[string, string]} */ ([key, key])),
  ...allFields().map(
    ({ key, label }) =>
      /** @type {[string, string]} */ ([key.slice(key.lastIndexOf('/') + 1), lowered(label)]),
  ),
  ['profile', 'profile'],
  ['interpolation', '“Between points”'],
  ['strain_unit', 'unit of the strains'],
  ['stress_unit', 'unit of the stresses'],
  ['onset', `“${LOADS.onset.label}” as the load`],
]);

/** @param {string} words */
const titled = (words) => `“${words[0].toUpperCase()}${words.slice(1)}”`;

/** What a key in back-quotes is called: a setting by the name under which it is looked for. @param {string} _ @param {string} key */
function called(_, key) {
  const last = key.slice(key.search(/[^./]*$/));
  const name = LABELS.get(last) ?? `“${last}”`;
  return /^(solver|mesh)\./.test(key) && LABELS.has(last) ? titled(name) : name;
}

/** What the service says to programs, and people are not told so. @type {[RegExp, string][]} */
const PLAINER = [
  [/ \(units \w+\)/g, ''],
  [/ \(`\{"rigid": true\}`\)/g, ' (Rigid under Hardening)'],
  [/\bits `interpolation` to\b/g, '`interpolation` to'],
  [/"([^"]*)"/g, '“$1”'],
  [/(\d)\.0{3,}(?!\d)/g, '$1'],
  [/must have between (\d+) and (\d+) items, got 0/g, 'is empty: $1 to $2 are needed'],
  [/must have between (\d+) and (\d+) items/g, 'must have $1 to $2 lines or numbers'],
  [/must be an array of (\d) numbers/g, 'must be $1 numbers'],
  [/must be (.*), got an? (string|array|object|boolean)$/g, 'must be $1'],
];

/** What a table of the solver says of a figure, for who reads it beside the form. @param {string} description */
export const described = (description) =>
  (BRIEF[description] ?? description)
    .replace(/`\[(\w+), (\w+)\]`/g, (_, one, other) => `of ${one.replace('_', ' ')} and ${other}`)
    .replace(/`(\w+)`/g, (_, key) => LABELS.get(key) ?? `“${key.replace('_', ' ')}”`);

/** What says no more than the label. @type {Record<string, string | undefined>} */
const BRIEF = {
  'Radius.': 'Half the diameter of the cylinder, of the sphere in axisymmetry.',
  'Exponent n.':
    'How straight the curve is: 0 does not harden, 1 is a straight line; steels have 0.1 to 0.5.',
  'Offset a.': 'Plastic strain at the reference stress, over σ0/E.',
  'Coefficient k.': 'Stress by which the curve has risen at a plastic strain of 1.',
  'Rate b.':
    'How soon the curve is near its saturation: 63 % of the way at a plastic strain of 1/b.',
};

/** @param {string} message in which keys stand between back-quotes */
export const inWords = (message) =>
  PLAINER.reduce((words, [pattern, plain]) => words.replace(pattern, plain), message)
    // Behind the words that it means, a key says nothing more.
    .replace(/ \(`[\w./]+`\)/g, '')
    .replace(/\b(the )?theory `flow`/g, 'flow theory')
    .replace(
      /\b(see|remark) `(\w+)`/g,
      (_, before, code) =>
        `${before === 'see' ? 'see the ' : ''}remark ${titled(code.replaceAll('_', ' '))}`,
    )
    .replace(/`([\w./]+)`/g, called)
    // Powers of ten as the page writes them.
    .replace(/(?<![\w.])\d(?:\.\d+)?e[+-]?\d+(?![\w.])/g, (number) => plain(Number(number)));
