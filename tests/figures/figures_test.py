# SPDX-License-Identifier: MIT
"""Tables land between their marks, and nothing else of their files changes: figures_test.py BUILD CORPUS

README.md has the rows of the speed table that it names, with the same numbers. With a corpus the clips within a budget are
measured again and have to keep it; without one the exit status is 77."""
import pathlib
import re
import sys
import tempfile

import figures

build, corpus = map(pathlib.Path, sys.argv[1:3])
for name, file in figures.TABLES.items():
    text = file.read_text()
    once = figures.with_table(text, name, "| new |")
    end = once.index(f"<!-- figures: {name} -->") + len(f"<!-- figures: {name} -->")
    after = once.index("<!-- end -->", end)
    assert once[end:after] == "\n\n| new |\n\n", once[end:after]
    assert text.startswith(once[:end]) and text.endswith(once[after:]), f"more than the table of {name} changed"
    assert figures.with_table(once, name, "| new |") == once

docs = [file for folder in ("", "runtime", "importer", "viewer", "tests", "samples") for file in
        ((figures.ROOT / folder).rglob("*.md") if folder else figures.ROOT.glob("*.md"))]
marked = [(name, file) for file in docs for name in re.findall(r"<!-- figures: (\w+) -->", file.read_text())]
assert sorted(marked) == sorted(figures.TABLES.items()), f"marked tables that no command makes, or the reverse: {marked}"


def table_of(name):
    return re.search(rf"<!-- figures: {name} -->\n(.*?)<!-- end -->", figures.TABLES[name].read_text(), re.DOTALL)[1].strip()


assert table_of("headlines") == figures.headlines(table_of("speed")), "README.md shows other numbers than tests/bench/README.md"

if not (corpus / "models").is_dir():
    print("no corpus here: no clip is measured")
    sys.exit(77)
with tempfile.TemporaryDirectory() as folder:
    copy = pathlib.Path(folder) / "README.md"
    copy.write_text(figures.TABLES["budgets"].read_text())
    figures.TABLES["budgets"] = copy
    figures.budgets(build, corpus)
    errors = [float(e) for e in re.findall(r"\| (\d\.\d{4}) mm \|", copy.read_text())]
    assert errors and max(errors) <= 0.1, errors
print(f"{len(errors)} clips in the table of budgets")
