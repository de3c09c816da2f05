// ---- The patches in the plane: rectangles to scale, packed in rows.

function atlasSection() {
  const t = model.tmesh;
  if (!t) return null;
  const area = t.patches.reduce((sum, p) => sum + p.width * p.height, 0);
  const lying = t.patches.map((patch, index) => ({patch, index, turned: patch.height > patch.width,
    w: Math.max(patch.width, patch.height), h: Math.min(patch.width, patch.height)}));
  const width = 1100, gap = 7;
  const unit = Math.min(Math.sqrt(width * 430 / area), width / Math.max(...lying.map(r => r.w)));   // pixels by unit
  lying.sort((r, s) => s.h - r.h || s.w - r.w);
  const rows = [];   // every rectangle goes to the first row with room for it
  for (const r of lying) {
    r.pw = r.w * unit;
    r.ph = Math.max(r.h * unit, 0.8);
    let row = rows.find(row => row.used + r.pw <= width + 1e-6);
    if (!row) rows.push(row = {used: 0, height: r.ph, rectangles: []});
    r.x = row.used;
    row.used += r.pw + gap;
    row.rectangles.push(r);
  }
  let y = 5;
  for (const row of rows) {
    for (const r of row.rectangles) r.y = y;
    y += row.height + gap;
  }
  const svg = makeSvg("svg", {viewBox: `-5 0 ${width + 10} ${y + 5}`, role: "img",
                              "aria-label": "the patches as rectangles"});
  for (const r of lying) svg.append(rectangle(r));
  for (const r of lying) svg.append(...marks(r, t, unit));
  return section("The patches in the plane",
    note(`${t.patches.length} rectangles to scale, in their colours on the model, some turned by 90°. Red and `
         + "blue dots are singularities, small ones are other ends of arcs."), svg);
}

function rectangle(r) {
  const rect = makeSvg("rect", {x: r.x, y: r.y, width: r.pw, height: r.ph, fill: colourOfPatch[r.index],
                                stroke: "#56606f", "stroke-width": 0.8});
  rect.append(makeSvg("title", {}, `patch ${r.index}: ${shown(r.patch.width, 4)} × ${shown(r.patch.height, 4)}`));
  return rect;
}

// The nodes on the sides, counterclockwise in the patch; y points down in the picture.
function marks(r, t, unit) {
  const {width, height} = r.patch, result = [];
  const place = (side, s) => [[s, 0], [width, s], [width - s, height], [0, height - s]][side];
  const onPicture = ([u, v]) => r.turned ? [r.x + v * unit, r.y + u * unit] : [r.x + u * unit, r.y + r.ph - v * unit];
  r.patch.sides.forEach((side, k) => {
    let s = 0;
    side.forEach((piece, n) => {
      const [from, to, length] = t.arcs[piece.arc], order = t.order[piece.forward ? from : to];
      const [cx, cy] = onPicture(place(k, s));
      if (order !== null)
        result.push(makeSvg("circle", {cx, cy, r: 3.4, fill: orderColour(order), stroke: "#fff", "stroke-width": 0.8}));
      else if (n > 0) result.push(makeSvg("circle", {cx, cy, r: 1.4, fill: "#56606f"}));
      s += length;
    });
  });
  return result;
}
