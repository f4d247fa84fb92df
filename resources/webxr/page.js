// The tracked hand and what its application draws, in a headset's browser or in any other.
// Messages are those of extensions/applications/page.py: OpenXR's axes (y up, -z forward), m.
import * as THREE from "./three.module.min.js";

const CHAINS = [
  ["thumb_cmc", "thumb_mcp", "thumb_ip", "thumb_tip"],
  ...["index", "middle", "ring", "little"].map((f) => ["mcp", "pip", "dip", "tip"].map((j) => `${f}_${j}`)),
];
const STATES = { measured: 0x5fb89c, inferred: 0xe69f00 };
const FRONT = new THREE.Vector3(0, 1.1, -0.35); // where G's origin is in a headset's room, m

const scene = new THREE.Scene();
scene.background = new THREE.Color(0x14171b);
const world = new THREE.Group();
world.position.copy(FRONT);
scene.add(world, new THREE.HemisphereLight(0xffffff, 0x445566, 2.2));
const sun = new THREE.DirectionalLight(0xffffff, 1.2);
sun.position.set(0.5, 2, 1);
scene.add(sun);
const camera = new THREE.PerspectiveCamera(45, 1, 0.01, 20);
camera.position.set(0.35, 1.65, 0.25);
camera.lookAt(0, 1.15, -0.6);

const renderer = new THREE.WebGLRenderer({ antialias: true });
renderer.xr.enabled = true;
document.body.append(renderer.domElement);
function fit() {
  renderer.setSize(innerWidth, innerHeight);
  camera.aspect = innerWidth / innerHeight;
  camera.updateProjectionMatrix();
}
addEventListener("resize", fit);
fit();

// --- the hand: a ball for each joint, a rod for each bone

const BALL = new THREE.SphereGeometry(1, 16, 12);
const ROD = new THREE.CylinderGeometry(1, 1, 1, 12);
const UP = new THREE.Vector3(0, 1, 0);
const joints = new Map(), bones = [];

function bonesOf() {
  const out = [];
  for (const chain of CHAINS) {
    ["wrist", ...chain].reduce((a, b) => (out.push([a, b]), b));
  }
  return out;
}
for (const [a, b] of bonesOf()) {
  const rod = new THREE.Mesh(ROD, new THREE.MeshStandardMaterial({ color: 0xcfd4d8 }));
  rod.visible = false;
  bones.push([a, b, rod]);
  world.add(rod);
}

function showHand(points) {
  for (const [name, { position, state, radius }] of Object.entries(points)) {
    let ball = joints.get(name);
    if (!ball) {
      ball = new THREE.Mesh(BALL, new THREE.MeshStandardMaterial());
      joints.set(name, ball);
      world.add(ball);
    }
    ball.visible = position !== null;
    if (position === null) continue;
    ball.position.fromArray(position);
    ball.scale.setScalar(radius);
    ball.material.color.setHex(STATES[state] ?? 0x888888);
  }
  for (const [a, b, rod] of bones) {
    const from = joints.get(a), to = joints.get(b);
    rod.visible = Boolean(from?.visible && to?.visible);
    if (!rod.visible) continue;
    const way = to.position.clone().sub(from.position);
    rod.position.copy(from.position).addScaledVector(way, 0.5);
    rod.quaternion.setFromUnitVectors(UP, way.clone().normalize());
    rod.scale.set(0.7 * to.scale.x, way.length(), 0.7 * to.scale.x);
  }
}

// --- the drawing: primitives by name; what is left out of a message is gone

const drawn = new Map();

function geometryOf(points, faces) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(points, 3));
  if (faces) {
    geometry.setIndex(faces);
    geometry.computeVertexNormals();
  }
  return geometry;
}

const makers = {
  mesh: (d) => new THREE.Mesh(geometryOf(d.points, d.faces), new THREE.MeshStandardMaterial({ transparent: true })),
  line: () => new THREE.Line(new THREE.BufferGeometry(), new THREE.LineBasicMaterial()),
  points: () => new THREE.Points(new THREE.BufferGeometry(), new THREE.PointsMaterial()),
  text: () => new THREE.Sprite(new THREE.SpriteMaterial({ depthTest: false })),
};

