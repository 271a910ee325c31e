// SPDX-License-Identifier: Apache-2.0
// The viewer inside a page written by draw/html.cpp: WebGL 2, or a depth buffer in JavaScript where there is no WebGL.
// The part of the address after # sets the first picture: view=front&explode=0.5&glass=1&edges=0&perspective=1&hide=2,3&pick=400,300&canvas=1
'use strict';
(() => {
const scene = JSON.parse(document.getElementById('scene').textContent);
const element = id => document.getElementById(id);
const canvas = element('view');
const wanted = new URLSearchParams(location.hash.slice(1));

// ---------------------------------------------------------------- data

const decode = (text, Type) => {
  const raw = atob(text), bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; ++i) bytes[i] = raw.charCodeAt(i);
  return new Type(bytes.buffer);
};
const points = decode(scene.points, Float32Array), normals = decode(scene.normals, Int16Array);
const triangles = decode(scene.triangles, Uint32Array), places = decode(scene.places, Float32Array);
const regions = scene.regions, faces = scene.faces, edges = scene.edges, marks = scene.marks;

for (const r of regions) r.shown = true;
const wayOf = region => region < 0 ? [0, 0, 0] : regions[region].way;

// A face between two regions is there once for each, so that regions can move apart.
const items = [];
faces.forEach((f, face) => {
  const own = [...new Set(f.regions.filter(r => r >= 0))];
  for (const region of own.length ? own : [-1]) {
    items.push({face, region, color: scene.coloring === 'faces' || f.own || region < 0 ? f.color : regions[region].color});
  }
});
// So are its edges.
const strokes = [];
edges.forEach((e, edge) => {
  const own = new Set();
  for (const f of e.faces) {
    const sides = faces[f].regions.filter(r => r >= 0);
    (sides.length ? sides : [-1]).forEach(r => own.add(r));
  }
  for (const region of own.size ? own : [-1]) strokes.push({edge, region});
});
const shown = region => region < 0 || regions[region].shown;

// ---------------------------------------------------------------- view

const state = {yaw: 0, pitch: 0, target: [0, 0, 0], height: 1, explode: 0, glass: false, lines: true, deep: false, face: -1, region: -1};
const views = {iso: [-45, 35.264389682754654], front: [-90, 0], back: [90, 0], left: [180, 0], right: [0, 0], top: [-90, 90], bottom: [-90, -90]};
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const add = (a, s, b) => [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
const unit = a => { const n = Math.hypot(...a) || 1; return [a[0] / n, a[1] / n, a[2] / n]; };

const axes = () => {
  const y = state.yaw * Math.PI / 180, p = state.pitch * Math.PI / 180;
  const right = [-Math.sin(y), Math.cos(y), 0];
  const back = [Math.cos(p) * Math.cos(y), Math.cos(p) * Math.sin(y), Math.sin(p)];
  return {right, up: cross(back, right), back};
};
const slope = Math.tan(15 * Math.PI / 180);  // half the angle of sight in perspective
const size = () => [canvas.clientWidth || 1, canvas.clientHeight || 1];
const distance = () => state.height / 2 / slope;
const furthest = regions.reduce((most, r) => Math.max(most, Math.hypot(...r.way)), 0);
const reach = () => 0.52 * scene.size + state.explode * furthest + Math.hypot(...state.target);

// Projection of view coordinates (right, up, towards the eye, from the target) to clip space, by columns.
const projection = () => {
  const [w, h] = size(), aspect = w / h, far = reach();
  if (!state.deep) return [2 / (state.height * aspect), 0, 0, 0, 0, 2 / state.height, 0, 0, 0, 0, -1 / far, 0, 0, 0, 0, 1];
  const d = distance(), n = Math.max(d - far, 0.005 * d), f = d + far;
  // w = d - z; depth = ((f + n) w - 2 f n) / (f - n)
  return [1 / (slope * aspect), 0, 0, 0, 0, 1 / slope, 0, 0, 0, 0, -(f + n) / (f - n), -1, 0, 0, ((f + n) * d - 2 * f * n) / (f - n), d];
};

let fitted = false;  // nothing was moved by hand since
const fit = () => {
  fitted = true;
  const {right, up, back} = axes(), seen = [];
  const take = (array, [first, count], way) => {
    for (let v = 3 * first; v < 3 * (first + count); v += 3) {
      const p = [0, 1, 2].map(k => array[v + k] + state.explode * way[k]);
      seen.push(dot(p, right), dot(p, up), dot(p, back));
    }
  };
  for (const item of items) if (shown(item.region)) take(points, faces[item.face].points, wayOf(item.region));
  for (const stroke of strokes) if (shown(stroke.region)) take(places, edges[stroke.edge].places, wayOf(stroke.region));
  for (const m of marks) take(m.place, [0, 1], [0, 0, 0]);
  if (!seen.length) return;
  const extent = (k, of) => {
    let low = Infinity, high = -Infinity;
    for (let i = 0; i < seen.length; i += 3) {
      const v = of(i, k);
      if (v < low) low = v;
      if (v > high) high = v;
    }
    return [low, high];
  };
  const flat = (i, k) => seen[i + k];
  const c = [0, 1, 2].map(k => { const [low, high] = extent(k, flat); return (low + high) / 2; });
  // Room for the cards: what is free lies a little to the left of and above the middle of the window.
  const [w, h] = size(), aside = w > 1000 ? 280 : 20;
  const freeW = Math.max(w - aside - 40, w / 2), freeH = Math.max(h - 150, h / 2);
  let width = 0, height = 0;
  if (!state.deep) {
    [width, height] = [0, 1].map(k => { const [low, high] = extent(k, flat); return high - low; });
    state.height = Math.max(height * h / freeH, width * h / freeW, 1e-9 * scene.size);
  } else {
    // The nearest eye from which all is inside the picture; then the middle of what is seen is made its middle, and again.
    for (let round = 0; round < 8; ++round) {
      let d = 0.02 * scene.size;
      for (let i = 0; i < seen.length; i += 3) {
        const z = seen[i + 2] - c[2];
        d = Math.max(d, z + Math.max(Math.abs(seen[i] - c[0]) * h / freeW, Math.abs(seen[i + 1] - c[1]) * h / freeH) / slope, z + 0.02 * scene.size);
      }
      state.height = 2 * slope * d;
      for (const k of [0, 1]) {
        const [low, high] = extent(k, i => (seen[i + k] - c[k]) / (d - seen[i + 2] + c[2]));
        c[k] += (low + high) / 2 * d;
      }
    }
  }
  const pixel = state.height / h;
  if (freeW > w / 2) c[0] += (aside - 20) / 2 * pixel;
  if (freeH > h / 2) c[1] -= 15 * pixel;
  state.target = [0, 1, 2].map(k => c[0] * right[k] + c[1] * up[k] + c[2] * back[k]);
};
const look = name => {
  [state.yaw, state.pitch] = views[name] || views.iso;
  fit();
  draw();
};

// ---------------------------------------------------------------- light, as in the shaded pictures

const keyLight = unit([-0.55, 0.60, 0.58]), fillLight = unit([0.72, 0.05, 0.69]);
const wrapped = c => { const h = Math.max(0, 0.5 + 0.5 * c); return h * h; };
const light = n => 0.46 + 0.52 * wrapped(dot(n, keyLight)) + 0.20 * wrapped(dot(n, fillLight));
const pickedFace = [255, 205, 70], pickedRegion = [255, 228, 160];
const tint = item => item.face === state.face ? [pickedFace, 0.75] : item.region >= 0 && item.region === state.region ? [pickedRegion, 0.45] : null;

// ---------------------------------------------------------------- WebGL

const meshVertex = `#version 300 es
precision highp float;
in vec3 point; in vec4 normal; in vec3 way; in vec4 color; in float item;
uniform mat4 projection; uniform mat3 turn; uniform vec3 target; uniform float explode; uniform sampler2D states;
out vec3 seen; out vec3 across; out vec4 paint;
void main() {
  int i = int(item + 0.5);
  vec4 s = texelFetch(states, ivec2(i & 1023, i >> 10), 0);
  seen = turn * (point + explode * way - target);
  across = turn * normal.xyz;
  paint = vec4(mix(color.rgb, s.rgb, s.a < 0.9 ? s.a : 0.0), 1.0);
  gl_Position = s.a > 0.9 ? vec4(2.0, 2.0, 2.0, 1.0) : projection * vec4(seen, 1.0);
}`;
const meshFragment = `#version 300 es
precision highp float;
in vec3 seen; in vec3 across; in vec4 paint;
uniform float alpha; uniform float away; uniform vec3 key; uniform vec3 fill;
out vec4 result;
float wrapped(float c) { float h = max(0.0, 0.5 + 0.5 * c); return h * h; }
void main() {
  vec3 flatNormal = normalize(cross(dFdx(seen), dFdy(seen)));
  vec3 eye = away > 0.0 ? normalize(vec3(0.0, 0.0, away) - seen) : vec3(0.0, 0.0, 1.0);
  if (dot(flatNormal, eye) < 0.0) flatNormal = -flatNormal;
  bool curved = dot(across, across) > 0.01;
  vec3 n = curved ? normalize(across) : flatNormal;
  if (dot(n, flatNormal) < 0.0) n = -n;
  float l = 0.46 + 0.52 * wrapped(dot(n, key)) + 0.20 * wrapped(dot(n, fill));
  float g = pow(max(0.0, dot(n, normalize(key + vec3(0.0, 0.0, 1.0)))), 32.0) * 0.10;
  float rim = curved ? mix(0.55, 1.0, smoothstep(0.0, 0.30, dot(n, eye))) : 1.0;
  result = vec4((paint.rgb * l + g) * rim, alpha);
}`;
const lineVertex = `#version 300 es
precision highp float;
in vec3 start; in vec3 end; in vec3 way; in vec4 color; in float region;
uniform mat4 projection; uniform mat3 turn; uniform vec3 target; uniform float explode; uniform vec2 screen; uniform float width; uniform bool edges;
uniform sampler2D states; uniform float away; uniform float lift;
out vec4 paint;
// Edges are lifted a little towards the eye, out of the faces they bound.
vec4 place(vec3 p) {
  vec3 v = turn * (p + explode * way - target);
  return projection * vec4(away > 0.0 ? mix(v, vec3(0.0, 0.0, away), lift / away) : v + vec3(0.0, 0.0, lift), 1.0);
}
void main() {
  int i = int(region + 0.5);
  bool hidden = region < -0.5 ? false : !edges || i > 0 && texelFetch(states, ivec2((i - 1) & 1023, (i - 1) >> 10), 0).r > 0.5;
  vec4 a = place(start), b = place(end);
  float least = 1e-4;
  if (a.w < least && b.w < least) hidden = true;
  if (a.w < least) a = mix(a, b, (least - a.w) / (b.w - a.w));
  if (b.w < least) b = mix(b, a, (least - b.w) / (a.w - b.w));
  vec2 along = (b.xy / b.w - a.xy / a.w) * screen;
  along = length(along) > 1e-6 ? normalize(along) : vec2(1.0, 0.0);
  vec4 c = (gl_VertexID & 1) == 0 ? a : b;
  vec2 off = vec2(-along.y, along.x) * ((gl_VertexID & 2) == 0 ? -1.0 : 1.0) + along * ((gl_VertexID & 1) == 0 ? -0.5 : 0.5);
  c.xy += off * width / screen * c.w;
  paint = color;
  gl_Position = hidden ? vec4(2.0, 2.0, 2.0, 1.0) : c;
}`;
const lineFragment = `#version 300 es
precision mediump float;
in vec4 paint; uniform float alpha; out vec4 result;
void main() { result = vec4(paint.rgb, alpha); }`;

const makeWebGL = () => {
  if (wanted.has('canvas')) return null;
  const gl = canvas.getContext('webgl2', {antialias: true, alpha: false, preserveDrawingBuffer: true});
  if (!gl) return null;
  const program = (vertex, fragment) => {
    const p = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const s = gl.createShader(type);
      gl.shaderSource(s, source);
      gl.compileShader(s);
      if (!gl.getShaderParameter(s, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(s));
      gl.attachShader(p, s);
    }
    gl.linkProgram(p);
    if (!gl.getProgramParameter(p, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(p));
    const at = {};
    for (let i = 0; i < gl.getProgramParameter(p, gl.ACTIVE_UNIFORMS); ++i) {
      const name = gl.getActiveUniform(p, i).name;
      at[name] = gl.getUniformLocation(p, name);
    }
    return {p, at};
  };
  const attribute = (p, name, data, count, type, normalized, divisor) => {
    const where = gl.getAttribLocation(p, name);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
    if (where < 0) return;
    gl.enableVertexAttribArray(where);
    gl.vertexAttribPointer(where, count, type, normalized, 0, 0);
    gl.vertexAttribDivisor(where, divisor);
  };
  const texture = count => {
    const rows = Math.max(1, Math.ceil(count / 1024)), bytes = new Uint8Array(4096 * rows);
    const t = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, t);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    return {t, bytes, send() {
      gl.bindTexture(gl.TEXTURE_2D, t);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, 1024, rows, 0, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    }};
  };

  let vertexCount = 0, indexCount = 0;
  for (const {face} of items) vertexCount += faces[face].points[1], indexCount += 3 * faces[face].triangles[1];
  const point = new Float32Array(3 * vertexCount), normal = new Int16Array(4 * vertexCount), way = new Float32Array(3 * vertexCount);
  const color = new Uint8Array(4 * vertexCount), item = new Float32Array(vertexCount), index = new Uint32Array(indexCount);
  let v = 0, i = 0;
  items.forEach((it, number) => {
    const f = faces[it.face], [first, count] = f.points, w = wayOf(it.region);
    for (let t = 3 * f.triangles[0]; t < 3 * (f.triangles[0] + f.triangles[1]); ++t) index[i++] = triangles[t] - first + v;
    point.set(points.subarray(3 * first, 3 * (first + count)), 3 * v);
    for (let k = first; k < first + count; ++k, ++v) {
      normal.set(normals.subarray(3 * k, 3 * k + 3), 4 * v);
      way.set(w, 3 * v);
      color.set(it.color, 4 * v);
      item[v] = number;
    }
  });
  const mesh = program(meshVertex, meshFragment), meshArray = gl.createVertexArray();
  gl.bindVertexArray(meshArray);
  attribute(mesh.p, 'point', point, 3, gl.FLOAT, false, 0);
  attribute(mesh.p, 'normal', normal, 4, gl.SHORT, true, 0);
  attribute(mesh.p, 'way', way, 3, gl.FLOAT, false, 0);
  attribute(mesh.p, 'color', color, 4, gl.UNSIGNED_BYTE, true, 0);
  attribute(mesh.p, 'item', item, 1, gl.FLOAT, false, 0);
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, index, gl.STATIC_DRAW);

  let segments = 0;
  for (const {edge} of strokes) segments += edges[edge].places[1] - 1;
  const total = segments + 3 * marks.length;
  const start = new Float32Array(3 * total), end = new Float32Array(3 * total), lineWay = new Float32Array(3 * total);
  const lineColor = new Uint8Array(4 * total), region = new Float32Array(total);
  let s = 0;
  for (const stroke of strokes) {
    const e = edges[stroke.edge], w = wayOf(stroke.region);
    for (let k = e.places[0]; k + 1 < e.places[0] + e.places[1]; ++k, ++s) {
      start.set(places.subarray(3 * k, 3 * k + 3), 3 * s);
      end.set(places.subarray(3 * k + 3, 3 * k + 6), 3 * s);
      lineWay.set(w, 3 * s);
      lineColor.set(e.color, 4 * s);
      region[s] = stroke.region + 1;
    }
  }
  for (const m of marks) {  // a small star of three strokes
    for (let axis = 0; axis < 3; ++axis, ++s) {
      const arm = [0, 0, 0];
      arm[axis] = 0.008 * scene.size;
      start.set(add(m.place, -1, arm), 3 * s);
      end.set(add(m.place, 1, arm), 3 * s);
      lineColor.set(m.color, 4 * s);
      region[s] = -1;
    }
  }
  const line = program(lineVertex, lineFragment), lineArray = gl.createVertexArray();
  gl.bindVertexArray(lineArray);
  attribute(line.p, 'start', start, 3, gl.FLOAT, false, 1);
  attribute(line.p, 'end', end, 3, gl.FLOAT, false, 1);
  attribute(line.p, 'way', lineWay, 3, gl.FLOAT, false, 1);
  attribute(line.p, 'color', lineColor, 4, gl.UNSIGNED_BYTE, true, 1);
  attribute(line.p, 'region', region, 1, gl.FLOAT, false, 1);
  gl.bindVertexArray(null);

  const itemStates = texture(items.length), regionStates = texture(regions.length);
  const paint = () => {
    const scale = Math.min(window.devicePixelRatio || 1, 2), [w, h] = size();
    canvas.width = Math.max(1, Math.round(w * scale));
    canvas.height = Math.max(1, Math.round(h * scale));
    items.forEach((it, k) => {
      const t = tint(it);
      itemStates.bytes.set(!shown(it.region) ? [0, 0, 0, 255] : t ? [...t[0], 255 * t[1]] : [0, 0, 0, 0], 4 * k);
    });
    regions.forEach((r, k) => { regionStates.bytes[4 * k] = r.shown ? 0 : 255; });
    itemStates.send();
    regionStates.send();
    const {right, up, back} = axes(), turn = [0, 1, 2].flatMap(k => [right[k], up[k], back[k]]);
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(1, 1, 1, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    const common = ({p, at}) => {
      gl.useProgram(p);
      gl.uniformMatrix4fv(at.projection, false, projection());
      gl.uniformMatrix3fv(at.turn, false, turn);
      gl.uniform3fv(at.target, state.target);
      gl.uniform1f(at.explode, state.explode);
      gl.uniform1i(at.states, 0);
      gl.uniform1f(at.away, state.deep ? distance() : 0);
    };
    common(mesh);
    gl.bindTexture(gl.TEXTURE_2D, itemStates.t);
    gl.uniform3fv(mesh.at.key, keyLight);
    gl.uniform3fv(mesh.at.fill, fillLight);
    gl.uniform1f(mesh.at.alpha, state.glass ? 0.32 : 1);
    gl.bindVertexArray(meshArray);
    if (state.glass) {
      gl.enable(gl.BLEND);
      gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
      gl.depthMask(false);
      gl.enable(gl.CULL_FACE);
      for (const side of [gl.FRONT, gl.BACK]) {
        gl.cullFace(side);
        gl.drawElements(gl.TRIANGLES, indexCount, gl.UNSIGNED_INT, 0);
      }
      gl.disable(gl.CULL_FACE);
      gl.depthMask(true);
      gl.colorMask(false, false, false, false);  // depth alone, to tell the edges behind from those before
      gl.drawElements(gl.TRIANGLES, indexCount, gl.UNSIGNED_INT, 0);
      gl.colorMask(true, true, true, true);
    } else {
      gl.drawElements(gl.TRIANGLES, indexCount, gl.UNSIGNED_INT, 0);
    }
    common(line);
    gl.bindTexture(gl.TEXTURE_2D, regionStates.t);
    gl.uniform2f(line.at.screen, canvas.width, canvas.height);
    gl.uniform1f(line.at.width, 1.5 * scale);
    gl.uniform1f(line.at.lift, 2.5 * state.height / h);
    gl.bindVertexArray(lineArray);
    gl.uniform1i(line.at.edges, state.lines ? 1 : 0);  // points are always there
    gl.depthMask(!state.glass);
    for (const behind of state.glass ? [true, false] : [false]) {
      gl.depthFunc(behind ? gl.GREATER : gl.LEQUAL);
      gl.uniform1f(line.at.alpha, behind ? 0.3 : 1);
      if (total > 0) gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, total);
    }
    gl.depthMask(true);
    gl.depthFunc(gl.LESS);
    gl.disable(gl.BLEND);
  };
  canvas.addEventListener('webglcontextlost', e => { e.preventDefault(); location.reload(); });
  return {name: 'webgl', paint};
};

// ---------------------------------------------------------------- without WebGL: a depth buffer in JavaScript

const makeCanvas = () => {
  const context = canvas.getContext('2d'), behind = document.createElement('canvas');
  let depth = new Float32Array(0);
  const paint = () => {
    const [cw, ch] = size(), fine = turning ? 1 : 2, w = Math.max(1, Math.round(cw * fine)), h = Math.max(1, Math.round(ch * fine));
    canvas.width = Math.round(cw);
    canvas.height = Math.round(ch);
    behind.width = w;
    behind.height = h;
    const picture = behind.getContext('2d').createImageData(w, h), out = picture.data;
    out.fill(255);
    if (depth.length !== w * h) depth = new Float32Array(w * h);
    depth.fill(Infinity);
    const {right, up, back} = axes(), d = distance(), pixels = h / state.height, near = 0.005 * d;
    // {x, y, depth, 1 / depth or 1}, or null behind the eye
    const seen = (array, v, way) => {
      const p = [0, 1, 2].map(k => array[3 * v + k] + state.explode * way[k] - state.target[k]);
      const z = state.deep ? d - dot(p, back) : -dot(p, back);
      if (state.deep && z < near) return null;
      const s = state.deep ? pixels * d / z : pixels;
      return [w / 2 + s * dot(p, right), h / 2 - s * dot(p, up), z];
    };
    const alpha = state.glass ? 0.32 : 1;
    const jobs = [];
    for (const item of items) {
      if (!shown(item.region)) continue;
      const f = faces[item.face], way = wayOf(item.region), [first, count] = f.points, at = [], t = tint(item);
      const color = t ? item.color.map((c, k) => k < 3 ? c + (t[0][k] - c) * t[1] : c) : item.color;
      for (let v = first; v < first + count; ++v) at.push(seen(points, v, way));
      for (let k = f.triangles[0]; k < f.triangles[0] + f.triangles[1]; ++k) {
        const ids = [triangles[3 * k], triangles[3 * k + 1], triangles[3 * k + 2]], corners = ids.map(v => at[v - first]);
        if (corners.includes(null)) continue;
        const q = ids.map(v => [points[3 * v], points[3 * v + 1], points[3 * v + 2]]);
        let flat = unit(cross(add(q[1], -1, q[0]), add(q[2], -1, q[0])));
        const area = (corners[1][0] - corners[0][0]) * (corners[2][1] - corners[0][1]) - (corners[1][1] - corners[0][1]) * (corners[2][0] - corners[0][0]);
        if (area === 0) continue;
        const front = area < 0 ? 1 : -1;  // y runs down
        const shades = ids.map(v => {
          const own = [normals[3 * v] / 32767, normals[3 * v + 1] / 32767, normals[3 * v + 2] / 32767];
          const n = dot(own, own) > 0.01 ? own : flat, m = [dot(n, right), dot(n, up), dot(n, back)].map(c => c * front);
          return light(unit(m));
        });
        jobs.push({corners, area, shades, color, z: corners[0][2] + corners[1][2] + corners[2][2]});
      }
    }
    if (state.glass) jobs.sort((a, b) => b.z - a.z);
    for (const {corners: [a, b, c], area, shades, color} of jobs) {
      const x0 = Math.max(0, Math.ceil(Math.min(a[0], b[0], c[0]) - 0.5)), x1 = Math.min(w - 1, Math.floor(Math.max(a[0], b[0], c[0]) - 0.5));
      const y0 = Math.max(0, Math.ceil(Math.min(a[1], b[1], c[1]) - 0.5)), y1 = Math.min(h - 1, Math.floor(Math.max(a[1], b[1], c[1]) - 0.5));
      for (let y = y0; y <= y1; ++y) {
        for (let x = x0; x <= x1; ++x) {
          const px = x + 0.5, py = y + 0.5;
          const u = ((b[0] - px) * (c[1] - py) - (b[1] - py) * (c[0] - px)) / area;
          const v = ((c[0] - px) * (a[1] - py) - (c[1] - py) * (a[0] - px)) / area, t = 1 - u - v;
          if (u < -1e-9 || v < -1e-9 || t < -1e-9) continue;
          const z = state.deep ? 1 / (u / a[2] + v / b[2] + t / c[2]) : u * a[2] + v * b[2] + t * c[2];
          const at = y * w + x;
          if (!state.glass) {
            if (z >= depth[at]) continue;
            depth[at] = z;
          }
          const l = u * shades[0] + v * shades[1] + t * shades[2];
          for (let k = 0; k < 3; ++k) out[4 * at + k] += alpha * (Math.min(255, color[k] * l) - out[4 * at + k]);
        }
      }
    }
    const dotAt = (x, y, z, radius, color) => {
      for (let yy = Math.max(0, Math.ceil(y - radius - 0.5)); yy <= Math.min(h - 1, y + radius - 0.5); ++yy) {
        for (let xx = Math.max(0, Math.ceil(x - radius - 0.5)); xx <= Math.min(w - 1, x + radius - 0.5); ++xx) {
          if ((xx + 0.5 - x) ** 2 + (yy + 0.5 - y) ** 2 <= radius * radius) out.set(color.slice(0, 3), 4 * (yy * w + xx));
        }
      }
    };
    const tolerance = z => 2.5 * fine * (state.deep ? z / (pixels * d) : 1 / pixels);
    const visible = (x, y, z) => x >= 0 && y >= 0 && x < w && y < h && z - tolerance(z) <= depth[Math.floor(y) * w + Math.floor(x)];
    for (const stroke of state.lines ? strokes : []) {
      if (!shown(stroke.region)) continue;
      const e = edges[stroke.edge], way = wayOf(stroke.region);
      for (let k = e.places[0]; k + 1 < e.places[0] + e.places[1]; ++k) {
        const a = seen(places, k, way), b = seen(places, k + 1, way);
        if (!a || !b) continue;
        const steps = Math.min(20000, Math.ceil(Math.hypot(b[0] - a[0], b[1] - a[1])) + 1);
        for (let i = 0; i <= steps; ++i) {
          const t = i / steps, x = a[0] + t * (b[0] - a[0]), y = a[1] + t * (b[1] - a[1]);
          const z = state.deep ? 1 / ((1 - t) / a[2] + t / b[2]) : a[2] + t * (b[2] - a[2]);
          if (visible(x, y, z)) dotAt(x, y, z, 0.7 * fine, e.color);
        }
      }
    }
    for (const m of marks) {
      const s = seen(m.place, 0, [0, 0, 0]);
      if (s && visible(...s)) dotAt(...s, 4 * fine, m.color);
    }
    behind.getContext('2d').putImageData(picture, 0, 0);
    context.imageSmoothingQuality = 'high';
    context.drawImage(behind, 0, 0, canvas.width, canvas.height);
  };
  return {name: 'canvas', paint};
};

let turning = false, asked = false;
let renderer = null;
try {
  renderer = makeWebGL();
} catch (error) {
  // A context that cannot compile its shaders is of no use, and its canvas gives no other.
  const fresh = canvas.cloneNode(true);
  canvas.replaceWith(fresh);
  console.warn('WebGL is not usable: ' + error.message);
  location.hash = (location.hash ? location.hash + '&' : '#') + 'canvas=1';
  location.reload();
  return;
}
renderer = renderer || makeCanvas();
const draw = () => {
  if (asked) return;
  asked = true;
  requestAnimationFrame(() => {
    asked = false;
    renderer.paint();
    document.documentElement.dataset.renderer = renderer.name;
  });
};

// ---------------------------------------------------------------- picking

const ray = (x, y) => {
  const [w, h] = size(), {right, up, back} = axes(), pixel = state.height / h;
  const dx = (x - w / 2) * pixel, dy = (h / 2 - y) * pixel;
  const on = add(add(state.target, dx, right), dy, up);
  if (!state.deep) return [add(on, 2 * reach(), back), back.map(c => -c)];
  const eye = add(state.target, distance(), back);
  return [eye, unit(add(on, -1, eye))];
};
const pick = (x, y) => {
  const [from, along] = ray(x, y);
  let nearest = Infinity, found = null;
  for (const item of items) {
    if (!shown(item.region)) continue;
    const o = add(from, -state.explode, wayOf(item.region)), f = faces[item.face];
    for (let k = 3 * f.triangles[0]; k < 3 * (f.triangles[0] + f.triangles[1]); k += 3) {
      const [i, j, l] = [3 * triangles[k], 3 * triangles[k + 1], 3 * triangles[k + 2]];
      const e1x = points[j] - points[i], e1y = points[j + 1] - points[i + 1], e1z = points[j + 2] - points[i + 2];
      const e2x = points[l] - points[i], e2y = points[l + 1] - points[i + 1], e2z = points[l + 2] - points[i + 2];
      const px = along[1] * e2z - along[2] * e2y, py = along[2] * e2x - along[0] * e2z, pz = along[0] * e2y - along[1] * e2x;
      const det = e1x * px + e1y * py + e1z * pz;
      if (Math.abs(det) < 1e-300) continue;
      const tx = o[0] - points[i], ty = o[1] - points[i + 1], tz = o[2] - points[i + 2];
      const u = (tx * px + ty * py + tz * pz) / det;
      if (u < 0 || u > 1) continue;
      const qx = ty * e1z - tz * e1y, qy = tz * e1x - tx * e1z, qz = tx * e1y - ty * e1x;
      const v = (along[0] * qx + along[1] * qy + along[2] * qz) / det;
      if (v < 0 || u + v > 1) continue;
      const t = (e2x * qx + e2y * qy + e2z * qz) / det;
      if (t > 0 && t < nearest) nearest = t, found = item;
    }
  }
  choose(found ? found.face : -1, found ? found.region : -1);
};

// ---------------------------------------------------------------- cards

const make = (parent, tag, text, name) => {
  const e = document.createElement(tag);
  if (text !== undefined) e.textContent = text;
  if (name) e.className = name;
  parent.appendChild(e);
  return e;
};
const figure = v => v === null ? '' : Math.abs(v) >= 1e6 || (v !== 0 && Math.abs(v) < 1e-3) ? v.toExponential(4) : String(+v.toPrecision(6));
const regionName = r => regions[r].name || 'region ' + regions[r].id;
const choose = (face, region) => {
  state.face = face;
  state.region = region;
  const info = element('info');
  info.hidden = face < 0 && region < 0;
  info.textContent = '';
  const list = make(info, 'dl'), entry = (key, value) => { make(list, 'dt', key); make(list, 'dd', value); };
  if (region >= 0) {
    entry('region', regionName(region));
    if (regions[region].name) entry('number', String(regions[region].id));
    entry('volume', figure(regions[region].volume));
    entry('faces', String(faces.filter(f => f.regions.includes(region)).length));
  }
  if (face >= 0) {
    entry('face', String(faces[face].id));
    if (faces[face].name) entry('name', faces[face].name);
    if (faces[face].kind) entry('kind', faces[face].kind);
    const sides = faces[face].regions;
    if (sides[0] >= 0 && sides[1] >= 0 && sides[0] !== sides[1]) entry('between', regionName(sides[0]) + ' and ' + regionName(sides[1]));
    else if (sides[0] < 0 && sides[1] < 0) entry('between', 'a sheet in open space');
  }
  document.querySelectorAll('#regions .row').forEach((row, k) => row.classList.toggle('picked', k === region));
  draw();
};
if (regions.length) {
  const card = element('regions'), head = make(card, 'h2');
  make(head, 'span', regions.length === 1 ? '1 region' : regions.length + ' regions');
  make(head, 'span', 'volume');
  regions.forEach((r, k) => {
    const row = make(card, 'div', undefined, 'row'), box = make(row, 'input');
    box.type = 'checkbox';
    box.checked = true;
    box.title = 'show';
    make(row, 'span', undefined, 'swatch').style.background = `rgb(${r.color.slice(0, 3).join(',')})`;
    make(row, 'span', regionName(k), 'name').title = regionName(k);
    make(row, 'span', figure(r.volume), 'volume');
    r.show = on => { r.shown = box.checked = on; row.classList.toggle('off', !on); draw(); };
    box.addEventListener('change', () => r.show(box.checked));
    row.addEventListener('click', e => { if (e.target !== box) choose(-1, state.region === k && state.face < 0 ? -1 : k); });
  });
}
for (const name of ['fit', ...Object.keys(views)]) {
  make(element('views'), 'button', name).addEventListener('click', () => name === 'fit' ? (fit(), draw()) : look(name));
}
element('explode').addEventListener('input', e => { fitted = false; state.explode = +e.target.value; draw(); });
for (const [id, key] of [['glass', 'glass'], ['lines', 'lines'], ['deep', 'deep']]) {
  element(id).addEventListener('change', e => { state[key] = e.target.checked; draw(); });
}
element('explode').parentElement.hidden = regions.length < 2;

// ---------------------------------------------------------------- hands

const hands = new Map();
let moved = 0;
canvas.addEventListener('contextmenu', e => e.preventDefault());
canvas.addEventListener('pointerdown', e => {
  canvas.setPointerCapture(e.pointerId);
  hands.set(e.pointerId, {x: e.clientX, y: e.clientY, pan: e.button !== 0 || e.shiftKey});
  if (hands.size === 1) moved = 0;
  turning = true;
  canvas.classList.add('turning');
});
const zoom = (factor, x, y) => {
  const [w, h] = size(), {right, up} = axes(), before = state.height;
  fitted = false;
  state.height = Math.min(Math.max(before * factor, 1e-6 * scene.size), 100 * scene.size);
  const change = (before - state.height) / h;  // what is under the pointer stays there
  state.target = add(add(state.target, (x - w / 2) * change, right), (h / 2 - y) * change, up);
  draw();
};
canvas.addEventListener('pointermove', e => {
  const hand = hands.get(e.pointerId);
  if (!hand) return;
  fitted = false;
  const dx = e.clientX - hand.x, dy = e.clientY - hand.y;
  moved += Math.abs(dx) + Math.abs(dy);
  const {right, up} = axes(), pixel = state.height / size()[1];
  if (hands.size === 2) {
    const other = [...hands].find(([id]) => id !== e.pointerId)[1];
    const was = Math.hypot(hand.x - other.x, hand.y - other.y), is = Math.hypot(e.clientX - other.x, e.clientY - other.y);
    if (was > 0 && is > 0) zoom(was / is, (e.clientX + other.x) / 2, (e.clientY + other.y) / 2);
    state.target = add(add(state.target, -dx * pixel / 2, right), dy * pixel / 2, up);
  } else if (hand.pan) {
    state.target = add(add(state.target, -dx * pixel, right), dy * pixel, up);
  } else {
    state.yaw -= 0.4 * dx;
    state.pitch = Math.max(-90, Math.min(90, state.pitch + 0.4 * dy));
  }
  hand.x = e.clientX;
  hand.y = e.clientY;
  draw();
});
const release = e => {
  const hand = hands.get(e.pointerId);
  if (!hand) return;
  hands.delete(e.pointerId);
  turning = hands.size > 0;
  canvas.classList.toggle('turning', turning);
  if (e.type === 'pointerup' && moved < 4 && !hand.pan) pick(e.clientX, e.clientY);
  draw();
};
canvas.addEventListener('pointerup', release);
canvas.addEventListener('pointercancel', release);
canvas.addEventListener('wheel', e => { e.preventDefault(); zoom(Math.exp(Math.max(-60, Math.min(60, e.deltaY)) * 0.004), e.clientX, e.clientY); }, {passive: false});
canvas.addEventListener('keydown', e => {
  const step = {ArrowLeft: [-15, 0], ArrowRight: [15, 0], ArrowUp: [0, 15], ArrowDown: [0, -15]}[e.key];
  if (step) fitted = false, state.yaw += step[0], state.pitch = Math.max(-90, Math.min(90, state.pitch + step[1]));
  else if (e.key === 'f') fit();
  else if (e.key === 'Escape') choose(-1, -1);
  else return;
  e.preventDefault();
  draw();
});
window.addEventListener('resize', () => { if (fitted) fit(); draw(); });

// ---------------------------------------------------------------- first picture

const set = (id, key, value) => { state[key] = value; const box = element(id); if (box.type === 'range') box.value = value; else box.checked = value; };
set('explode', 'explode', Math.max(0, +(wanted.get('explode') ?? scene.explode) || 0));
set('glass', 'glass', wanted.get('glass') === '1');
set('lines', 'lines', wanted.get('edges') !== '0');
set('deep', 'deep', wanted.has('perspective') ? wanted.get('perspective') === '1' : scene.perspective);
for (const id of (wanted.get('hide') || '').split(',')) regions.filter(r => String(r.id) === id).forEach(r => r.show(false));
look(wanted.get('view') || scene.view);
if (wanted.has('pick')) pick(...wanted.get('pick').split(',').map(Number));
})();
