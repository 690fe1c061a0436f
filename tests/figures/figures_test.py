# SPDX-License-Identifier: MIT
"""Tables land between their marks in the README, and nothing else of it changes: figures_test.py BUILD CORPUS

With a corpus the clips within a budget are measured again and have to keep it; without one the exit status is 77."""
import pathlib
import re
import sys
import tempfile

import figures

build, corpus = map(pathlib.Path, sys.argv[1:3])
text = figures.README.read_text()
for name in ("speed", "budgets"):
    once = figures.with_table(text, name, "| new |")
    end = once.index(f"<!-- figures: {name} -->") + len(f"<!-- figures: {name} -->")
    after = once.index("<!-- end -->", end)
    assert once[end:after] == "\n\n| new |\n\n", once[end:after]
    assert text.startswith(once[:end]) and text.endswith(once[after:]), f"more than the table of {name} changed"
    assert figures.with_table(once, name, "| new |") == once

if not (corpus / "models").is_dir():
    print("no corpus here: no clip is measured")
    sys.exit(77)
with tempfile.TemporaryDirectory() as folder:
    figures.README = pathlib.Path(folder) / "README.md"
    figures.README.write_text(text)
    figures.budgets(build, corpus)
    errors = [float(e) for e in re.findall(r"\| (\d\.\d{4}) mm \|", figures.README.read_text())]
    assert errors and max(errors) <= 0.1, errors
print(f"{len(errors)} clips in the table of budgets")
