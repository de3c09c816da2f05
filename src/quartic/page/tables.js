// ---- The sections below the model: text, tables and charts from the report.

function table(columns, rows) {
  const kind = column => column.text ? {class: "text"} : {};
  return make("div", {class: "scroll"}, make("table", {},
    make("thead", {}, make("tr", {}, columns.map(c => make("th", kind(c), c.title)))),
    make("tbody", {}, rows.map(row => make("tr", {}, columns.map(c => make("td", kind(c), c.of(row))))))));
}
function list(entries) {
  return make("dl", {}, entries.filter(([, value]) => value !== undefined && value !== "")
    .map(([name, value]) => [make("dt", {}, name), make("dd", {}, value)]));
}
function section(title, ...content) {
  return make("section", {}, make("h2", {}, title), ...content);
}
const note = text => make("p", {class: "note"}, text);

function facts() {
  const list = [["genus", report.input.genus], ["triangles", grouped(report.input.faces)]];
  if (report.singularities) list.push(["singularities", report.singularities.length]);
  if (corners.length > 0) list.push(["corners", corners.length]);
  if (report.tmesh) list.push(["rectangles", grouped(report.tmesh.patches)]);
  if (report.quad_mesh) list.push(["quads", grouped(report.quad_mesh.quads)]);
  if (report.quality) list.push(["area scale spread", shown(report.quality.area_scale_99_to_1_percent)]);
  if (report.max_holonomy_error_radians !== undefined)
    list.push(["holonomy error [rad]", shown(report.max_holonomy_error_radians, 2)]);
  list.push(["seconds", shown(report.timings.total)]);
  return list.map(([name, value]) => make("li", {}, make("b", {}, String(value)), make("span", {}, name)));
}

function dot(order) {
  return make("i", {class: "dot", style: `background:${orderColour(order)}`});
}

function square(order) {
  return make("i", {class: "dot square", style: `background:${orderColour(order)}`});
}
const quadsAt = n => n === 1 ? "1 quad" : `${n} quads`;
function boundaryText() {
  const b = report.input.boundary;
  return b === 0 ? "" : b === 1 ? "1 boundary curve, " : `${b} boundary curves, `;
}

// of singularities and corners
const placeColumns = [
  {title: "position", of: s => s.position ? s.position.map(x => shown(x, 4)).join(", ") : `face ${s.face}`},
  {title: "moved by", of: s => shown(s.moved_by)},
  {title: "", of: s => s.pinned ? "pinned" : ""}];

function cornersOfBoundary() {
  if (corners.length === 0) return "";
  const columns = [
    {title: "", of: c => String(corners.indexOf(c) + 1)},
    {title: "quads", of: c => make("span", {}, square(c.order), " " + c.quads)},
    ...placeColumns];
  return make("div", {},
    make("h2", {}, "Corners"),
    note("At a corner of the boundary with m quads the angle is m right angles, and its order m − 2. Between corners the "
         + "boundary is straight."),
    table(columns, corners));
}

function singularities() {
  const all = report.singularities;
  if (!all) return "";
  if (all.length === 0)
    return make("div", {}, make("h2", {}, "Singularities"), note("There is none: the metric is flat everywhere."));
  const columns = [
    {title: "", of: s => String(all.indexOf(s) + 1)},
    {title: "order", of: s => make("span", {}, dot(s.order), " " + orderName(s.order))},
    {title: "valence", of: s => String(s.valence)},
    ...placeColumns];
  return make("div", {},
    make("h2", {}, "Singularities"),
    note("A vertex of valence k is a zero of order k − 4 of the differential (a pole where that is negative). "
         + (report.input.boundary === 0 ? "The orders add up to 8g − 8. "
                                        : "With those of the corners the orders add up to 8g − 8 + 4b. ")
         + "“Moved by” is how far legalization and exact holonomy took it."),
    table(columns, all));
}

function holonomy() {
  if (!report.holonomy) return "";
  const columns = [
    {title: "loop", of: h => h.loop},
    {title: "rotation, degrees", of: h => shown(90 * h.multiple_of_90, 4)},
    {title: "off by, degrees", of: h => shown(h.error_degrees, 2)}];
  return make("div", {},
    make("h2", {}, "Holonomy"),
    note("A direction carried along a loop comes back rotated by a multiple of 90°. Round a singularity it is the cone "
         + "angle." + (report.input.boundary === 0 ? "" : " Arcs lead from one boundary curve to another, from its direction "
                                                         + "to that of the other.")),
    table(columns, report.holonomy));
}

function conesSection() {
  if (!report.singularities && !report.holonomy) return null;
  return make("section", {}, make("div", {class: "columns"}, singularities(), cornersOfBoundary(), holonomy()));
}

