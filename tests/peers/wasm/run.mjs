// Millions of lines a second that the decoder does in WebAssembly: `node run.mjs [GNSS BRIDGE]`, after the build that README.md
// names. GNSS and BRIDGE are our own native rates from the race; 60 % of them is enough too.
import { readFile } from "node:fs/promises";

const LINES = 200_000;
const ROUNDS = 9;
const LEAST = 4;
const SHARE = 0.6;
const native = process.argv.slice(2).map(Number);

const file = new URL("target/wasm32-unknown-unknown/release/wheelover_wasm_speed.wasm", import.meta.url);
const { instance } = await WebAssembly.instantiate(await readFile(file), {});
const { prepare, decode } = instance.exports;
let slow = false;
for (const [number, name] of ["gnss", "bridge"].entries()) {
  prepare(number, LINES);
  let best = Infinity;
  for (let round = 0; round < ROUNDS; round++) {
    const start = process.cpuUsage().user;
    const right = decode();
    best = Math.min(best, process.cpuUsage().user - start);
    if (right !== LINES) throw new Error(`${right} of ${LINES} lines are right`);
  }
  const rate = LINES / best;
  const share = rate / (native[number] ?? Infinity);
  slow ||= rate < LEAST && share < SHARE;
  const beside = share > 0 ? `, ${(share * 100).toFixed(0)} % of native` : "";
  console.log(`${name.padEnd(8)} ${rate.toFixed(2)} M lines a second in WebAssembly${beside}`);
}
if (slow) {
  console.log(`less than ${LEAST} M lines a second and less than ${SHARE * 100} % of native`);
  process.exitCode = 1;
}
