/** What laboratories call columns and specimens, `api/columns.json`: `npm --prefix tests/page run presets`. */

/* prettier-ignore */
/** @type {{[name: string]: string}} */
export const ROLES = {
  "time": "(prüf|test|elapsed|running|total)?(zeit|time|temps|tiempo)",
  "plastic_strain": "(true|wahre|equivalent|log|logarithmic)?plast(ic|isch|ische)?(ε|eps|epsilon|strain|dehnung|verformung)|(ε|eps|epsilon)p(l|last)?|umformgrad|logarithmischeformänderung|(déformation|deformation)plasti(que|ca)|peeq",
  "true_strain": "(true|wahre|log|logarithmic|logarithmische|hencky)(ε|eps|epsilon|strain|dehnung|verformung)|tstrain|(déformation|deformation)(vraie|rationnelle|logarithmique)",
  "engineering_strain": "(eng|engineering|nominal|total|tensile|compressive|axial|technische|gesamt|nenn|zug|druck|extensometer|standard)(ε|eps|epsilon|strain|dehnung|stauchung)\\d?|estrain|strain\\d|(déformation|deformation)(totale|nominale)|allongement(relatif|total)?",
  "strain": "ε|e|eps|epsilon|strain|dehnung|stauchung|déformation|deformation",
  "true_stress": "(true|wahre|flow|cauchy|vonmises|equivalent)(σ|sig|sigma|stress|spannung|q)|(fließ|fliess|vergleichs)spannung|tstress|q|contraintevraie",
  "engineering_stress": "(eng|engineering|nominal|total|tensile|compressive|axial|technische|nenn|zug|druck|standard)(σ|sig|sigma|stress|spannung)|estress|contraintenominale",
  "stress": "σ|s|r|sig|sigma|stress|spannung|contrainte",
  "force": "(axial|standard|test|prüf|normal|indentation|raw)?(force|load|kraft|last)(zelle|cell)?|f|p|fn|fz|charge|effort|force(axiale|normale)",
  "extension": "(extensometer|axialextension|axialextensometer|längenänderung|verlängerung|extensomètre|feindehnung|dehnungsaufnehmer|extensometerweg|extensometertravel|strainextensometer|(axial)?strainextension)\\d?",
  "travel": "(standard|traversen|crosshead|maschinen|machine|axial|kolben|tensile|compressive|grip)?(weg|travel|extension|displacement|position|stroke|separation|hub)|crosshead|traverse|traverseabs|wegabs|déplacement|deplacement|élongation|elongation|allongement|verformung|deformation|déformation|ext",
  "penetration": "(eindring|prüfkörper|indentation|penetration|indenter|indent|contact)?(depth|tiefe)|h|profondeur|(profondeur|enfoncement)depénétration|displacement(intosurface)?|eindringweg",
  "depth": "z|depth|(rand|oberflächen)?abstand(vomrand|vonderoberfläche)?|(rand|mess|härte)?tiefe|distance|distancefrom(the)?(surface|edge)|profondeur|profondità|profundidad|position",
  "hardness": "(hardness|härte(wert)?|vickers|dureté|durezza|dureza)*((hv|vhn|dph|dpn)[\\d,/]*|hrc|rockwellc)?",
  "factor": "factor|faktor|facteur",
  "place": "x|r|position|pos|distance|weg|länge|length|abscisse|abstand",
  "height": "h|y|z|height|höhe|hauteur|profil|profile|cote|amplitude",
  "count": "nr|no|n°|nº|num|number|nummer|lfdnr|index|i|point|punkt|messpunkt|indent|eindruck|mesure|#"
};

/* prettier-ignore */
/** @type {{[name: string]: string}} */
export const FACTS = {
  "diameter": "(specimen|proben?|initial|anfangs)?(diameter|durchmesser|diamètre|d0|d)",
  "width": "(specimen|proben?|initial|anfangs)?(width|breite|largeur|b0|b)",
  "thickness": "(specimen|proben?|initial|anfangs)?(thickness|dicke|épaisseur|a0)",
  "section": "(specimen|proben?|initial|anfangs)?(area|crosssection|crosssectionalarea|section|querschnitt|querschnittsfläche|surface|s0)",
  "gauge_length": "(specimen|proben?|initial|anfangs|extensometer)?(gaugelength|gagelength|messlänge|meßlänge|longueur|longueurutile|longueurdebase|l0|le|gripseparation|griplength|einspannlänge|clampinglength)"
};
