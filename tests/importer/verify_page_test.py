# SPDX-License-Identifier: MIT
"""Opens the page of `sinew verify` in headless Chromium, in light and dark, and asks it what it shows: verify_page_test.py SINEW

Exit status 77 where there is no Chromium."""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).parents[1] / "support"))
from browser import DARK, browser, run

# One joint that turns by 90 degrees within a second, and one at its end.
MODEL = {
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"name": "arm & <hand>", "children": [1]}, {"name": "tip", "translation": [0, 1, 0]}],
    "animations": [{"name": "turn", "channels": [{"sampler": 0, "target": {"node": 0, "path": "rotation"}}], "samplers": [{"input": 0, "output": 1}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 2, "type": "SCALAR", "min": [0], "max": [1]},
                  {"bufferView": 1, "componentType": 5126, "count": 2, "type": "VEC4"}],
    "bufferViews": [{"buffer": 0, "byteLength": 8}, {"buffer": 0, "byteOffset": 8, "byteLength": 32}],
    "buffers": [{"byteLength": 40, "uri": "data:application/octet-stream;base64,AAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AAAAAAAAAADzBDU/8wQ1Pw=="}]}

# Runs after the page's own script and leaves its findings where --dump-dom shows them.
PROBE = """<script>
const strokes = [...document.querySelectorAll("svg path.curve")].map(path => path.getTotalLength() > 10 && !path.getAttribute("d").includes("NaN"));
const sections = [...document.querySelectorAll("section")].map(s => s.className);
document.body.dataset.probe = JSON.stringify({ title: document.querySelector("h1").textContent, sections, curves: strokes.length, drawn: strokes.every(Boolean),
  bones: document.querySelectorAll(".bone.was, .bone.is").length, rows: document.querySelectorAll("table.worst tbody tr").length,
  kept: document.querySelectorAll("#kept tbody tr").length, starts: document.querySelector(".moved b").textContent,
  paper: getComputedStyle(document.body).backgroundColor, wide: document.documentElement.scrollWidth > innerWidth });
</script>
</body>"""


def probe(folder, page, *arguments):
    done = run(folder, page, "--dump-dom", *arguments)
    complaints = [line for line in done.stderr.splitlines() if "CONSOLE" in line]
    assert not complaints, complaints
    found = re.search(r'data-probe="([^"]*)"', done.stdout)
    assert found, "the page's script did not come to its end"
    text = found[1]
    for entity, character in (("&quot;", '"'), ("&lt;", "<"), ("&gt;", ">"), ("&amp;", "&")):
        text = text.replace(entity, character)
    return json.loads(text)


def main():
    if browser() is None:
        print("no Chromium here: the page is not opened")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        models, goldens = folder / "models", folder / "goldens"
        models.mkdir()
        for model in ("kept", "moved"):
            (models / f"{model}.gltf").write_text(json.dumps(MODEL))
        subprocess.run([sys.argv[1], "sample", models, "--fps", "10", "-o", goldens], check=True, capture_output=True)
        golden = json.loads((goldens / "moved.json").read_text())
        assert len(golden["clips"][1]["samples"]) == 11, "the rest pose comes before the clip"
        for sample in golden["clips"][1]["samples"][4:7]:
            sample["nodes"][1]["world"][12] += 0.05
        (goldens / "moved.json").write_text(json.dumps(golden))
        page = folder / "page.html"
        done = subprocess.run([sys.argv[1], "verify", models, goldens, "--html", page], capture_output=True)
        assert done.returncode == 1, done
        probed = folder / "probed.html"
        probed.write_text(page.read_text().replace("</body>", PROBE))
        for dark in (False, True):
            seen = probe(folder, probed, *(DARK if dark else []))
            # Curves: one over time; of the joint x, y, z of both poses, its distance and its angle. Bones: golden and current in two views.
            expected = {"title": "1 of 2 files does not match", "sections": ["moved", ""], "curves": 9, "drawn": True, "bones": 4, "rows": 1, "kept": 1,
                        "starts": '"tip"', "paper": "rgb(20, 23, 26)" if dark else "rgb(246, 245, 241)", "wide": False}
            assert seen == expected, (seen, expected)
        print("the page draws in light and dark")


main()
