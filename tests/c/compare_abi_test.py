# SPDX-License-Identifier: MIT
"""Shows compare_abi.py changes of which it is known whether programs that exist survive them. Exit status 77 without abidiff."""
import pathlib
import shutil
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).parent))
from compare_abi import ROOT, compare, is_compatible

LAYER = "runtime/c/frame.h"
PLAN = "runtime/c/plan.h"
SCENE = "runtime/c/scene.h"
CHANGES = {
    "nothing": (SCENE, "", "", True),
    "a function more": (SCENE, "SINEW_API size_t sinew_joint_count", "SINEW_API int sinew_new(void);\nSINEW_API size_t sinew_joint_count", True),
    "a function less": (SCENE, "SINEW_API size_t sinew_skin_count(const sinew_scene* scene);", "", False),
    "another type of a parameter": (SCENE, "sinew_clip_duration_s(const sinew_scene* scene, uint32_t clip)", "sinew_clip_duration_s(const sinew_scene* scene, uint64_t clip)", False),
    "members in another order": (LAYER, "  double time_s;\n  uint32_t clip;\n", "  uint32_t clip;\n  double time_s;\n", False),
    "a member more at the end of a struct that begins with its size": (PLAN, "} sinew_needs;", "  uint64_t more;\n} sinew_needs;", True),
    "a member more in its middle": (PLAN, "  uint32_t max_layers; ", "  uint64_t more;\n  uint32_t max_layers; ", False),
    "another number of an error": ("runtime/c/types.h", "SINEW_BUSY = 11,", "SINEW_BUSY = 12000,", False),
    "an error more": ("runtime/c/types.h", "  SINEW_NULL_ARGUMENT = 100,", "  SINEW_NEW = 99,\n  SINEW_NULL_ARGUMENT = 100,", True),
    "a member more in a struct that never grows": (LAYER, "  uint64_t inside[6];", "  uint64_t inside[7];", False),
}


def main():
    if shutil.which("abidiff") is None:
        print("no abidiff (libabigail) here: nothing is compared")
        sys.exit(77)
    for name, (file, old, new, compatible) in CHANGES.items():
        with tempfile.TemporaryDirectory() as folder:
            changed = pathlib.Path(folder)
            shutil.copytree(ROOT / "runtime", changed / "runtime", ignore=shutil.ignore_patterns("*.cpp"))
            text = (changed / file).read_text()
            assert not old or text.count(old) == 1, f"{file} has changed: where is {old!r}?"
            (changed / file).write_text(text.replace(old, new) if old else text)
            status, report = compare(str(ROOT), str(changed))
            assert is_compatible(status) == compatible, f"{name}:\n{report}"
            print(f"{name}: {'compatible' if compatible else 'incompatible'}")


main()
