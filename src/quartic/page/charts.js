// ---- Charts, drawn as SVG.

const chartWidth = 440, chartHeight = 230, margin = {left: 72, right: 14, top: 12, bottom: 38};

function chartFrame(xTitle, yTitle, label) {
  const svg = makeSvg("svg", {viewBox: `0 0 ${chartWidth} ${chartHeight}`, role: "img", "aria-label": label});
  const x = (margin.left + chartWidth - margin.right) / 2, y = (margin.top + chartHeight - margin.bottom) / 2;
  svg.append(makeSvg("text", {x, y: chartHeight - 4, "text-anchor": "middle"}, xTitle),
             makeSvg("text", {transform: `translate(12 ${y}) rotate(-90)`, "text-anchor": "middle"}, yTitle));
  return svg;
}

const scale = (from, to, low, high) => x => low + (high - low) * (to === from ? 0.5 : (x - from) / (to - from));
const xScale = (from, to) => scale(from, to, margin.left, chartWidth - margin.right);
const yScale = (from, to) => scale(from, to, chartHeight - margin.bottom, margin.top);

function axes(svg) {
  const bottom = chartHeight - margin.bottom;
  svg.append(makeSvg("line", {class: "axis", x1: margin.left, x2: chartWidth - margin.right, y1: bottom, y2: bottom}));
}
function xTick(svg, x, text) {
  const y = chartHeight - margin.bottom;
  svg.append(makeSvg("line", {class: "axis", x1: x, x2: x, y1: y, y2: y + 4}),
             makeSvg("text", {x, y: y + 17, "text-anchor": "middle"}, text));
}
function yTick(svg, y, text) {
  svg.append(makeSvg("line", {class: "grid", x1: margin.left, x2: chartWidth - margin.right, y1: y, y2: y}),
             makeSvg("text", {x: margin.left - 7, y: y + 4, "text-anchor": "end"}, text));
}

// round steps: about `count` of them between two numbers
function niceTicks(from, to, count) {
  const raw = (to - from) / count || 1, power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map(m => m * power).find(s => s >= raw * 0.999);
  const ticks = [];
  for (let k = Math.ceil(from / step - 1e-9); k * step <= to + 1e-9 * step; ++k) ticks.push(k * step);
  return ticks;
}

// Errors by step on a logarithmic axis; or, where the values hardly change, on a linear one.
function convergenceChart(history, {title, x = "step", y, colour = "#2f6690", tolerance}) {
  const positive = history.filter(v => v > 0);
  if (positive.length === 0) return make("p", {class: "note"}, title + ": zero from the start.");
  const all = tolerance ? positive.concat(tolerance) : positive;
  const logarithmic = Math.max(...all) / Math.min(...all) > 30;
  const of = logarithmic ? Math.log10 : v => v;
  let low = Math.min(...all.map(of)), high = Math.max(...all.map(of));
  if (logarithmic) { low = Math.floor(low); high = Math.ceil(high); }
  else { const pad = (high - low || Math.abs(high) || 1) * 0.08; low -= pad; high += pad; }
  const svg = chartFrame(x, y, title), toX = xScale(0, Math.max(1, history.length - 1)), toY = yScale(low, high);
  if (logarithmic) {
    const every = Math.max(1, Math.ceil((high - low) / 6));
    for (let e = high; e >= low; e -= every) yTick(svg, toY(e), "10" + superscript(e));
  } else for (const t of niceTicks(low, high, 4)) yTick(svg, toY(t), shown(t, 4));
  axes(svg);
  const last = Math.max(1, history.length - 1), every = Math.ceil(last / 10);
  for (let k = 0; k <= last; k += every) xTick(svg, toX(k), k);
  if (tolerance) {
    const at = toY(of(tolerance));
    svg.append(makeSvg("line", {x1: margin.left, x2: chartWidth - margin.right, y1: at, y2: at, stroke: "#98a2b3",
                                "stroke-dasharray": "5 4"}),
               makeSvg("text", {x: margin.left + 6, y: at - 5}, "tolerance"));
  }
  const points = history.map((v, k) => [toX(k), toY(of(Math.max(v, 10 ** -300)))]).filter((_, k) => history[k] > 0);
  svg.append(makeSvg("polyline", {class: "curve", stroke: colour, points: points.map(p => p.join()).join(" ")}));
  const r = points.length > 30 ? 1.8 : 3.2;
  for (const [cx, cy] of points) svg.append(makeSvg("circle", {cx, cy, r, fill: colour}));
  return make("figure", {}, make("h3", {}, title), svg);
}

// Shares of the area; the axis of values is logarithmic: `from` and `to` are logarithms.
function histogramChart({from, to, share}, {title, x, colour = "#2f6690", caption}) {
  const svg = chartFrame(x, "% of the area by bin", title), highest = Math.max(...share) * 100;
  const toX = xScale(from, to), toY = yScale(0, highest * 1.05);
  for (const t of niceTicks(0, highest * 1.05, 4)) yTick(svg, toY(t), shown(t, 2));
  const width = (to - from) / share.length;
  share.forEach((s, k) => {
    const left = toX(from + k * width), top = toY(100 * s);
    svg.append(makeSvg("rect", {x: left + 0.5, y: top, width: Math.max(0.5, toX(from + width) - toX(from) - 1),
                                height: Math.max(0, toY(0) - top), fill: colour}));
  });
  axes(svg);
  for (const t of niceTicks(Math.exp(from), Math.exp(to), 6))
    if (t > 0 && Math.log(t) >= from && Math.log(t) <= to) xTick(svg, toX(Math.log(t)), shown(t, 4));
  return make("figure", {}, make("h3", {}, title), svg, make("figcaption", {}, caption));
}
