// Shaders of the viewer for ropes, netting, solid bodies, seabed, water and its surface.

import * as T from 'three';

interface Settings {
  side?: T.Side; transparent?: boolean; depthWrite?: boolean; depthTest?: boolean; behind?: number;
  uniforms?: Record<string, T.IUniform>;
}

export function rgb(hex: string): number[] {
  return [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16) / 255);
}
// Colours of stored designs, distinguishable without red and green vision (after Okabe and Ito,
// Color Universal Design, 2008).
export function kept_colour(k: number): string {
  return ['#7F8B95', '#0072B2', '#D55E00', '#009E73', '#CC79A7', '#56B4E9', '#8C6D00', '#000000'][k % 8];
}

export type Materials = ReturnType<typeof new_materials>;

// Returns the shaders with their shared uniforms.
export function new_materials() {
  // Colours of the water from the surface down, and of the bed and its grid.
  const waters = ['#F1F9FB', '#CCE6EF', '#A9CDDE'], sands = ['#E6DAC0', '#CBB98F'];
  function glsl(hex: string) { return 'vec3(' + rgb(hex).map((v) => v.toFixed(4)).join(', ') + ')'; }

  const shared = {
    pixel: { value: 1 }, spacing: { value: 1 }, flat_: { value: 0 }, ahead: { value: new T.Vector3() },
    light: { value: new T.Vector3(0, 0, 1) }, ratio: { value: 1 },
    fogNear: { value: 1 }, fogFar: { value: 2 }, fogMost: { value: 0.6 },
    paper: { value: 0 }, waterTop: { value: 0 }, waterSpan: { value: 1 },
    ghost: { value: 0 }, ghostColour: { value: new T.Color() }
  };
  const head = [
    'uniform float pixel, spacing, flat_, ratio, fogNear, fogFar, fogMost, paper, waterTop, waterSpan, ghost;',
    'uniform vec3 ahead, light, ghostColour;',
    // Returns the colour of the water at height z.
    'float depthShare(float z) { return clamp((waterTop - z) / waterSpan, 0.0, 1.0); }',
    'vec3 waterAt(float z) {',
    '  float deep = depthShare(z);',
    '  vec3 water = mix(' + glsl(waters[0]) + ', ' + glsl(waters[1]) + ', min(2.0 * deep, 1.0));',
    '  water = mix(water, ' + glsl(waters[2]) + ', max(2.0 * deep - 1.0, 0.0));',
    '  return mix(water, vec3(1.0), paper);',
    '}',
    // distance and height of a point
    'varying vec2 vWhere;', ''
  ].join('\n');
  const vertex_head = head + [
    // Returns the position of a point in the picture.
    'vec4 seenAt(vec3 place) {',
    '  vec4 seen = viewMatrix * vec4(place, 1.0);',
    '  vWhere = vec2(-seen.z, place.z);',
    '  return projectionMatrix * seen;',
    '}', ''
  ].join('\n');
  const fragment_head = head + [
    // Distant and deep points take the colour of the water.
    'void paint(vec3 colour, float alpha) {',
    '  vec3 seen = mix(colour, ghostColour, ghost) * (1.0 - 0.10 * (1.0 - paper) * depthShare(vWhere.y));',
    '  gl_FragColor = vec4(mix(seen, waterAt(vWhere.y), fogMost * smoothstep(fogNear, fogFar, vWhere.x)), alpha);',
    '}', ''
  ].join('\n');

  function material(vertex: string, fragment: string, more?: Settings) {
    const set = more || {};
    return new T.ShaderMaterial({
      vertexShader: vertex_head + vertex, fragmentShader: fragment_head + fragment,
      uniforms: Object.assign({}, shared, set.uniforms), side: set.side === undefined ? T.FrontSide : set.side,
      transparent: !!set.transparent, depthWrite: set.depthWrite !== false,
      depthTest: set.depthTest !== false, polygonOffset: !!set.behind,
      polygonOffsetFactor: set.behind || 0, polygonOffsetUnits: set.behind || 0
    });
  }

  // Returns a repeating texture from noise of a fixed seed: relief of sand (red), patches (green)
  // and a net of light (blue).
  let made: T.DataTexture | null = null;
  function sand() {
    if (made) return made;
    const n = 128;
    let seed = 20260101;
    function chance() {
      seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
      return seed / 4294967296;
    }
    // Returns smooth noise that repeats: octaves of random values on grids.
    function noise(first: number, octaves: number) {
      const sum = new Float32Array(n * n);
      let high = 1;
      for (let o = 0, cells = first; o < octaves; o++, cells *= 2, high *= 0.55) {
        const at = Float32Array.from({ length: cells * cells }, chance), size = n / cells;
        for (let y = 0; y < n; y++) {
          for (let x = 0; x < n; x++) {
            const i = Math.floor(x / size), j = Math.floor(y / size);
            let u = x / size - i, v = y / size - j;
            u *= u * (3 - 2 * u);
            v *= v * (3 - 2 * v);
            const right = (i + 1) % cells, below = (j + 1) % cells;
            sum[y * n + x] += high * (
              (at[j * cells + i] * (1 - u) + at[j * cells + right] * u) * (1 - v) +
              (at[below * cells + i] * (1 - u) + at[below * cells + right] * u) * v);
          }
        }
      }
      return sum;
    }
    const hills = noise(4, 5), bends = noise(4, 3), glints = noise(8, 2), bytes = new Uint8Array(4 * n * n);
    function height(x: number, y: number) {
      const at = (y % n) * n + x % n;
      return hills[at] * 1.3 + 0.22 * Math.sin(2 * Math.PI * (10 * x / n + 1.3 * bends[at]));
    }
    for (let y = 0; y < n; y++) {
      for (let x = 0; x < n; x++) {
        const at = y * n + x, to = 4 * at;
        bytes[to] = 128 + 330 * (height(x + 1, y) - height(x, y) + 0.4 * (height(x, y + 1) - height(x, y)));
        bytes[to + 1] = 255 * Math.min(hills[at] / 2.1, 1);
        bytes[to + 2] = 255 * Math.pow(1 - Math.min(Math.abs(glints[at] - 0.78) * 2.6, 1), 5);
        bytes[to + 3] = 255;
      }
    }
    made = new T.DataTexture(new Uint8Array(bytes), n, n);
    made.wrapS = made.wrapT = T.RepeatWrapping;
    made.minFilter = T.LinearMipmapLinearFilter;
    made.magFilter = T.LinearFilter;
    made.generateMipmaps = true;
    made.needsUpdate = true;
    return made;
  }

  // The water behind the gear.
  const around = material([
    'varying vec3 vRay;',
    'void main() {',
    '  vec4 far_ = inverse(projectionMatrix * viewMatrix) * vec4(position.xy, 1.0, 1.0);',
    '  vRay = far_.xyz / far_.w - cameraPosition;',
    '  gl_Position = vec4(position.xy, 1.0, 1.0);',
    '}'
  ].join('\n'), [
    'uniform float away; uniform sampler2D grain; varying vec3 vRay;',
    'void main() {',
    '  vec3 ray = normalize(vRay);',
    '  float z = cameraPosition.z + away * ray.z;',
    // Shafts of light lean and fade with depth.
    '  float turn = atan(ray.y, ray.x) * 1.9 + 0.6 * ray.z;',
    '  float shafts = texture2D(grain, vec2(turn, 0.31)).g - texture2D(grain, vec2(0.37 * turn, 0.77)).g;',
    '  float high = 1.0 - depthShare(z);',
    '  gl_FragColor = vec4(waterAt(z) + 0.18 * shafts * high * smoothstep(1.0, 0.8, high), 1.0);',
    '}'
  ].join('\n'), {
    depthWrite: false, depthTest: false, uniforms: { away: { value: 1 }, grain: { value: sand() } }
  });

  // Ropes are tubes along their lines, with a minimum width in pixels and dashes where slack. Close
  // up, the pattern shows the lay of ropes, links of chain and discs of ground gear. Seams are as
  // thin as twine.
  const ropeMaterial = material([
    // about: radius (m), slack (0 or 1) + 2 * form, distance along the rope (m)
    'attribute vec3 from, to, wayFrom, wayTo, colour, about;',
    'varying vec3 vColour, vNormal, vAlong; varying float vSlack, vForm;',
    'void main() {',
    '  vec3 p = mix(from, to, position.z), way = mix(wayFrom, wayTo, position.z);',
    '  seenAt(p);',
    '  float size = pixel * (flat_ > 0.5 ? 1.0 : max(vWhere.x, 0.0));',
    '  vSlack = mod(about.y, 2.0); vForm = floor(about.y / 2.0);',
    '  float own = about.x * (vForm == 1.0 ? 1.7 : 1.0);',
    '  float radius = max(own, (vForm == 4.0 ? 0.5 : vSlack > 0.5 ? 0.8 : 1.35) * ratio * size);',
    '  vec3 eye = flat_ > 0.5 ? -ahead : cameraPosition - p;',
    '  vec3 side = cross(way, eye);',
    '  if (dot(side, side) < 1e-10 * dot(eye, eye)) side = cross(way, vec3(0.31, 0.72, 0.62));',
    '  side = normalize(side);',
    '  vec3 out_ = normalize(cross(side, way));',
    '  vNormal = side * position.x + out_ * position.y;',
    '  vColour = colour;',
    '  float along = about.z + position.z * length(to - from);',
    // vAlong: distance along the rope in dashes and in diameters, position across it
    '  vAlong = vec3(along / (9.0 * ratio * size), along / max(2.0 * about.x, 1e-4), position.x);',
    '  gl_Position = projectionMatrix * viewMatrix * vec4(p + radius * vNormal, 1.0);',
    '}'
  ].join('\n'), [
    'varying vec3 vColour, vNormal, vAlong; varying float vSlack, vForm;',
    'void main() {',
    '  if (vSlack > 0.5 && fract(vAlong.x) > 0.6) discard;',
    '  vec3 n = normalize(vNormal);',
    '  float lit = dot(n, light), grain = 1.0, w = fwidth(vAlong.y), seen = 1.0 - smoothstep(0.2, 0.6, w);',
    '  if (vForm == 1.0) {',
    // Links of chain alternate between flat and on edge.
    '    float at = fract(vAlong.y / 4.0), turned = step(0.5, fract(vAlong.y / 8.0));',
    '    float off = abs(vAlong.z), ends = abs(at - 0.5);',
    '    if (seen > 0.5) {',
    '      if (turned < 0.5 && off < 0.42 && ends < 0.32) discard;',
    '      if (turned > 0.5 && off > 0.34) discard;',
    '    }',
    '    grain = 1.0 - 0.25 * seen * turned;',
    '  } else if (vForm == 2.0) {',
    '    grain = 1.0 - 0.55 * seen * smoothstep(0.28, 0.5, abs(fract(vAlong.y / 0.55) - 0.5));',
    '  } else if (vForm == 0.0) {',
    '    grain = 1.0 - 0.22 * seen * smoothstep(0.25, 0.5, abs(fract(vAlong.y / 0.8 + 0.45 * vAlong.z) - 0.5));',
    '  }',
    '  vec3 colour = vColour * grain * (0.66 + 0.36 * max(lit, 0.0) + 0.06 * n.z);',
    '  colour += 0.20 * pow(max(lit, 0.0), 22.0);',
    '  paint(colour, 1.0);',
    '}'
  ].join('\n'));

  // Netting is a surface with twines at integer mesh coordinates. If twines are closer than
  // `spacing` (m), the whole panel shows fewer: at multiples of a power of two of the drawn
  // coordinates (R/scene-drawn.R). A translucent film replaces the omitted twine. Fish fill the
  // meshes behind the front of a catch. core: true for opaque pixels (drawn first), false for soft
  // edges.
  function netting(core: boolean) {
    return material([
      // gap: distance between twines (m), at integer mesh and at integer drawn coordinates.
      // about: twine thickness in meshes, plus 1 if filled with catch; slack of both families.
      'attribute vec3 colourU, colourV; attribute vec2 mesh, drawn, gap; attribute vec3 about;',
      'varying vec3 vU, vV, vNormal, vLines; varying vec2 vMesh; varying vec4 vAbout;',
      'void main() {',
      '  vU = colourU; vV = colourV; vMesh = mesh; vNormal = normal;',
      '  float full = step(0.75, about.x), level = log2(spacing / gap.y);',
      '  vLines = level < 0.0 ? vec3(mesh, 0.0) : vec3(drawn, level);',
      '  vAbout = vec4((about.x - full) * (level < 0.0 ? 1.0 : gap.x / gap.y), about.yz, full);',
      '  gl_Position = seenAt(position);',
      '}'
    ].join('\n'), [
      '#define CORE ' + (core ? 1 : 0),
      'varying vec3 vU, vV, vNormal, vLines; varying vec2 vMesh; varying vec4 vAbout;',
      // Returns the covered fraction of a pixel and its shading. x: across the twines; w: pixel size.
      'vec2 cover(float x, float w, float thick, float along, float slack) {',
      '  float k = floor(vLines.z), f = vLines.z - k, step_ = exp2(k);',
      '  float fine = abs(fract(x / step_ + 0.5) - 0.5) * step_ / w;',
      '  float coarse = abs(fract(x / step_ * 0.5 + 0.5) - 0.5) * step_ * 2.0 / w;',
      '  float half_ = max(0.5 * thick / w, (slack > 0.5 ? 0.42 : 0.6) * ratio);',
      '  float fade = 1.0 - smoothstep(0.85, 1.0, f);',
      '  float c = max(clamp(half_ + 0.5 - coarse, 0.0, 1.0), clamp(half_ + 0.5 - fine, 0.0, 1.0) * fade);',
      // Twines that nearly touch form a film.
      '  float close = w / step_;',
      '  c = mix(c, min(half_ * close * (1.0 + fade), 0.48), smoothstep(0.35, 0.8, close * ratio));',
      // Dashes mark slack twine.
      '  if (slack > 0.5 && fract(along / step_ * 0.5) > 0.62) c = 0.0;',
      '  float off = min(min(fine, coarse) / half_, 1.0);',
      '  return vec2(c, 1.0 - smoothstep(1.2, 3.0, half_) * 0.45 * off * off);',
      '}',
      'void main() {',
      '  vec2 w = max(fwidth(vLines.xy), vec2(1e-6));',
      '  float thick = vAbout.x, full = vAbout.w, slackU = vAbout.y, slackV = vAbout.z;',
      '  vec2 u = cover(vLines.y, w.y, thick, vLines.x, slackU);',
      '  vec2 v = cover(vLines.x, w.x, thick, vLines.y, slackV);',
      '  float fineness = smoothstep(0.08, 0.6, max(w.x, w.y) * ratio);',
      '  float slack = 0.5 * (slackU + slackV);',
      '  float film = fineness * min(3.0 * thick, 0.3) * (1.0 - 0.4 * slack);',
      '  vec3 twine = v.x > u.x ? vV * v.y : vU * u.y;',
      '  float alpha = max(u.x, v.x);',
      '  float knot = 0.5 * thick * 1.9;',
      '  float far_ = max(w.x, w.y);',
      '  if (knot / far_ > 1.5) {',
      '    vec2 off = abs(fract(vMesh + 0.5) - 0.5);',
      '    alpha = max(alpha, clamp((knot - length(off)) / far_ + 0.5, 0.0, 1.0));',
      '  }',
      '  vec3 n = normalize(vNormal);',
      '  float facing = abs(dot(n, light));',
      '  float lit = 0.70 + 0.34 * facing;',
      '  vec3 colour = mix(0.5 * (vU + vV), twine, alpha > 0.02 ? 1.0 : 0.0) * lit;',
      '  float whole = alpha + (1.0 - alpha) * film;',
      '  if (full > 0.5) {',
      // Fish have silver flanks with darker backs and are two meshes long.
      '    vec2 at = vMesh * vec2(0.5, 0.5) + vec2(0.25 * floor(vMesh.y), 0.0);',
      '    vec2 fish = fract(at) - 0.5;',
      '    float back = smoothstep(-0.5, 0.5, fish.x + fish.y);',
      '    vec3 silver = mix(vec3(0.60, 0.66, 0.70), vec3(0.28, 0.34, 0.38), back) * (0.55 + 0.6 * facing);',
      '    colour = mix(silver, colour, alpha);',
      '    whole = 1.0;',
      '  }',
      '#if CORE == 1',
      '  if (whole < 0.5) discard;',
      '  paint(colour, 1.0);',
      '#else',
      '  if (whole >= 0.5 || whole < 0.01) discard;',
      '  paint(colour, whole);',
      '#endif',
      '}'
    ].join('\n'), { side: T.DoubleSide, transparent: !core, depthWrite: core });
  }
  const nettingCore = netting(true), nettingEdge = netting(false);

  const solid = material([
    'attribute vec3 colour; varying vec3 vNormal, vColour, vEye;',
    'void main() {',
    '  vNormal = normal; vColour = colour;',
    '  vEye = flat_ > 0.5 ? -ahead : cameraPosition - position;',
    '  gl_Position = seenAt(position);',
    '}'
  ].join('\n'), [
    'varying vec3 vNormal, vColour, vEye;',
    'void main() {',
    '  vec3 n = normalize(vNormal);',
    '  if (!gl_FrontFacing) n = -n;',
    '  float lit = max(dot(n, light), 0.0);',
    '  float shine = pow(max(dot(n, normalize(light + normalize(vEye))), 0.0), 28.0);',
    '  vec3 c = vColour * (0.58 + 0.44 * lit + 0.10 * n.z) + 0.28 * shine;',
    '  paint(c, 1.0);',
    '}'
  ].join('\n'), { side: T.DoubleSide });

  // Returns the seabed with the gear's shadow (ground = true) or the water surface with waves. Both
  // have a grid that fades away from the gear.
  function sheet(ground: boolean, strength: number) {
    const colour = ground ? sands[0] : '#9CC6E0', line = ground ? sands[1] : '#6FA3C6';
    return material([
      'varying vec2 vAt;',
      'void main() {',
      '  vAt = position.xy;',
      '  gl_Position = seenAt(position);',
      '}'
    ].join('\n'), [
      '#define GROUND ' + (ground ? 1 : 0),
      'uniform sampler2D grain, shadow; uniform vec3 colour, line, shadowAt;',
      'uniform float square, strength, reach; uniform vec2 middle;',
      'varying vec2 vAt;',
      'void main() {',
      '  vec2 w = max(fwidth(vAt / square), vec2(1e-6));',
      '  vec2 d = abs(fract(vAt / square + 0.5) - 0.5) / w;',
      '  float on = max(clamp(0.5 * ratio + 0.5 - d.x, 0.0, 1.0) * (1.0 - smoothstep(0.12, 0.5, w.x)),',
      '    clamp(0.5 * ratio + 0.5 - d.y, 0.0, 1.0) * (1.0 - smoothstep(0.12, 0.5, w.y)));',
      '  float fade = 1.0 - smoothstep(0.35, 1.0, length(vAt - middle) / reach);',
      // The sheet fades close to the eye to hide its edge.
      '  if (flat_ < 0.5) fade *= smoothstep(0.02, 0.25, vWhere.x / fogNear);',
      '  vec2 at = vAt / square;',
      '  vec3 wide = texture2D(grain, mat2(0.8, -0.6, 0.6, 0.8) * at * 0.23).rgb;',
      '  vec3 near = texture2D(grain, at * 0.71).rgb;',
      '  vec3 ground_ = colour;',
      '#if GROUND == 1',
      '  vec3 fine = texture2D(grain, at * 5.3).rgb;',
      '  float relief = 0.20 * (wide.r - 0.5) + 0.27 * (near.r - 0.5) + 0.20 * (fine.r - 0.5);',
      '  ground_ = colour * (1.0 + (1.0 - paper) * (relief + 0.16 * (wide.g - 0.5)));',
      '  ground_ += (1.0 - paper) * 0.05 * near.b * (0.4 + wide.g);',
      '  vec2 under = (vAt - shadowAt.xy) / shadowAt.z * 0.5 + 0.5;',
      '  vec2 inside = step(abs(under - 0.5), vec2(0.5));',
      '  float dark = 0.55 * textureLod(shadow, under, 1.0).a + 0.65 * textureLod(shadow, under, 3.5).a;',
      '  ground_ *= 1.0 - min(0.42 * dark, 0.34) * inside.x * inside.y;',
      '  ground_ = mix(ground_, line, 0.55 * on);',
      '  paint(ground_, strength * fade);',
      '#else',
      '  float wave = (1.0 - paper) * (0.6 * (near.r - 0.5) + 0.5 * (wide.r - 0.5));',
      '  ground_ = mix(mix(ground_, vec3(1.0), clamp(3.0 * wave, 0.0, 1.0)), line, on);',
      '  paint(ground_, (strength + 0.5 * abs(wave) + on * 0.2) * fade);',
      '#endif',
      '}'
    ].join('\n'), {
      side: T.DoubleSide, transparent: true, depthWrite: false, behind: 1,
      uniforms: {
        colour: { value: new T.Vector3().fromArray(rgb(colour)) },
        line: { value: new T.Vector3().fromArray(rgb(line)) }, square: { value: 1 },
        strength: { value: strength }, reach: { value: 1 }, middle: { value: { x: 0, y: 0 } },
        grain: { value: sand() }, shadow: { value: null }, shadowAt: { value: new T.Vector3(0, 0, 1) }
      }
    });
  }

  return {
    shared, around, rope: ropeMaterial, nettingCore,
    nettingEdge, solid, sheet
  };
}
