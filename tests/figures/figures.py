#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the tables and pictures of the documentation again: figures.py BUILD CORPUS [NAME...]       all of them without a NAME

speed     the table of `./run bench` in tests/bench/README.md, and its few rows in README.md (`headlines`)
budgets   what `sinew compile --budget 0.1mm` says of the clips of a few models, in runtime/compress/README.md
caches    sizes and speed of geometry caches, in runtime/geometry_cache/README.md
cost      the first chart of `sinew cost`, as importer/tool/cost/report.png (needs Chromium)
showcase  showcase.png, flag.png, ambient_light.png and normals.png in samples/showcase, and one_motion.png in samples/one_motion

A table goes between the lines `<!-- figures: NAME -->` and `<!-- end -->` of its file. Models come from CORPUS; without it,
figures that need them stay as they are. Leave the machine alone meanwhile.
"""
import base64
import json
import math
import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
TABLES = {  # where each marked table stands
    "headlines": ROOT / "README.md",
    "speed": ROOT / "tests/bench/README.md",
    "budgets": ROOT / "runtime/compress/README.md",
    "cache_sizes": ROOT / "runtime/geometry_cache/README.md",
    "cache_speed": ROOT / "runtime/geometry_cache/README.md",
}
sys.path.append(str(ROOT / "tests/support"))
from browser import browser, run

BUDGET_MODELS = ("CesiumMan", "Fox", "Knight", "InfiniteSkinnedTentacle")
COST_MODEL = "CesiumMan"
CACHE_MODELS = (("CesiumMan", "0.1mm"), ("Knight", "0.1mm"), ("Fox", "0.1mm"), ("Fox", "10mm"), ("enemy", "0.1mm"), ("InfiniteSkinnedTentacle", "0.1mm"))
CACHE_TARGETS = (("avx3", "AVX-512"), ("avx2", "AVX2"), ("sse4", "SSE4"))
CACHE_WORK = (  # benchmark, words, counter, factor, unit
    ("sinew/cloth30k/forward", "forward, into floats", "items_per_second", 1e-6, "M points/s"),
    ("sinew/lively_cloth30k/forward", "the same in a livelier wind", "items_per_second", 1e-6, "M points/s"),
    ("sinew/cloth30k/vertices", "forward, into the order of the mesh", "items_per_second", 1e-6, "M vertices/s"),
    ("sinew/cloth30k/farthest_seek", "farthest seek in a segment of 32 frames", "cpu_time", 1e-6, "ms"),
    ("sinew/cloth30k/open_and_first_frame", "opening the file and the first frame", "cpu_time", 1e-6, "ms"),
    ("zstd/cloth30k/forward", "zstd, frames of the same 16-bit numbers", "items_per_second", 1e-6, "M points/s"),
    ("copy/cloth30k/forward", "a copy of the floats", "items_per_second", 1e-6, "M points/s"),
    ("copy/cloth30k/forward", "a copy of the floats", "bytes_per_second", 1e-9, "GB/s"),
    ("sinew/cloth30k/forward", "forward, floats that are written", "bytes_per_second", 1e-9, "GB/s"),
)
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
<script>document.querySelector("#rotation details").open = true;
document.body.dataset.height = Math.ceil(document.getElementById("rotation").getBoundingClientRect().bottom) + 4;</script></body>"""


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


def tool(build, *arguments):
    return subprocess.run([build / "bin/sinew", *arguments], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=True).stdout


def bench_caches(build, target):
    command = [build / "bin/sinew-bench", f"--target={target}", "--benchmark_filter=geometry_cache/", "--benchmark_format=json"]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    rows = json.loads(done.stdout)["benchmarks"] if done.returncode == 0 and done.stdout else []
    return {row["name"].removeprefix("geometry_cache/"): row for row in rows}


def beside_zstd(build, cache, folder):
    """Bytes of zstd -19 on the numbers of the first 64 frames, and of the cache, of the floats of points."""
    tool(build, "cost", cache, "-o", folder)
    group = json.loads((folder / "report.json").read_text())["groups"][0]
    sizes = {point["name"]: point["size"] for point in group["points"]}
    ours = next(point["size"] for point in group["points"] if point["default"])
    return ours / sizes["zstd -19"]


