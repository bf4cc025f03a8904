/**
 * Heights in files of text: grids of Gwyddion, Surfer and ESRI, plain grids, lists of x, y and z.
 * Every line above the figures is understood or refused, so that no unit and no size is lost. The
 * Python package reads them by the same rules.
 */

import { quoted, withMinus } from '../lib/number.js';
import { grouped, inJobUnits } from '../lib/units.js';

/**
 * @typedef {object} Grid heights as a file has them
 * @property {number[][]} heights `[i][j]` at the i-th x and the j-th y, NaN where there is none
 * @property {[number, number]} [spacing] distances along x and y, in the unit `across`
 * @property {string} across unit of the distances, empty where the file says none
 * @property {string} up unit of the heights, empty where the file says none
 * @property {string[]} notes what was read and taken for granted
 */
/** @typedef {{number: number, line: string}} Line counted from 1 */

/** @param {string} name @returns {number | undefined} one of this unit in mm */
export const lengthInMm = (name) =>
  inJobUnits(1, name.trim().replace(/^[[(]+|[\])]+$/g, ''), 'length', 'mm_N_MPa');

/** @param {string} name */
const isLength = (name) => lengthInMm(name) !== undefined;

/** What is not understood, with its line. */
export class NotUnderstood extends Error {
  /** @param {string} message @param {number} [line] that the reader could leave out */
  constructor(message, line) {
    super(message);
    this.line = line;
  }
}

