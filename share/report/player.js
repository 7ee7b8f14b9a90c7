// Player of a motion (octave/gsmbp_report.m), WebGL without a library. D is what stands in the
// element `motion`: times t; bodies (0 is ground), whose poses, 12 numbers a frame (rotation by
// rows, place), are the float32 numbers of `poses`; solids {kind, body, m}: unit box, its edges,
// cylinder (about z) or sphere, moved by the columns and the offset in m (12 numbers, in axes of the body);
// pairs of points {kind, body, at, child, child_at}; beams {places, lines, color}, whose places are
// the float32 numbers of `axes_of_beams`, lines pairs of numbers of them;
// points and frames {body, at, axes by rows};
// arrows {body, at, v: index of force}; up, view.
(() => {
"use strict";
const $ = id => document.getElementById(id), page = document.documentElement.dataset;
page.errors = "";
window.addEventListener("error", e => { page.errors += e.message + "; "; });
const D = JSON.parse($("motion").textContent), cv = $("scene3d");
const floats = s => new Float32Array(Uint8Array.from(atob(s), c => c.charCodeAt(0)).buffer);
const P = floats(D.poses), A = floats(D.arrows_v), B = floats(D.axes_of_beams), NB = D.bodies.length, NF = D.t.length;
const gl = cv.getContext("webgl", { antialias: true, preserveDrawingBuffer: true });
page.webgl = gl ? "yes" : "no";
if (!gl) { cv.hidden = $("controls").hidden = true; $("no-webgl").hidden = false; return; }
$("still").hidden = true;

// vectors
const add = (a, b, f = 1) => a.map((x, i) => x + f * b[i]);
const cross = (a, b) => [a[1]*b[2] - a[2]*b[1], a[2]*b[0] - a[0]*b[2], a[0]*b[1] - a[1]*b[0]];
const dot = (a, b) => a[0]*b[0] + a[1]*b[1] + a[2]*b[2], size = a => Math.sqrt(dot(a, a));
const unit = a => { const n = size(a) || 1; return a.map(x => x / n); };
const pose = (k, b) => b ? P.subarray(12*(NB*k + b), 12*(NB*k + b) + 12)
                         : [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0];
const turn = (R, a) => [0, 3, 6].map(i => R[i]*a[0] + R[i+1]*a[1] + R[i+2]*a[2]);
const place = (R, a) => add(turn(R, a), [R[9], R[10], R[11]]);

// programs and meshes
const shader = (kind, text) => { const s = gl.createShader(kind); gl.shaderSource(s, text);
  gl.compileShader(s); return s; };
const pr = gl.createProgram();
gl.attachShader(pr, shader(gl.VERTEX_SHADER, "attribute vec3 p,n;uniform mat4 v,m;uniform mat3 k;" +
  "varying vec3 w;void main(){w=k*n;gl_Position=v*m*vec4(p,1.);}"));
gl.attachShader(pr, shader(gl.FRAGMENT_SHADER, "precision mediump float;varying vec3 w;" +
  "uniform vec3 c,l;void main(){float a=dot(w,w)<.01?1.:.5+.3*abs(dot(normalize(w),l))" +
  "+.2*dot(normalize(w),l);gl_FragColor=vec4(c*a,1.);}"));
gl.linkProgram(pr); gl.useProgram(pr);
const at = q => gl.getUniformLocation(pr, q), U = { v: at("v"), m: at("m"), k: at("k"), c: at("c"),
  l: at("l") };
const LP = gl.getAttribLocation(pr, "p"), LN = gl.getAttribLocation(pr, "n");
const mesh = list => { const b = gl.createBuffer(); gl.bindBuffer(gl.ARRAY_BUFFER, b);
  gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(list), gl.STATIC_DRAW);
  return { b, n: list.length / 6 }; };
const quad = (o, a, b, c, d, na, nb, nc, nd) =>
  o.push(...a, ...na, ...b, ...nb, ...c, ...nc, ...a, ...na, ...c, ...nc, ...d, ...nd);
const box = [], cylinder = [], sphere = [], N = 28;
for (let i = 0; i < 3; i++) for (const s of [-.5, .5]) {
  const f = (u, w) => { const p = [0, 0, 0]; p[i] = s; p[(i+1)%3] = u/2; p[(i+2)%3] = w/2; return p; };
  const n = [0, 0, 0]; n[i] = 2*s; quad(box, f(-1,-1), f(1,-1), f(1,1), f(-1,1), n, n, n, n); }
const ring = j => [Math.cos(2*Math.PI*j/N), Math.sin(2*Math.PI*j/N), 0];
const ball = (i, j) => { const e = Math.PI*(i/14 - .5), r = ring(j);
  return [Math.cos(e)*r[0], Math.cos(e)*r[1], Math.sin(e)]; };
for (let j = 0; j < N; j++) { const a = ring(j), b = ring(j+1), h = [0, 0, .5], z = [0, 0, 1];
  quad(cylinder, add(a, h, -1), add(b, h, -1), add(b, h), add(a, h), a, b, b, a);
  for (const s of [-1, 1]) { const m = z.map(x => s*x);
    cylinder.push(...add([0,0,0], h, s), ...m, ...add(a, h, s), ...m, ...add(b, h, s), ...m); }
  for (let i = 0; i < 14; i++) { const q = [ball(i, j), ball(i, j+1), ball(i+1, j+1), ball(i+1, j)];
    quad(sphere, ...q, ...q); } }
const M = { box: mesh(box), cylinder: mesh(cylinder), sphere: mesh(sphere) }, lines = gl.createBuffer();

// one solid: columns a, b, c and offset o in ground axes
const solid = (kind, a, b, c, o, color) => { const g = M[kind];
  gl.bindBuffer(gl.ARRAY_BUFFER, g.b); gl.enableVertexAttribArray(LN);
  gl.vertexAttribPointer(LP, 3, gl.FLOAT, false, 24, 0);
  gl.vertexAttribPointer(LN, 3, gl.FLOAT, false, 24, 12);
  gl.uniformMatrix4fv(U.m, false, [...a, 0, ...b, 0, ...c, 0, ...o, 1]);
  gl.uniformMatrix3fv(U.k, false, [cross(b, c), cross(c, a), cross(a, b)].flatMap(unit));
  gl.uniform3fv(U.c, color); gl.drawArrays(gl.TRIANGLES, 0, g.n); };
const rod = (p, q, r, color) => { const z = add(q, p, -1), x = unit(cross(z, Math.abs(z[0]) >
  .9*size(z) ? [0, 1, 0] : [1, 0, 0])), y = cross(unit(z), x);
  solid("cylinder", x.map(v => r*v), y.map(v => r*v), z, add(p, z, .5), color); };
const edges = (a, b, c, o, color) => { const l = [], v = (i, j, k) =>
    add(add(add(o, a, i/2), b, j/2), c, k/2);
  for (const i of [-1, 1]) for (const j of [-1, 1])
    l.push(v(i, j, -1), v(i, j, 1), v(i, -1, j), v(i, 1, j), v(-1, i, j), v(1, i, j));
  path(l, color, gl.LINES); };
const path = (points, color, kind) => { gl.bindBuffer(gl.ARRAY_BUFFER, lines);
  gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(points.flat()), gl.STREAM_DRAW);
  gl.disableVertexAttribArray(LN); gl.vertexAttrib3f(LN, 0, 0, 0);
  gl.vertexAttribPointer(LP, 3, gl.FLOAT, false, 12, 0);
  gl.uniformMatrix4fv(U.m, false, [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]);
  gl.uniformMatrix3fv(U.k, false, [1,0,0, 0,1,0, 0,0,1]);
  gl.uniform3fv(U.c, color); gl.drawArrays(kind, 0, points.length); };