def cache_row(build, name, file, budget, folder):
    clips = [(i, clip) for i, clip in enumerate(json.loads(tool(build, "info", "--json", file))["clips"]) if clip["duration_s"] > 0]
    shares, total, raw, frames = {}, 0, 0, 0
    longest = max(clips, key=lambda c: c[1]["duration_s"])[0]
    for i, clip in clips:
        out = folder / ("longest.sgeo" if i == longest else "clip.sgeo")
        tool(build, "bake", file, "--clip", str(i), "--budget", budget, "-o", out)
        cache = json.loads(tool(build, "info", "--json", out))["geometry_cache"]
        shares[clip["name"]] = cache["bytes"] / cache["raw_bytes"]
        total, raw, frames = total + cache["bytes"], raw + cache["raw_bytes"], frames + cache["frames"]
    vertices = sum(mesh["vertices"] for mesh in cache["meshes"])
    points = sum(mesh["points"] for mesh in cache["meshes"])
    zstd = beside_zstd(build, folder / "longest.sgeo", folder / f"cost{budget}{name}")
    return (f"| {name}, {len(clips)} clip{'s' if len(clips) > 1 else ''} | {budget} | {vertices:,} | {points:,} | {frames:,} | {total:,} | "
            f"{100 * total / raw:.1f} % | {100 * min(shares.values()):.1f} to {100 * max(shares.values()):.1f} % | {zstd:.2f} |")


def cloth_row(words, row):
    raw = 12 * 29949 * 128
    return (f"| {words} | 0.1mm | 29,949 | 29,949 | 128 | {round(raw * row['of_raw']):,} | {100 * row['of_raw']:.1f} % | | "
            f"{row['of_raw'] / row['zstd_of_raw']:.2f} |")


def point_cache_row(build, obj, folder):
    out = folder / "points.sgeo"
    tool(build, "bake", obj, "--points", obj.with_suffix(".mdd"), "--up", "z", "-o", out)
    cache = json.loads(tool(build, "info", "--json", out))["geometry_cache"]
    mesh, share = cache["meshes"][0], 100 * cache["bytes"] / cache["raw_bytes"]
    return (f"| {obj.stem}.mdd of Blender | 0.1mm | {mesh['vertices']:,} | {mesh['points']:,} | {cache['frames']} | {cache['bytes']:,} | "
            f"{share:.1f} % | | {beside_zstd(build, out, folder / obj.stem):.2f} |")


def caches(build, corpus):
    by_target = {words: rows for target, words in CACHE_TARGETS if (rows := bench_caches(build, target))}
    head = [f"| work | unit | {' | '.join(by_target)} |", "|---|---|" + "---|" * len(by_target)]
    write_table("cache_speed", "\n".join(head + [
        f"| {words} | {unit} | {' | '.join(f'{factor * rows[name][counter]:.3g}' for rows in by_target.values())} |"
        for name, words, counter, factor, unit in CACHE_WORK]))
    best = next(iter(by_target.values()))
    head = ["| cache | within | vertices | points | frames at 30 Hz | bytes | of raw floats | least and most of a clip | of zstd -19 |", "|---|---|---|---|---|---|---|---|---|"]
    rows = [cloth_row("cloth of 201 x 149 in a calm wind", best["sinew/cloth30k/forward"]),
            cloth_row("the same cloth in a livelier wind", best["sinew/lively_cloth30k/forward"])]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        rows += [cache_row(build, name, model(corpus, name), budget, folder) for name, budget in CACHE_MODELS if model(corpus, name)]
        rows += [point_cache_row(build, obj, folder) for obj in sorted((corpus / "cache").glob("*.obj"))]
    write_table("cache_sizes", "\n".join(head + rows))


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


def with_lamps_off(source, target):
    """The .glb with lights of no intensity: without any, the viewer would bring a key light."""
    file = source.read_bytes()
    length = struct.unpack_from("<I", file, 12)[0]
    document = json.loads(file[20:20 + length])
    for light in document["extensions"]["KHR_lights_punctual"]["lights"]:
        light["intensity"] = 0
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    rest = file[20 + length:]
    target.write_bytes(struct.pack("<4sIIII", b"glTF", 2, 20 + len(text) + len(rest), len(text), 0x4E4F534A) + text + rest)


