# SPDX-License-Identifier: MIT
"""Compiles the runtime for another machine by the clang of PyPI's `ziglang`, with a program that hashes poses: cross_compile.py TARGET BUILD

TARGET is wasm32-wasi, x86_64-windows-gnu, aarch64-macos or another triple of `zig`. WebAssembly is run by Node.js and has to print the
hash of this machine's program, which is linked with BUILD. Exit status 77 without ziglang, or Node.js for WebAssembly."""
import concurrent.futures
import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
HERE = pathlib.Path(__file__).resolve().parent
BATCH = 8
# Headers of others that are the same for each machine. A folder of links keeps the rest of /usr/include away.
HEADERS = ("glm", "tl", "hwy", "eigen3/Eigen", "xxhash.h")


def sources_of_runtime(target):
    text = (ROOT / "runtime/CMakeLists.txt").read_text()
    listed = re.search(r"sinew_runtime_library\(runtime\s+SOURCES\s+(.*?)\s+(?:PUBLIC|PRIVATE)", text, re.S)[1].split()
    assert len(listed) > 100, f"{len(listed)} sources"
    # WASI's libc++ has no threads: pages of clips, which a loader's thread brings, are left out.
    return [ROOT / "runtime" / name for name in listed if "wasm" not in target or not name.startswith("paging/")]


def run(*words):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False)
    assert done.returncode == 0, f"{words[0]} ... {words[-1]}: status {done.returncode}\n{done.stdout[-3000:]}{done.stderr[-3000:]}"
    return done.stdout


def cross_compile(target, build, folder):
    """The program, linked with every object of the runtime."""
    headers = folder / "headers"
    headers.mkdir()
    for name in HEADERS:
        (headers / pathlib.Path(name).name).symlink_to(pathlib.Path("/usr/include") / name)
    # The kernels of the target's own instruction set: those of Highway's dispatcher are compiled in its library.
    flags = ["-target", target, "-std=c++20", "-O2", "-w", "-ffp-contract=off", "-I", ROOT, "-I", build / "include", "-I", headers]
    if "wasm" in target:
        # Highway 1.0.3 has no double precision in its own kind of WebAssembly vectors: the compiler makes vectors of plain loops.
        flags += ["-msimd128", "-DHWY_COMPILE_ONLY_EMU128", "-fno-exceptions", "-fno-rtti"]
    else:
        flags.append("-DHWY_COMPILE_ONLY_STATIC")
    if "windows" in target:
        flags += ["-DNOMINMAX", "-D_USE_MATH_DEFINES"]
    sources = sources_of_runtime(target)
    alone = [source for source in sources if "foreach_target" in source.read_text()]  # these are compiled once a set
    others = [source for source in sources if source not in alone]
    units = alone[:]
    for i in range(0, len(others), BATCH):
        units.append(folder / f"unit{i}.cpp")
        units[-1].write_text("".join(f'#include "{source}"\n' for source in others[i:i + BATCH]))
    zig = [sys.executable, "-m", "ziglang", "c++"]

    def compiled(numbered):
        i, unit = numbered
        run(*zig, *flags, "-c", unit, "-o", folder / f"{i}.o")
        return folder / f"{i}.o"

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        objects = list(pool.map(compiled, enumerate(units)))
    program = folder / "poses"
    run(*zig, *flags, HERE / "cross_poses.cpp", *objects, "-o", program)
    return program


def main():
    target, build = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
    if importlib.util.find_spec("ziglang") is None:
        print("no ziglang in this Python (pip install ziglang): nothing is compiled")
        sys.exit(77)
    is_wasm = "wasm" in target
    if is_wasm and shutil.which("node") is None:
        print("no Node.js here: nothing is run")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        program = cross_compile(target, build, folder)
        print(f"{target}: the runtime compiles and links, {program.stat().st_size} bytes")
        if is_wasm:
            native = folder / "native"
            run("g++", "-std=c++20", "-O2", "-ffp-contract=off", "-I", ROOT, "-I", build / "include", HERE / "cross_poses.cpp",
                build / "runtime/libsinew_runtime.a", "-lhwy", "-o", native)
            here, there = run(native), run("node", "--no-warnings", HERE / "run_wasm.mjs", program)
            assert here == there, f"this machine: {here}{target}: {there}"
            print(f"the same bits: {here}", end="")


main()
