# SPDX-License-Identifier: MIT
"""The viewer counts pictures and rays on a terminal, and leaves the line empty: terminal_progress_test.py SINEW-VIEWER SHOWCASE"""
import os
import re
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(__file__), '../support'))
import on_a_terminal  # noqa: E402

WIPED = '\r\x1b[K'

with tempfile.TemporaryDirectory() as folder:
    viewer, showcase = sys.argv[1:]
    os.environ['SINEW_CACHE'] = os.path.join(folder, 'cache')  # an empty one: what is kept takes no time
    assert on_a_terminal.run([showcase, '.'], folder)[0] == 0
    pictures = [viewer, 'twisted-arms.glb', '--size', '32x32', '--headless']
    code, text = on_a_terminal.run([*pictures, 'out/', '--frames', '0:2'], folder)
    shown = re.search(r'\rpicture 1 of 3, \d+ s left\x1b\[K\rpicture 2 of 3, \d+ s left\x1b\[K', text)
    assert code == 0 and shown and text.endswith(WIPED), repr(text)
    code, text = on_a_terminal.run([*pictures, 'one.png'], folder)
    assert code == 0 and text.endswith(WIPED) and 'picture' not in text, repr(text)

    for work, options in {'reading': [], 'centers of rotation': ['--skinning', 'center-of-rotation'],
                          'casting rays': ['--ao', 'rays']}.items():
        code, text = on_a_terminal.run([*pictures, 'long.png', *options], folder)
        shown = [int(percent) for percent in re.findall(rf'\r{work}: *(\d+) %', text)]
        assert code == 0 and shown and shown == sorted(shown) and text.rindex(WIPED) > text.rindex('%'), repr(text)