function matrix(rows) {
  return make("table", {class: "matrix"},
    make("tbody", {}, rows.map(row => make("tr", {}, row.map(x => make("td", {}, x))))));
}
function surfaceSection() {
  const p = report.period_matrix, a = report.abel_jacobi;
  if (!p || report.input.genus === 0) return null;
  const entries = p.re.map((row, i) => row.map((re, j) => complex(re, p.im[i][j], decimals(4))));
  const periods = make("figure", {}, make("h3", {}, "Period matrix"), make("div", {class: "scroll"}, matrix(entries)),
    make("figcaption", {}, "Symmetric, imaginary part positive definite. Discretisation indicator "
                           + shown(p.star_defect, 2) + "."));
  const content = [];
  if (a) content.push(make("figure", {}, make("h3", {}, "Abel–Jacobi image of the divisor"),
    make("div", {class: "scroll"}, table([{title: "", of: z => String(a.image.indexOf(z) + 1)},
      {title: "image", of: z => complex(z.re, z.im, x => shown(x, 2))},
      {title: "s", of: z => String(a.integers.s[a.image.indexOf(z)])},
      {title: "t", of: z => String(a.integers.t[a.image.indexOf(z)])}], a.image)),
    make("figcaption", {}, "Zero modulo the lattice of periods; s and t are the integers. Residual "
                           + `${shown(a.residual, 2)} rad after ${a.iterations} Gauss–Newton steps.`)));
  const loops = report.homology && report.homology.loops;
  if (loops) content.push(make("figure", {}, make("h3", {}, "Loops of the homology basis"),
    table([{title: "loop", of: l => l.name}, {title: "kind", of: l => l.kind || "–"},
           {title: "length", of: l => shown(l.length)}, {title: "edges", of: l => String(l.vertices.length)}], loops)));
  return section("The Riemann surface", periods, make("div", {class: "columns"}, content));
}

function convergenceSection() {
  const charts = [], d = report.distortion, a = report.abel_jacobi, f = report.flow;
  if (a && a.history.length > 1)
    charts.push(convergenceChart(a.history, {title: "Legalization", x: "Gauss–Newton step", y: "residual, rad",
                                             colour: "#a8611f"}));
  if (d && d.history && d.history.length > 1)
    charts.push(convergenceChart(d.history, {title: "Area distortion while singularities move",
                                             y: "mean square of log scale", colour: "#a8611f"}));
  if (f && f.history.length > 1)
    charts.push(convergenceChart(f.history, {title: "Flow to the flat metric", x: "Newton step",
                                             y: "curvature error, rad", tolerance: f.tolerance}));
  if (f && f.holonomy_history.length > 1)
    charts.push(convergenceChart(f.holonomy_history, {title: "Exact holonomy", x: "outer step",
                                                      y: "holonomy error, rad", colour: "#17806d"}));
  if (charts.length === 0) return null;
  const legal = a && a.history.length === 1
    ? note(`Legalization: the divisor is on the Abel–Jacobi variety, residual ${shown(a.residual, 2)} rad`
           + (d && d.search ? `; the search among ${d.search.count} singularities kept it there.` : ".")) : "";
  return section("Convergence", legal, make("div", {class: "columns charts"}, charts));
}

function distortionSection() {
  const h = model.histograms, q = report.quality;
  if (!h || !q) return null;
  const charts = [];
  if (h.log_conformal_distortion) {
    const c = q.conformal_distortion;
    charts.push(histogramChart(h.log_conformal_distortion, {
      title: "Conformal distortion", x: "σ₁ / σ₂, 1 is an exactly conformal triangle",
      caption: `Mean ${shown(c.mean, 4)}, 95 % of the area below ${shown(c["95_percent"], 4)}, largest `
               + `${shown(c.max, 4)}. The last bin holds everything above.`}));
  }
  charts.push(histogramChart(h.log_area_scale, {
    title: "Area scale", x: "flat area / area, 1 on average of the logarithm", colour: "#17806d",
    caption: `The 99 % quantile is ${shown(q.area_scale_99_to_1_percent)} times the 1 % quantile.`}));
  return section("Distortion", make("div", {class: "columns charts"}, charts));
}

