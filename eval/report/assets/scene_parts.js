// SPDX-License-Identifier: BSD-3-Clause
// What the 3D view is made of: functions from the scene's data to three.js objects.

const vector = (p) => new THREE.Vector3(...p);

// A colour of the style sheet, as the page's scheme has it now.
function schemeColour(value) {
  const probe = element('i');
  probe.style.color = value;
  document.body.append(probe);
  const rgb = getComputedStyle(probe).color;
  probe.remove();
  return new THREE.Color(rgb);
}

const surface = (value, options = {}) =>
    new THREE.MeshLambertMaterial({color: schemeColour(value), side: THREE.DoubleSide, ...options});

// Straight pieces as thin rods: lines of WebGL are one pixel wide, which is hard to see.
function rods(lines, radius, material) {
  const group = new THREE.Group();
  for (const [start, end] of lines.map((line) => line.map(vector))) {
    const along = new THREE.Vector3().subVectors(end, start);
    if (along.length() === 0) continue;
    const rod = new THREE.Mesh(new THREE.CylinderBufferGeometry(radius, radius, along.length(), 6), material);
    rod.position.addVectors(start, end).multiplyScalar(0.5);
    rod.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), along.normalize());
    group.add(rod);
  }
  return group;
}

function pathPart(points, value) {
  const group = new THREE.Group();
  if (points.length < 2) return group;
  const curve = new THREE.CatmullRomCurve3(points.map(vector));
  group.add(new THREE.Mesh(new THREE.TubeBufferGeometry(curve, 3 * points.length, 0.014, 6), surface(value)));
  return group;
}

// Pyramids: from the centre to the base's corners, and around the base.
function camerasPart(cameras, value) {
  const material = new THREE.LineBasicMaterial({color: schemeColour(value)});
  const edges = [[0, 1], [0, 2], [0, 3], [0, 4], [1, 2], [2, 3], [3, 4], [4, 1]];
  const points =
      cameras.flatMap((corners) => edges.flatMap(([a, b]) => [vector(corners[a]), vector(corners[b])]));
  return new THREE.LineSegments(new THREE.BufferGeometry().setFromPoints(points), material);
}

// The edges at which a surface bends.
function creases(geometry) {
  const material = new THREE.LineBasicMaterial({color: 0x222222, transparent: true, opacity: 0.45});
  return new THREE.LineSegments(new THREE.EdgesGeometry(geometry, 30), material);
}

// With the triangles' own colours where they are known; corners are not shared, which makes faces flat.
function cadPart(object) {
  const {vertices, triangles, colours} = object.cad;
  const position = new Float32Array(triangles.length * 3), shade = new Float32Array(triangles.length * 3);
  triangles.forEach((vertex, corner) => {
    for (let i = 0; i < 3; ++i) {
      position[3 * corner + i] = vertices[3 * vertex + i];
      shade[3 * corner + i] = colours.length ? colours[3 * Math.floor(corner / 3) + i] / 255 : 1;
    }
  });
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(position, 3));
  geometry.setAttribute('color', new THREE.BufferAttribute(shade, 3));
  geometry.computeVertexNormals();
  const material = surface(
      colours.length ? '#ffffff' : categoryColour(object.category),
      {vertexColors: THREE.VertexColors, polygonOffset: true, polygonOffsetFactor: 1});
  if (colours.length === 0)
    material.color.lerp(new THREE.Color(0xd8d8d8), 0.45);  // calmer than the wireframe
  const group = new THREE.Group();
  group.add(new THREE.Mesh(geometry, material), creases(geometry));
  return group;
}

function groupOf(items, make) {
  const group = new THREE.Group();
  items.forEach((item) => group.add(make(item)));
  return group;
}

// Squares of a metre under the lowest object, across `up`.
function groundPart(box, up) {
  const size = Math.ceil(box.getSize(new THREE.Vector3()).length());
  const grid = new THREE.GridHelper(size, size, schemeColour('var(--rule)'), schemeColour('var(--rule)'));
  const corners = [box.min, box.max].map((p) => p.dot(up));
  grid.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), up);
  const centre = box.getCenter(new THREE.Vector3());
  grid.position.copy(centre).addScaledVector(up, Math.min(...corners) - centre.dot(up));
  return grid;
}

// The layers by name, in the order of their boxes; those without anything are left out.
function sceneLayers(scene) {
  const layers = {
    'cameras': scene.cameras.length ? camerasPart(scene.cameras, 'var(--quiet)') : null,
    'estimated path': scene.path.length ? pathPart(scene.path, 'var(--path)') : null,
    'true path': scene.true_path.length ? pathPart(scene.true_path, 'var(--truth)') : null,
    'wireframes':
        groupOf(scene.objects, (o) => rods(o.wireframe, 0.011, surface(categoryColour(o.category)))),
    'CAD models': groupOf(scene.objects.filter((object) => object.cad.triangles.length), cadPart),
    'true boxes': groupOf(scene.objects, (object) => rods(object.true_box, 0.005, surface('var(--truth)'))),
  };
  const empty = (part) =>
      part === null || (part.isGroup && part.children.every((c) => c.isGroup && !c.children.length));
  return Object.fromEntries(Object.entries(layers).filter(([, part]) => !empty(part)));
}
