/**
 * Where the words beside lines across a chart stand: clear of its curves and of each other, as far
 * as there is room.
 */

/** @typedef {{left: number, right: number, top: number, bottom: number}} Box */
/** @typedef {[number, number]} Point */
/**
 * @typedef {object} Line
 * @property {'x' | 'y'} across which axis it stands on
 * @property {number} at in pixels
 * @property {number} width of its words
 * @property {boolean} [left] where the words of a level line stand if there is room
 */
/** @typedef {{x: number, y: number}} Place where words begin, on their base line */

const SIZE = 11;
/** Shares of the way from one end of a level line to the other. */
const ALONG = [0, 1, 0.25, 0.75, 0.5];
/** Rows beside an upright line. */
const ROWS = [0, 1, 2, 3, 4, 5, 6, 7];

/**
 * @param {Line[]} lines
 * @param {Point[][]} curves in pixels
 * @param {Box} box of the axes
 * @param {number} [ratio] of pixels to those of the page
 * @returns {Place[]}
 */
export function placeWords(lines, curves, box, ratio = 1) {
  const taken = /** @type {Box[]} */ ([]);
  return lines.map((line) => {
    const tried = (line.across === 'y' ? besideLevel : besideUpright)(line, box, ratio).map(
      (place) => {
        const around = {
          left: place.x - 2 * ratio,
          right: place.x + line.width + 2 * ratio,
          top: place.y - SIZE * ratio,
          bottom: place.y + 3 * ratio,
        };
        const crossings = curves.reduce((count, curve) => count + crossed(curve, around), 0);
        const outside =
          around.left < box.left ||
          around.right > box.right + 4 * ratio ||
          around.top < box.top ||
          around.bottom > box.bottom;
        const covered = taken.filter((other) => overlap(other, around)).length;
        return { place, around, faults: crossings + 1000 * covered + (outside ? 100 : 0) };
      },
    );
    const best = tried.reduce((a, b) => (b.faults < a.faults ? b : a));
    taken.push(best.around);
    return best.place;
  });
}

/**
 * @param {Line} line
 * @param {Box} box
 * @param {number} ratio
 * @returns {Place[]} the one that is liked best first
 */
function besideLevel({ at, width, left }, box, ratio) {
  const [from, to] = [box.left + 4 * ratio, box.right - 4 * ratio - width];
  const [first, last] = left ? [from, to] : [to, from];
  return ALONG.flatMap((share) =>
    [at - 5 * ratio, at + (SIZE + 3) * ratio].map((y) => ({
      x: first + share * (last - first),
      y,
    })),
  );
}

/** @param {Line} line @param {Box} box @param {number} ratio @returns {Place[]} */
function besideUpright({ at, width }, box, ratio) {
  return ROWS.flatMap((row) =>
    [at + 4 * ratio, at - 4 * ratio - width].map((x) => ({
      x,
      y: box.top + (12 + 16 * row) * ratio,
    })),
  );
}

/** @param {Box} a @param {Box} b */
const overlap = (a, b) =>
  a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

/**
 * @param {Point[]} curve
 * @param {Box} box
 * @returns {number} pieces of the curve that touch the box
 */
function crossed(curve, box) {
  let count = 0;
  for (let k = 1; k < curve.length; k++) if (touches(curve[k - 1], curve[k], box)) count += 1;
  return count;
}

/**
 * Whether a straight piece touches the box: neither lies beside the other, nor are all corners on
 * one side of the piece. Asked tens of thousands of times for a chart, so that no list is made.
 * @param {Point} a @param {Point} b @param {Box} box
 */
function touches(a, b, { left, right, top, bottom }) {
  const ax = a[0];
  const ay = a[1];
  const bx = b[0];
  const by = b[1];
  if ((ax < left && bx < left) || (ax > right && bx > right)) return false;
  if ((ay < top && by < top) || (ay > bottom && by > bottom)) return false;
  const l = (by - ay) * (left - ax);
  const r = (by - ay) * (right - ax);
  const t = (bx - ax) * (top - ay);
  const u = (bx - ax) * (bottom - ay);
  return Math.min(t, u) <= Math.max(l, r) && Math.max(t, u) >= Math.min(l, r);
}
