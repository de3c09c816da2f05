// ---- A picture of the surface without WebGL: triangles and arcs from far to near.

function hasCanvas() {
  return Boolean(document.createElement("canvas").getContext("2d"));
}

function picture(width, height) {
  const s = model.surface, points = numbers(s.points), triangles = numbers(s.triangles);
  const corner = numbers(s.corner.point);
  const patch = s.corner.patch ? numbers(s.corner.patch) : null, arcs = model.tmesh ? numbers(s.arcs) : [];
  const axes = viewAxes(points), extent = extentAlong(axes, points);
  const size = extent.map(([low, high]) => high - low), zoom = 0.92 * Math.min(width / size[0], height / size[1]);
  const middle = extent.map(([low, high]) => (low + high) / 2);
  const onPicture = (points, p) => [width / 2 + zoom * (along(axes[0], points, p) - middle[0]),
                                    height / 2 - zoom * (along(axes[1], points, p) - middle[1]),
                                    along(axes[2], points, p)];
  const seen = new Float32Array(points.length);   // x and y in pixels, and the depth towards the eye
  for (let p = 0; p < points.length; p += 3) seen.set(onPicture(points, p), p);
  const vertexNormals = normals(points, corner, triangles);
  const light = unit([0, 1, 2].map(k => 0.3 * axes[0][k] + 0.5 * axes[1][k] + axes[2][k]));
  const items = [];   // {depth, draw}
  for (let t = 0; t < triangles.length; t += 3) {
    const at = [0, 1, 2].map(k => 3 * corner[triangles[t + k]]);
    items.push({depth: Math.min(...at.map(p => seen[p + 2])), t, at});
  }
  const lift = size[2] / 300;   // arcs come after the triangles at them
  for (let a = 0; a < arcs.length; a += 2) {
    const at = [3 * arcs[a], 3 * arcs[a + 1]];
    items.push({depth: Math.max(...at.map(p => seen[p + 2])) + lift, at});
  }
  const addMarker = (singularity, isCorner) => {
    if (singularity.position)
      items.push({depth: along(axes[2], singularity.position, 0) + 2 * lift, singularity, isCorner});
  };
  for (const singularity of report.singularities || [])
    addMarker(singularity, false);
  for (const corner of corners) addMarker(corner, true);
  items.sort((a, b) => a.depth - b.depth);

  const canvas = make("canvas", {width, height, id: "picture"}), context = canvas.getContext("2d");
  context.lineJoin = context.lineCap = "round";
  const path = at => {
    context.beginPath();
    at.forEach((p, k) => context[k === 0 ? "moveTo" : "lineTo"](seen[p], seen[p + 1]));
  };
  for (const {t, at, singularity, isCorner} of items) {
    if (singularity) {
      const [x, y] = onPicture(singularity.position, 0), r = width / 190;
      context.beginPath();
      if (isCorner) context.rect(x - r, y - r, 2 * r, 2 * r);
      else context.arc(x, y, r, 0, 2 * Math.PI);
      context.fillStyle = orderColour(singularity.order);
      context.fill();
    } else if (t === undefined) {
      path(at);
      context.strokeStyle = "#2b3340";
      context.lineWidth = width / 500;
      context.stroke();
    } else {
      const brightness = 0.55 + 0.45 * Math.max(0, at.reduce((sum, p) => sum + along(light, vertexNormals, p), 0) / 3);
      const colour = patch && colourOfPatch.length > 0 ? colourOfPatch[patch[triangles[t]]] : "#d3d9e2";
      const rgb = [1, 3, 5].map(k => Math.round(brightness * parseInt(colour.slice(k, k + 2), 16)));
      path(at);
      context.closePath();
      context.fillStyle = context.strokeStyle = `rgb(${rgb.join()})`;
      context.lineWidth = 0.7;   // no gaps between triangles
      context.fill();
      context.stroke();
    }
  }
  return canvas;
}
