// ---- report.html#selftest: every layer must change what is seen, and change it back. The verdict is put on the page.

function differences(a, b) {
  let count = 0;
  for (let i = 0; i < a.length; i += 4) {
    let difference = 0;
    for (let k = i; k < i + 4; ++k) difference += Math.abs(a[k] - b[k]);
    if (difference > 12) ++count;
  }
  return count;
}

// the pixels that change when a layer is switched, seen from four sides; all must be as before when it is switched back
function testLayer(viewer, layer) {
  let changed = 0, restored = true;
  for (let side = 0; side < 4; ++side) {
    const before = viewer.pixels();
    layer.set(!layer.on);
    changed += differences(before, viewer.pixels());
    layer.set(!layer.on);
    restored = restored && differences(before, viewer.pixels()) === 0;
    viewer.turn(Math.PI / 2);
  }
  return {changed, restored};
}

function selfTest(viewer) {
  const result = {webgl: viewer !== null, layers: {}};
  if (viewer) {
    const pixels = viewer.pixels();
    result.drawn = differences(pixels, new Uint8Array(pixels.length));
    for (const layer of viewer.layers) result.layers[layer.name] = testLayer(viewer, layer);
  }
  result.picture = document.getElementById("picture") !== null;
  result.sections = document.querySelectorAll("#sections section").length;
  result.overflow = document.documentElement.scrollWidth > document.documentElement.clientWidth;
  document.body.append(make("pre", {id: "selftest"}, JSON.stringify(result)));
}
