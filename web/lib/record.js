/**
 * Records of tests as testing machines write them: which columns are strain and stress, which are
 * force and travel of a specimen, which are force and depth of an indentation. The Python package
 * reads them by the same rules, and both meet `tests/measured/tables.json`.
 */

import { FACTS, ROLES } from './columns.js';
import { hasDecimalComma, parted, quoted, readNumber } from './number.js';
import { inJobUnits, isUnit } from './units.js';

/** @typedef {import('./units.js').Quantity} Quantity */
/**
 * @typedef {{number: number, cells: string[], comment: boolean}} Row a line of the text, counted
 *   from 1
 */
/** @typedef {{name: string, unit: string, role: string}} Column */
/**
 * @typedef {object} Choice what is pointed at where the names do not tell, or tell something else
 * @property {number[]} [columns] of strain and stress, or of travel and force
 * @property {string[]} [units] of these
 * @property {'engineering' | 'true'} [measure]
 * @property {number} [section] of the specimen [mm²]
 * @property {number} [gauge_length] [mm]
 */
/**
 * @typedef {object} Record a record of a test
 * @property {'engineering' | 'true' | 'force' | 'indentation'} measure `force`: travel and force
 * @property {number[][]} points strain and stress [1, MPa], or penetration and force [mm, N]
 * @property {string[]} notes
 * @property {Column[]} columns
 * @property {Choice} choice what was taken
 * @property {string} [problem] what is to be chosen before there are points
 */

const QUANTITIES = /** @type {{[role: string]: Quantity}} */ ({
  plastic_strain: 'strain',
  true_strain: 'strain',
  engineering_strain: 'strain',
  strain: 'strain',
  true_stress: 'stress',
  engineering_stress: 'stress',
  stress: 'stress',
  force: 'force',
  extension: 'length',
  travel: 'length',
  penetration: 'length',
});
/** Columns that make a record, the first that are there. @type {[Record['measure'] | 'plastic', string[], string[]][]} */
const PAIRS = [
  ['plastic', ['plastic_strain'], ['true_stress', 'stress', 'engineering_stress']],
  ['true', ['true_strain'], ['true_stress', 'stress']],
  ['engineering', ['engineering_strain', 'strain'], ['engineering_stress', 'stress']],
  ['true', ['strain'], ['true_stress']],
  ['force', ['extension', 'travel'], ['force']],
  ['indentation', ['penetration', 'travel', 'depth'], ['force']],
];
/** Lengths by which a record is one of an indentation, whatever its column is called [mm]. */
const SMALL = 0.1;
/** Share of the largest stress below which the first one is that of a record, not of a curve that begins at yield. */
const BEGINS = 0.2;
/** Ratio to Young’s modulus within which a first slope tells the unit of the strains. */
const ALIKE = 3;
const EXTENSOMETER = /extenso|fein|strain 1|dehnungsaufnehmer/i;

const compile = (/** @type {{[name: string]: string}} */ words) =>
  Object.entries(words).map(([name, text]) => ({ name, called: new RegExp(`^(${text})$`, 'u') }));
const [CALLED, KNOWN] = [compile(ROLES), compile(FACTS)];

/** @param {string} name as the vocabulary has it */
const plain = (name) =>
  name
    .normalize('NFC')
    .toLowerCase()
    .replace(/[[(][^\])]*[\])]?/g, '')
    .replace(/[\s_.:'"/-]/g, '');

/**
 * Name and unit of a header: the unit in brackets, or behind the last words.
 * @param {string} header
 * @returns {[name: string, unit: string]}
 */
export function partsOf(header) {
  const [, before, bracketed] = /^(.*?)[[(]([^\])]+)[\])]$/.exec(header) ?? [];
  if (bracketed) return [before.trim(), bracketed.trim()];
  const start = [0, ...[...header.matchAll(/[\s/,_]/g)].map(({ index }) => index + 1)];
  const at = start.find((from) => isUnit(header.slice(from).trim()));
  return at === undefined
    ? [header, '']
    : [header.slice(0, at).replace(/(\sin)?[\s/,_]*$/, ''), header.slice(at).trim()];
}

/** A cell of a line of units: in brackets, or one that is known. @param {string} cell */
const isUnitCell = (cell) => /^[[(].*[\])]$/.test(cell) || isUnit(cell) || /^(s|sec|min|°C|Hz|)$/.test(cell); // prettier-ignore

