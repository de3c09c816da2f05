// ---- The model that turns, by three.js.

// A grey-white board whose squares have crisp edges at every size: the pattern's mean over a pixel, after I. Quilez,
// "Filtering the checkerboard pattern", 2011.
const surfaceShader = {
  vertex: `
    attribute vec2 pattern;
    attribute vec3 colour;
    varying vec2 place;
    varying vec3 base, eyeNormal;
    void main() {
      place = pattern;
      base = colour;
      eyeNormal = normalMatrix * normal;
      gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    }`,
  fragment: `
    uniform float squares;       // by unit
    uniform bool  checkered, coloured;
    varying vec2 place;
    varying vec3 base, eyeNormal;
    float board(vec2 p) {
      vec2 w = max(fwidth(p), 1e-4);
      vec2 i = 2.0 * (abs(fract((p - 0.5 * w) * 0.5) - 0.5) - abs(fract((p + 0.5 * w) * 0.5) - 0.5)) / w;
      float mean = 0.5 - 0.5 * i.x * i.y;
      return mix(mean, 0.5, smoothstep(0.6, 1.4, max(w.x, w.y)));   // squares smaller than a pixel: no moire
    }
    void main() {
      vec3 c = coloured ? base : vec3(0.87, 0.89, 0.92);
      if (checkered) c *= mix(coloured ? 0.78 : 0.5, 1.06, board(place * squares));
      vec3 n = normalize(gl_FrontFacing ? eyeNormal : -eyeNormal);
      float light = 0.50 + 0.48 * max(dot(n, normalize(vec3(0.25, 0.45, 1.0))), 0.0) + 0.10 * (0.5 + 0.5 * n.y);
      float shine = pow(max(dot(n, normalize(vec3(0.2, 0.35, 1.0))), 0.0), 40.0);
      gl_FragColor = vec4(min(c * light + 0.05 * shine, 1.0), 1.0);
    }`
};

function rgbOfPatches() {
  const rgb = new Float32Array(3 * Math.max(1, colourOfPatch.length)).fill(0.8);
  colourOfPatch.forEach((c, p) => new THREE.Color(c).toArray(rgb, 3 * p));
  return rgb;
}

function surfaceMaterial() {
  return new THREE.ShaderMaterial({
    vertexShader: surfaceShader.vertex, fragmentShader: surfaceShader.fragment,
    uniforms: {squares: {value: 1}, checkered: {value: false}, coloured: {value: true}},
    side: THREE.DoubleSide, extensions: {derivatives: true},
    polygonOffset: true, polygonOffsetFactor: 1.5, polygonOffsetUnits: 2   // lines lie on it
  });
}

// Triangles of corners with a point, a patch and a place in the pattern each.
function shadedMesh(points, corner, triangles, patch, pattern) {
  const geometry = new THREE.BufferGeometry();
  geometry.setIndex(new THREE.BufferAttribute(triangles, 1));
  geometry.setAttribute("position", new THREE.BufferAttribute(gathered(points, corner), 3));
  geometry.setAttribute("normal", new THREE.BufferAttribute(gathered(normals(points, corner, triangles), corner), 3));
  geometry.setAttribute("colour", new THREE.BufferAttribute(gathered(rgbOfPatches(), patch), 3));
  geometry.setAttribute("pattern", new THREE.BufferAttribute(pattern, 2));
  return new THREE.Mesh(geometry, surfaceMaterial());
}

function surfaceMesh() {
  const s = model.surface, points = numbers(s.points), triangles = numbers(s.triangles);
  const corner = numbers(s.corner.point);
  const patch = s.corner.patch ? numbers(s.corner.patch) : new Uint32Array(corner.length);
  const pattern = s.corner.uv ? numbers(s.corner.uv) : new Float32Array(2 * corner.length);
  if (model.tmesh)
    patch.forEach((p, c) => {
      pattern.set(moved(model.tmesh.patches[p].pattern, pattern[2 * c], pattern[2 * c + 1]), 2 * c);
    });
  return shadedMesh(points, corner, triangles, patch, pattern);
}

// Lines some pixels wide between pairs of points.
function wideLines(pairs, colour, width, resolution) {
  const geometry = new THREE.LineSegmentsGeometry();
  geometry.setPositions(pairs);
  const material = new THREE.LineMaterial({color: new THREE.Color(colour), linewidth: width});
  material.uniforms.resolution.value = resolution;   // shared: the size of the canvas
  return new THREE.LineSegments2(geometry, material);
}

