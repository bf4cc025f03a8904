/**
 * Stresses of elastic bodies under the middle of Hertz's contact, over depth: closed forms to lay
 * beside an answer.
 */

/**
 * @typedef {{sigma_x: number[], sigma_y: number[], sigma_z: number[], tau_max: number[],
 *   von_mises: number[]}} Stresses
 */

/**
 * Line contact (McEwen; Johnson, Contact Mechanics, 4.45) or circular contact (Johnson 3.45),
 * tension positive: `sigma_x` along the surface, `sigma_y` normal to it, `sigma_z` out of the
 * plane (the hoop stress in axisymmetry).
 * @param {number[]} depths
 * @param {{half_width: number, peak_pressure: number}} hertz
 * @param {number} ratio Poisson's
 * @param {string} analysis
 * @returns {Stresses}
 */
export function elasticStresses(depths, { half_width: a, peak_pressure: p }, ratio, analysis) {
  const all = depths.map((z) => {
    if (analysis === 'axisymmetric') {
      const decay = 1 / (1 + (z / a) ** 2);
      const radial = -p * ((1 + ratio) * (1 - (z / a) * Math.atan2(a, z)) - decay / 2);
      return [radial, -p * decay, radial];
    }
    const root = Math.hypot(a, z);
    const along = (-p / a) * ((a * a + 2 * z * z) / root - 2 * z);
    const normal = (-p * a) / root;
    return [along, normal, analysis === 'plane_strain' ? ratio * (along + normal) : 0];
  });
  const mises = all.map(([x, y, z]) =>
    Math.sqrt(((x - y) ** 2 + (y - z) ** 2 + (z - x) ** 2) / 2),
  );
  return {
    sigma_x: all.map(([x]) => x),
    sigma_y: all.map(([, y]) => y),
    sigma_z: all.map(([, , z]) => z),
    tau_max: all.map((three) => (Math.max(...three) - Math.min(...three)) / 2),
    von_mises: mises,
  };
}
