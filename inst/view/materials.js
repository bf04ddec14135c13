// Materials of the viewer: shaders for ropes, netting, solids, the sea bed and the water's surface, and
// what they share (codendView.materials()).
window.codendView = window.codendView || {};
window.codendView.rgb = function (hex) {
  return [1, 3, 5].map(function (at) { return parseInt(hex.slice(at, at + 2), 16) / 255; });
};
// Colours of the kept designs over which another is drawn, told apart by readers who see no red or green
// (after Okabe and Ito, Color Universal Design, 2008).
window.codendView.kept_colour = function (k) {
  return ['#7F8B95', '#0072B2', '#D55E00', '#009E73', '#CC79A7', '#56B4E9', '#8C6D00', '#000000'][k % 8];
};
window.codendView.materials = function () {
  'use strict';
  var T = window.THREE, rgb = window.codendView.rgb;

  var shared = {
    pixel: { value: 1 }, flat: { value: 0 }, ahead: { value: new T.Vector3() },
    light: { value: new T.Vector3(0, 0, 1) }, ratio: { value: 1 },
    fogColour: { value: new T.Color() }, fogNear: { value: 1 }, fogFar: { value: 2 },
    fogMost: { value: 0.6 }, ghost: { value: 0 }, ghostColour: { value: new T.Color() }
  };
  var head = [
    'uniform float pixel, flat_, ratio, fogNear, fogFar, fogMost, ghost;',
    'uniform vec3 ahead, light, fogColour, ghostColour;'
  ].join('\n');
  var fog = [
    'vec3 inFog(vec3 colour, float away) {',
    '  return mix(colour, fogColour, fogMost * smoothstep(fogNear, fogFar, away));',
    '}'
  ].join('\n');

  function material(vertex, fragment, more) {
    var uniforms = {
      pixel: shared.pixel, flat_: shared.flat, ahead: shared.ahead, light: shared.light,
      ratio: shared.ratio, fogColour: shared.fogColour, fogNear: shared.fogNear,
      fogFar: shared.fogFar, fogMost: shared.fogMost, ghost: shared.ghost,
      ghostColour: shared.ghostColour
    };
    var set = more || {};
    Object.keys(set.uniforms || {}).forEach(function (name) { uniforms[name] = set.uniforms[name]; });
    return new T.ShaderMaterial({
      vertexShader: head + '\n' + vertex, fragmentShader: head + '\n' + fog + '\n' + fragment,
      uniforms: uniforms, side: set.side === undefined ? T.FrontSide : set.side,
      transparent: !!set.transparent, depthWrite: set.depthWrite !== false,
      polygonOffset: !!set.behind, polygonOffsetFactor: set.behind || 0,
      polygonOffsetUnits: set.behind || 0
    });
  }

  // Ropes: a tube along each line, at least some pixels thick; stripes where slack.
  var ropeMaterial = material([
    'attribute vec3 from, to, wayFrom, wayTo, colour, about;',  // about: radius, slack, metres along
    'varying vec3 vColour, vNormal; varying float vAlong, vSlack, vAway;',
    'void main() {',
    '  vec3 p = mix(from, to, position.z), way = mix(wayFrom, wayTo, position.z);',
    '  vec4 seen = viewMatrix * vec4(p, 1.0);',
    '  vAway = -seen.z;',
    '  float size = pixel * (flat_ > 0.5 ? 1.0 : max(vAway, 0.0));',
    '  float radius = max(about.x, (about.y > 0.5 ? 2.0 : 1.35) * ratio * size);',
    '  vec3 eye = flat_ > 0.5 ? -ahead : cameraPosition - p;',
    '  vec3 side = cross(way, eye);',
    '  if (dot(side, side) < 1e-10 * dot(eye, eye)) side = cross(way, vec3(0.31, 0.72, 0.62));',
    '  side = normalize(side);',
    '  vec3 out_ = normalize(cross(side, way));',
    '  vNormal = side * position.x + out_ * position.y;',
    '  vColour = colour; vSlack = about.y;',
    '  vAlong = (about.z + position.z * length(to - from)) / (9.0 * ratio * size);',
    '  gl_Position = projectionMatrix * viewMatrix * vec4(p + radius * vNormal, 1.0);',
    '}'
  ].join('\n'), [
    'varying vec3 vColour, vNormal; varying float vAlong, vSlack, vAway;',
    'void main() {',
    '  vec3 n = normalize(vNormal);',
    '  float lit = dot(n, light);',
    '  vec3 colour = vSlack > 0.5 && fract(vAlong) > 0.6 ? vec3(1.0) : vColour;',
    '  colour *= 0.72 + 0.34 * max(lit, 0.0);',
    '  colour += 0.16 * pow(max(lit, 0.0), 18.0);',
    '  colour = mix(colour, ghostColour, ghost);',
    '  gl_FragColor = vec4(inFog(colour, vAway), 1.0);',
    '}'
  ].join('\n'));

  // Netting: a surface with the twines of its meshes, at whole mesh coordinates. Where meshes are
  // smaller than some pixels only every second, fourth... twine is drawn, over a film as dense as the
  // twine that is left out. `core`: what covers, first; then the soft edges.
  function netting(core) {
    return material([
      'attribute vec3 colourU, colourV; attribute vec2 mesh; attribute vec3 about;',
      'varying vec3 vU, vV, vNormal; varying vec2 vMesh; varying vec3 vAbout; varying float vAway;',
      'void main() {',
      '  vU = colourU; vV = colourV; vMesh = mesh; vAbout = about; vNormal = normal;',
      '  vec4 seen = viewMatrix * vec4(position, 1.0);',
      '  vAway = -seen.z;',
      '  gl_Position = projectionMatrix * seen;',
      '}'
    ].join('\n'), [
      '#define CORE ' + (core ? 1 : 0),
      'varying vec3 vU, vV, vNormal; varying vec2 vMesh; varying vec3 vAbout; varying float vAway;',
      // how much of a pixel a twine covers: x across the twines, one apart; w: of a pixel
      'float cover(float x, float w, float thick, float along, float slack, float gone) {',
      '  float level = max(0.0, log2(7.0 * ratio * w));',
      '  float k = floor(level), f = level - k, step_ = exp2(k);',
      '  float fine = abs(fract(x / step_ + 0.5) - 0.5) * step_ / w;',
      '  float coarse = abs(fract(x / step_ * 0.5 + 0.5) - 0.5) * step_ * 2.0 / w;',
      '  float half_ = max(0.5 * thick / w, (slack > 0.5 ? 0.85 : 0.6) * ratio);',
      '  float c = max(clamp(half_ + 0.5 - coarse, 0.0, 1.0),',
      '    clamp(half_ + 0.5 - fine, 0.0, 1.0) * (1.0 - smoothstep(0.3, 1.0, f)));',
      // dashes of half a drawn mesh
      '  if (slack > 0.5 && fract(along / step_ * 0.5) > 0.62) c = 0.0;',
      '  return c;',
      '}',
      'void main() {',
      '  vec2 w = max(fwidth(vMesh), vec2(1e-6));',
      '  float slackU = vAbout.y, slackV = vAbout.z;',
      '  float u = cover(vMesh.y, w.y, vAbout.x, vMesh.x, slackU, 0.0);',
      '  float v = cover(vMesh.x, w.x, vAbout.x, vMesh.y, slackV, 0.0);',
      '  float fineness = smoothstep(0.08, 0.6, max(w.x, w.y) * ratio);',
      '  float film = fineness * clamp(1.6 * vAbout.x + 0.06, 0.08, 0.3);',
      '  float slack = 0.5 * (slackU + slackV);',
      '  film = max(film, slack * 0.3 * fineness);',
      '  vec3 twine = v > u ? vV : vU;',
      '  float alpha = max(u, v);',
      '  float knot = 0.5 * vAbout.x * 1.9;',
      '  float far_ = max(w.x, w.y);',
      '  if (knot / far_ > 1.5) {',
      '    vec2 off = abs(fract(vMesh + 0.5) - 0.5);',
      '    alpha = max(alpha, clamp((knot - length(off)) / far_ + 0.5, 0.0, 1.0));',
      '  }',
      '  vec3 n = normalize(vNormal);',
      '  float lit = 0.78 + 0.24 * abs(dot(n, light));',
      '  vec3 colour = mix(mix(0.5 * (vU + vV), twine, alpha > 0.02 ? 1.0 : 0.0) * lit, ghostColour, ghost);',
      '  float whole = alpha + (1.0 - alpha) * film;',
      '#if CORE == 1',
      '  if (whole < 0.5) discard;',
      '  gl_FragColor = vec4(inFog(colour, vAway), 1.0);',
      '#else',
      '  if (whole >= 0.5 || whole < 0.01) discard;',
      '  gl_FragColor = vec4(inFog(colour, vAway), whole);',
      '#endif',
      '}'
    ].join('\n'), { side: T.DoubleSide, transparent: !core, depthWrite: core });
  }
  var nettingCore = netting(true), nettingEdge = netting(false);

  var solid = material([
    'attribute vec3 colour; varying vec3 vNormal, vColour; varying float vAway;',
    'void main() {',
    '  vNormal = normal; vColour = colour;',
    '  vec4 seen = viewMatrix * vec4(position, 1.0);',
    '  vAway = -seen.z;',
    '  gl_Position = projectionMatrix * seen;',
    '}'
  ].join('\n'), [
    'varying vec3 vNormal, vColour; varying float vAway;',
    'void main() {',
    '  vec3 n = normalize(vNormal);',
    '  float lit = dot(gl_FrontFacing ? n : -n, light);',
    '  vec3 c = vColour * (0.68 + 0.36 * max(lit, 0.0)) + 0.10 * pow(max(lit, 0.0), 12.0);',
    '  gl_FragColor = vec4(inFog(mix(c, ghostColour, ghost), vAway), 1.0);',
    '}'
  ].join('\n'), { side: T.DoubleSide });

  // The sea bed and the water's surface, with squares of a round size that fade away from the gear.
  function sheet(colour, line, strength) {
    return material([
      'varying vec2 vAt; varying float vAway;',
      'void main() {',
      '  vAt = position.xy;',
      '  vec4 seen = viewMatrix * vec4(position, 1.0);',
      '  vAway = -seen.z;',
      '  gl_Position = projectionMatrix * seen;',
      '}'
    ].join('\n'), [
      'uniform vec3 colour, line; uniform float square, strength, reach; uniform vec2 middle;',
      'varying vec2 vAt; varying float vAway;',
      'void main() {',
      '  vec2 w = max(fwidth(vAt / square), vec2(1e-6));',
      '  vec2 d = abs(fract(vAt / square + 0.5) - 0.5) / w;',
      '  float on = max(clamp(0.5 * ratio + 0.5 - d.x, 0.0, 1.0) * (1.0 - smoothstep(0.12, 0.5, w.x)),',
      '    clamp(0.5 * ratio + 0.5 - d.y, 0.0, 1.0) * (1.0 - smoothstep(0.12, 0.5, w.y)));',
      '  float fade = 1.0 - smoothstep(0.35, 1.0, length(vAt - middle) / reach);',
      '  gl_FragColor = vec4(inFog(mix(colour, line, on), vAway), strength * fade + on * 0.35 * fade);',
      '}'
    ].join('\n'), {
      side: T.DoubleSide, transparent: true, depthWrite: false, behind: 1,
      uniforms: {
        colour: { value: new T.Vector3().fromArray(rgb(colour)) },
        line: { value: new T.Vector3().fromArray(rgb(line)) }, square: { value: 1 },
        strength: { value: strength }, reach: { value: 1 }, middle: { value: { x: 0, y: 0 } }
      }
    });
  }

  return {
    shared: shared, rope: ropeMaterial, nettingCore: nettingCore, nettingEdge: nettingEdge,
    solid: solid, sheet: sheet
  };
};
