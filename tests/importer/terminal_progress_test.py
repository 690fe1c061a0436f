# SPDX-License-Identifier: MIT
"""Long work of the tool shows on a terminal how far it is, and leaves the line empty: terminal_progress_test.py SINEW SHOWCASE"""
import os
import re
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(__file__), '../support'))
import on_a_terminal  # noqa: E402

SHOWN = re.compile(r'\r\x1b\[K *(\d+) %  sampling')

with tempfile.TemporaryDirectory() as folder:
    sinew, showcase = sys.argv[1:]
    assert on_a_terminal.run([showcase, '.'], folder)[0] == 0
    code, text = on_a_terminal.run([sinew, 'sample', 'twisted-arms.glb', '--fps', '20000', '--format', 'csv', '-o', 'poses.csv'], folder)
    assert code == 0, text
    shown = [int(percent) for percent in SHOWN.findall(text)]
    assert len(shown) >= 2 and shown == sorted(shown) and shown[-1] <= 100, repr(text[:400])
    assert text.endswith('\r\x1b[K') and SHOWN.sub('', text) == '\r\x1b[K', repr(text[-400:])

    code, text = on_a_terminal.run([sinew, 'sample', 'twisted-arms.glb', '--times', '0', '-o', 'pose.json'], folder)
    assert (code, text) == (0, ''), 'work that takes no time shows nothing: ' + repr(text)
print(f'{len(shown)} times, from {shown[0]} to {shown[-1]} %')