const helix = (p, q, r) => { const z = unit(add(q, p, -1)), h = size(add(q, p, -1)), o = [];
  const x = unit(cross(z, Math.abs(z[0]) > .9 ? [0, 1, 0] : [1, 0, 0])), y = cross(z, x);
  for (let i = 0; i <= 120; i++) { const a = i/120, w = 16*Math.PI*a;
    o.push(add(add(add(p, z, h*a), x, r*Math.cos(w)), y, r*Math.sin(w))); }
  return [p, ...o, q]; };

// camera
let az = D.view[0], el = D.view[1], far = 1, k = 0, clock = 0, running = true, held = null;
const [E1, E2, E3] = D.up;
const look = () => { const d = D.extent*1.4*far, dir = add(add(E1.map(x => x*Math.cos(el)*Math.cos(az)),
    E2, Math.cos(el)*Math.sin(az)), E3, Math.sin(el)), eye = add(D.target, dir, d);
  const x = unit(cross(E3, dir)), y = cross(dir, x), f = 2.4, w = cv.height / cv.width;
  const n = d*.02, g = d + D.extent*20;
  gl.uniform3fv(U.l, unit(add(add(dir, x, .5), y, .8)));
  const row = (a, s) => [...a.map(v => s*v), -s*dot(a, eye)], X = row(x, f*w), Y = row(y, f);
  const Z = row(dir, 1), Q = (g + n)/(g - n);
  return [0, 1, 2, 3].flatMap(i => [X[i], Y[i], -Q*Z[i] - (i === 3 ? 2*g*n/(g - n) : 0), -Z[i]]); };

