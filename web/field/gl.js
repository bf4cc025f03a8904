/** Draws nodal values on deformed meshes, banded, by WebGL2. */

import { MOST_BANDS } from './palette.js';

/** Numbers that are handed over at once. */
const PIECE = 1 << 17;
/** Corners of an element as two triangles, and as four sides. */
const [TRIANGLES, SIDES] = [
  [0, 1, 2, 0, 2, 3],
  [0, 1, 1, 2, 2, 3, 3, 0],
];

/** @typedef {import('../types.js').Mesh} Mesh */
/** @typedef {{array: WebGLVertexArrayObject, sides: WebGLBuffer}} Edges */
/** @typedef {{body: import('./read.js').Body, mesh: Mesh, vertices: WebGLVertexArrayObject, buffers: WebGLBuffer[], edges: Edges | null, count: number}} Body `buffers`: nodes, displacements, values, triangles */
/**
 * @typedef {object} Scene
 * @property {import('./camera.js').Camera} camera
 * @property {import('./palette.js').Bands} bands
 * @property {number} deformation factor on displacements
 * @property {boolean} mirrored whether a half stands for both
 * @property {boolean} odd whether values change their sign on the other side
 * @property {boolean} lines whether edges of elements are drawn
 * @property {boolean} isolines whether limits of bands are drawn
 * @property {number} floor values up to here have no colour
 * @property {[number, number, number]} plain that colour
 */

const VERTEX = `#version 300 es
layout(location = 0) in vec2 node;
layout(location = 1) in vec2 displacement;
layout(location = 2) in float value;
uniform vec2 centre, scale;
uniform float deformation, side, lift, parity;
out float v;
void main() {
  vec2 p = node + deformation * displacement + vec2(0.0, lift);
  v = parity * value;
  gl_Position = vec4((vec2(side, 1.0) * p - centre) * scale, 0.0, 1.0);
}`;

const FRAGMENT = `#version 300 es
precision highp float;
uniform float low, width, bottom;
uniform int count;
uniform bool isolines;
uniform vec3 colours[${MOST_BANDS}], plain;
uniform vec4 line;
in float v;
out vec4 colour;
void main() {
  float t = (v - low) / width, edge = 0.5 * fwidth(t);
  int band = clamp(int(floor(t)), 0, count - 1);
  int next = clamp(int(floor(t + edge)), 0, count - 1), before = clamp(int(floor(t - edge)), 0, count - 1);
  // Where a pixel lies across a limit it takes of both bands.
  vec3 mixed = next == before ? colours[band] : mix(colours[before], colours[next], clamp((fract(t + edge)) / (2.0 * edge), 0.0, 1.0));
  vec3 ground = v <= bottom ? plain : mixed;
  // Where the values are the same from pixel to pixel, no limit is crossed.
  float limit = round(t), slope = fwidth(t);
  bool crossed = isolines && slope > 1e-5 && limit > 0.5 && limit < float(count) - 0.5;
  float ink = crossed ? 0.7 * clamp(1.2 - abs(t - limit) / slope, 0.0, 1.0) : 0.0;
  colour = line.a > 0.0 ? line : vec4(mix(ground, vec3(0.05), ink), 1.0);
}`;

export class Renderer {
  /** @type {Body[]} */
  #bodies = [];
  /** Where indices are put together, again and again. */
  #piece = new Uint32Array((PIECE / 4) * Math.max(TRIANGLES.length, SIDES.length));

  /** @param {WebGL2RenderingContext} gl */
  constructor(gl) {
    this.gl = gl;
    this.program = program(gl);
    const names = [
      'centre',
      'scale',
      'deformation',
      'side',
      'parity',
      'lift',
      'isolines',
      'low',
      'width',
      'bottom',
      'count',
      'colours',
      'plain',
      'line',
    ];
    this.at = Object.fromEntries(
      names.map((name) => [name, gl.getUniformLocation(this.program, name)]),
    );
  }

  /** @param {import('./read.js').Body[]} bodies */
  load(bodies) {
    for (const body of this.#bodies) this.#free(body);
    this.#bodies = bodies.map((body) => this.#upload(body));
  }

  /** @param {import('./read.js').Body} body @returns {Body} */
  #upload(body) {
    const { mesh } = body;
    const { gl } = this;
    const buffers = [mesh.nodes, mesh.displacement].map((data) =>
      this.#buffer(gl.ARRAY_BUFFER, data),
    );
    // Its values come by choose().
    buffers.push(gl.createBuffer());
    const triangles = this.#indices(mesh.elements, TRIANGLES);
    const vertices = this.#array(buffers, triangles);
    const count = (mesh.elements.length / 4) * TRIANGLES.length;
    return { body, mesh, vertices, buffers: [...buffers, triangles], edges: null, count };
  }

