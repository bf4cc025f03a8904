/**
 * Tables as laboratories and programs write them: what is taken, with what note, and what is
 * refused. None is taken wrongly without a word.
 */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { readTable } from '../../../web/lib/table.js';

/** @type {Record<string, [import('../../../web/lib/units.js').Quantity[], string[]]>} */
const KINDS = {
  hardness: [['length', 'hardness'], ['z', 'HV']], // prettier-ignore
  strength: [['strain', 'stress'], ['ε_p', 'q']], // prettier-ignore
  stress: [['length', 'stress', 'stress'], ['z', 'σ_x', 'σ_z']], // prettier-ignore
};

/** @param {string} kind @param {string} text */
const read = (kind, text) => readTable(text, KINDS[kind][0], 'mm_N_MPa', KINDS[kind][1]);

/** Name, kind, text, points, words of the note. @type {[string, string, string, number[][], RegExp][]} */
const TAKEN = [
  [
    'a German protocol with BOM, CRLF, running numbers and remarks',
    'hardness',
    '\ufeffPrüfprotokoll 4711\r\nDatum: 12.03.2025\r\nNr.;Abstand [mm];HV1;Bemerkung\r\n1;0,10;720;Rand\r\n2;0,50;640;\r\n3;1,00;500;\r\n',
    [[0.1, 720], [0.5, 640], [1, 500]], // prettier-ignore
    /“Nr\.” counts the lines.*“Bemerkung” left out.*decimal commas read/,
  ],
  [
    'a French header in micrometres',
    'hardness',
    'Profondeur (µm);Dureté (HV0,3)\n100;720\n500;640\n',
    [[0.1, 720], [0.5, 640]], // prettier-ignore
    /converted from µm/,
  ],
  [
    'hardness first, without names',
    'hardness',
    '720 0.1\n640 0.5\n500 1.0',
    [[0.1, 720], [0.5, 640], [1, 500]], // prettier-ignore
    /columns taken as hardness, depth/,
  ],
  [
    'hardness first, with names',
    'hardness',
    'Härte [HV]\tRandabstand [mm]\n720\t0,1\n640\t0,5',
    [[0.1, 720], [0.5, 640]], // prettier-ignore
    /columns taken by their names/,
  ],
  [
    'units beside each number',
    'hardness',
    '100 µm; 720 HV0.5\n0.5 mm; 640 HV0.5\n',
    [[0.1, 720], [0.5, 640]], // prettier-ignore
    /column 1 converted from µm/,
  ],
  [
    'units beside each number but zero',
    'hardness',
    '0;730\n100 µm;720 HV\n0.5 mm;640\n',
    [[0, 730], [0.1, 720], [0.5, 640]], // prettier-ignore
    /column 1 converted from µm/,
  ],
  [
    'units beside each number, spaces between columns',
    'hardness',
    '0.1 mm 720 HV\n0.5 mm 640 HV',
    [[0.1, 720], [0.5, 640]], // prettier-ignore
    /^$/,
  ],
  [
    'a column that counts, without a name',
    'hardness',
    '1\t0.1\t720\n2\t0.5\t640\n3\t1.0\t500',
    [[0.1, 720], [0.5, 640], [1, 500]], // prettier-ignore
    /first column counts the lines/,
  ],
  [
    'a header without the column that counts',
    'hardness',
    'Depth [µm];HV\n1;100;720\n2;500;640\n',
    [[0.1, 720], [0.5, 640]], // prettier-ignore
    /first column counts the lines.*column 2 converted from µm/,
  ],
  [
    'stress over depth with German names',
    'stress',
    'Tiefe [µm];Eigenspannung x [MPa];Eigenspannung z [MPa]\n0;-300;-200\n100;-200;-100',
    [[0, -300, -200], [0.1, -200, -100]], // prettier-ignore
    /column 1 converted from µm/,
  ],
  [
    'a card of a finite-element program',
    'strength',
    '*MATERIAL, NAME=S355\n*ELASTIC\n210000., 0.3\n*PLASTIC\n350., 0.\n400., 0.02\n** a comment\n450., 0.1\n*DENSITY\n7.8e-9',
    [[0, 350], [0.02, 400], [0.1, 450]], // prettier-ignore
    /card \*PLASTIC read: stress, plastic strain/,
  ],
  [
    'a card with one temperature and exponents of Fortran',
    'strength',
    '*Plastic, hardening=ISOTROPIC\n3.5D2, 0., 20.\n4.0D2, 2.0D-2, 20.\n',
    [[0, 350], [0.02, 400]], // prettier-ignore
    /\*PLASTIC/,
  ],
  [
    'the lines of a card alone',
    'strength',
    '350., 0.\n400., 0.02\n450., 0.1',
    [[0, 350], [0.02, 400], [0.1, 450]], // prettier-ignore
    /columns taken as stress, strain/,
  ],
  [
    'columns of a testing machine',
    'strength',
    'Zeit [s];Kraft [N];plast. Dehnung [%];Spannung [MPa]\n0;1;0;350\n1;2;2,5;400',
    [[0, 350], [0.025, 400]], // prettier-ignore
    /“Zeit \[s\]” left out.*“Kraft \[N\]” left out.*converted from %/,
  ],
  [
    'a title, and units in a line of their own',
    'hardness',
    'Case A, sample 3\nz;HV\nmm;HV\n0.1;720\n0.5;640',
    [[0.1, 720], [0.5, 640]], // prettier-ignore
    /3 header lines read/,
  ],
];