function closedLoop(points) {
  const n = points.length / 3, indices = [];
  for (let i = 0; i < n; ++i) indices.push(i, (i + 1) % n);
  return gathered(points, indices);
}

function loopLabel(letter) {
  const kind = model.loops.find(l => l.name[0] === letter).kind;
  return "Loops " + letter + (kind ? `, ${kind}s` : "");
}

function loopLines(letter, resolution) {
  const group = new THREE.Group();
  for (const loop of model.loops || [])
    if (loop.name[0] === letter)
      group.add(wideLines(closedLoop(numbers(loop.points)), loopColours[letter], 4.5, resolution));
  return group;
}

function markers(shape, singularities) {
  const group = new THREE.Group();
  for (const s of singularities) {
    if (!s.position) continue;
    const mesh = new THREE.Mesh(shape, new THREE.MeshLambertMaterial({color: orderColour(s.order)}));
    mesh.position.set(...s.position);
    group.add(mesh);
  }
  return group;
}

function quadMesh(resolution) {
  const q = model.quads, points = numbers(q.points), quads = numbers(q.quads), patch = numbers(q.patch);
  const triangles = new Uint32Array(quads.length / 4 * 6), patchOfCorner = new Uint32Array(quads.length);
  const edges = [], drawn = new Set(), number = (a, b) => a * points.length + b;
  for (let f = 0; f < patch.length; ++f) {
    const c = 4 * f;
    triangles.set([c, c + 1, c + 2, c, c + 2, c + 3], 6 * f);
    for (let k = 0; k < 4; ++k) {
      const a = quads[c + k], b = quads[c + (k + 1) % 4];
      if (!drawn.has(number(b, a))) edges.push(a, b);   // the neighbour, if there is one, runs along it the other way
      drawn.add(number(a, b));
      patchOfCorner[c + k] = patch[f];
    }
  }
  const group = new THREE.Group(), noPattern = new Float32Array(2 * quads.length);
  group.add(shadedMesh(points, quads, triangles, patchOfCorner, noPattern),
            wideLines(gathered(points, edges), "#39424f", 1.1, resolution));
  return group;
}

// Puts the camera where the surface is as large as fits.
function placeCamera(camera, points) {
  const axes = viewAxes(points), extent = extentAlong(axes, points);
  const tangent = 0.93 * Math.tan(camera.fov / 2 * Math.PI / 180);
  const middle = extent.map(([low, high]) => (low + high) / 2);
  let distance = 0;
  for (let p = 0; p < points.length; p += 3) {
    const [x, y, z] = axes.map((axis, k) => along(axis, points, p) - middle[k]);
    distance = Math.max(distance, z + Math.abs(x) / (tangent * camera.aspect), z + Math.abs(y) / tangent);
  }
  const centre = new THREE.Vector3(), radius = Math.hypot(...extent.map(([low, high]) => (high - low) / 2));
  axes.forEach((axis, k) => centre.addScaledVector(new THREE.Vector3(...axis), middle[k]));
  camera.up.set(...upAxis(axes));
  camera.position.copy(centre).addScaledVector(new THREE.Vector3(...axes[2]), distance);
  camera.near = radius / 50;
  camera.far = radius * 30;
  camera.lookAt(centre);
  return {centre, radius};
}

function hasWebGL() {
  try {
    const canvas = document.createElement("canvas");
    return Boolean(canvas.getContext("webgl") || canvas.getContext("experimental-webgl"));
  } catch (error) {
    return false;
  }
}

