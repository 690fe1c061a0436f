# SPDX-License-Identifier: MIT
"""Runs the commands of the recipes in samples/verify_in_ci on a copy of that folder: verify_recipes_test.py SINEW SAMPLE

As a build server would: the model is kept, then moved, then its goldens are renewed. Exit status 77 without PyYAML."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

try:
    import yaml
except ImportError:
    print("no PyYAML here: the recipes are not read")
    sys.exit(77)


def github(folder):
    """Commands that compare, and the folder that is kept."""
    job = yaml.safe_load((folder / ".github/workflows/poses.yml").read_text())["jobs"]["compare"]
    steps = {step.get("name", step.get("uses")): step for step in job["steps"]}
    assert list(steps) == ["actions/checkout@v4", "Install sinew", "Compare poses", "Keep the report"], list(steps)
    keep = steps["Keep the report"]
    assert keep["if"] == "always()", "a report of a failure would be lost"
    return steps["Compare poses"]["run"], keep["with"]["path"]


def gitlab(folder):
    job = yaml.safe_load((folder / ".gitlab-ci.yml").read_text())["poses"]
    kept = job["artifacts"]
    assert kept["when"] == "always" and kept["reports"]["junit"].startswith(kept["paths"][0]), kept
    return "\n".join(job["script"]), kept["paths"][0]


def update_line(readme):
    """The command that the sample's README names for new goldens."""
    return next(line.strip() for line in readme.read_text().splitlines() if line.startswith("    ") and "--update" in line)


def main():
    sinew, sample = map(pathlib.Path, sys.argv[1:])
    environment = dict(os.environ, PATH=f"{sinew.parent}:{os.environ['PATH']}")
    for recipe in (github, gitlab):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name) / "repository"
            shutil.copytree(sample, folder)
            commands, report = recipe(folder)

            def run(text):
                # Both servers stop at the first command that fails.
                return subprocess.run(["bash", "-e", "-c", text], cwd=folder, env=environment, capture_output=True, text=True, check=False)

            def failures():
                return xml.etree.ElementTree.parse(folder / report / "poses.xml").getroot().get("failures")

            kept = run(commands)
            assert kept.returncode == 0 and failures() == "0", kept
            model = folder / "models/arm.gltf"
            text = model.read_text()
            assert text.count("0,\n    1,\n    0") == 1, "the hand stands one metre above the arm"
            model.write_text(text.replace("0,\n    1,\n    0", "0,\n    1.002,\n    0"))
            moved = run(commands)
            assert moved.returncode == 1 and failures() == "1", moved
            assert '"hand\\"' in (folder / report / "poses.html").read_text()
            renewed = run(update_line(folder / "README.md"))
            assert renewed.returncode == 0 and run(commands).returncode == 0, renewed
            print(f"{recipe.__name__}: kept, moved and renewed")


main()
