// SPDX-License-Identifier: BSD-3-Clause
// The 3D view: one WebGL context for all sequences, made when the figure comes into sight.

function hasWebGl() {
  const context = element('canvas').getContext('webgl');
  if (context) context.getExtension('WEBGL_lose_context')?.loseContext();
  return context !== null;
}

// Where the view starts: above the cameras, looking over them at the objects.
function startView(view, scene, box) {
  const up = vector(scene.up), centre = box.getCenter(new THREE.Vector3());
  const mean = scene.path.reduce((sum, p) => sum.add(vector(p)), new THREE.Vector3())
                   .divideScalar(Math.max(scene.path.length, 1));
  const back = mean.sub(centre).projectOnPlane(up);
  if (back.length() < 0.3) back.set(1, 0.2, 1).projectOnPlane(up);
  const reach = box.getSize(new THREE.Vector3()).length() / 2;
  view.camera.up.copy(up);
  view.camera.position.copy(centre)
      .addScaledVector(back.normalize(), 1.1 * reach)
      .addScaledVector(up, 0.75 * reach);
  view.controls?.dispose();
  view.controls = new THREE.OrbitControls(view.camera, view.renderer.domElement);
  view.controls.enableKeys = false;  // the arrow keys scroll the page
  view.controls.target.copy(centre).addScaledVector(up, -0.1 * reach);
  view.controls.addEventListener('change', view.render);
  view.controls.update();
}

function light(up) {
  const sky = new THREE.HemisphereLight(0xffffff, 0x777777, 0.75);
  sky.position.copy(up);
  const sun = new THREE.DirectionalLight(0xffffff, 0.35);
  sun.position.copy(up).add(new THREE.Vector3(0.5, 0.3, 0.8));
  return [sky, sun];
}

function freeGeometry(root) {
  root.traverse((part) => {
    part.geometry?.dispose();
    part.material?.dispose();
  });
}

// Puts a sequence's map into the view, with the layers that are switched on.
function showScene(view, scene) {
  freeGeometry(view.root);
  const up = vector(scene.up), layers = sceneLayers(scene);
  view.root = new THREE.Scene();
  view.root.add(...light(up), ...Object.values(layers));
  const box = new THREE.Box3().setFromObject(view.root);
  view.root.add(groundPart(box, up));
  view.boxes.replaceChildren(...Object.entries(layers).map(([name, part]) => {
    part.visible = !view.hidden.has(name);
    return checkbox(name, part.visible, (shown) => {
      part.visible = shown;
      view.hidden[shown ? 'delete' : 'add'](name);
      view.render();
    });
  }));
  return box;
}

function fitToCanvas(view) {
  const {clientWidth, clientHeight} = view.canvas;
  view.renderer.setSize(clientWidth, clientHeight);
  view.camera.aspect = clientWidth / Math.max(clientHeight, 1);
  view.camera.updateProjectionMatrix();
  view.render();
}

function makeView(canvas, boxes) {
  // The drawing is kept for printing.
  const renderer = new THREE.WebGLRenderer({antialias: true, alpha: true, preserveDrawingBuffer: true});
  renderer.setPixelRatio(window.devicePixelRatio);
  canvas.append(renderer.domElement);
  const camera = new THREE.PerspectiveCamera(45, 1, 0.05, 500);
  const view = {renderer, camera, canvas, boxes, root: new THREE.Scene(), hidden: new Set()};
  view.render = () => renderer.render(view.root, camera);
  return view;
}

function startScenes(canvas, controls) {
  const {scenes} = report.data;
  const boxes = element('span', {className: 'controls'});
  const view = makeView(canvas, boxes);
  let shown = 0;
  const show = (index) => {
    shown = index;
    startView(view, scenes[shown], showScene(view, scenes[shown]));
    view.render();
  };
  controls.append(choice('', scenes.map((scene) => `${scene.sequence} · ${scene.run}`), 0, show), boxes);
  fitToCanvas(view);
  show(0);
  new ResizeObserver(() => fitToCanvas(view)).observe(canvas);
  document.addEventListener('scheme', () => {
    showScene(view, scenes[shown]);
    view.render();
  });
}

report.draw.scenes = (figure) => {
  const canvas = element('div', {className: 'canvas'}), controls = element('div', {className: 'controls'});
  figure.append(controls, canvas);
  if (!hasWebGl()) {
    canvas.append(element('p', {textContent: 'This browser has no WebGL, which the 3D view needs.'}));
    canvas.style.height = 'auto';
    return;
  }
  let started = false;
  const start = () => {
    if (started) return;
    started = true;
    startScenes(canvas, controls);
  };
  new IntersectionObserver((entries, observer) => {
    if (!entries.some((entry) => entry.isIntersecting)) return;
    observer.disconnect();
    start();
  }, {rootMargin: '200px'}).observe(canvas);
  window.addEventListener('beforeprint', start);
};
