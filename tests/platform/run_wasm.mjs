// SPDX-License-Identifier: MIT
// Runs a WASI program: node run_wasm.mjs PROGRAM.wasm
import { readFile } from "node:fs/promises";
import { WASI } from "node:wasi";
import process from "node:process";
const wasi = new WASI({ version: "preview1", args: ["poses"], env: {}, returnOnExit: true });
const { instance } = await WebAssembly.instantiate(await readFile(process.argv[2]), wasi.getImportObject());
process.exitCode = wasi.start(instance);
