/**
 * A field of the form: its description, the values its reading depends on, and its control.
 */

/** @typedef {import('../lib/units.js').Quantity} Quantity */
/**
 * @typedef {object} Field
 * @property {string} key below its parent's pointer
 * @property {string} label
 * @property {string} [symbol]
 * @property {Quantity | 'load'} [quantity] `load`: a force, in the unit of the analysis
 * @property {'number' | 'list' | 'history' | 'points' | 'terms' | 'choice' | 'flag' | 'tags' | 'heights' | 'text'} [kind] `number` unless said otherwise
 * @property {Record<string, string>} [choices] value: label
 * @property {string} [hint]
 * @property {string} [help] key of its explanation, where it is not its own
 * @property {Quantity[]} [columns] quantities of points or terms
 * @property {string[]} [members] names of the figures of a term
 * @property {[number, number]} [bounds] between which a slider moves
 * @property {string} [description]
 * @property {number | [number, number][]} [example] typical, in mm, N, MPa
 * @property {string} [unit] of figures that have the same in every system
 * @property {number} [longest] letters that a text may have
 * @property {string} [none] what a choice that is not made is called
 * @property {boolean} [optional] a choice that is not made is the service's, where `DEFAULTS` does not say which
 */
/** @typedef {{label: string, description?: string, fields: Field[]}} Kind */
/**
 * @typedef {object} Surroundings of a field: what its reading depends on beside its text
 * @property {() => import('../lib/units.js').Units} units
 * @property {(field: Field) => Quantity | undefined} quantity
 * @property {(value: number, field: Field) => number} wire a figure in mm, N and MPa, in the units of the job
 * @property {() => Record<string, any> | undefined} parent the object that the field is a key of
 * @property {(values: Record<string, unknown>) => void} beside sets keys of the object that the field is a key of, in one change
 * @property {(values: Record<string, unknown>) => void} inMaterial sets keys of the material of the body
 * @property {(value: number, moving: boolean) => void} [slide] called while a slider moves the figure
 */
/**
 * @typedef {object} Control
 * @property {HTMLInputElement | HTMLSelectElement | HTMLTextAreaElement} input
 * @property {() => unknown} read the value as it goes into the job
 * @property {(value: any) => void} write
 * @property {(value: unknown) => string} [problem] what is wrong with a value, if this can be told without the service
 * @property {Node[]} [beside]
 */

/** What keeps its capitals within a sentence. */
const NAMES = /^(Young|Poisson|Ramberg|Swift|Ludwik|Voce|[A-Z]{2})/;

/** A label within a sentence or on an axis, its index in line. @param {string} label */
export const lowered = (label) =>
  `${NAMES.test(label) ? label[0] : label.charAt(0).toLowerCase()}${label.slice(1)}`.replace(
    '_',
    '',
  );
