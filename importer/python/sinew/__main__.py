# SPDX-License-Identifier: MIT
"""`python -m sinew` is the command-line tool."""

import sys

from sinew._tool import exec_tool


def main() -> None:
    exec_tool(sys.argv[1:])


if __name__ == "__main__":
    main()
