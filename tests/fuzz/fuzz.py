#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the libFuzzer program of a build for a while and sums up: fuzz.py BUILD MINUTES JOBS [SEED FOLDER...]

Minutes are shared by all targets. Inputs that reach something new are kept in BUILD/corpus/TARGET, or in
$SINEW_FUZZ_CORPUS/TARGET to outlive the build, and are where the next run starts; what breaks a promise lands in BUILD/findings/TARGET and makes the exit code 1: minimise it, fix the cause, and move it
to tests/fuzz/found/TARGET, where every build runs it.
"""
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys

TARGETS = ["glb", "json", "accessors", "compressed", "images", "clips", "geometry", "assets", "poses", "motion", "graphs", "graph_bytes"]
LIMITS = ["-rss_limit_mb=2560", "-malloc_limit_mb=1024", "-timeout=30", "-print_final_stats=1", "-verbosity=1"]
# The weights that libFuzzer's entropic schedule keeps of every feature took more than two thirds of the time of whole files.
SPEED = ["-entropic=0", "-reload=0", "-print_funcs=0"]
DOCUMENTS = {"glb", "json"}  # whole files: short ones reach as much in a fraction of the time
# Little memory waits to be freed, so that it stays in the cache, and no deep stacks are stored with each allocation.
SANITIZER = "quarantine_size_mb=1:malloc_context_size=3:thread_local_quarantine_size_kb=64"
HERE = pathlib.Path(__file__).resolve().parent


def fuzz(build, target, seconds):
    """One program for `seconds`: its last report and what it found."""
    corpus = pathlib.Path(os.environ.get("SINEW_FUZZ_CORPUS") or build / "corpus") / target
    findings = build / "findings" / target
    for folder in (corpus, findings):
        folder.mkdir(parents=True, exist_ok=True)
    inputs = [folder for folder in (build / "seeds" / target, HERE / "found" / target) if folder.is_dir()]
    command = [build / "bin" / "sinew-fuzz", corpus, *inputs, f"-max_total_time={seconds}", f"-dict={HERE / 'gltf.dict'}",
               f"-artifact_prefix={findings}/", f"-max_len={8192 if target in DOCUMENTS else 32768}", *LIMITS, *SPEED]
    options = {"SINEW_FUZZ_TARGET": target, "ASAN_OPTIONS": ":".join(filter(None, [SANITIZER, os.environ.get("ASAN_OPTIONS")]))}
    before = set(findings.iterdir())
    log = build / "findings" / f"{target}.log"
    with open(log, "wb") as out:
        code = subprocess.run(command, stdout=out, stderr=subprocess.STDOUT, env={**os.environ, **options}).returncode
    return report(target, log.read_text(errors="replace"), code, sorted(set(findings.iterdir()) - before), log)


def report(target, text, code, found, log):
    def last(pattern):
        hits = re.findall(pattern, text)
        return int(hits[-1]) if hits else 0

    # A program that ends in any other way than by its time is a finding even when it could not write the input.
    return {"target": target, "executions": last(r"stat::number_of_executed_units: (\d+)") or last(r"#(\d+)\t"),
            "edges": last(r"cov: (\d+)"), "features": last(r"ft: (\d+)"), "new": last(r"stat::new_units_added:\s+(\d+)"),
            "found": [str(path) for path in found] or ([str(log)] if code != 0 else [])}


def main():
    build, minutes, jobs = pathlib.Path(sys.argv[1]).resolve(), float(sys.argv[2]), int(sys.argv[3])
    subprocess.run([build / "bin" / "sinew-fuzz-seeds", build / "seeds", *sys.argv[4:]], check=True)
    rounds = -(-len(TARGETS) // jobs)
    seconds = max(1, round(60 * minutes / rounds))
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        reports = list(pool.map(lambda target: fuzz(build, target, seconds), TARGETS))
    print(f"{'target':12}{'executions':>12}{'a second':>10}{'edges':>8}{'features':>10}{'new inputs':>12}  found")
    for r in reports:
        print(f"{r['target']:12}{r['executions']:12}{r['executions'] // seconds:10}{r['edges']:8}{r['features']:10}{r['new']:12}  {', '.join(r['found']) or 'nothing'}")
    return 1 if any(r["found"] or not r["executions"] for r in reports) else 0


if __name__ == "__main__":
    sys.exit(main())
