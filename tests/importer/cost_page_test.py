# SPDX-License-Identifier: MIT
"""Opens the page of `sinew cost` in headless Chromium, in light and dark, and asks it what it shows: cost_page_test.py SINEW

Exit status 77 where there is no Chromium."""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).parents[1] / "support"))
from browser import DARK, browser, run

# Runs after the page's own script and leaves its findings where --dump-dom shows them.
PROBE = """<script>
const folded = document.documentElement.scrollHeight, screen = document.getElementById("overview").getBoundingClientRect().bottom;
document.querySelectorAll("details").forEach(fold => { fold.open = true; });
const boxes = [...document.querySelectorAll("svg")].map(svg => [...svg.querySelectorAll("g.point text")].map(t => t.getBBox()));
const apart = (a, b) => a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + 0.8 * a.height <= b.y || b.y + 0.8 * b.height <= a.y;
const overlaps = boxes.flatMap(list => list.flatMap((a, i) => list.slice(i + 1).filter(b => !apart(a, b)))).length;
const focusable = [...document.querySelectorAll("g.point")];
const details = focusable.filter(g => { g.focus(); return g.closest("section").querySelector(".detail").textContent.includes("—"); }).length;
document.body.dataset.probe = JSON.stringify({ charts: boxes.length, labels: boxes.flat().length, points: focusable.length, overlaps, details,
  rows: document.querySelectorAll("tbody tr").length, paper: getComputedStyle(document.body).backgroundColor,
  wide: document.documentElement.scrollWidth > innerWidth, frame: document.querySelectorAll("#frame .bar").length,
  choices: document.querySelectorAll(".choices h2").length, short: folded < 0.3 * document.documentElement.scrollHeight && screen < 1200 });
</script>
</body>"""


def probe(folder, page, *arguments):
    done = run(folder, page, "--dump-dom", *arguments)
    complaints = [line for line in done.stderr.splitlines() if "CONSOLE" in line]
    assert not complaints, complaints
    found = re.search(r'data-probe="([^"]*)"', done.stdout)
    assert found, "the page's script did not come to its end"
    return json.loads(found[1].replace("&quot;", '"'))


def main():
    if browser() is None:
        print("no Chromium here: the page is not opened")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subprocess.run([sys.argv[1], "cost", "--quick", "-o", folder / "costs"], check=True, capture_output=True)
        page, report = folder / "costs/report.html", json.loads((folder / "costs/report.json").read_text())
        points = sum(len(group["points"]) for group in report["groups"])
        probed = folder / "probed.html"
        text, changed = re.subn(r'"spread": *[0-9.e-]+', '"spread":3', page.read_text(), 1)  # a very noisy machine
        assert changed == 1
        probed.write_text(text.replace("</body>", PROBE))
        for dark in (False, True):
            seen = probe(folder, probed, *(DARK if dark else []))
            expected = {"charts": sum(bool(g["points"]) for g in report["groups"]), "points": points, "labels": points, "overlaps": 0,
                        "details": points, "rows": points, "paper": "rgb(20, 23, 26)" if dark else "rgb(246, 245, 241)", "wide": False,
                        "frame": 1, "choices": len(report["overview"]["choices"]), "short": True}
            assert seen == expected, (seen, expected)
        paper = folder / "page.pdf"
        run(folder, page, f"--print-to-pdf={paper}", "--no-pdf-header-footer")
        assert paper.read_bytes().startswith(b"%PDF") and paper.stat().st_size > 20000
        print(f"{points} points in {expected['charts']} charts, in light, dark and on paper")


main()
