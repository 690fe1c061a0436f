#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints the results of sinew-bench as a Markdown table: each job and case, ours beside the plain GLM version.

    table.py [--all] BENCH.json...    table of finished runs (--benchmark_out of sinew-bench), a column for each: its instruction set;
                                      the other columns are of the first. The rows of README.md in this folder, or all of them
    table.py --run SINEW_BENCH        runs every benchmark once, briefly, and fails when one of ours has no GLM partner
"""
import json
import math
import re
import subprocess
import sys

PAIRS = ("sample", "blend", "local_to_model", "correct_pose", "morph", "skin_linear", "skin_dual_quaternion",
         "skin_center_of_rotation", "frame", "crowd")
HEADLINES = re.compile(r"""
    (blend|local_to_model|mirror_pose|retarget_pose|sample) / (CesiumMan|Fox-0|biped67|tree1024|crowd1024) (/.*)? | frame/.* | crowd/.* | correct_pose/.*
    | (compile_clip|compile_plan|first_frame|load_clips)/(CesiumMan|Fox|biped67) | import/(arms|corpus|face|flight) | memory/(32k|4M|64M) | morph/.* | pose/(CesiumMan|biped)/.* | skin_center_of_rotation/PN/4/(10k|1M) | skin_dual_quaternion/(PN/1/10k|(P|PN|PNT)/4/10k|PN/4/1M)
    | (load_assets|start)/(biped67/.*|CesiumMan|Fox|Knight) | base64/1M | geometry_cache/.* | skin_(dual_quaternion|center_of_rotation)/(CesiumMan|Fox|Knight)
    | skin_linear/(PN/1/10k|PN/8/10k|(P|PN|PNT)/4/10k|PN/4/(300|1k|10k/cold|100k|1M|1M/2threads)|CesiumMan|Fox|Knight)""", re.VERBOSE)  # what README.md of this folder shows, without the ways that lost
BASELINES = ("glm", "tinygltf", "stream", "copy")


def read(report):
    """{(job, case): {implementation: entry}}; medians where the run was repeated, with the relative spread added."""
    found, spreads = {}, {}
    for entry in report["benchmarks"]:
        if entry.get("error_occurred"):
            sys.exit(f"{entry['name']}: {entry['error_message']}")
        entry["run_name"] = entry["run_name"].removesuffix("/real_time")  # the clock that was read is no part of the name
        job, implementation, *case = entry["run_name"].split("/")
        aggregate = entry.get("aggregate_name", "median")
        if aggregate == "cv":
            spreads[job, "/".join(case), implementation] = entry["per_item"]
        if aggregate == "median":
            found.setdefault((job, "/".join(case)), {})[implementation] = entry
    for (job, case, implementation), spread in spreads.items():
        found[job, case][implementation]["spread"] = spread
    return found


def number(value, form):
    return "" if value is None or (isinstance(value, float) and math.isnan(value)) else form % value


def row(job, case, times, entry, plain, stream):
    """`times`: per item on each target, None where that did not run the case."""
    ratio = entry["per_item"] / plain["per_item"] if plain else None
    rate = entry.get("bytes_per_second")
    of_stream = f" ({stream['per_item'] / entry['per_item'] * 100:.0f} %)" if stream and rate else ""
    spread = entry.get("spread")
    cells = [job, case, *(number(time * 1e9 if time is not None else None, "%.2f") for time in times),
             number(spread * 100 if spread is not None else None, "%.0f %%"),
             number(plain["per_item"] * 1e9 if plain else None, "%.2f"), number(ratio, "%.2f"), number(entry.get("error"), "%.1e"),
             number(plain.get("error") if plain else None, "%.1e"),
             "%.0f MB/s" % (rate / 1e6) if rate and job == "import" else number(rate / 1e9 if rate else None, "%.0f") + of_stream]
    print("| " + " | ".join(cells) + " |")


def print_table(runs, everything):
    """in   runs  {target: what read() found}, the one with the plain versions first"""
    print("| job | case | " + " | ".join(f"{target}, ns" for target in runs) + " | spread | GLM ns | ratio | error | GLM error | GB/s (of stream) |")
    print("|---|---|" + "---|" * (len(runs) + 6))
    for (job, case), entries in sorted(next(iter(runs.values())).items()):
        if not everything and not HEADLINES.fullmatch(f"{job}/{case}"):
            continue
        plain, stream = entries.get("glm", entries.get("tinygltf")), entries.get("stream")
        for implementation, entry in entries.items():
            found = [run.get((job, case), {}).get(implementation) for run in runs.values()]
            times = [other and other["per_item"] for other in found]
            if implementation == "copy":
                row(job, "copy " + case, times, entry, None, None)
            elif implementation in ("sinew", "packed", "unpacked") or (everything and implementation not in BASELINES):
                row(job, case if implementation == "sinew" else f"{case}, {implementation}", times, entry, plain, stream)


def print_stages(found):
    """Where the time of imports goes, in percent."""
    imports = {case: entries["sinew"] for (job, case), entries in sorted(found.items()) if job == "import" and "sinew" in entries}
    stages = [stage for stage in ("parse", "buffers", "scene", "meshes", "clips", "images", "check")
              if any(f"part:{stage}" in entry for entry in imports.values())]
    if not stages:
        return
    print("\n| import | " + " | ".join(stages) + " |\n|---|" + "---|" * len(stages))
    for case, entry in imports.items():
        print(f"| {case} | " + " | ".join(number(100 * entry[f"part:{stage}"] if f"part:{stage}" in entry else None, "%.0f %%") for stage in stages) + " |")


def main():
    if len(sys.argv) == 3 and sys.argv[1] == "--run":
        command = [sys.argv[2], "--benchmark_format=json", "--benchmark_min_time=0.0001"]
        found = read(json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout))
        alone = [key for key, entries in found.items() if key[0] in PAIRS and not {"sinew", "glm"} <= entries.keys()
                 or key[0] == "import" and not {"sinew", "tinygltf"} <= entries.keys()]
        missing = [job for job in (*PAIRS, "import", "memory") if not any(key[0] == job and HEADLINES.fullmatch("/".join(key)) for key in found)]
        if alone or missing:
            sys.exit(f"without a partner: {alone}; missing: {missing}")
        print_table({"best": found}, everything=True)
        print_stages(found)
        return
    paths = [argument for argument in sys.argv[1:] if argument != "--all"]
    if not paths or any(path.startswith("--") for path in paths):
        sys.exit(__doc__)
    runs = {}
    for path in paths:
        with open(path, encoding="utf-8") as file:
            report = json.load(file)
        runs[report["context"]["target"]] = read(report)
    print_table(runs, everything="--all" in sys.argv)
    if "--all" in sys.argv:
        print_stages(next(iter(runs.values())))


if __name__ == "__main__":
    main()