/** @param {string} name @param {string} unit @returns {string} what a column is, by its name and a unit of its quantity */
function roleOf(name, unit) {
  const fits = (/** @type {string} */ role) =>
    !unit || !QUANTITIES[role] || inJobUnits(1, unit, QUANTITIES[role], 'mm_N_MPa') !== undefined;
  const word = plain(name);
  return (
    (word && CALLED.find(({ name: role, called }) => called.test(word) && fits(role))?.name) || ''
  );
}

/** Columns as the lines above the figures name them. @param {Row[]} headers @returns {Column[]} */
function columnsOf(headers) {
  const isTaken = (/** @type {string[]} */ cells) =>
    cells.length > 1 && !/^[-+]?[.,\d]/.test(cells[1]);
  const named = headers.findLast(
    ({ cells }) => isTaken(cells) && cells.filter((cell) => roleOf(...partsOf(cell))).length > 1,
  );
  const units = headers.findLast(
    (row) => row !== named && row.cells.length > 1 && row.cells.every(isUnitCell),
  );
  return (named?.cells ?? []).map((cell, k) => {
    const below = (units?.cells[k] ?? '').replace(/^[[(]|[\])]$/g, '').trim();
    const [name, beside] = partsOf(cell);
    const unit = isUnit(below) ? below : isUnit(beside) ? beside : '';
    return { name: cell, unit, role: roleOf(unit === beside ? name : cell, unit) };
  });
}

/**
 * Figures of the specimen, `Diameter (mm);10.00`, `Diameter;10.00;mm`, `Diameter: 10 mm`.
 * @param {Row[]} headers @returns {{[fact: string]: number}} in mm and mm²
 */
function factsOf(headers) {
  const facts = /** @type {{[fact: string]: number}} */ ({});
  for (const { cells } of headers) {
    const [whole, figure, behind] = cells.length > 1 ? cells : cells[0].split(/[:=]\s*/);
    if (!figure) continue;
    const [name, unit] = partsOf(whole);
    const { digits, name: own } = parted(figure);
    const reading = readNumber(digits, hasDecimalComma(digits));
    const fact = KNOWN.find(({ called }) => called.test(plain(name)))?.name;
    if (!fact || 'problem' in reading || !(reading.value > 0)) continue;
    const of = (own || unit || behind || 'mm').replace(/[[()\]]/g, '').replace(/\^?[2²]$/, '');
    const one = inJobUnits(1, of, 'length', 'mm_N_MPa');
    if (one) facts[fact] = reading.value * one ** (fact === 'section' ? 2 : 1);
  }
  const { diameter, width, thickness } = facts;
  facts.section ??= diameter ? (Math.PI / 4) * diameter ** 2 : width * thickness;
  return facts;
}

/** Whether a curve of stress over strain begins at nothing, as a record does. @param {number[][]} points */
export const beginsAtNothing = (points) =>
  Math.abs(points[0]?.[1]) < BEGINS * Math.max(...points.map(([, stress]) => Math.abs(stress)));

/**
 * The unit of strains by the first slope: per cent where that is Young’s modulus, and not a
 * hundredth of it.
 * @param {number[][]} points [?, MPa] @param {number} modulus [MPa] @returns {string} nothing where neither is
 */
function strainUnit(points, modulus) {
  const most = Math.max(...points.map(([, stress]) => stress));
  const first = points.filter(([strain, stress], k) => k > 0 && strain > 0 && stress > 0 && stress < 0.5 * most); // prettier-ignore
  const slopes = first.map(([strain, stress]) => stress / strain).sort((a, b) => a - b);
  const slope = slopes[Math.floor(slopes.length / 2)] ?? NaN;
  const near = (/** @type {number} */ times) =>
    slope * times > modulus / ALIKE && slope * times < modulus * ALIKE;
  return near(100) ? '%' : near(1) ? '1' : '';
}

/**
 * @param {Row[]} headers lines above the figures
 * @param {Row[]} body
 * @param {number} modulus [MPa] that tells per cent where no unit does
 * @param {Choice} [choice]
 * @returns {Record | undefined} nothing where the table is none
 */