  /** @param {Body} body */
  #free({ vertices, buffers, edges }) {
    const { gl } = this;
    for (const array of [vertices, edges?.array]) if (array) gl.deleteVertexArray(array);
    for (const buffer of [...buffers, edges?.sides]) if (buffer) gl.deleteBuffer(buffer);
  }

  /** @param {(mesh: Mesh, moved: number) => Float32Array} values of every node */
  choose(values) {
    const { gl } = this;
    for (const { body, mesh, buffers } of this.#bodies) {
      gl.bindBuffer(gl.ARRAY_BUFFER, buffers[2]);
      this.#fill(gl.ARRAY_BUFFER, values(mesh, body.moved));
    }
  }

  /** @param {Scene} scene */
  draw({ camera, bands, deformation, mirrored, odd, lines, isolines, floor, plain }) {
    const { gl, at } = this;
    gl.viewport(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.useProgram(this.program);
    gl.uniform2f(at.centre, camera.x, camera.y);
    gl.uniform2f(at.scale, (2 * camera.scale) / camera.width, (2 * camera.scale) / camera.height);
    gl.uniform1f(at.deformation, deformation);
    gl.uniform1f(at.low, bands.low);
    gl.uniform1f(at.width, bands.step);
    gl.uniform1f(at.bottom, floor);
    gl.uniform1i(at.isolines, isolines ? 1 : 0);
    gl.uniform1i(at.count, bands.colours.length);
    gl.uniform3fv(at.colours, bands.colours.flat());
    gl.uniform3fv(at.plain, plain);
    for (const body of this.#bodies) {
      gl.uniform1f(at.lift, body.body.lift);
      for (const side of mirrored ? [1, -1] : [1]) {
        gl.uniform1f(at.side, side);
        gl.uniform1f(at.parity, odd ? side : 1);
        gl.uniform4f(at.line, 0, 0, 0, 0);
        gl.bindVertexArray(body.vertices);
        gl.drawElements(gl.TRIANGLES, body.count, gl.UNSIGNED_INT, 0);
        if (lines) this.#drawLines(body);
      }
    }
    gl.bindVertexArray(null);
  }

  /** @param {Body} body */
  #drawLines(body) {
    const { gl, at } = this;
    body.edges ??= this.#edges(body);
    gl.uniform4f(at.line, 0.08, 0.09, 0.1, 1);
    gl.bindVertexArray(body.edges.array);
    gl.drawElements(gl.LINES, (body.count / TRIANGLES.length) * SIDES.length, gl.UNSIGNED_INT, 0);
  }

  /** @param {Body} body @returns {Edges} */
  #edges({ mesh, buffers }) {
    const sides = this.#indices(mesh.elements, SIDES);
    return { sides, array: this.#array(buffers.slice(0, 3), sides) };
  }

  /** Corners of every element in an order, put together piece by piece. @param {Uint32Array} elements @param {number[]} order */
  #indices(elements, order) {
    const { gl } = this;
    const buffer = gl.createBuffer();
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, elements.length * order.length, gl.STATIC_DRAW);
    const piece = this.#piece;
    for (let begin = 0; begin < elements.length; begin += PIECE) {
      const end = Math.min(begin + PIECE, elements.length);
      let count = 0;
      for (let k = begin; k < end; k += 4)
        for (const corner of order) piece[count++] = elements[k + corner];
      gl.bufferSubData(gl.ELEMENT_ARRAY_BUFFER, begin * order.length, piece, 0, count);
      this.#arrived();
    }
    return buffer;
  }

  /** @param {WebGLBuffer[]} buffers nodes, displacements, values @param {WebGLBuffer} indices */
  #array(buffers, indices) {
    const { gl } = this;
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    buffers.forEach((buffer, k) => {
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      gl.enableVertexAttribArray(k);
      gl.vertexAttribPointer(k, k < 2 ? 2 : 1, gl.FLOAT, false, 0, 0);
    });
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, indices);
    gl.bindVertexArray(null);
    return array;
  }

  /** Piece by piece: what is on its way to the graphics card is held once more. @param {number} target @param {Float32Array | Uint32Array} data */
  #fill(target, data) {
    const { gl } = this;
    gl.bufferData(target, data.byteLength, gl.STATIC_DRAW);
    for (let at = 0; at < data.length; at += PIECE) {
      gl.bufferSubData(target, 4 * at, data, at, Math.min(PIECE, data.length - at));
      this.#arrived();
    }
  }

  /**
   * Waits until a piece has been taken over, which no answer says but that to a question: `finish`
   * does not wait in Chromium.
   */
  #arrived() {
    this.gl.getError();
  }

  /** @param {number} target @param {Float32Array | Uint32Array} data */
  #buffer(target, data) {
    const buffer = this.gl.createBuffer();
    this.gl.bindBuffer(target, buffer);
    this.#fill(target, data);
    return buffer;
  }
}

/** @param {WebGL2RenderingContext} gl */
function program(gl) {
  const made = gl.createProgram();
  for (const [type, source] of /** @type {const} */ ([
    [gl.VERTEX_SHADER, VERTEX],
    [gl.FRAGMENT_SHADER, FRAGMENT],
  ])) {
    const shader = gl.createShader(type);
    if (!shader) throw new Error('the drawing context is lost');
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(made, shader);
  }
  gl.linkProgram(made);
  if (!gl.getProgramParameter(made, gl.LINK_STATUS))
    throw new Error(gl.getProgramInfoLog(made) ?? 'no shader');
  return made;
}
