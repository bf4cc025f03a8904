/** Fetches a result, packs its mesh fields into typed arrays and hands them over without copying. */

/** Nodal fields that are shown. */
const SCALARS = ['von_mises', 'equivalent_plastic_strain', 'sigma_x', 'sigma_y', 'sigma_z', 'tau_xy'];

self.addEventListener('message', async ({ data: { number, url, headers } }) => {
  try {
    const response = await fetch(url, { headers });
    const report = await response.json();
    if (!response.ok) return self.postMessage({ number, status: response.status, problem: report });
    const buffers = /** @type {ArrayBuffer[]} */ ([]);
    for (const step of report.steps) {
      for (const side of ['upper', 'lower']) {
        if (step.fields?.[side]) step.fields[side] = pack(step.fields[side], buffers);
      }
    }
    /** @type {any} */ (self).postMessage({ number, report }, buffers);
  } catch {
    self.postMessage({ number, status: 0, problem: {} });
  }
});

/** @param {any} field @param {ArrayBuffer[]} buffers */
function pack(field, buffers) {
  const packed = /** @type {Record<string, any>} */ ({
    nodes: pairs(field.nodes),
    displacement: pairs(field.displacement),
    triangles: triangles(field.elements),
  });
  for (const name of SCALARS) packed[name] = Float32Array.from(field[name]);
  for (const array of Object.values(packed)) buffers.push(array.buffer);
  return packed;
}

/** @param {[number, number][]} list */
function pairs(list) {
  const packed = new Float32Array(2 * list.length);
  for (let k = 0; k < list.length; k++) {
    packed[2 * k] = list[k][0];
    packed[2 * k + 1] = list[k][1];
  }
  return packed;
}

/** Each quadrilateral as two triangles. @param {[number, number, number, number][]} elements */
function triangles(elements) {
  const packed = new Uint32Array(6 * elements.length);
  for (let k = 0; k < elements.length; k++) {
    const [a, b, c, d] = elements[k];
    packed.set([a, b, c, a, c, d], 6 * k);
  }
  return packed;
}
