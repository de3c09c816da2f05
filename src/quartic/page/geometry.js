// ---- Geometry that the model and the picture share.

// i^k (u + iv) + x + iy
function moved([k, x, y], u, v) {
  const [a, b] = [[u, v], [-v, u], [-u, -v], [v, -u]][k];
  return [a + x, b + y];
}

// Normals by point, of all triangles there, so that the cuts along arcs do not show.
function normals(points, corner, triangles) {
  const sum = new Float32Array(points.length);
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [0, 1, 2].map(k => 3 * corner[triangles[t + k]]);
    const ux = points[b] - points[a], uy = points[b + 1] - points[a + 1], uz = points[b + 2] - points[a + 2];
    const vx = points[c] - points[a], vy = points[c + 1] - points[a + 1], vz = points[c + 2] - points[a + 2];
    const nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
    for (const p of [a, b, c]) { sum[p] += nx; sum[p + 1] += ny; sum[p + 2] += nz; }
  }
  for (let p = 0; p < sum.length; p += 3) {
    const length = Math.hypot(sum[p], sum[p + 1], sum[p + 2]) || 1;
    for (let k = 0; k < 3; ++k) sum[p + k] /= length;
  }
  return sum;
}

// The entries of a table of triples, one for every index.
function gathered(table, indices) {
  const result = new Float32Array(3 * indices.length);
  for (let i = 0; i < indices.length; ++i)
    for (let k = 0; k < 3; ++k) result[3 * i + k] = table[3 * indices[i] + k];
  return result;
}

const along = (axis, points, p) => axis[0] * points[p] + axis[1] * points[p + 1] + axis[2] * points[p + 2];
const unit = v => { const length = Math.hypot(...v); return v.map(x => x / length); };
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unitAxis = k => [0, 1, 2].map(j => Number(j === k));

function extentAlong(axes, points) {
  return axes.map(axis => {
    let low = Infinity, high = -Infinity;
    for (let p = 0; p < points.length; p += 3) {
      const x = along(axis, points, p);
      low = Math.min(low, x);
      high = Math.max(high, x);
    }
    return [low, high];
  });
}

// From where the surface is seen: the directions to the right, up, and to the eye. The eye is on the shortest axis, a
// little to the side and above; y is up, or z where one looks along y.
function viewAxes(points) {
  const size = extentAlong([0, 1, 2].map(unitAxis), points).map(([low, high]) => high - low);
  const shortest = [2, 1, 0].reduce((a, b) => size[b] < 0.999 * size[a] ? b : a);
  const up = shortest === 1 ? 2 : 1, side = 3 - shortest - up, eye = [0, 0, 0];
  eye[shortest] = shortest === 1 ? -1 : 1;
  eye[side] = 0.42;
  eye[up] = 0.36;
  const towardsEye = unit(eye), right = unit(cross(unitAxis(up), towardsEye));
  return [right, cross(towardsEye, right), towardsEye];
}
// the coordinate axis that is up
const upAxis = ([, up]) => unitAxis(up[2] > up[1] ? 2 : 1);
