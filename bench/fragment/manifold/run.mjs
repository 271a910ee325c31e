// SPDX-License-Identifier: Apache-2.0
// A chain of set operations in manifold-3d (WebAssembly, one thread), given by a file of manifold.cpp.
//
//   node run.mjs FILE       prints: seconds solids volume
//   node run.mjs            prints: version
//
// The file: words of 32 bits, little endian. The operation (0 union, 1 difference); the number of steps, the first being
// the operand to begin with; per step the number of solids, and per solid the numbers of points and triangles, the
// points' coordinates as floats, and the triangles' corners.
import {readFileSync} from 'node:fs';
import Module from 'manifold-3d';

if (process.argv.length < 3) {
  const description = new URL('package.json', import.meta.resolve('manifold-3d'));
  console.log(JSON.parse(readFileSync(description)).version);
  process.exit(0);
}

const wasm = await Module();
wasm.setup();
const {Manifold, Mesh} = wasm;

const bytes = readFileSync(process.argv[2]);
const data = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
const words = new Uint32Array(data);
let at = 0;
const isDifference = words[at++] === 1;
const steps = [];
for (let left = words[at++]; left > 0; --left) {
  const solids = [];
  for (let more = words[at++]; more > 0; --more) {
    const points = words[at++], triangles = words[at++];
    const vertProperties = new Float32Array(data, 4 * at, 3 * points);
    at += 3 * points;
    const triVerts = words.subarray(at, at + 3 * triangles);
    at += 3 * triangles;
    solids.push(new Manifold(new Mesh({numProp: 3, vertProperties, triVerts})));
  }
  steps.push(solids);
}

function run() {
  let result = steps[0][0];
  for (const solids of steps.slice(1)) {
    const all = [result, ...solids];
    result = isDifference ? Manifold.difference(all) : Manifold.union(all);
  }
  if (result.status() !== 'NoError') throw new Error(result.status());  // evaluates it: until then it is an expression
  return result;
}

function seconds() {
  const {user, system} = process.cpuUsage();
  return 1e-6 * (user + system);
}

// The first round compiles and is not counted, unless it is long.
let result;
const rounds = [];
let sum = 0;
for (let round = 0; round < 6 && sum < 4; ++round) {
  result?.delete();
  const before = seconds();
  result = run();
  const taken = seconds() - before;
  sum += taken;
  if (round > 0 || taken > 4) rounds.push(taken);
}
rounds.sort((a, b) => a - b);
const solids = result.decompose().filter(part => part.volume() > 0);
console.log(rounds[Math.floor(rounds.length / 2)], solids.length, result.volume());