def ambient_light(build):
    """The skull in ambient light alone: without ambient occlusion, and with rays from its vertices."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subprocess.run([build / "bin/sinew-showcase", folder], stdout=subprocess.DEVNULL, check=True)
        with_lamps_off(folder / "skull-flight.glb", folder / "skull.glb")
        ways = {"without": ["--no-ao"], "rays": ["--ao", "rays", "--key-poses", "5"]}  # a key pose is at 2 s
        for way, options in ways.items():
            subprocess.run([build / "bin/sinew-viewer", folder / "skull.glb", "--headless", folder / f"{way}.png", "--time", "2", "--size", "360x400",
                            "--eye", "5,2,24", "--target", "-0.6,1.2,10", "--fov", "29", "--environment", "plain", "--exposure", "0.8", "--ground", "none", *options], check=True)
        if shutil.which("convert"):
            subprocess.run(["convert", *(folder / f"{way}.png" for way in ways), "+append", "-depth", "8", ROOT / "samples/showcase/ambient_light.png"], check=True)


def coarse_ball(columns, rows):
    """A glTF ball of few quads with smooth normals."""
    angles = [(2 * math.pi * c / columns, math.pi * (r / rows - 0.5)) for r in range(rows + 1) for c in range(columns + 1)]
    points = [(math.cos(lat) * math.sin(lon), math.sin(lat), math.cos(lat) * math.cos(lon)) for lon, lat in angles]
    below = [r * (columns + 1) + c for r in range(rows) for c in range(columns)]
    indices = [i + step for i in below for step in (0, 1, columns + 2, 0, columns + 2, columns + 1)]
    vectors = b"".join(struct.pack("<3f", *p) for p in points)
    data = vectors + struct.pack(f"<{len(indices)}H", *indices)
    vec3 = {"bufferView": 0, "componentType": 5126, "count": len(points), "type": "VEC3", "min": [-1, -1, -1], "max": [1, 1, 1]}
    primitive = {"attributes": {"POSITION": 0, "NORMAL": 0}, "indices": 1, "material": 0}
    look = {"baseColorFactor": [0.3, 0.4, 0.7, 1], "metallicFactor": 0, "roughnessFactor": 0.25}
    return json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [primitive]}], "materials": [{"pbrMetallicRoughness": look}],
        "buffers": [{"byteLength": len(data), "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}],
        "bufferViews": [{"buffer": 0, "byteLength": len(vectors)},
                        {"buffer": 0, "byteOffset": len(vectors), "byteLength": len(data) - len(vectors)}],
        "accessors": [vec3, {"bufferView": 1, "componentType": 5123, "count": len(indices), "type": "SCALAR"}]})


def normals(build):
    """A coarse ball with both interpolations of normals, and how far they are apart, eightfold."""
    if not shutil.which("convert"):
        return
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "ball.gltf").write_text(coarse_ball(6, 4))
        pictures = [folder / f"{way}.png" for way in ("interpolated", "quaternion")]
        for picture in pictures:
            subprocess.run([build / "bin/sinew-viewer", folder / "ball.gltf", "--headless", picture, "--size", "240x240", "--normals", picture.stem,
                            "--ground", "none", "--no-ao"], check=True)
        subprocess.run(["convert", *pictures, "(", *pictures, "-compose", "difference", "-composite", "-evaluate", "multiply", "8", ")",
                        "-alpha", "off", "+append", "-depth", "8", ROOT / "samples/showcase/normals.png"], check=True)


def showcase(build, corpus):
    no_display = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    subprocess.run([ROOT / "run", "--preset", build.name, "demo"], env=no_display, check=True)
    for name in ("showcase.png", "flag.png"):
        shutil.copy(ROOT / "build/demo" / name, ROOT / "samples/showcase" / name)
    ambient_light(build)
    normals(build)
    bodies, picture = ROOT / "build/demo/one_motion.glb", ROOT / "samples/one_motion/one_motion.png"
    subprocess.run([build / "bin/one_motion", bodies], check=True)
    subprocess.run([build / "bin/sinew-viewer", bodies, "--headless", picture, "--time", "0.25", "--size", "960x400", "--eye",
                    "2.8,1.5,6.2", "--target", "0,0.86,0", "--fov", "23"], check=True)
    if shutil.which("convert"):
        subprocess.run(["convert", picture, "-colors", "200", picture], check=True)


def main():
    build, corpus, names = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve(), sys.argv[3:]
    figures = {"showcase": showcase, "budgets": budgets, "caches": caches, "cost": cost, "speed": speed}
    if unknown := [name for name in names if name not in figures]:
        sys.exit(f"figures: there is no {unknown[0]}; there are {', '.join(figures)}")
    for name in names or figures:
        print(f"figures: {name}", flush=True)
        figures[name](build, corpus)


if __name__ == "__main__":
    main()
