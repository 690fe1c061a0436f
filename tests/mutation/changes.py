# SPDX-License-Identifier: MIT
"""Which lines of the sources the newest commits wrote."""
import collections
import re
import subprocess


def git(root, *arguments):
    return subprocess.run(['git', *arguments], cwd=root, check=True, capture_output=True, text=True).stdout


def earlier_commits(root):
    """The commits before the last one, newest first. There has to be one: without it every line would be new, or none."""
    commits = git(root, 'rev-list', '--first-parent', 'HEAD').split()[1:]
    if not commits:
        raise SystemExit('there is no commit before the last one to compare with: fetch more of the history')
    return commits


def lines_since(root, commit):
    """File -> the lines of the last commit that were written after `commit`."""
    lines, file = collections.defaultdict(set), ''
    for text in git(root, 'diff', '--unified=0', '--no-color', '--no-renames', commit, 'HEAD').splitlines():
        if text.startswith('+++ '):
            file = text[6:]
        elif found := re.match(r'@@ -\S+ \+(\d+)(?:,(\d+))? @@', text):
            first, count = int(found[1]), int(found[2] or 1)
            lines[file].update(range(first, first + count))
    return lines


def newest(root, mutants_of):
    """The mutants of the lines that the last commit wrote; where it has none, those of the last two commits, and so on.
    `mutants_of` finds the mutants of some files."""
    for commit in earlier_commits(root):
        lines = lines_since(root, commit)
        if found := [m for m in mutants_of(set(lines)) if m.line in lines[m.file]]:
            return found
    raise SystemExit('no commit of this history wrote a line in which a mutant can be set')
