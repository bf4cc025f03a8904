/** Quantities, their units in both systems, and how figures are written. */

/**
 * @typedef {'length' | 'stress' | 'force' | 'line_force' | 'area' | 'volume' | 'number' |
 *   'hardness' | 'strain' | 'stiffness' | 'line_stiffness' | 'energy' | 'line_energy'} Quantity
 */
/** @typedef {'mm_N_MPa' | 'SI'} Units of a job */
/**
 * @typedef {{length: string, per: string, stress: string, force: string}} UnitSet `per`: the
 *   length that line loads are counted by
 */

/** @type {Record<Units, UnitSet>} */
const SETS = {
  mm_N_MPa: { length: 'mm', per: 'mm', stress: 'MPa', force: 'N' },
  SI: { length: 'm', per: 'm', stress: 'Pa', force: 'N' },
};

/** Names of units of length, those of one unit beside each other, and what one of it is in SI. */
const LENGTHS = {
  km: 1e3,
  'm meter meters': 1,
  cm: 1e-2,
  'mm millimeter Millimeter': 1e-3,
  'µm um micron microns micrometer micrometers Mikrometer': 1e-6,
  'nm nanometer nanometers Nanometer': 1e-9,
  Å: 1e-10,
  pm: 1e-12,
  'in inch inches ″ "': 0.0254,
  'mil thou': 2.54e-5,
};

/** Names of units and what one of each is in SI. */
const NAMES = /** @type {Partial<Record<Quantity, Record<string, number>>>} */ ({
  length: Object.fromEntries(
    Object.entries(LENGTHS).flatMap(([names, one]) => names.split(' ').map((name) => [name, one])),
  ),
  stress: {
    Pa: 1,
    kPa: 1e3,
    MPa: 1e6,
    'N/m²': 1,
    'kN/m²': 1e3,
    'N/cm²': 1e4,
    'N/mm²': 1e6,
    'kN/cm²': 1e7,
    'kN/mm²': 1e9,
    'kgf/mm²': 9.80665e6,
    GPa: 1e9,
    bar: 1e5,
    psi: 6894.757293168,
    ksi: 6894757.293168,
  },
  force: {
    N: 1,
    µN: 1e-6,
    uN: 1e-6,
    mN: 1e-3,
    kN: 1e3,
    MN: 1e6,
    kgf: 9.80665,
    lbf: 4.4482216152605,
  },
  line_force: {
    'N/m': 1,
    'N/mm': 1e3,
    'kN/m': 1e3,
    'kN/mm': 1e6,
    'lbf/in': 4.4482216152605 / 0.0254,
  },
  strain: {
    '%': 1e-2,
    '‰': 1e-3,
    1: 1,
    '-': 1,
    'm/m': 1,
    'mm/mm': 1,
    'in/in': 1,
    'µm/m': 1e-6,
    µε: 1e-6,
    µstrain: 1e-6,
  },
  number: { 1: 1, '-': 1 },
});

/** @param {string} name as people write it: with spaces, another µ, or a square as a 2 */
const unitName = (name) =>
  name
    .replace(/\s/g, '')
    .replace('μ', 'µ')
    .replace('\u212b', 'Å')
    .replace(/[–—]/, '-')
    .replace(/\^?2$/, '²');

/** Vickers hardness by its names, the load of the test [kgf] behind it. */
const VICKERS = /^(HV|VHN|DPH|DPN)\s?[\d.,/]*$/i;

/** @param {string} name @returns {boolean} whether a unit of any quantity has this name */
export const isUnit = (name) =>
  Object.values(NAMES).some((names) => Object.hasOwn(names, unitName(name)));

/** Powers of the units that the unit of a quantity is made of. @type {Partial<Record<Quantity, Partial<Record<keyof UnitSet, number>>>>} */
const MADE = {
  length: { length: 1 },
  stress: { stress: 1 },
  force: { force: 1 },
  line_force: { force: 1, per: -1 },
  area: { length: 2 },
  volume: { length: 3 },
  stiffness: { force: 1, length: -1 },
  line_stiffness: { force: 1, per: -1, length: -1 },
  energy: { force: 1, length: 1 },
  line_energy: { force: 1, per: -1, length: 1 },
};

/** @param {Quantity} quantity @param {UnitSet} set @returns {number} one of its units in SI */
function inSi(quantity, set) {
  return Object.entries(MADE[quantity] ?? {}).reduce((product, [name, power]) => {
    const kind = /** @type {'length' | 'stress' | 'force'} */ (name === 'per' ? 'length' : name);
    const one = NAMES[kind]?.[set[/** @type {keyof UnitSet} */ (name)]] ?? NaN;
    return product * one ** power;
  }, 1);
}

/** @param {Units | UnitSet} units @returns {UnitSet} */
export const setOf = (units) => (typeof units === 'string' ? SETS[units] : units);

/**
 * @param {Quantity} quantity
 * @param {Units | UnitSet} from
 * @param {Units | UnitSet} to
 * @returns {number}
 */
export function factor(quantity, from, to) {
  const [a, b] = [setOf(from), setOf(to)];
  return unit(quantity, a) === unit(quantity, b)
    ? 1
    : Number((inSi(quantity, a) / inSi(quantity, b)).toPrecision(15));
}