/** What Surfer and others put where nothing was measured: all from here on. */
const BLANK = 1.7e38;
const HOLE =
  /^(-?nan(\(.*\))?|n\/?a|null|none|bad|void|masked|\*+|-{1,3}|\?+|no ?data|#n\/?[av]|#wert!|#value!|[-+]?1[.,]#(qnan|snan|ind|inf).*|[-+]?inf(inity)?)$/i;
const NUMBER = /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i;
const COMMA = /^[-+]?\d*,\d+(e[-+]?\d+)?$/i;
/** What stands behind a decimal comma, and no figure begins with. */
const DIGITS = /^([-+]?0\d+|-0)$/;
/** A decimal comma or a thousand. */
const AMBIGUOUS = /^[-+]?[1-9]\d{0,2},\d{3}$/;
const SIGN = /^\s*(#|%|\/\/|!|\*|;)+\s*/;

const SIZE = 'length size range scan scansize scanrange dimension extent länge taille';
const STEP =
  'spacing step stepsize pitch resolution pixelsize inc increment delta d abstand schrittweite auflösung cellsize pas';
const COUNT = 'pixel pixels point points sample samples count res punkte';
const on = (/** @type {string} */ axis, /** @type {string} */ words) =>
  words
    .split(' ')
    .map((one) => `${axis}${one} ${one}${axis}`)
    .join(' ');

/** Keys of header lines, lower case without spaces, dots and dashes, by what they say. */
const KEYS = Object.entries({
  width: `width breite largeur ${on('x', SIZE)}`,
  length: `height höhe hauteur ${on('y', SIZE)}`,
  extent:
    'size range scansize scanrange scanbereich größe taille fieldofview imagesize physicalsize physicalsizes',
  dx: `pixelwidth pixelbreite largeurdupixel ${on('x', STEP)}`,
  dy: `pixelheight pixelhöhe hauteurdupixel ${on('y', STEP)}`,
  spacing:
    "spacing pixelsize pixelspacing cellsize resolution lateralresolution step stepsize pitch samplinginterval samplingdistance samplingstep increment pixelgröße schrittweite abstand punktabstand messpunktabstand auflösung lateraleauflösung pas pasd'échantillonnage tailledupixel tailledepixel résolution",
  up: 'unit units valueunit valueunits heightunit heightunits zunit zunits dataunit dataunits einheit einheiten werteinheit werteinheiten werteeinheit höheneinheit zeinheit einheitderwerte einheitderhöhe einheitderhöhen unité unités unitédesvaleurs unitésdesvaleurs unitédevaleur unitéz unitédehauteur',
  across:
    'lateralunit lateralunits xyunit xyunits xunit xunits yunit yunits lengthunit lateraleeinheit xyeinheit xeinheit yeinheit unitélatérale unitéxy unitéx unitéy',
  nx: `nx ncols cols columns numberofcolumns spalten spaltenzahl colonnes nombredecolonnes pixelsperline pointsperline ${on('x', COUNT)}`,
  ny: `ny nrows rows lines numberofrows numberoflines zeilen zeilenzahl lignes nombredelignes profiles ${on('y', COUNT)}`,
  nodata:
    'nodata nodatavalue novalue missing missingvalue missingdata blank blankvalue blankingvalue invalid invalidvalue badvalue badpixelvalue undefined undefinedvalue ungültig fehlwert keinwert keinedaten valeurmanquante valeurabsente absent',
  said: 'channel kanal canal title titel titre name file filename fileformat filetype datei dateiname fichier nom nomdufichier date datum time uhrzeit zeit heure datetime operator bediener opérateur user benutzer instrument device gerät appareil comment comments kommentar commentaire commentaires remark remarks bemerkung sample samplename sampleid probe échantillon objective objektiv objectif software version format createdby erstellt exportedby exportedfrom source startofdata data daten données type measurement messung mesure serialnumber magnification vergrößerung company project projekt xoffset yoffset offsetx offsety',
}).map(([name, words]) => ({ name, words: new Set(words.split(' ')) }));

/**
 * @param {string} text
 * @param {number[]} [skip] numbers of lines that are left out, counted from 1
 * @returns {Grid}
 * @throws {NotUnderstood}
 */
export function readGridText(text, skip = []) {
  const lines = withMinus(text.replace(/^\ufeff/, ''))
    .split(/\r\n?|\n/)
    .map((line, k) => ({ number: k + 1, line: skip.includes(k + 1) ? '' : line }))
    .filter(({ line }) => line.trim());
  if (!lines.length) throw new NotUnderstood('there is nothing in it');
  const first = lines[0].line.trim();
  if (first === 'DSAA') return surfer(lines.slice(1));
  if (/^(ncols|nrows)\s+\d/i.test(first)) return esri(lines);
  const blank = new Set(
    text
      .split(/\r\n?|\n/)
      .flatMap((line, k) => (line.trim() || skip.includes(k + 1) ? [] : [k + 1])),
  );
  return plainGrid(lines, blank);
}

/** Whether a line begins with a sign, and not with a word for a hole such as `#N/A`. @param {string} line */
function isComment(line) {
  const [first] = line.trim().split(/[\s;,]/);
  return SIGN.test(line) && first !== '' && !HOLE.test(first);
}

/** @param {string} line */
const withoutSign = (line) => (isComment(line) ? line.replace(SIGN, '') : line);

/** @param {number} number of its line @param {string} word */
function float(number, word) {
  if (HOLE.test(word)) return NaN;
  if (!NUMBER.test(word))
    throw new NotUnderstood(`line ${number}: ${quoted(word)} is not a number`);
  return Number(word);
}

/** @param {string} line */
const wordsOf = (line) => line.trim().split(/\s+/);

/** Figures of lines that may end anywhere. @param {Line[]} lines @param {number} count */
function figuresOf(lines, count) {
  const decimal = lines.some(({ line }) => wordsOf(line).some((word) => COMMA.test(word)));
  const figures = lines.flatMap(({ number, line }) =>
    wordsOf(line).map((word) => float(number, decimal ? word.replace(',', '.') : word)),
  );
  if (figures.length !== count)
    throw new NotUnderstood(
      `the head says ${grouped(count)} heights, and there are ${grouped(figures.length)}`,
    );
  return figures;
}

/** @param {number[]} figures line by line @param {number} nx @param {number} ny @returns {number[][]} lines */
const linesOf = (figures, nx, ny) =>
  Array.from({ length: ny }, (_, j) => figures.slice(j * nx, (j + 1) * nx));

/** @param {number[][]} lines along x, in the order of y @returns {number[][]} `[i][j]` */
const turned = (lines) => lines[0].map((_, i) => lines.map((line) => line[i]));

/** @param {[number, number]} spacing @returns {[number, number]} */
function positive(spacing) {
  if (!spacing.every((one) => one > 0 && Number.isFinite(one)))
    throw new NotUnderstood(`the head makes distances of ${spacing.join(' and ')}`);
  return spacing;
}

/** @param {number[]} values @returns {[number, number]} */
export function rangeOf(values) {
  let [low, high] = [Infinity, -Infinity];
  for (const one of values) {
    if (one < low) low = one;
    if (one > high) high = one;
  }
  return [low, high];
}

/** @param {Line[]} lines @returns {Grid} */
function surfer(lines) {
  if (lines.length < 5)
    throw new NotUnderstood('a grid of Surfer has five lines above its heights');
  const head = lines
    .slice(0, 4)
    .map(({ number, line }) => wordsOf(line).map((word) => float(number, word)));
  if (head.some((two) => two.length !== 2) || !(Math.min(...head[0]) >= 2))
    throw new NotUnderstood(
      'lines 2 to 5 of a grid of Surfer have two figures each: counts, x, y and z from to',
    );
  const [[nx, ny], [x0, x1], [y0, y1], [low, high]] = head;
  const figures = figuresOf(lines.slice(4), nx * ny).map((one) => (one >= BLANK ? NaN : one));
  const reached = rangeOf(figures);
  if (
    reached[0] <= reached[1] &&
    Math.max(Math.abs(reached[0] - low), Math.abs(reached[1] - high)) > 1e-3 * (high - low)
  )
    throw new NotUnderstood(
      `line 5 says heights from ${low} to ${high}, and they go from ${reached[0]} to ${reached[1]}`,
    );
  return {
    heights: turned(linesOf(figures, nx, ny)),
    spacing: positive([(x1 - x0) / (nx - 1), (y1 - y0) / (ny - 1)]),
    across: '',
    up: '',
    notes: ['a grid of Surfer: lines along x, the first at the smallest y'],
  };
}

const ESRI =
  /^\s*(ncols|nrows|xllcorner|xllcenter|yllcorner|yllcenter|cellsize|dx|dy|nodata_value)\s+(\S+)\s*$/i;

/** @param {Line[]} lines @returns {Grid} */
function esri(lines) {
  const head = /** @type {Record<string, number>} */ ({});
  let start = 0;
  for (; start < lines.length; start++) {
    const [, key, value] = ESRI.exec(lines[start].line) ?? [];
    if (!key) break;
    head[key.toLowerCase()] = float(lines[start].number, value.replace(',', '.'));
  }
  const {
    ncols: nx,
    nrows: ny,
    cellsize,
    dx = cellsize,
    dy = cellsize,
    nodata_value: none,
  } = head;
  const lacking = [nx ? '' : 'ncols', ny ? '' : 'nrows', dx && dy ? '' : 'cellsize'].filter(
    Boolean,
  );
  if (lacking.length) throw new NotUnderstood(`a grid of ESRI lacks ${lacking.join(' and ')}`);
  const figures = figuresOf(lines.slice(start), nx * ny).map((one) => (one === none ? NaN : one));
  return {
    heights: turned(linesOf(figures, nx, ny).reverse()),
    spacing: positive([dx, dy]),
    across: '',
    up: '',
    notes: ['a grid of ESRI: lines along x, the first at the largest y'],
  };
}

/** @typedef {{number: number, line: string, cells: string[]}} Row */

/** @param {Line[]} lines @param {Set<number>} blank numbers of lines @returns {Grid} */
function plainGrid(lines, blank) {
  const separator = separatorOf(lines);
  const rows = lines.map((one) => ({ ...one, cells: cellsOf(one.line, separator) }));
  const isBody = rows.map(({ line, cells }) => !isComment(line) && isData(cells));
  const start = isBody.indexOf(true);
  if (start < 0) {
    const { number, cells } = rows[Math.floor(rows.length / 2)];
    const wrong = cells.find((cell) => !isFigure(cell) && /\d/.test(cell));
    throw new NotUnderstood(
      wrong ? `line ${number}: ${quoted(wrong)} is not a number` : 'there are no figures in it',
    );
  }
  const head = rows.slice(0, start);
  let body = /** @type {Row[]} */ ([]);
  rows.slice(start).forEach((row, k) => {
    if (isBody[start + k]) body.push(row);
    else if (isComment(row.line)) {
      if (/[\p{L}\d]/u.test(row.line))
        throw new NotUnderstood(
          `line ${row.number}: ${quoted(row.line)} stands among the figures: another map?`,
          row.number,
        );
    } else {
      const wrong = row.cells.find((cell) => !isFigure(cell)) ?? row.line;
      throw new NotUnderstood(
        `line ${row.number} has a height that is no number: ${quoted(wrong)}`,
      );
    }
  });
  if (body.every(({ cells }) => cells.at(-1) === ''))
    body = body.map((row) => ({ ...row, cells: row.cells.slice(0, -1) }));
  if (separator === ',')
    for (const { number, cells } of body) {
      const wrong = cells.find((cell) => DIGITS.test(cell));
      if (wrong)
        throw new NotUnderstood(
          `line ${number}: ${quoted(wrong)} between commas: commas between figures, or decimal commas?`,
        );
    }
  const values = readFigures(body);
  const columns = values[0].length;
  const gaps = body.slice(1).map(({ number }, k) => {
    for (let one = body[k].number + 1; one < number; one++) if (blank.has(one)) return one;
    return 0;
  });
  const gap = gaps.find(Boolean);
  if (columns > 3 && gap && gaps.includes(0))
    throw new NotUnderstood(
      `line ${gap} is blank, with figures above and below: another map?`,
      gap,
    );
  const uneven = values.findIndex((row) => row.length !== columns);
  if (uneven > 0)
    throw new NotUnderstood(
      `line ${body[uneven].number} has ${values[uneven].length} heights, line ${body[0].number} has ${columns}`,
    );
  const header = new Header();
  for (const row of head) header.take(row, columns === 3);
  const { nodata } = header;
  const table =
    nodata === undefined
      ? values
      : values.map((row) =>
          row.map((one) => (Math.abs(one - nodata) <= 1e-6 * Math.abs(nodata) ? NaN : one)),
        );
  if (columns === 3) return header.gridOfList(table);
  if (columns < 3 || values.length < 2)
    throw new NotUnderstood('a grid of heights is wanted, with several lines and columns');
  return header.grid(table);
}

/** @param {Line[]} lines @returns {string} */
function separatorOf(lines) {
  const figures = lines.map(({ line }) => line).filter((line) => /^\s*"?[-+.,\d]/.test(line));
  for (const one of ['\t', ';']) if (figures.some((line) => line.includes(one))) return one;
  if (figures.some((line) => /\d[.,]?\s+[-+]?[.,]?\d/.test(line)))
    return figures.some((line) => /\d,\s+[-+]?[.,]?\d/.test(line)) ? ', ' : ' ';
  return figures.some((line) => line.includes(',')) ? ',' : ' ';
}

/** Cells between separators, those in quotation marks as they are. @param {string} line @param {string} separator */
function splitAt(line, separator) {
  if (!line.includes('"')) return line.split(separator);
  const parts = line.split('"');
  const cells = [''];
  parts.forEach((part, k) => {
    const [first, ...rest] = k % 2 ? [part] : part.split(separator);
    cells[cells.length - 1] += first;
    cells.push(...rest);
  });
  return cells;
}

/** @param {string} line @param {string} separator */
function cellsOf(line, separator) {
  const bare = withoutSign(line);
  const cells =
    separator === ', '
      ? bare
          .trim()
          .replace(/,$/, '')
          .split(/,\s+|\s+/)
      : separator === ' '
        ? wordsOf(bare.replace(/no data/gi, 'nodata'))
        : splitAt(bare.replace(/[ \r\n]+$/, ''), separator);
  return cells.map((cell) => cell.trim().replace(/^"|"$/g, '').trim());
}

/** @param {string} word */
const isFigure = (word) => word === '' || HOLE.test(word) || NUMBER.test(word.replace(',', '.'));

/** @param {string[]} cells */
const isData = (cells) => cells.every(isFigure) && cells.some(Boolean);

/** Figures with a decimal point, or all with a decimal comma. @param {Row[]} body @returns {number[][]} */
function readFigures(body) {
  let comma = /** @type {{number: number, word: string} | undefined} */ (undefined);
  let point = /** @type {{number: number, word: string} | undefined} */ (undefined);
  let sure = false;
  for (const { number, cells } of body)
    for (const word of cells) {
      if (!point && word.includes('.')) point = { number, word };
      if ((!comma || !sure) && COMMA.test(word)) {
        comma ??= { number, word };
        sure ||= !AMBIGUOUS.test(word);
      }
    }
  if (comma && point)
    throw new NotUnderstood(
      `line ${comma.number}: ${quoted(comma.word)} has a decimal comma, and ${quoted(point.word)} in line ${point.number} a point`,
    );
  if (comma && !sure)
    throw new NotUnderstood(
      `line ${comma.number}: ${quoted(comma.word)} can be read as ${comma.word.replace(',', '.')} or as ${comma.word.replace(',', '')}`,
    );
  return body.map(({ number, cells }) =>
    cells.map((word) => (word ? float(number, word.replace(',', '.')) : NaN)),
  );
}

/** @param {string} line @returns {[key: string, value: string]} */
function keyAndValue(line) {
  const [, key, value] = /^([^:=\t;]*?)\s*[:=\t;]\s*(.*)$/.exec(line) ?? [];
  if (key !== undefined)
    return [
      key,
      value
        .trim()
        .replace(/[;\s]+$/, '')
        .replace(/^"|"$/g, ''),
    ];
  const [, before, behind] =
    /^(.*?\D)[\s,]+([-+]?[\d.,]+(?:e[-+]?\d+)?(?:\s*\D*)?)$/i.exec(line) ?? [];
  return before === undefined ? [line, ''] : [before, behind];
}

/** @param {string} key */
const plainKey = (key) => key.toLowerCase().replace(/[\s._-]/g, '');

/** What the lines above the figures say. */
class Header {
  /** @type {Record<string, {value: number, unit: string}>} */
  lengths = {};
  units = { up: '', across: '' };
  /** @type {Record<string, number>} */
  counts = {};
  /** @type {number | undefined} */
  nodata;
  /** @type {string[]} of the columns of a list */
  columns = [];
  /** @type {string[]} */
  notes = [];
  isGwyddion = false;

  /** @param {Row} row @param {boolean} isList */
  take({ number, line, cells }, isList) {
    const bare = withoutSign(line).trim().replace(/^"|"$/g, '').trim();
    if (!/[\p{L}\d]/u.test(bare) || (isList && this.#takesColumns(cells))) return;
    if (!isList && cells.length > 3 && this.#takesColumns(cells.slice(0, 3)))
      throw new NotUnderstood(
        `line ${number}: ${quoted(bare)} names columns x, y, z and others: leave these three`,
      );
    const full = cells.filter(Boolean);
    let [key, value] =
      line.includes(',') && full.length === 2 && !/[:=]/.test(bare) ? full : keyAndValue(bare);
    let plain = plainKey(key);
    const bracketed = /[[(]\s*([^\])]+?)\s*[\])]$/.exec(key);
    if (bracketed && isLength(bracketed[1])) {
      value = `${value} ${bracketed[1]}`;
      plain = plainKey(key.slice(0, bracketed.index));
    }
    let name = KEYS.find(({ words }) => words.has(plain))?.name;
    if (!name || !this.#takes(name, value)) {
      // Words alone can say nothing of sizes.
      const harmless = !value && !/\d/.test(bare) && !wordsOf(bare).some(isLength);
      if (!harmless)
        throw new NotUnderstood(`line ${number}: ${quoted(bare)} is not understood`, number);
      name = 'said';
    }
    if (name === 'said') this.notes.push(`line ${number} (${quoted(bare)}) left out`);
    this.isGwyddion ||= /^(width|length)$/.test(name) && line.trimStart().startsWith('#');
  }

  /** Whether a line names the columns of a list; keeps their units. @param {string[]} cells */
  #takesColumns(cells) {
    const names = cells.map((one) => one.toLowerCase().replace(/[^a-zäöü].*/s, ''));
    if (cells.length !== 3 || names[0][0] !== 'x' || names[1][0] !== 'y') return false;
    if (!/^(z|h|height|value|höhe|wert|hauteur|valeur)$/.test(names[2])) return false;
    const units = cells.map((one) => /[[(/,]?\s*([^[(/,\s]+?)\s*[\])]?$/.exec(one)?.[1] ?? '');
    if (cells.some((one, k) => /[[(]/.test(one) && !isLength(units[k]))) return false;
    this.columns = units.map((one) => (isLength(one) ? one : ''));
    return true;
  }

  /** Whether a value is one of its key; keeps it. @param {string} name @param {string} value */
  #takes(name, value) {
    if (name === 'said') return true;
    if (name === 'up' || name === 'across') {
      const unit = value.trim().replace(/^[[(]+|[\])]+$/g, '');
      if (isLength(unit)) this.units[name] = unit;
      return isLength(unit);
    }
    if (name === 'nx' || name === 'ny') {
      if (!/^\d+$/.test(value.trim())) return false;
      this.counts[name] = Number(value);
      return true;
    }
    if (name === 'nodata') {
      const word = value.trim().replace(',', '.');
      if (HOLE.test(word)) return true;
      if (!NUMBER.test(word)) return false;
      this.nodata = Number(word);
      return true;
    }
    const isBoth = name === 'extent' || name === 'spacing';
    const two =
      isBoth &&
      /^([-+\d.,e]+)\s*([^\d\sx×*;]*)(?:\s*[x×*;]\s*|\s+)([-+\d.,e]+)\s*([^\d\s]*)$/i.exec(
        value.trim(),
      );
    const one = /^([-+\d.,e]+)\s*([^\d\s].*)?$/i.exec(value.trim());
    const pairs = two
      ? [
          [two[1], two[2] || two[4]],
          [two[3], two[4] || two[2]],
        ]
      : one
        ? Array.from({ length: isBoth ? 2 : 1 }, () => [one[1], one[2] ?? ''])
        : [];
    const read = pairs.map(([figure, unit]) => ({
      value: AMBIGUOUS.test(figure) || !NUMBER.test(figure.replace(',', '.')) ? NaN : Number(figure.replace(',', '.')), // prettier-ignore
      unit,
    }));
    if (!read.length || read.some(({ value, unit }) => !(value > 0) || (unit && !isLength(unit))))
      return false;
    const names =
      name === 'extent' ? ['width', 'length'] : name === 'spacing' ? ['dx', 'dy'] : [name];
    names.forEach((key, k) => (this.lengths[key] = read[k]));
    return true;
  }

  /** A grid whose lines are those of the file. @param {number[][]} rows @returns {Grid} */
  grid(rows) {
    const notes = this.notes;
    if (counts(rows[0]) && !counts(rows[1]))
      throw new NotUnderstood('the first line counts the columns: take it out of the file');
    const axes = axesOf(rows);
    if (axes && counts(rows[0].slice(1)) && counts(rows.slice(1).map((row) => row[0])))
      throw new NotUnderstood(
        'the first line and the first column count: take them out of the file',
      );
    const [first, second] = [0, 1].map((k) => rows.map((row) => row[k]));
    if (!axes && counts(first) && !counts(second))
      throw new NotUnderstood('the first column counts the lines: take it out of the file');
    for (const [what, one, next] of /** @type {[string, number[], number[]][]} */ ([
      ['line', rows[0], rows[1]],
      ['column', first, second],
    ]))
      if (!axes && one.length > 5 && stepOf(one) !== undefined && stepOf(next) === undefined)
        throw new NotUnderstood(
          `the first ${what} rises or falls by equal steps, and the next does not: if it has places, take it out of the file and give the distance`,
        );
    const { up, across } = this.units;
    const says = Object.keys(this.lengths).length + Object.keys(this.counts).length > 0;
    if (!axes && !says && !this.isGwyddion) {
      notes.push('lines along y, one for each x');
      return { heights: rows, across, up, notes };
    }
    let lines = rows;
    let spacing = /** @type {[number, number] | undefined} */ (undefined);
    if (axes) {
      lines = rows.slice(1).map((row) => row.slice(1));
      if (axes[1] > 0) lines.reverse();
      spacing = [axes[0], Math.abs(axes[1])];
      notes.push('the first line and the first column are x and y');
    }
    const [nx, ny] = [lines[0].length, lines.length];
    for (const [name, count, words] of /** @type {[string, number, string][]} */ ([
      ['nx', nx, 'columns'],
      ['ny', ny, 'lines'],
    ]))
      if ((this.counts[name] ?? count) !== count)
        throw new NotUnderstood(
          `the head says ${this.counts[name]} ${words}, and there are ${count}`,
        );
    notes.push('lines along x, the first at the largest y');
    const { width, length } = this.lengths;
    const isCount = (/** @type {{value: number, unit: string} | undefined} */ side, /** @type {number} */ count) => side?.value === count && !side.unit; // prettier-ignore
    if (isCount(width, nx) && isCount(length, ny) && !across) {
      delete this.lengths.width;
      delete this.lengths.length;
      notes.push('width and height of the head are numbers of points');
    }
    const said = this.#spacing(nx, ny);
    const isOther =
      said && spacing?.some((one, k) => Math.abs(one - said.spacing[k]) > 1e-3 * one);
    if (isOther)
      throw new NotUnderstood(
        `the head makes distances of ${said.spacing.join(' and ')}, the first line and the first column of ${spacing?.join(' and ')}`,
      );
    return {
      heights: turned([...lines].reverse()),
      spacing: said?.spacing ?? spacing,
      across: said?.unit ?? across,
      up,
      notes,
    };
  }

  /** Distances as the head says them. @param {number} nx @param {number} ny */
  #spacing(nx, ny) {
    const found = /** @type {{value: number, unit: string}[]} */ ([]);
    for (const [side, step, count] of /** @type {[string, string, number][]} */ ([
      ['width', 'dx', nx],
      ['length', 'dy', ny],
    ])) {
      const { [step]: own, [side]: whole } = this.lengths;
      if (own && whole && !agree(own, whole, count))
        throw new NotUnderstood(
          `the head says ${count} steps of ${own.value} ${own.unit} and a side of ${whole.value} ${whole.unit}`,
        );
      if (own) found.push(own);
      else if (whole) found.push({ value: whole.value / count, unit: whole.unit });
    }
    if (!found.length) return undefined;
    if (found.length === 1) {
      found.push(found[0]);
      this.notes.push('one distance is said, and taken for both');
    }
    const [a, b] = found.map(({ unit }) => unit || this.units.across);
    if (a !== b) throw new NotUnderstood(`the head has lengths in “${a}” and in “${b}”`);
    return { spacing: positive([found[0].value, found[1].value]), unit: a };
  }

  /** A grid whose points are lines of x, y and z. @param {number[][]} table @returns {Grid} */
  gridOfList(table) {
    const [ux = '', uy = '', uz = ''] = this.columns;
    if (ux !== uy) throw new NotUnderstood(`x is in “${ux}” and y in “${uy}”`);
    const lost = table.findIndex(([x, y]) => !Number.isFinite(x) || !Number.isFinite(y));
    if (lost >= 0) throw new NotUnderstood(`point ${lost + 1} of the list has no place`);
    const x = placesOf(
      table.map((row) => row[0]),
      'x',
    );
    const y = placesOf(
      table.map((row) => row[1]),
      'y',
    );
    for (const [name, { count }] of /** @type {['nx' | 'ny', {count: number}][]} */ ([
      ['nx', x],
      ['ny', y],
    ]))
      if ((this.counts[name] ?? count) !== count)
        throw new NotUnderstood(
          `the head says ${this.counts[name]} places along ${name[1]}, and there are ${count}`,
        );
    if (x.count * y.count > 4 * table.length)
      throw new NotUnderstood(
        `${grouped(table.length)} points stand on no grid: they would be ${x.count} × ${y.count}; put them on one first`,
      );
    const heights = Array.from({ length: x.count }, () => new Array(y.count).fill(NaN));
    const taken = new Set();
    table.forEach(([, , z], k) => {
      const [i, j] = [x.numbers[k], y.numbers[k]];
      if (taken.has(i * y.count + j))
        throw new NotUnderstood('two points of the list stand at one place');
      taken.add(i * y.count + j);
      heights[i][j] = z;
    });
    return {
      heights,
      spacing: [x.step, y.step],
      across: ux || this.units.across,
      up: uz || this.units.up,
      notes: [
        ...this.notes,
        `${grouped(table.length)} points x, y, z onto ${x.count} × ${y.count}`,
      ],
    };
  }
}

/**
 * Whether so many steps, or one fewer, make a side; also where a unit is left open.
 * @param {{value: number, unit: string}} step @param {{value: number, unit: string}} side @param {number} count
 */
function agree(step, side, count) {
  if (!step.unit !== !side.unit) return true;
  const ratio = step.unit ? (lengthInMm(side.unit) ?? NaN) / (lengthInMm(step.unit) ?? NaN) : 1;
  const steps = (side.value * ratio) / step.value;
  return steps >= 0.999 * (count - 1) && steps <= 1.001 * count;
}

/** Whether values are 0, 1, 2 or 1, 2, 3 and so on. @param {number[]} values */
const counts = (values) =>
  (values[0] === 0 || values[0] === 1) && values.every((one, k) => one === values[0] + k);

/** @param {number[]} values @returns {number | undefined} their step, if it is one */
function stepOf(values) {
  const steps = values.slice(1).map((one, k) => one - values[k]);
  const [low, high] = rangeOf(steps);
  const mean = steps.reduce((sum, one) => sum + one, 0) / steps.length;
  return values.length > 2 && values.every(Number.isFinite) && high - low < 1e-3 * Math.abs(mean)
    ? mean
    : undefined;
}

/** Steps of x and y where the first line and the first column are positions. @param {number[][]} rows */
function axesOf(rows) {
  const x = stepOf(rows[0].slice(1));
  const y = stepOf(rows.slice(1).map((row) => row[0]));
  const inner = stepOf(rows[1].slice(1));
  return x !== undefined && x > 0 && y !== undefined && inner === undefined ? [x, y] : undefined;
}

/** Number of each value among equal steps. @param {number[]} values @param {string} axis */
function placesOf(values, axis) {
  const order = Float64Array.from(values).sort();
  const extent = order[order.length - 1] - order[0];
  const real = /** @type {number[]} */ ([]);
  for (let k = 1; k < order.length; k++)
    // What repeats within a millionth of the extent is one place.
    if (order[k] - order[k - 1] > 1e-6 * extent) real.push(order[k] - order[k - 1]);
  if (!real.length) throw new NotUnderstood(`all points of the list have one ${axis}`);
  const [least] = rangeOf(real);
  const small = real.filter((one) => one < 1.5 * least).sort((a, b) => a - b);
  const step = extent / Math.round(extent / small[Math.floor(small.length / 2)]);
  const numbers = values.map((one) => Math.round((one - order[0]) / step));
  values.forEach((one, k) => {
    const off = Math.abs((one - order[0]) / step - numbers[k]);
    if (off > 0.05)
      throw new NotUnderstood(
        `the ${axis} of the list stand at no equal steps: point ${k + 1} lies ${off.toFixed(2)} steps beside one; put them on a grid first`,
      );
  });
  return { numbers, step, count: rangeOf(numbers)[1] + 1 };
}
