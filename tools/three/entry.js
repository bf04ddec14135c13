// What the viewer (inst/view/viewer.js) uses of three.js, delaunator and fflate; tools/three/build makes
// inst/view/three.js of it.
export {
  BoxGeometry, BufferAttribute, BufferGeometry, Color, ColorManagement, CylinderGeometry, DataTexture,
  DoubleSide, ExtrudeGeometry, FrontSide, InstancedBufferAttribute,
  InstancedBufferGeometry, LinearFilter, LinearMipmapLinearFilter, LinearSRGBColorSpace, Matrix4, Mesh,
  OrthographicCamera, PerspectiveCamera, RepeatWrapping, Scene, ShaderMaterial, Shape, SphereGeometry,
  TorusGeometry, Vector3, WebGLRenderer, WebGLRenderTarget
} from 'three/src/Three.js';
export { default as Delaunator } from 'delaunator';
export { unzlibSync } from 'fflate';
