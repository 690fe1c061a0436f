#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What a build by default makes: the libraries, the programs of the product, and no object of a test.
usage: default_build_test.py BUILD"""
import re
import subprocess
import sys

PRODUCT = {'sinew', 'sinew-viewer', 'sinew-bake-flag'}  # the last one makes a file that the viewer holds

build = sys.argv[1]
commands = subprocess.run(['ninja', '-C', build, '--quiet', '-t', 'commands', 'all'], check=True, capture_output=True, text=True).stdout
outputs = re.findall(r' -o (\S+)', commands)
programs = {o.removeprefix('bin/') for o in outputs if o.startswith('bin/')}
compiled = [o for o in outputs if o.endswith('.o')]
of_tests = [o for o in compiled if o.startswith(('tests/', 'samples/')) and not o.startswith('samples/showcase/')]
print(f'{len(compiled)} objects, programs: {", ".join(sorted(programs))}')
if of_tests:
    sys.exit(f'{len(of_tests)} objects of tests and samples are built by default: {", ".join(of_tests[:5])}')
if not programs or programs - PRODUCT:
    sys.exit(f'programs of a default build: {", ".join(sorted(programs))}, not {", ".join(sorted(PRODUCT))}')