/**
 * @param {number} value
 * @param {string} name of its unit
 * @param {Quantity} quantity
 * @param {Units} units of the job
 * @returns {number | undefined} in these; `undefined` if the unit is none of this quantity
 */
export function inJobUnits(value, name, quantity, units) {
  if (quantity === 'hardness') return VICKERS.test(name.trim()) ? value : undefined;
  const names = NAMES[quantity];
  const key = unitName(name);
  if (!names || !Object.hasOwn(names, key)) return undefined;
  const given = names[key];
  const own = inSi(quantity, SETS[units]);
  return given === own ? value : Number(((value * given) / own).toPrecision(15));
}

/** @param {{units?: unknown}} job @returns {Units} */
export const unitsOf = (job) => (job.units === 'SI' ? 'SI' : 'mm_N_MPa');

/**
 * Whether a force is a total force rather than a force per length.
 * @param {{analysis?: unknown}} job
 */
const isWhole = ({ analysis }) => analysis === 'axisymmetric' || analysis === 'three_dimensional';

/** @param {{analysis?: unknown}} job @returns {Quantity} of its load */
export const forceOf = (job) => (isWhole(job) ? 'force' : 'line_force');

/** @param {{analysis?: unknown}} job @returns {Quantity} of its dP/dα */
export const stiffnessOf = (job) => (isWhole(job) ? 'stiffness' : 'line_stiffness');

/** @param {{analysis?: unknown}} job @returns {Quantity} of its work */
export const energyOf = (job) => (isWhole(job) ? 'energy' : 'line_energy');

/** @param {Quantity} quantity @param {Units | UnitSet} units @returns {string} name of its unit */
export function unit(quantity, units) {
  const { length, per, stress, force } = setOf(units);
  switch (quantity) {
    case 'length':
      return length;
    case 'stress':
      return stress;
    case 'force':
      return force;
    case 'line_force':
      return `${force}/${per}`;
    case 'area':
      return `${length}²`;
    case 'volume':
      return `${length}³`;
    case 'stiffness':
      return `${force}/${length}`;
    case 'line_stiffness':
      return length === per ? `${force}/${per}²` : `${force}/(${per}·${length})`;
    case 'energy':
      return `${force}·${length}`;
    case 'line_energy':
      return length === per ? force : `${force}·${length}/${per}`;
    case 'hardness':
      return 'HV';
    default:
      return '';
  }
}

/**
 * @param {number} value
 * @param {Quantity} quantity
 * @param {Units} from
 * @param {Units} to
 */
export const convert = (value, quantity, from, to) =>
  from === to ? value : Number((value * factor(quantity, from, to)).toPrecision(15));

/**
 * Five significant figures, without an exponent where that reads well.
 * @param {number | null | undefined} value
 * @param {number} [digits]
 */
export function figure(value, digits = 5) {
  if (value == null || !Number.isFinite(value)) return '—';
  if (value === 0) return '0';
  // 999.9999 is 1000.0, which has one place less.
  const size = Math.abs(Number(value.toPrecision(digits)));
  if (size >= 1e6 || size < 1e-4) {
    const [mantissa, exponent] = value.toExponential(digits - 1).split('e');
    return `${mantissa.replace('-', '−')}·10${superscript(Number(exponent))}`;
  }
  const places = Math.max(0, digits - 1 - Math.floor(Math.log10(size)));
  return value.toFixed(Math.min(places, 20)).replace('-', '−');
}

/**
 * A round figure as short as it can be written.
 * @param {number} value
 * @param {number} [digits]
 */
export function plain(value, digits = 6) {
  if (!Number.isFinite(value)) return '—';
  const short = Number(value.toPrecision(digits));
  const size = Math.abs(short);
  if (size === 0 || (size >= 1e-4 && size < 1e6)) return String(short).replace('-', '−');
  const [mantissa, exponent] = short.toExponential().split('e');
  const power = `10${superscript(Number(exponent))}`;
  return (mantissa === '1' ? power : `${mantissa}·${power}`).replace('-', '−');
}

/**
 * A figure that was put in, as it was: of a clearance between two radii the last digits are all
 * there is. Beyond twelve stands the noise of conversions.
 * @param {number} value
 */
export const exact = (value) => plain(value, 12);

/** @param {number} exponent */
const superscript = (exponent) =>
  String(Number(exponent)).replace(/./g, (sign) =>
    sign === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(sign)],
  );

/** @param {number | null | undefined} ratio */
export const percent = (ratio, digits = 2) =>
  ratio == null ? '—' : `${figure(100 * ratio, digits)} %`;

/** @param {number} bytes */
export const megabytes = (bytes) => `${figure(bytes / 1e6, bytes < 1e7 ? 2 : 3)} MB`;

/**
 * Describes the progress of a download.
 * @param {number} received bytes
 * @param {number} total 0 while it is not known
 */
export const loaded = (received, total) =>
  total > received ? `${Math.round(received / 1e6)} of ${megabytes(total)}` : megabytes(received);

/** @param {number} count */
export const grouped = (count) => String(Math.round(count)).replace(/\B(?=(\d{3})+$)/g, '\u202f');

/** @param {number} ms */
export const duration = (ms, digits = 3) =>
  ms < 1000
    ? `${figure(ms, digits)} ms`
    : ms < 120e3
      ? `${figure(ms / 1000, digits)} s`
      : `${Math.round(ms / 60e3)} min`;
