# SPDX-License-Identifier: MIT
"""Compares the binary interface of the C functions between two trees with libabigail: compare_abi.py OLD [NEW]

OLD and NEW are commits or folders; NEW is this working tree by default. Exit status 0: programs built against OLD run with NEW;
1: they do not, and the report says why; 77 without abidiff. Nothing of the library is compiled: the headers are the interface."""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
HEADERS = ("runtime/sinew.h", "runtime/c_assets/sinew_assets.h", "runtime/c_geometry/sinew_geometry.h")
MARK = r"__attribute__\(\(visibility\(\"default\"\)\)\)"  # SINEW_API, once the preprocessor has run
CHANGED = 4  # abidiff's exit status is a set of bits; functions that are new set none here


def tree_of(name, folder):
    """A folder as it is, or the runtime of a commit unpacked into `folder`."""
    if pathlib.Path(name).is_dir():
        return pathlib.Path(name)
    folder.mkdir()
    archive = subprocess.run(["git", "-C", ROOT, "archive", name, "runtime"], check=True, capture_output=True).stdout
    subprocess.run(["tar", "-x", "-C", folder], input=archive, check=True)
    return folder


def library_of(tree, folder):
    """A shared library of functions without bodies, one for each that the headers declare: their types are in its debug information, and
    handles stay opaque as they are for a caller."""
    folder.mkdir()
    unit, library = folder / "unit.c", folder / "libsinew_c.so"
    unit.write_text("".join(f'#include "{header}"\n' for header in HEADERS))
    declared = subprocess.run(["gcc", "-std=c2x", "-E", "-P", "-I", tree, unit], check=True, capture_output=True, text=True).stdout
    defined, count = re.subn(MARK + r"\s*([^;{}]*\))\s*;", r"\1 { __builtin_trap(); }", declared)
    assert count > 100 and not re.search(MARK, defined), f"{count} functions in the headers of {tree}"
    unit.write_text(defined)
    subprocess.run(["gcc", "-std=c2x", "-g", "-w", "-fPIC", "-shared", unit, "-o", library], check=True)
    return library


def growing_structs(tree):
    """Structs that begin with their size: a library takes those of older headers, so they may get members at their end."""
    texts = [path.read_text() for part in ("c", "c_assets", "c_geometry") for path in (tree / "runtime" / part).rglob("*.h")]
    return [name for text in texts for name in re.findall(r"typedef struct (\w+) \{\s*size_t struct_size;", text)]


def compare(old, new):
    """Exit status and report of abidiff; functions that are new are no difference for programs that exist."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        trees = [tree_of(tree, folder / f"tree{i}") for i, tree in enumerate((old, new))]
        libraries = [library_of(tree, folder / f"library{i}") for i, tree in enumerate(trees)]
        rule = "[suppress_type]\n  type_kind = struct\n  name_regexp = ^(%s)$\n  has_data_member_inserted_at = end\n"
        (folder / "may_grow").write_text(rule % "|".join(growing_structs(trees[0])))
        done = subprocess.run(["abidiff", "--no-added-syms", "--suppressions", folder / "may_grow", *libraries], capture_output=True, text=True, check=False)
    return done.returncode, done.stdout + done.stderr


def is_compatible(status):
    assert status & 3 == 0, f"abidiff ended with status {status}"  # bits of errors and wrong usage
    return status & CHANGED == 0


def main():
    if shutil.which("abidiff") is None:
        print("no abidiff (libabigail) here: nothing is compared")
        sys.exit(77)
    status, report = compare(sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else str(ROOT))
    print(report or "no difference\n", end="")
    sys.exit(not is_compatible(status))


if __name__ == "__main__":
    main()
