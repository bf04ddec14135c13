// Exports of three.js, delaunator and fflate that the viewer (inst/view/viewer.js) uses.
// tools/three/build bundles them into inst/view/three.js.
export {
  BoxGeometry, BufferAttribute, BufferGeometry, Color, ColorManagement, CylinderGeometry, DataTexture,
  DoubleSide, ExtrudeGeometry, FrontSide, InstancedBufferAttribute,
  InstancedBufferGeometry, LinearFilter, LinearMipmapLinearFilter, LinearSRGBColorSpace, Matrix4, Mesh,
  OrthographicCamera, PerspectiveCamera, RepeatWrapping, Scene, ShaderMaterial, Shape, SphereGeometry,
  TorusGeometry, Vector3, WebGLRenderer, WebGLRenderTarget
} from 'three/src/Three.js';
export { default as Delaunator } from 'delaunator';
export { unzlibSync } from 'fflate';
