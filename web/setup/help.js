/** Explanations in place: what a figure means, for those who do not set up contacts every day. */

import { h, uniqueId } from '../lib/dom.js';
import { described } from './words.js';

/** By the key of a field or figure. @type {Record<string, string>} */
const TEXTS = {
  analysis:
    'Plane strain: long rollers and rails, which cannot stretch along the line of contact; loads are per length. Plane stress: thin discs and sheets, free to bulge sideways. Axisymmetric: balls and indenters; loads are whole forces, and cylinders become spheres. Three dimensions: balls in grooves, rollers that end and tilt, measured heights; loads are whole forces on half-spaces.',
  support:
    'How the far side of the body is held, at the diametral plane or the base. Clamped: it cannot move. Roller: it slides sideways. Far from the contact this changes the approach by some per cent and the pressure hardly.',
  young_modulus:
    'Stiffness in tension before yield: 200 to 212 GPa for steel, 70 GPa for aluminium.',
  poisson_ratio:
    'Lateral contraction over axial extension in a tensile test: 0.3 for steel, 0.33 for aluminium.',
  law: 'How the stress that makes the metal flow grows with plastic strain. Elastic: it never flows. Bilinear: a yield stress and a slope. Swift, Ludwik and Voce: fits of tensile tests. Table: points of a test. Rigid: it neither bends nor flows.',
  target:
    'The load is the answer: it is searched for until the contact has this figure. What stays behind (permanent approach, dent) is known to flow theory alone.',
  error_bar:
    'How far the figure may be from that of an infinitely fine mesh, estimated from a second mesh of half the density; the bars held in at least 95 of 100 tested cases. They say nothing of the model or of the figures put in.',
  initial_stress:
    'Stress that grinding, peening or hardening has left, by depth below the surface. It relaxes before the first load where the surface is curved; what is left is in the stresses over depth. It is added to the stress of the load, and a stress that yields by itself is refused.',
  surface_kind:
    'Smooth, or with heights on it that are measured or computed. The contact is then solved on the cells of these heights, and there is none beyond them.',
  backstress:
    'The yield surface moves with plastic strain and yields earlier when the load turns back (Bauschinger). dX = ⅔ C dε_p − γ X dp for each term; up to four.',
  yield_stress: 'Stress in a tensile test at which plastic flow begins.',
  tangent_modulus:
    'Slope of stress over total strain beyond yield. 0 is perfectly plastic; steels are often taken at E/100.',
  reference_stress:
    'Stress at which the plastic strain is a·σ0/E. With σ0 = R_p0.2, a = 0.002 E/σ0.',
  saturation_stress: 'Stress that hardening approaches and does not pass.',
  width:
    'Full width of the body. Ten half-widths of the contact or more keep its sides out of the answer.',
  depth:
    'From the surface to the base, where the body is held. The approach grows with it without bound, the pressure does not.',
  kind: 'Force: the load is known. Approach: how far the bodies are pressed together is known, the force is an answer. A sweep gives a curve. Force for a given figure: a pressure, width, strain or dent is wanted, and the force for it is the answer. Onset of yield: the least load that makes the metal flow.',
  force:
    'In plane strain and plane stress the load per unit of thickness, on the whole contact; in axisymmetry and in three dimensions the whole force.',
  approach:
    'How far the two held sides move towards each other. It depends on where the bodies are held.',
  'mesh/elements_per_half_width':
    'Elements over half the width of the contact, in three dimensions cells over each semi-axis. 20 gives the peak pressure to some 0.05 %, 10 is enough for a look; time and memory grow with the square.',
  'mesh/accuracy':
    'Largest error of the figures that answer the job. The mesh is refined until their error bars are as small, to at most four times the elements; a remark of the result names a figure that misses it. How long it takes is told from the time and the error bars of the same set-up on one mesh, once that is solved. Searches and tolerances take one mesh.',
  'solver/increments':
    'Steps in which flow theory puts each load on. Left empty, the program chooses them from its own estimate of their error.',
  'solver/tolerance':
    'Relative change of displacements and out-of-balance force at which the iteration ends.',
  theory:
    'Flow theory follows the load from rest in increments: it knows unloading, residual stresses and the dent. Deformation theory takes plastic strain from the state as it is: faster, and wrong by some per cent far beyond yield, which no error bar holds.',
};

/**
 * A question mark that opens the explanation of a figure.
 * @param {string} key
 * @param {string} name
 * @param {string} label id of the element that names it
 * @param {string} [description] where there is no other text
 * @param {boolean} [ofField] whether a field opens it by F1: it is no stop of its own on the way of Tab
 */
export function help(key, name, label, description, ofField = false) {
  const text = TEXTS[key] ?? (description && described(description));
  if (!text) return null;
  const id = uniqueId('help');
  return h(
    'span',
    { class: 'help' },
    h(
      'button',
      {
        type: 'button',
        class: 'plain',
        popovertarget: id,
        'aria-label': 'Explanation',
        'aria-describedby': label,
        tabindex: ofField ? -1 : null,
      },
      '?',
    ),
    h('span', { id, popover: 'auto', role: 'note' }, h('b', {}, name), h('br'), text),
  );
}