// The viewer in an element: its layers {name, label, colour, on, set(on)}, and draw(). null where it cannot be.
function createViewer(element) {
  if (typeof THREE === "undefined" || !model.surface || !hasWebGL()) return null;
  const renderer = new THREE.WebGLRenderer({antialias: true, alpha: true, preserveDrawingBuffer: true});
  renderer.setClearColor(0xffffff, 0);
  renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
  element.replaceChildren(renderer.domElement);

  const scene = new THREE.Scene(), camera = new THREE.PerspectiveCamera(32, 1, 0.1, 100);
  const resolution = new THREE.Vector2(1, 1);
  const headlight = new THREE.DirectionalLight(0xffffff, 0.75);
  camera.add(headlight);
  headlight.position.set(0.4, 0.7, 1);
  scene.add(camera, new THREE.AmbientLight(0xffffff, 0.45));
  const surface = surfaceMesh();
  scene.add(surface);
  camera.aspect = element.clientWidth / Math.max(1, element.clientHeight);
  const {centre, radius} = placeCamera(camera, numbers(model.surface.points));

  const controls = new THREE.OrbitControls(camera, renderer.domElement);
  controls.target.copy(centre);
  controls.minDistance = radius / 20;
  controls.maxDistance = radius * 12;
  controls.rotateSpeed = 0.9;
  let waiting = false;
  const draw = () => { waiting = false; renderer.render(scene, camera); };
  const request = () => { if (!waiting) { waiting = true; requestAnimationFrame(draw); } };
  controls.addEventListener("change", request);
  const fit = () => {
    const {clientWidth: w, clientHeight: h} = element;
    if (w === 0 || h === 0) return;
    renderer.setSize(w, h);
    resolution.set(w, h);
    camera.aspect = w / h;
    camera.updateProjectionMatrix();
    request();
  };
  new ResizeObserver(fit).observe(element);
  fit();
  controls.update();

  const layers = [], uniforms = surface.material.uniforms;
  const addLayer = (name, label, on, set, colour) => {
    const layer = {name, label, on, colour, set: value => { layer.on = value; set(value); request(); }};
    layers.push(layer);
    set(on);
  };
  const addObject = (name, label, on, object, colour) => {
    scene.add(object);
    addLayer(name, label, on, value => { object.visible = value; }, colour);
  };
  const s = model.surface, points = numbers(s.points), pairs = array => gathered(points, numbers(array));
  if (s.corner.uv) addLayer("checkerboard", "Checkerboard", true, value => { uniforms.checkered.value = value; });
  if (model.tmesh) {
    addLayer("patches", "Patches in colours", true, value => { uniforms.coloured.value = value; });
    addObject("arcs", "T-mesh arcs", true, wideLines(pairs(s.arcs), "#2b3340", 2, resolution), "#2b3340");
  } else uniforms.coloured.value = false;
  if ((report.singularities || []).length > 0)
    addObject("singularities", "Singularities", true,
              markers(new THREE.SphereBufferGeometry(radius / 70, 20, 14), report.singularities));
  if (corners.length > 0) {
    const side = radius / 45;
    addObject("corners", "Corners of the boundary", true, markers(new THREE.BoxBufferGeometry(side, side, side), corners));
  }
  for (const letter of ["a", "b"])
    if ((model.loops || []).some(l => l.name[0] === letter))
      addObject("loops_" + letter, loopLabel(letter), false, loopLines(letter, resolution), loopColours[letter]);
  if (model.quads) {
    const quads = quadMesh(resolution);
    quads.children[0].material.uniforms.coloured = uniforms.coloured;   // shared
    scene.add(quads);
    addLayer("quads", "Quad mesh", false, value => { quads.visible = value; surface.visible = !value; });
  }
  if (s.edges.length > 0)
    addObject("wireframe", "Input triangles", !s.corner.uv, wideLines(pairs(s.edges), "#7b8698", 0.8, resolution),
              "#7b8698");

  // squares: about 2500 on the surface, as in flat.png
  const units = model.tmesh ? model.tmesh.patches.reduce((sum, p) => sum + p.width * p.height, 0)
                            : report.immersion ? report.input.area / report.immersion.surface_units_per_unit ** 2 : 1;
  const setSquares = number => { uniforms.squares.value = Math.sqrt(number / units); request(); };
  setSquares(2500);
  return {layers, setSquares, hasSquares: Boolean(s.corner.uv), draw, canvas: renderer.domElement,
          pixels: () => { draw(); return readPixels(renderer); },
          turn: angle => {
            camera.position.sub(centre).applyAxisAngle(camera.up, angle).add(centre);
            camera.lookAt(centre);
          }};
}

function readPixels(renderer) {
  const gl = renderer.getContext(), w = gl.drawingBufferWidth, h = gl.drawingBufferHeight;
  const pixels = new Uint8Array(4 * w * h);
  gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return pixels;
}
