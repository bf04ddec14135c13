// What the viewer (inst/view/viewer.js) uses of three.js, delaunator and fflate; tools/three/build makes
// inst/view/three.js of it.
export {
  BoxGeometry, BufferAttribute, BufferGeometry, Color, ColorManagement, CylinderGeometry, DoubleSide,
  ExtrudeGeometry, FrontSide, IcosahedronGeometry, InstancedBufferAttribute, InstancedBufferGeometry,
  LinearSRGBColorSpace, Matrix4, Mesh, OrthographicCamera, PerspectiveCamera, Scene, ShaderMaterial,
  Shape, SphereGeometry, TorusGeometry, Vector3, WebGLRenderer
} from 'three';
export { default as Delaunator } from 'delaunator';
export { unzlibSync } from 'fflate';
