# SPDX-License-Identifier: MIT
"""Tables land between their marks, and nothing else of their files changes: figures_test.py BUILD GENERATED CORPUS

README.md has the rows of the speed table that it names, with the same numbers. Clips of generated models, and of a corpus where
there is one, are measured within a budget and have to keep it."""
import pathlib
import re
import shutil
import sys
import tempfile

import figures

build, generated, corpus = map(pathlib.Path, sys.argv[1:4])
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



def stand_in(folder):
    """A corpus in which generated models have the names of those in the table."""
    for name, file in zip(figures.BUDGET_MODELS, ("random-3.glb", "random-7.glb")):
        (folder / "models" / name).mkdir(parents=True)
        shutil.copy(generated / "models" / file, folder / "models" / name)
    return folder


def errors_mm(corpus, folder):
    """Of the clips in the table of budgets."""
    copy = folder / "README.md"
    copy.write_text(BUDGETS.read_text())
    figures.TABLES["budgets"] = copy
    figures.budgets(build, corpus)
    table = table_of("budgets")
    assert copy.read_text() == figures.with_table(BUDGETS.read_text(), "budgets", table)
    return [float(e) for e in re.findall(r"\| (\d\.\d{4}) mm \|", table)]


BUDGETS = figures.TABLES["budgets"]
with tempfile.TemporaryDirectory() as folder:
    folder = pathlib.Path(folder)
    for models in (stand_in(folder / "corpus"), corpus):
        if (models / "models").is_dir():
            errors = errors_mm(models, folder)
            assert errors and max(errors) <= 0.1, errors
            print(f"{len(errors)} clips of {models} in the table of budgets")