export function recordOf(headers, body, modulus, choice = {}) {
  const columns = columnsOf(headers);
  const found = (/** @type {string[]} */ roles) => {
    const those = roles.flatMap((role) =>
      columns.flatMap((one, k) => (one.role === role ? [k] : [])),
    );
    return those.find((k) => EXTENSOMETER.test(columns[k].name)) ?? those[0] ?? -1;
  };
  const pair = PAIRS.find(([, a, b]) => found(a) >= 0 && found(b) >= 0);
  const at = choice.columns ?? (pair ? [found(pair[1]), found(pair[2])] : []);
  if (!at.length || pair?.[0] === 'plastic') return undefined;
  const quantities = at.map((k) => QUANTITIES[columns[k]?.role]);
  const units = [...(choice.units ?? at.map((k) => columns[k]?.unit ?? ''))];
  const isForce = inJobUnits(1, units[1], 'force', 'mm_N_MPa') !== undefined || (!units[1] && quantities[1] === 'force'); // prettier-ignore
  const kinds = /** @type {Quantity[]} */ (isForce ? ['length', 'force'] : ['strain', 'stress']);
  const record = /** @type {Record} */ ({
    measure: choice.measure ?? pair?.[0] ?? 'engineering',
    points: [],
    notes: [],
    columns,
    choice: { ...choice, columns: at, units },
  });
  const ask = (/** @type {string} */ problem) => ({ ...record, problem });
  const used = (/** @type {Row} */ { cells }) => at.map((k) => cells[k] ?? '');
  const commas = body.some(({ cells }) => cells.some(hasDecimalComma));
  const rows = body.filter((row) => used(row).every(Boolean));
  for (const row of rows) {
    const readings = used(row).map((cell) => readNumber(cell, commas));
    const fault = readings.find((one) => 'problem' in one);
    if (fault && 'problem' in fault) return ask(`line ${row.number}: ${fault.problem}`);
    record.points.push(readings.map((one) => ('value' in one ? one.value : NaN)));
  }
  const less = body.length - rows.length;
  if (less) record.notes.push(`${less} line${less > 1 ? 's' : ''} without a figure in these columns left out`); // prettier-ignore
  if (record.points.every(([, up]) => up <= 0))
    return ask(`${quoted(columns[at[1]]?.name ?? `column ${at[1] + 1}`)} has no figure above 0: write a test in compression as true strain and true stress without signs`); // prettier-ignore
  // Without a word of what they are, figures that begin at yield are a hardening curve.
  const isSure = choice.columns || columns.some(({ role }) => role.startsWith('engineering'));
  if (!isForce && !isSure && !beginsAtNothing(record.points)) return undefined;
  if (kinds[0] === 'strain' && !(units[0] && units[1])) {
    const one = inJobUnits(1, units[1] || 'MPa', 'stress', 'mm_N_MPa') ?? NaN;
    const told = strainUnit(record.points.map(([e, s]) => [e, s * one]), modulus); // prettier-ignore
    if (told && !units[0]) {
      units[0] = told;
      record.notes.push(`strain taken for ${told === '%' ? 'per cent' : 'a share'}, by the first slope`); // prettier-ignore
    }
    // Megapascals are what the slope is Young's modulus by.
    if (
      told &&
      !units[1] &&
      inJobUnits(1, told, 'strain', 'mm_N_MPa') === inJobUnits(1, units[0], 'strain', 'mm_N_MPa')
    ) {
      units[1] = 'MPa';
      record.notes.push('stress taken for MPa, by the first slope');
    }
  }
  for (const [axis, kind] of kinds.entries()) {
    const one = inJobUnits(1, units[axis], kind, 'mm_N_MPa');
    const name = columns[at[axis]]?.name ?? `column ${at[axis] + 1}`;
    if (one === undefined) return ask(`the unit of ${quoted(name)} is not said: choose it`);
    // Digits that are lost by a factor come back by rounding.
    for (const point of record.points) point[axis] = Number((point[axis] * one).toPrecision(12));
    record.notes.push(`${['along', 'up'][axis]}: ${quoted(name)}${units[axis] ? ` in ${units[axis]}` : ''}`); // prettier-ignore
  }
  if (!isForce) return record;
  const facts = factsOf(headers);
  const { section = facts.section, gauge_length: length = facts.gauge_length } = choice;
  const reach = Math.max(...record.points.map(([travel]) => Math.abs(travel)));
  if (pair?.[0] === 'indentation' || (reach < SMALL && !(section > 0 && length > 0)))
    return { ...record, measure: 'indentation' };
  record.choice = { ...record.choice, section, gauge_length: length };
  record.measure = 'force';
  if (!(section > 0 && length > 0))
    return ask('force over travel: the section of the specimen and its gauge length make stress and strain of it'); // prettier-ignore
  record.notes.push(
    `section ${Number(section.toPrecision(6))} mm², gauge length ${length} mm${choice.section ? '' : ' as the file says'}`,
  );
  if (columns[at[0]]?.role === 'travel')
    record.notes.push('travel of the machine, which bends too: the first slope is softer than the specimen’s'); // prettier-ignore
  const points = record.points.map(([travel, force]) =>
    [travel / length, force / section].map((one) => Number(one.toPrecision(12))),
  );
  return { ...record, measure: 'engineering', points };
}
