// ---- What the program embedded in the page, and the colours that all parts of it share.

const read = id => JSON.parse(document.getElementById(id).textContent);
const run = read("run"), report = read("report"), model = read("model");

// {type, length, base64} as a typed array
function numbers(array) {
  const text = atob(array.base64), bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  const Type = {Float32Array, Uint32Array}[array.type];
  return new Type(bytes.buffer);
}

// The colours of the program's pictures: simple poles red, double ones orange, higher ones dark red; simple zeros blue,
// double ones green, higher ones turquoise.
const poleColours = ["#db2924", "#f58c1a", "#730d26"], zeroColours = ["#215ccc", "#1f9947", "#0d9ead"];
function orderColour(order) {
  if (order === 0) return "#8c8c8c";
  const colours = order < 0 ? poleColours : zeroColours;
  return colours[Math.min(Math.abs(order), colours.length) - 1];
}
const corners = report.corners || [];   // of the boundary
const orderName = order => (order < 0 ? "−" : "+") + Math.abs(order);

const loopColours = {a: "#f2991a", b: "#0a807a"};

// Soft colours, as many as neighbours need to differ wherever that is possible.
const softColours = ["#f4b9a7", "#a9cfe8", "#bfdfae", "#f3d998", "#cdbfe6", "#f2bdd6", "#a8dcd2", "#d9c6ac", "#c6d2f2",
                     "#dfe39b"];

// A colour for every patch: the one its neighbours have least, of those the one used least.
function patchColours(tmesh) {
  const neighbours = tmesh.patches.map(() => new Set()), first = new Map();
  tmesh.patches.forEach((patch, p) => patch.sides.flat().forEach(({arc}) => {
    if (first.has(arc) && first.get(arc) !== p) {
      neighbours[p].add(first.get(arc));
      neighbours[first.get(arc)].add(p);
    }
    first.set(arc, p);
  }));
  const chosen = new Array(tmesh.patches.length).fill(-1), uses = softColours.map(() => 0);
  const area = p => tmesh.patches[p].width * tmesh.patches[p].height;
  const bySize = tmesh.patches.map((patch, p) => p).sort((p, q) => area(q) - area(p));
  for (const p of bySize) {
    const near = softColours.map(() => 0);
    for (const q of neighbours[p]) if (chosen[q] >= 0) ++near[chosen[q]];
    const best = softColours.map((_, c) => c).sort((c, d) => near[c] - near[d] || uses[c] - uses[d] || c - d)[0];
    chosen[p] = best;
    ++uses[best];
  }
  return chosen.map(c => softColours[c]);
}
const colourOfPatch = model.tmesh ? patchColours(model.tmesh) : [];

// ---- Elements

// make("p", {class: "note"}, "text", child, ...): an element; text is never taken as HTML
function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children.flat(Infinity));
  return element;
}
function makeSvg(tag, attributes = {}, ...children) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children.flat(Infinity));
  return element;
}

// ---- Numbers

const superscript = n => String(n).replace(/[-\d]/g, c => c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[c]);

// a number for people: three digits, powers of ten where it is very small or very large
function shown(x, digits = 3) {
  if (x === null || x === undefined || !Number.isFinite(x)) return "–";
  if (x === 0) return "0";
  const size = Math.abs(x);
  if (size < 1e-3 || size >= 1e6) {
    const [mantissa, exponent] = x.toExponential(digits - 1).split("e");
    return mantissa.replace("-", "−") + " · 10" + superscript(Number(exponent));
  }
  const wholeDigits = size >= 1 ? Math.floor(Math.log10(size)) + 1 : 0;
  return Number(x.toPrecision(Math.max(digits, wholeDigits))).toString().replace("-", "−");
}
const grouped = n => Math.round(n).toLocaleString("en").replace(/,/g, " ");
function complex(re, im, format = x => shown(x, 3)) {
  return format(re) + (im < 0 ? " − " : " + ") + format(Math.abs(im)) + " i";
}
const decimals = n => x => (Object.is(Number(x.toFixed(n)), -0) ? 0 : x).toFixed(n).replace("-", "−");
