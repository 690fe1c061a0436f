# SPDX-License-Identifier: MIT
"""Runs a program whose stderr is a terminal: run(COMMAND) answers its exit code and all that it wrote there."""
import os
import pty
import subprocess


def run(command, folder):
    ours, theirs = pty.openpty()
    program = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=theirs)
    os.close(theirs)
    written = b''
    while True:
        try:
            some = os.read(ours, 4096)
        except OSError:  # the last program that had the other end has closed it
            some = b''
        if not some:
            break
        written += some
    os.close(ours)
    return program.wait(), written.decode()