/** Name, kind, text, refusal. @type {[string, string, string, RegExp][]} */
const REFUSED = [
  ['a hole', 'hardness', 'z;HV\n0.1;720\n0.5;\n1.0;500', /^line 3 has 1 column, not two/],
  ['a hole in the depths', 'hardness', 'Nr;z;HV\n1;0.1;720\n2;;640', /^line 3: “” is not a number/],
  ['points and commas', 'hardness', 'z;HV\n0,1;720\n0.5;640', /decimal point, and others/],
  ['Brinell hardness', 'hardness', 'Tiefe [mm];Härte HBW\n0.1;300', /“HBW” is another scale/],
  ['a unit in a title', 'hardness', 'Alle Längen in µm\n100;720\n500;640', /^line 1: “Alle Längen in µm”/],
  ['two columns of depth', 'hardness', 'Tiefe;Abstand;HV\n1;0.1;720', /^line 1: “Abstand” is not known/],
  ['no column of hardness', 'hardness', 'Nr;z;Kraft\n1;0.1;720\n2;0.2;700', /has no column called HV/],
  ['three columns without names', 'hardness', '7 0.1 720\n9 0.5 640', /^line 1 has 3 columns, not two/],
  ['depth last', 'stress', '-300;-200;0,0\n-250;-210;0,1\n-250;-220;0,3', /does not rise, and column 3 does: are they swapped/],
  ['engineering strain whose unit nothing tells', 'strength', 'Technische Dehnung;Spannung\n0;0\n0.1;500', /the unit of “Technische Dehnung” is not said/],
  ['total strain in French, likewise', 'strength', 'Déformation totale;Contrainte\n0;0\n0.1;500', /the unit of “Déformation totale” is not said/],
  ['several temperatures', 'strength', '*PLASTIC\n350,0,20\n400,0.1,20\n300,0,200', /line 4 is of another temperature/],
  ['rates', 'strength', '*PLASTIC, RATE=10\n350,0', /“RATE” is not known here/],
  ['another card', 'strength', '*ELASTIC\n210000, 0.3', /^line 1: “\*ELASTIC” is no card/],
  ['a card in another field', 'hardness', '*PLASTIC\n350,0', /is a hardening curve/],
  ['a unit beside one number alone', 'hardness', '100 µm;720\n200;690\n300;600', /^line 2: “200” has no unit, and others of its column are in µm/],
  ['a unit that is none', 'hardness', '0.1 N;720\n0.5 N;640', /^line 1: “0.1 N” is not a number/],
]; // prettier-ignore

for (const [name, kind, text, points, words] of TAKEN)
  test(`taken: ${name}`, () => {
    const table = read(kind, text);
    if ('problem' in table) assert.fail(table.problem);
    assert.deepEqual(table.points, points);
    assert.match(table.notes.join('; '), words);
  });

for (const [name, kind, text, words] of REFUSED)
  test(`refused: ${name}`, () => {
    const table = read(kind, text);
    assert.match('problem' in table ? table.problem : JSON.stringify(table), words);
  });
