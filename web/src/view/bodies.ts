// Shapes of boards, floats, weights and other components, and of vessels.

import * as T from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';

export type ShapeName = 'plate' | 'cloth' | 'ball' | 'float' | 'sinker' | 'clump' | 'runner' | 'bag' | 'ring' | 'hook' |
  'anchor' | 'hull' | 'box';

// Returns a plate of 1 by 1 in x and y, bent towards z.
function plate(bend: number, thick: number) {
  const made = new T.BoxGeometry(1, 1, thick, 10, 1, 1), at = made.getAttribute('position');
  for (let i = 0; i < at.count; i++) {
    const x = at.getX(i);
    at.setZ(i, at.getZ(i) + bend * (1 - 4 * x * x));
  }
  made.computeVertexNormals();
  return made;
}

// Returns a hull of length 1: stern at the origin, bow at x = -1, deck above z = 0.
function hull() {
  const deck = new T.Shape();
  deck.moveTo(0, -0.13);
  deck.lineTo(-0.62, -0.135);
  deck.quadraticCurveTo(-0.86, -0.12, -1, 0);
  deck.quadraticCurveTo(-0.86, 0.12, -0.62, 0.135);
  deck.lineTo(0, 0.13);
  deck.closePath();
  const made = new T.ExtrudeGeometry(deck, { depth: 0.15, bevelEnabled: false, curveSegments: 8 });
  const at = made.getAttribute('position');
  for (let i = 0; i < at.count; i++) {
    // The hull is narrow at the keel and rises towards the bow.
    const up = at.getZ(i) / 0.15, x = at.getX(i);
    at.setY(i, at.getY(i) * (0.45 + 0.55 * up));
    at.setX(i, x * (0.9 + 0.1 * up));
    at.setZ(i, -0.07 + (0.13 + 0.06 * x * x) * up);
  }
  made.computeVertexNormals();
  return made;
}

function box(x: number, y: number, z: number, wide: number, tall: number, deep: number) {
  return new T.BoxGeometry(wide, tall, deep).translate(x, y, z);
}
function ring(radius: number, thick: number, arc = 2 * Math.PI) {
  return new T.TorusGeometry(radius, thick, 6, 18, arc);
}

// Returns a board: two foils with a slot between them, ribs behind, and a shoe below.
function board() {
  function foil(x: number, wide: number, bend: number) {
    return plate(bend, 0.035).scale(wide, 0.94, 1).translate(x, 0.02, 0);
  }
  return mergeGeometries([
    foil(-0.33, 0.3, 0.035).rotateY(0.10), foil(0.16, 0.66, 0.075),
    box(0, 0.49, 0.03, 0.98, 0.03, 0.12), box(0, 0.02, 0.015, 0.92, 0.03, 0.09),
    box(0, -0.475, 0.03, 1, 0.06, 0.16)
  ]);
}
// Returns a float with its seam and two ears.
function float() {
  return mergeGeometries([
    new T.SphereGeometry(1, 18, 12), ring(1, 0.06).rotateX(Math.PI / 2),
    ring(0.2, 0.07).translate(1.12, 0, 0), ring(0.2, 0.07).translate(-1.12, 0, 0)
  ]);
}
// Returns a drum with rounded ends and an eye.
function sinker() {
  return mergeGeometries([
    new T.CylinderGeometry(0.72, 0.72, 0.9, 16), new T.CylinderGeometry(0.45, 0.72, 0.28, 16).translate(0, 0.59, 0),
    new T.CylinderGeometry(0.72, 0.45, 0.28, 16).translate(0, -0.59, 0), ring(0.26, 0.09).translate(0, 0.95, 0)
  ]).rotateX(Math.PI / 2);
}
// Returns a heap of chain links.
function clump() {
  return mergeGeometries([0, 1, 2, 3, 4, 5, 6].map((k) =>
    ring(0.5, 0.19).scale(1, 1.5, 1).rotateZ(k * 1.1).rotateX(k * 0.9)
      .translate(0.35 * Math.cos(2.4 * k), 0.35 * Math.sin(2.4 * k), 0.2 * k - 0.6)));
}
function hook() {
  return mergeGeometries([
    new T.CylinderGeometry(0.09, 0.09, 1.5, 6).rotateX(Math.PI / 2).translate(0.5, 0, -0.6),
    ring(0.5, 0.09, Math.PI).rotateX(-Math.PI / 2).translate(0, 0, -1.35),
    new T.CylinderGeometry(0.09, 0.02, 0.5, 6).rotateX(Math.PI / 2).translate(-0.5, 0, -1.15)
  ]);
}
// Returns the end of a beam trawl's shoe: a runner that is turned up at the front.
function runner() {
  return mergeGeometries([box(0, 0, -0.5, 1.6, 0.9, 0.2), box(-1.1, 0, -0.25, 0.8, 0.9, 0.2).rotateY(0.25)]);
}
// Returns a full bag, longer than wide, with lobes between its lines.
function bag() {
  const made = new T.SphereGeometry(1, 32, 18), at = made.getAttribute('position');
  for (let i = 0; i < at.count; i++) {
    const swell = 1 + 0.035 * Math.cos(8 * Math.atan2(at.getZ(i), at.getX(i))), y = at.getY(i);
    at.setXYZ(i, at.getX(i) * swell, 1.5 * y + 0.25 * y * y, at.getZ(i) * swell);
  }
  made.computeVertexNormals();
  return made.rotateZ(-Math.PI / 2);
}

let shapes: Record<ShapeName, T.BufferGeometry> | null = null;
// Returns all shapes, which are built once.
export function shapes_once() {
  if (shapes) return shapes;
  shapes = {
    plate: board(), cloth: plate(0.05, 0.012), ball: new T.SphereGeometry(1, 18, 12), float: float(),
    sinker: sinker(), clump: clump(), runner: runner(), bag: bag(), ring: ring(0.85, 0.16), hook: hook(),
    anchor: new T.CylinderGeometry(0, 1, 1.6, 4).rotateX(Math.PI / 2), hull: hull(),
    box: new T.BoxGeometry(1, 1, 1)
  };
  return shapes;
}
