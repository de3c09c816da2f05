// ---- Puts the page together.

function layerControls(viewer) {
  const box = document.getElementById("layers");
  for (const layer of viewer.layers) {
    const input = make("input", {type: "checkbox", name: layer.name});
    input.checked = layer.on;
    input.addEventListener("change", () => layer.set(input.checked));
    const label = make("label", {}, input, make("span", {}, layer.label));
    if (layer.colour) label.append(make("i", {class: "stroke", style: `background:${layer.colour}`}));
    box.append(label);
    if (layer.name === "checkerboard") {
      const size = make("input", {type: "range", min: 2, max: 5, step: 0.05, value: Math.log10(2500),
                                  "aria-label": "number of squares"});
      size.addEventListener("input", () => viewer.setSquares(10 ** Number(size.value)));
      box.append(make("label", {class: "range"}, size));
    }
  }
}

function legend() {
  const box = document.getElementById("legend");
  const add = (title, singularities, mark, name) => {
    const count = new Map();
    for (const s of singularities) count.set(s.order, (count.get(s.order) || 0) + 1);
    if (count.size === 0) return;
    const items = [...count.keys()].sort((a, b) => a - b)
      .map(order => make("li", {}, mark(order), `${name(order)}: ${count.get(order)}`));
    box.append(make("h3", {}, title), make("ul", {}, items));
  };
  add("Singularities", report.singularities || [], dot, order => `order ${orderName(order)}, valence ${order + 4}`);
  add("Corners", corners, square, order => quadsAt(order + 2));
}

// What takes the model's place: a picture of it, and why.
function withoutModel() {
  document.getElementById("layers").remove();
  const view = document.getElementById("view");
  const why = !model.surface ? "The surface is known by its edge lengths alone: it has no shape in space to show."
    : typeof THREE === "undefined" ? "The model does not turn: this program was built without three.js. Install it "
                                     + "(Debian: libjs-three), build again and run again."
    : "The model does not turn: this browser has no WebGL, or it is switched off.";
  document.getElementById("view-note").textContent = why;
  if (model.surface && hasCanvas()) view.append(picture(2 * view.clientWidth, 2 * view.clientHeight));
  else view.remove();
}

function assemble() {
  const i = report.input;
  document.getElementById("subtitle").textContent =
    `genus ${i.genus}, ${boundaryText()}${grouped(i.vertices)} vertices, ${grouped(i.faces)} triangles`;
  document.getElementById("facts").append(...facts());
  document.getElementById("sections").append(...[atlasSection, quadsSection, conesSection, surfaceSection,
    convergenceSection, distortionSection, timeSection, runSection].map(make => make()).filter(Boolean));
  legend();
  const viewer = createViewer(document.getElementById("view"));
  if (viewer) {
    layerControls(viewer);
    document.getElementById("help").textContent =
      "Drag to turn, right button or two fingers to move, wheel or pinch to zoom.";
    document.getElementById("credit").textContent =
      ` The model is drawn with three.js r${THREE.REVISION} (MIT licence).`;
    const notes = [];
    if (model.surface.reduced_from)
      notes.push(`The surface has ${grouped(model.surface.reduced_from)} triangles; it is drawn with fewer, `
                 + `${grouped(model.surface.triangles.length / 3)} in a regular grid on every patch, `
                 + "without those of the input.");
    if (model.surface.corner.uv && model.tmesh)
      notes.push("The squares of the checkerboard are exact squares of the flat metric. Patches lie side by side along "
                 + "the longest arcs; across the others the pattern is shifted, since their lengths are no whole "
                 + "numbers of squares.");
    document.getElementById("view-note").textContent = notes.join(" ");
  } else withoutModel();
  return viewer;
}

const viewer = assemble();
if (location.hash === "#selftest") selfTest(viewer);