const updaters = {
  mesh(object, d) {
    object.matrixAutoUpdate = false;
    object.matrix.fromArray(d.matrix);
    object.material.color.set(d.colour);
    object.material.opacity = d.opacity;
  },
  line(object, d) {
    object.geometry.dispose();
    object.geometry = geometryOf(d.points);
    object.material.color.set(d.colour);
  },
  points(object, d) {
    object.geometry.dispose();
    object.geometry = geometryOf(d.points);
    object.material.color.set(d.colour);
    object.material.size = 2 * d.radius;
  },
  text(object, d) {
    object.position.fromArray(d.position);
    if (object.userData.text === d.text + d.colour) return;
    object.userData.text = d.text + d.colour;
    const canvas = document.createElement("canvas");
    canvas.width = 512;
    canvas.height = 64;
    const pen = canvas.getContext("2d");
    pen.font = "44px sans-serif";
    pen.textAlign = "center";
    pen.fillStyle = d.colour || "#ffffff";
    pen.fillText(d.text, 256, 46);
    object.material.map?.dispose();
    object.material.map = new THREE.CanvasTexture(canvas);
    object.material.needsUpdate = true;
    object.scale.set(0.24, 0.03, 1);
  },
};

function showDrawing(list) {
  const there = new Set();
  for (const d of list) {
    const key = `${d.kind} ${d.name}`;
    there.add(key);
    let object = drawn.get(key);
    if (object && d.kind === "mesh" && d.points) {
      world.remove(object);
      object = undefined;
    }
    if (!object) {
      if (d.kind === "mesh" && !d.points) continue; // its points have not come yet
      object = makers[d.kind](d);
      drawn.set(key, object);
      world.add(object);
    }
    object.visible = true;
    updaters[d.kind](object, d);
  }
  for (const [key, object] of drawn) if (!there.has(key)) object.visible = false;
}

// --- messages

const said = document.getElementById("said");
const figures = { messages: 0, presenting: false, frames: 0, title: "" };
function connect() {
  const socket = new WebSocket(`ws://${location.host}/stream`);
  socket.onmessage = ({ data }) => {
    const message = JSON.parse(data);
    figures.messages += 1;
    figures.title = message.title;
    showHand(message.hand);
    showDrawing(message.drawing);
    said.textContent = [message.title, message.gestures.join(", ")].filter(Boolean).join(": ");
  };
  socket.onclose = () => {
    said.textContent = "Waiting for the hand…";
    setTimeout(connect, 1000);
  };
}
connect();

// --- the headset

const enter = document.getElementById("enter");
async function emulate() {
  await new Promise((done) => {
    const script = document.createElement("script");
    script.src = "iwer.min.js";
    script.onload = done;
    document.head.append(script);
  });
  const device = new IWER.XRDevice(IWER.metaQuest3);
  device.installRuntime({ forceInstall: true }); // a browser without a headset has an XRSystem too
  device.position.set(0.25, 1.6, 0.2);
}
async function prepare() {
  if (new URLSearchParams(location.search).has("emulate")) await emulate();
  enter.disabled = !(await navigator.xr?.isSessionSupported("immersive-vr"));
  if (enter.disabled) enter.textContent = "No headset";
}
enter.onclick = async () => {
  const session = await navigator.xr.requestSession("immersive-vr", { optionalFeatures: ["local-floor"] });
  session.addEventListener("end", () => (figures.presenting = false));
  await renderer.xr.setSession(session);
  figures.presenting = true;
};
prepare();

renderer.setAnimationLoop(() => {
  figures.frames += 1;
  renderer.render(scene, camera);
});

// What is on the page, for whoever wants to know: places of joints in OpenXR's axes, m.
window.glovetrack = {
  figures,
  joint: (name) => joints.get(name)?.position.toArray() ?? null,
  drawn: () => [...drawn].filter(([, o]) => o.visible).map(([key]) => key),
};
