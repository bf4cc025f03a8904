/**
 * Materials of `api/materials.json`, in mm, N, MPa. Generated: `npm --prefix tests/page run
 * presets`.
 */

/* prettier-ignore */
/** @type {import('./materials.js').Preset[]} */
export const PRESETS = [
  {"name":"Steel S235","source":"R_eH 235 MPa: EN 10025-2, up to 16 mm. E, ν: EN 1993-1-1, 3.2.6; hardening E/100: EN 1993-1-5, C.6","material":{"young_modulus":210000,"poisson_ratio":0.3,"plasticity":{"law":"bilinear","yield_stress":235,"tangent_modulus":2100}}},
  {"name":"Steel S355","source":"R_eH 355 MPa: EN 10025-2, up to 16 mm. E, ν: EN 1993-1-1, 3.2.6; hardening E/100: EN 1993-1-5, C.6","material":{"young_modulus":210000,"poisson_ratio":0.3,"plasticity":{"law":"bilinear","yield_stress":355,"tangent_modulus":2100}}},
  {"name":"Steel C45E +QT","source":"R_e 430 MPa: EN 10083-2, 16 to 40 mm. E, ν: EN 1993-1-1, 3.2.6; hardening E/100: EN 1993-1-5, C.6","material":{"young_modulus":210000,"poisson_ratio":0.3,"plasticity":{"law":"bilinear","yield_stress":430,"tangent_modulus":2100}}},
  {"name":"Steel 42CrMo4 +QT","source":"R_e 750 MPa: EN 10083-3, 16 to 40 mm. E, ν: EN 1993-1-1, 3.2.6; hardening E/100: EN 1993-1-5, C.6","material":{"young_modulus":210000,"poisson_ratio":0.3,"plasticity":{"law":"bilinear","yield_stress":750,"tangent_modulus":2100}}},
  {"name":"Bearing steel 52100 (100Cr6), hardened","source":"q = B (C + 10^6 ε_p)^n, B = 945 MPa, C = 20, n = 0.121, as in the document on static rating. E, ν as there.","material":{"young_modulus":210000,"poisson_ratio":0.3,"plasticity":{"law":"swift","yield_stress":1357.865,"strain_offset":0.00002,"exponent":0.121}}},
  {"name":"Bearing steel, elastic","source":"E, ν as in ISO/TS 16281. No yield: for loads within the static rating.","material":{"young_modulus":207000,"poisson_ratio":0.3}},
  {"name":"Bearing steel 100Cr6, 58 HRC","source":"58 HRC is 653 HV (ISO 18265). Yield estimated: σ_y = 2.876 HV − 90.7 MPa, Pavlina and Van Tyne 2008, a little beyond their hardest steels. E, ν as in ISO/TS 16281; hardening E/100 assumed.","material":{"young_modulus":207000,"poisson_ratio":0.3,"plasticity":{"law":"bilinear","yield_stress":1787,"tangent_modulus":2100}}},
  {"name":"Gear steel 18CrNiMo7-6, case 1 mm","source":"Case 660 HV, core 25 HRC or 266 HV: the least of ISO 6336-5, quality MQ; depth to 550 HV 1 mm, to be replaced by the drawing’s. Yield estimated: σ_y = 2.876 HV − 90.7 MPa, Pavlina and Van Tyne 2008. Hardening E/100 assumed.","material":{"young_modulus":210000,"poisson_ratio":0.3,"plasticity":{"law":"bilinear","yield_stress":674,"tangent_modulus":2100,"over_depth":{"hardness":{"surface":660,"core":266,"case_depth":1}}}}},
  {"name":"Rail steel R260","source":"260 HBW, the least of EN 13674-1, is 274 HV (ISO 18265). Yield estimated: σ_y = 2.876 HV − 90.7 MPa, Pavlina and Van Tyne 2008; pearlite scatters below it, a tensile test is better. Hardening E/100 assumed.","material":{"young_modulus":210000,"poisson_ratio":0.3,"plasticity":{"law":"bilinear","yield_stress":697,"tangent_modulus":2100}}},
  {"name":"Rail steel R350HT","source":"350 HBW, the least of EN 13674-1, is 368 HV (ISO 18265). Yield estimated: σ_y = 2.876 HV − 90.7 MPa, Pavlina and Van Tyne 2008; pearlite scatters below it, a tensile test is better. Hardening E/100 assumed.","material":{"young_modulus":210000,"poisson_ratio":0.3,"plasticity":{"law":"bilinear","yield_stress":968,"tangent_modulus":2100}}},
  {"name":"Bronze CuSn7Zn2Pb3-C","source":"R_p0.2 130 MPa (EN 1982, sand cast), E 90–96 GPa: Kemper data sheet. ν 0.34 assumed, no hardening.","material":{"young_modulus":93000,"poisson_ratio":0.34,"plasticity":{"law":"bilinear","yield_stress":130,"tangent_modulus":0}}},
  {"name":"Aluminium EN AW-6061 T6","source":"f_0 240 MPa, n_p 55: EN 1999-1-1, table 3.2b; a = 0.002 E/f_0. E, ν: EN 1999-1-1, 3.2.5","material":{"young_modulus":70000,"poisson_ratio":0.3,"plasticity":{"law":"ramberg_osgood","reference_stress":240,"offset":0.583333,"exponent":55}}},
  {"name":"Reference problem","source":"Jiang and Shang’s cylinders: σ_y 500 MPa, E_t = E/20.","material":{"young_modulus":210000,"poisson_ratio":0.3,"plasticity":{"law":"bilinear","yield_stress":500,"tangent_modulus":10500}}},
];
