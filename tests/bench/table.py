#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints the results of sinew-bench as a Markdown table: each job and case, ours beside the plain GLM version.

    table.py BENCH.json          table of a finished run (--benchmark_out of sinew-bench)
    table.py --run SINEW_BENCH   runs every benchmark once, briefly, and fails when one of ours has no GLM partner
"""
import json
import subprocess
import sys


def read(report):
    """{(job, case): {implementation: seconds per item}}; medians where the run was repeated."""
    found = {}
    for entry in report["benchmarks"]:
        if entry.get("aggregate_name", "median") != "median":
            continue
        if entry.get("error_occurred"):
            sys.exit(f"{entry['name']}: {entry['error_message']}")
        job, implementation, *case = entry["run_name"].split("/")
        found.setdefault((job, "/".join(case)), {})[implementation] = entry["per_item"]
    return found


def nanoseconds(seconds):
    return "" if seconds is None else f"{seconds * 1e9:.2f}"


def print_table(found):
    print("| job | case | sinew ns/item | baseline ns/item | ratio |")
    print("|---|---|---|---|---|")
    for (job, case), times in sorted(found.items()):
        if "copy" in times:
            print(f"| {job} | copy {case} | | | {1e-9 / times['copy']:.1f} GB/s |")
            continue
        ours, plain = times.get("sinew"), times.get("glm", times.get("tinygltf"))
        ratio = f"{ours / plain:.2f}" if ours and plain else ""
        print(f"| {job} | {case} | {nanoseconds(ours)} | {nanoseconds(plain)} | {ratio} |")


def main():
    if len(sys.argv) == 3 and sys.argv[1] == "--run":
        command = [sys.argv[2], "--benchmark_format=json", "--benchmark_min_time=0.0001"]
        found = read(json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout))
        pairs = ("sample", "blend", "local_to_model", "morph", "skin_linear", "skin_dual_quaternion", "frame")
        alone = [key for key, times in found.items() if key[0] in pairs and not {"sinew", "glm"} <= times.keys()]
        missing = [job for job in pairs if not any(key[0] == job for key in found)]
        if alone or missing:
            sys.exit(f"without a partner: {alone}; missing: {missing}")
        print_table(found)
    elif len(sys.argv) == 2:
        with open(sys.argv[1], encoding="utf-8") as file:
            print_table(read(json.load(file)))
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main()
