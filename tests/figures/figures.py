#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the tables and pictures of the documentation again: figures.py BUILD CORPUS [NAME...]       all of them without a NAME

speed     the table of `./run bench` in tests/bench/README.md, and its few rows in README.md (`headlines`)
budgets   what `sinew compile --budget 0.1mm` says of the clips of a few models, in runtime/compress/README.md
cost      the first chart of `sinew cost`, as importer/tool/cost/report.png (needs Chromium)
showcase  showcase.png and flag.png in samples/showcase

A table goes between the lines `<!-- figures: NAME -->` and `<!-- end -->` of its file. Models come from CORPUS; without it,
figures that need them stay as they are. Leave the machine alone meanwhile.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
TABLES = {  # where each marked table stands
    "headlines": ROOT / "README.md",
    "speed": ROOT / "tests/bench/README.md",
    "budgets": ROOT / "runtime/compress/README.md",
}
sys.path.append(str(ROOT / "tests/support"))
from browser import browser, run

BUDGET_MODELS = ("CesiumMan", "Fox", "Knight", "InfiniteSkinnedTentacle")
COST_MODEL = "CesiumMan"
WIDTH = 988  # of the picture, pixels

# The rows of the speed table that a user compares, in their order: (job, case), words, unit.
HEADLINES = (
    ("sample", "biped67/forward", "sample a clip of 67 joints, playing forward", "joint"),
    ("sample", "biped67/seek", "sample it at times all over the clip", "joint"),
    ("blend", "biped67/4", "blend four poses", "joint"),
    ("local_to_model", "biped67", "local pose to model matrices", "joint"),
    ("morph", "PN/16targets/4active/10k", "morph positions and normals, 4 of 16 targets active", "vertex"),
    ("skin_linear", "PN/4/10k", "skin positions and normals, 4 influences, linear blend", "vertex"),
    ("skin_dual_quaternion", "PN/4/10k", "the same with dual quaternions", "vertex"),
    ("skin_center_of_rotation", "PN/4/10k", "the same about centers of rotation", "vertex"),
    ("frame", "biped/1layer/PN/4/3k", "whole frame of a character of 3,273 vertices", "frame"),
    ("crowd", "biped67/1024/2threads", "poses of 1,024 characters that blend two clips, two threads", "joint"),
)

# Leaves one chart of the page, without the table under it, and says how high that is.
ONE_CHART = """<style>main { padding: 0 !important } main > :not(#groups), .scroll, .about, .detail, section:not(#rotation) { display: none !important }
section { margin: 4px !important }</style>
<script>document.body.dataset.height = Math.ceil(document.getElementById("rotation").getBoundingClientRect().bottom) + 4;</script></body>"""


def model(corpus, name):
    found = sorted(path for ending in ("glb", "gltf") for path in (corpus / "models" / name).glob(f"*.{ending}"))
    return found[0] if found else None


def with_table(text, name, table):
    """The text with a table in place of the one between its marks."""
    marks = re.compile(rf"(<!-- figures: {name} -->\n).*?(<!-- end -->)", re.DOTALL)
    assert len(marks.findall(text)) == 1, f"{TABLES[name]} has to hold <!-- figures: {name} --> and <!-- end --> once"
    return marks.sub(lambda m: f"{m[1]}\n{table.strip()}\n\n{m[2]}", text)


def write_table(name, table):
    TABLES[name].write_text(with_table(TABLES[name].read_text(), name, table))


def headlines(table):
    """The few rows of the speed table, each in words."""
    rows = {}
    for line in table.splitlines():
        cells = [cell.strip() for cell in line.strip("| ").split("|")]
        rows[tuple(cells[:2])] = cells
    columns = rows["job", "case"]
    head = ["| work | ns per | sinew | plain GLM | ratio |", "|---|---|---|---|---|"]
    for job, case, words, unit in HEADLINES:
        cells = rows[job, case]
        ours, plain, ratio = (cells[column] for column in (2, columns.index("GLM ns"), columns.index("ratio")))
        head.append(f"| {words} | {unit} | {ours} | {plain} | {ratio} |")
    return "\n".join(head)


def speed(build, corpus):
    done = subprocess.run([ROOT / "run", "--preset", build.name, "bench"], stdout=subprocess.PIPE, text=True, check=True)
    write_table("speed", done.stdout)
    write_table("headlines", headlines(done.stdout))


def budget_rows(build, name, file, folder):
    out = pathlib.Path(folder) / f"{name}.sinew"
    subprocess.run([build / "bin/sinew", "compile", file, "-o", out, "--budget", "0.1mm"], stdout=subprocess.DEVNULL, check=True)
    clips = json.loads(subprocess.run([build / "bin/sinew", "info", "--json", out], stdout=subprocess.PIPE, check=True).stdout)["compiled_clips"]
    clips.sort(key=lambda clip: -clip["certificate"]["bytes"])
    for clip in clips[:3]:  # of models with dozens of clips, the largest
        c = clip["certificate"]
        title = name + (f", {clip['name']}" if clip["name"] else "")
        yield (f"| {title} | {1e3 * c['measured_m']:.4f} mm | {c['kept_keys']} of {c['source_keys']} | {c['bytes']} | "
               f"{c['bytes_per_joint_second']:.1f} | {c['bytes'] / c['source_bytes']:.2f} |")


def budgets(build, corpus):
    head = ["| clip | largest error | keys | bytes | bytes/joint/s | of all keys in float |", "|---|---|---|---|---|---|"]
    with tempfile.TemporaryDirectory() as folder:
        rows = [row for name in BUDGET_MODELS if model(corpus, name) for row in budget_rows(build, name, model(corpus, name), folder)]
    if not rows:
        return print("budgets: no corpus, left as they are")
    write_table("budgets", "\n".join(head + rows))


def cost(build, corpus):
    file = model(corpus, COST_MODEL)
    if file is None or browser() is None:
        return print("cost: no corpus or no Chromium, left as it is")
    (build / "figures").mkdir(exist_ok=True)
    subprocess.run([build / "bin/sinew", "cost", file, "-o", build / "figures/cost"], check=True)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        page, picture = folder / "chart.html", ROOT / "importer/tool/cost/report.png"
        page.write_text((build / "figures/cost/report.html").read_text().replace("</body>", ONE_CHART))
        height = re.search(r'data-height="(\d+)"', run(folder, page, "--dump-dom", f"--window-size={WIDTH},800").stdout)[1]
        run(folder, page, f"--screenshot={picture}", f"--window-size={WIDTH},{height}")
    if shutil.which("convert"):
        subprocess.run(["convert", picture, "-colors", "128", picture], check=True)


def showcase(build, corpus):
    no_display = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    subprocess.run([ROOT / "run", "--preset", build.name, "demo"], env=no_display, check=True)
    for name in ("showcase.png", "flag.png"):
        shutil.copy(ROOT / "build/demo" / name, ROOT / "samples/showcase" / name)


def main():
    build, corpus, names = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve(), sys.argv[3:]
    figures = {"showcase": showcase, "budgets": budgets, "cost": cost, "speed": speed}
    if unknown := [name for name in names if name not in figures]:
        sys.exit(f"figures: there is no {unknown[0]}; there are {', '.join(figures)}")
    for name in names or figures:
        print(f"figures: {name}", flush=True)
        figures[name](build, corpus)


if __name__ == "__main__":
    main()
