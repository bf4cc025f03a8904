/** The figures of a step: rows of its answers, by their names. */

/** @typedef {Partial<Pick<import('../types.js').Step, 'answers'>>} Rows of a step, or of a whole job */
/** @typedef {import('../wire.js').Answer} Row */

/** The first row of a name: of bodies that of the one that decides. @param {Rows} step @param {...string} names the first that there is @returns {Row | undefined} */
export const rowOf = ({ answers = [] }, ...names) =>
  names
    .map((name) => answers.find((one) => one.name === name))
    .find((found) => found !== undefined);

/** @param {Rows} step @param {...string} names @returns {number | null} */
export const valueIn = (step, ...names) => rowOf(step, ...names)?.value ?? null;

/** Names of half the width of a contact, along its shorter side. */
export const WIDTH = ['half_width', 'semi_axis_a'];

/** Names of the approach, under a load and without one. */
export const APPROACH = ['approach', 'permanent_approach'];

/** @param {import('../types.js').Step} step of one that was stopped what it asked for */
export const forceIn = (step) => valueIn(step, 'force') ?? step.load.force ?? 0;

/** @param {Rows} step 0 where it is not known */
export const approachIn = (step) => valueIn(step, ...APPROACH) ?? 0;

/** @param {Rows} step 0 where it is not known */
export const widthIn = (step) => valueIn(step, ...WIDTH) ?? 0;

/** x of the largest pressure. @param {Rows} step */
export const peakIn = (step) => rowOf(step, 'peak_pressure')?.place?.x ?? 0;

/** Whether a body has yielded. @param {Rows} step */
export const hasYielded = (step) => rowOf(step, 'plastic_depth') !== undefined;

/** Hertz's contact beside this one. @param {Rows} step @returns {{half_width: number, peak_pressure: number} | null} */
export function hertzIn(step) {
  const [half_width, peak_pressure] = [rowOf(step, ...WIDTH), rowOf(step, 'peak_pressure')].map(
    (row) => row?.elastic ?? 0,
  );
  return half_width > 0 && peak_pressure > 0 ? { half_width, peak_pressure } : null;
}

/** The bound of its relative error: 0 of what is given or exact. @param {Row} row @returns {number | null} */
export const boundOf = ({ error }) =>
  typeof error === 'number' ? error : error === 'not_bounded' ? null : 0;