const grid = [];
for (let i = -5; i <= 5; i++) for (const [a, b] of [[E1, E2], [E2, E1]])
  for (const s of [-5, 5]) grid.push(add(add(D.floor, a, i*D.extent/5), b, s*D.extent/5));
const trace = D.bodies.map((b, i) => i && b.moves
  ? D.t.map((_, j) => place(pose(j, i), b.centre)) : []);
const pathOf = D.points.map(p => p.body ? D.t.map((_, j) => place(pose(j, p.body), p.at)) : []);
const GREY = [.55, .55, .55], shown = id => !$(id) || $(id).checked;

const draw = () => {
  const wide = cv.clientWidth || 960, tall = Math.round(wide*.58), px = window.devicePixelRatio || 1;
  if (cv.width !== Math.round(wide*px)) { cv.width = Math.round(wide*px); cv.height = Math.round(tall*px); }
  gl.viewport(0, 0, cv.width, cv.height); gl.clearColor(.985, .985, .975, 1);
  gl.enable(gl.DEPTH_TEST); gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  gl.enableVertexAttribArray(LP); gl.uniformMatrix4fv(U.v, false, look());
  if (D.grid) path(grid, [.82, .82, .8], gl.LINES);
  for (const s of D.solids) { const R = pose(k, s.body), m = s.m;
    const parts = [turn(R, m.slice(0, 3)), turn(R, m.slice(3, 6)), turn(R, m.slice(6, 9)),
      place(R, m.slice(9)), s.color];
    if (s.kind === "edges") edges(...parts.slice(0, 4), s.color.map(c => .4 + .6*c)); else solid(s.kind, ...parts); }
  let first = k*B.length/NF;   // beams by their bent axes
  for (const b of D.beams) { const axis = [], r = D.extent*.008;
    for (let i = 0; i < b.places; i++, first += 3) axis.push(Array.from(B.subarray(first, first + 3)));
    for (let i = 0; i < b.lines.length; i += 2) rod(axis[b.lines[i]-1], axis[b.lines[i+1]-1], r, b.color);
    for (const p of axis) solid("sphere", [r, 0, 0], [0, r, 0], [0, 0, r], p, b.color); }
  for (const s of D.pairs) { const p = place(pose(k, s.body), s.at),
      q = place(pose(k, s.child), s.child_at), r = D.extent*.012;
    if (s.kind === "spring") path(helix(p, q, 1.6*r), [.25, .25, .25], gl.LINE_STRIP);
    else { rod(p, q, .5*r, [.45, .47, .5]); rod(p, add(p, add(q, p, -1), .5), r, [.35, .4, .5]); } }
  gl.disable(gl.DEPTH_TEST);   // traces are seen through what moves along them
  if (shown("traces")) D.bodies.forEach((b, i) => { if (trace[i].length > 1)
    path(trace[i], b.color.map(c => .3 + .7*c), gl.LINE_STRIP); });
  if (shown("points") && shown("traces")) pathOf.forEach(l => { if (l.length > 1)
    path(l, [.15, .15, .15], gl.LINE_STRIP); });
  gl.enable(gl.DEPTH_TEST);
  if (shown("points")) D.points.forEach(p => { const R = pose(k, p.body), o = place(R, p.at);
    const r = D.extent*.009, c = [.1, .1, .1];
    solid("sphere", [r, 0, 0], [0, r, 0], [0, 0, r], o, c);
    if (p.kind === "frame") [0, 1, 2].forEach(i => rod(o, add(o, turn(R, [p.axes[i], p.axes[3+i],
      p.axes[6+i]]), D.extent*.07), .4*r, [[.8, .1, .1], [.1, .55, .1], [.1, .2, .8]][i])); });
  if (shown("forces")) D.arrows.forEach((s, i) => { const f = 3*(D.arrows.length*k + i);
    const p = place(pose(k, s.body), s.at), v = Array.from(A.subarray(f, f + 3));
    if (size(v) > 1e-3*D.extent) { rod(p, add(p, v), D.extent*.005, [.8, .1, .1]);
      rod(add(p, v), add(p, v, 1.0 + .04*D.extent/size(v)), D.extent*.012, [.8, .1, .1]); } });
  $("time").value = k; $("now").textContent = D.t[k].toFixed(3) + " s";
  page.frame = k; page.glError = gl.getError(); };

