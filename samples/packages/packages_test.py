# SPDX-License-Identifier: MIT
"""Uses what this build packages, as a stranger would: packages_test.py deb|rust BUILD SCRATCH

deb   cpack writes Debian packages; they are unpacked into an empty root, where an outside project is built and the tool runs
rust  cargo builds the crate in rust/ against the installed libraries; exit status 77 without cargo"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ENGINE = HERE.parent / "link_from_an_engine"
LIFTED = "1.00 s, character 1: first joint at 3.000 1.000 0.000 m"


def run(*words, **options):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False, **options)
    assert done.returncode == 0, f"{words}: status {done.returncode}\n{done.stdout}{done.stderr}"
    return done.stdout


def contents(package):
    return {line.split()[5].removeprefix("./") for line in run("dpkg-deb", "-c", package).splitlines() if not line.startswith("d")}


def check_deb(build, scratch):
    if shutil.which("dpkg-deb") is None:
        print("no dpkg-deb here: no package is made")
        sys.exit(77)
    run("cpack", "-B", scratch, cwd=build)
    packages = {path.name.split("_")[0]: path for path in scratch.glob("*.deb")}
    assert sorted(packages) == ["libsinew-dev", "sinew"], packages
    files = {name: contents(package) for name, package in packages.items()}
    shared = files["sinew"] & files["libsinew-dev"]
    assert not shared, f"in both: {shared}"
    assert "usr/bin/sinew" in files["sinew"] and not any(re.search(r"\.(h|a|cmake|pc)$", name) for name in files["sinew"])
    assert {"usr/include/sinew/sinew.h", "usr/lib/libsinew_runtime.a"} <= files["libsinew-dev"]
    assert all(name.startswith("usr/") for names in files.values() for name in names)
    needs = {name: run("dpkg-deb", "-f", package, "Depends") for name, package in packages.items()}
    assert re.search(r"\blibc6\b", needs["sinew"]) and "libglm-dev" in needs["libsinew-dev"], needs
    # apt would install these: each package of the list has to exist.
    for name in re.findall(r"[a-z0-9.+-]+(?= \(|,|$)", needs["libsinew-dev"].strip()):
        run("dpkg-query", "-W", name)

    root = scratch / "root"
    for package in packages.values():
        run("dpkg-deb", "-x", package, root)
    engine = scratch / "engine"
    run("cmake", "-S", ENGINE, "-B", engine, f"-DCMAKE_PREFIX_PATH={root}/usr", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_FIND_PACKAGE_NO_PACKAGE_REGISTRY=ON")
    run("cmake", "--build", engine)
    cache = (engine / "CMakeCache.txt").read_text()
    assert f"sinew_DIR:PATH={root}/usr/" in cache, "another sinew was found"
    file = scratch / "lift.sinew"
    run(root / "usr/bin/sinew", "compile", ENGINE / "lift.gltf", "-o", file, "--budget", "0")
    assert LIFTED in run(engine / "link_from_an_engine", file)
    print(f"{len(files['libsinew-dev'])} files of libsinew-dev and {len(files['sinew'])} of sinew, used in an empty root")


def check_rust(build, scratch):
    if shutil.which("cargo") is None:
        print("no cargo here: the crate is not built")
        sys.exit(77)
    prefix, file = scratch / "prefix", scratch / "lift.sinew"
    run("cmake", "--install", build, "--prefix", prefix)
    run(prefix / "bin/sinew", "compile", ENGINE / "lift.gltf", "-o", file, "--budget", "0")
    shutil.copytree(HERE / "rust", scratch / "crate")
    environment = dict(os.environ, PKG_CONFIG_PATH=str(prefix / "lib/pkgconfig"), CARGO_TARGET_DIR=str(scratch / "target"))
    run("cargo", "build", "--offline", "--quiet", cwd=scratch / "crate", env=environment)
    program = scratch / "target/debug/sinew-sys"
    lines = run(program, file).splitlines()
    assert lines[2] == "0.50 s: first joint at 0.000 0.500 0.000 m" and len(lines) == 5, lines
    broken = subprocess.run([program, ENGINE / "lift.gltf"], capture_output=True, text=True, check=False)
    assert broken.returncode == 1 and "this is no asset file" in broken.stderr, broken
    print("the crate plays a clip, and says why it refuses a file")


def main():
    what, build, scratch = sys.argv[1], *(pathlib.Path(word).resolve() for word in sys.argv[2:])
    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir(parents=True)
    {"deb": check_deb, "rust": check_rust}[what](build, scratch)


main()