function quadsSection() {
  const q = report.quad_mesh;
  if (!q) return null;
  const entries = [
    ["quads, vertices", `${grouped(q.quads)}, ${grouped(q.vertices)} (asked for: ${grouped(q.target)})`],
    ["scaled Jacobian", `at least ${shown(q.scaled_jacobian.min)}, ${shown(q.scaled_jacobian.mean, 4)} on average`],
    ["angles", `${shown(q.angle_degrees.min)}° to ${shown(q.angle_degrees.max)}°, off 90° by `
       + `${shown(q.angle_degrees.mean_deviation_from_90)}° on average`],
    ["sides", `up to 1 : ${shown(q.edge_ratio.max)} in a quad`],
    ["distance", `at most ${shown(q.distance_by_diagonal.quads_to_input.max)} of the diagonal from the surface, rms `
       + shown(q.distance_by_diagonal.quads_to_input.rms)],
    ["irregular vertices", Object.entries(q.irregular_vertices).map(([valence, n]) => `${n} of valence ${valence}`)
       .join(", ") || "none"],
    ["integer lengths", `${q.quantization.method}` + (q.quantization.optimal ? ", proved to be the best" : "")
       + `; cost ${shown(q.quantization.cost)}, lower bound ${shown(q.quantization.lower_bound)}`]];
  if (q.smoothing) entries.push(["smoothing", `${q.smoothing.sweeps} sweeps; before, the scaled Jacobian was at least `
    + shown(q.smoothing.before.min)]);
  if (q.shortfall) entries.push(["number", q.shortfall]);
  if (q.splines) {
    const s = q.splines;
    entries.push(["splines", `${s.patches} bicubic patches of ${s.spans_by_patch_side} spans a side; distance from the `
      + `surface at most ${shown(s.distance_by_diagonal.max)} of the diagonal, rms ${shown(s.distance_by_diagonal.rms)}`]);
  }
  return section("Quad mesh", list(entries));
}

const stepNames = {
  read: "read", homology: "homology basis", holomorphic_forms: "holomorphic forms", period_matrix: "period matrix",
  abel_jacobi: "Abel–Jacobi map", legalization: "singularities, legalization", cone_metric: "flat metric",
  holonomy: "exact holonomy", immersion: "immersion", refinement: "refinement", t_mesh: "T-mesh", quad_mesh: "quads",
  write: "writing"};

function timeSection() {
  const {total, ...steps} = report.timings, longest = Math.max(...Object.values(steps), 1e-9);
  const bar = seconds => {
    const svg = makeSvg("svg", {viewBox: "0 0 300 10", preserveAspectRatio: "none", class: "bars"});
    svg.append(makeSvg("rect", {class: "bar", width: 300 * seconds / longest, height: 10, rx: 1.5}));
    return svg;
  };
  const seconds = s => s === 0 ? "–" : s < 0.0005 ? "< 0.001" : s.toFixed(3);
  const rows = Object.entries(steps).map(([name, s]) => make("tr", {}, make("td", {}, stepNames[name] || name),
    make("td", {style: "width:60%"}, bar(s)), make("td", {}, seconds(s))));
  rows.push(make("tr", {}, make("td", {}, make("b", {}, "total")), make("td"),
                 make("td", {}, make("b", {}, seconds(total)))));
  return section("Running time",
    note("Wall-clock seconds; that of putting down report.json and this page at the end is not in it."),
    make("table", {}, make("tbody", {}, rows)),
    note(`Peak memory ${grouped(report.peak_memory_bytes / 2 ** 20)} MiB.`));
}

function runSection() {
  const i = report.input, v = report.versions, p = report.precision;
  const files = [];
  if (i.embedded && (report.singularities || []).length > 0) files.push("singularities");
  if (i.embedded && corners.length > 0) files.push("corners");
  const edit = files.length > 0
    ? [note(`To go on from these ${files.join(" and ")}, edit or pin them in ${files.join(".txt and ")}.txt and add:`),
       make("pre", {}, files.map(name => `--${name} ${run.folder}/${name}.txt`).join(" "))] : [];
  return section("The run",
    list([["input", i.mesh],
          ["surface", `genus ${i.genus}, ${boundaryText()}${grouped(i.vertices)} vertices, ${grouped(i.edges)} edges, `
                      + `${grouped(i.faces)} faces, area ${shown(i.area, 5)}`
                      + (i.embedded ? "" : "; known by its edge lengths alone")],
          ["notes", i.notes.join("; ")], ["results", run.folder],
          ["charts", report.immersion && `exact on a grid of 2${superscript(-report.immersion.grid_exponent)}, `
                                         + `${report.immersion.flips} triangles flipped`],
          ["precision", p && `${p.bits} bits` + (p.reason ? ": " + p.reason : "")],
          ["versions", `quartic ${v.quartic}, CGAL ${v.cgal}, Eigen ${v.eigen}, ${v.factorisation}, `
                       + `compiler ${v.compiler}`]]),
    make("h3", {}, "To do it again"), make("pre", {}, run.command), ...edit);
}