// what the user does
$("time").max = NF - 1;
$("time").oninput = e => { running = false; $("play").textContent = "play"; k = +e.target.value; draw(); };
$("play").onclick = () => { running = !running; clock = D.t[k < NF - 1 ? k : 0];
  $("play").textContent = running ? "pause" : "play"; };
for (const id of ["traces", "forces", "points"]) if ($(id)) $(id).onchange = draw;
const swing = (a, b) => { az += a; el = Math.max(-1.55, Math.min(1.55, el + b)); draw(); };
cv.onpointerdown = e => { held = [e.clientX, e.clientY]; cv.setPointerCapture(e.pointerId); };
cv.onpointerup = cv.onpointercancel = () => { held = null; };
cv.onpointermove = e => { if (held) { swing((held[0] - e.clientX)/150, (e.clientY - held[1])/150);
  held = [e.clientX, e.clientY]; } };
cv.addEventListener("wheel", e => { far *= Math.exp(e.deltaY/800); draw(); e.preventDefault(); },
  { passive: false });
cv.onkeydown = e => { const s = { ArrowLeft: [-.1, 0], ArrowRight: [.1, 0], ArrowUp: [0, .1],
  ArrowDown: [0, -.1] }[e.key]; if (s) { swing(...s); e.preventDefault(); } };
let before = null;
const tick = now => { if (running && before !== null) {
    clock += (now - before)/1000*$("speed").value;
    if (clock > D.t[NF - 1] || clock < D.t[0]) clock = D.t[0];
    let j = k; if (D.t[j] > clock) j = 0; while (j < NF - 1 && D.t[j + 1] <= clock) j++;
    if (j !== k) { k = j; draw(); } }
  before = now; requestAnimationFrame(tick); };
if (matchMedia("(prefers-reduced-motion: reduce)").matches) $("play").onclick();
clock = D.t[0]; draw(); requestAnimationFrame(tick);
})();
