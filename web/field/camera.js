/** What part of the section is seen: its middle, and how many pixels a unit of length takes. */

/**
 * How far one can go from where the whole contact is seen, before there is one point or one colour
 * left.
 */
const [FARTHEST, CLOSEST] = [1e-3, 1e3];

export class Camera {
  x = 0;
  y = 0;
  scale = 1;
  width = 1;
  height = 1;
  /** Scale at which the whole contact is seen. */
  #whole = 1;

  /** @param {number} half of the width to be seen @param {number} x in the middle @param {number} y */
  home(half, x, y) {
    this.#whole = Math.min(this.width / (2 * half), this.height / (1.5 * half));
    Object.assign(this, { x, y, scale: this.#whole });
  }

  /** @param {number} px @param {number} py @returns {[number, number]} in the section */
  toWorld(px, py) {
    return [
      this.x + (px - this.width / 2) / this.scale,
      this.y - (py - this.height / 2) / this.scale,
    ];
  }

  /** @param {number} x @param {number} y @returns {[number, number]} in pixels */
  toScreen(x, y) {
    return [
      this.width / 2 + (x - this.x) * this.scale,
      this.height / 2 - (y - this.y) * this.scale,
    ];
  }

  /** @param {number} dx pixels to the right @param {number} dy pixels down */
  pan(dx, dy) {
    this.x -= dx / this.scale;
    this.y += dy / this.scale;
  }

  /** @param {number} factor @param {number} px what stays where it is @param {number} py */
  zoom(factor, px = this.width / 2, py = this.height / 2) {
    const [x, y] = this.toWorld(px, py);
    this.scale = Math.min(
      CLOSEST * this.#whole,
      Math.max(FARTHEST * this.#whole, this.scale * factor),
    );
    const [nx, ny] = this.toWorld(px, py);
    this.x += x - nx;
    this.y += y - ny;
  }
}
