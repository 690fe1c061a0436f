# SPDX-License-Identifier: MIT
"""What a finished Ninja build knows of itself: how each object is compiled, what it includes, what each test program links."""
import collections
import json
import os
import re
import subprocess

# Programs that read sources or archives instead of running code.
NOT_RUN = {'sinew-test-architecture', 'sinew-test-bare', 'sinew-test-headers', 'sinew-test-own-copies-engine', 'sinew-test-own-copies-fast_engine'}


class Tree:
    def __init__(self, root, build):
        self.root, self.build = root, build
        with open(f'{build}/compile_commands.json', encoding='utf-8') as file:
            entries = json.load(file)
        self.commands, self.source = {}, {}
        for entry in entries:
            target = re.search(r' -o (\S+)', entry['command']).group(1)
            self.commands[target] = entry['command']
            self.source[target] = os.path.relpath(entry['file'], root)
        self.libraries, self.programs = {}, {}
        tests = ['sinew-tests'] if re.search('^sinew-tests:', self.ninja('-t', 'targets', 'all'), re.M) else []
        for command in self.ninja('-t', 'commands', 'all', *tests).splitlines():
            archive = re.search(r' qc (\S+\.a)\s+(.*?)(?: && |$)', command)
            program = re.search(r'^: && (.*? -o bin/(sinew-test-\S+) .*?)(?: && |$)', command)
            if archive:
                self.libraries[archive.group(1)] = [word for word in archive.group(2).split() if word.endswith('.o')]
            elif program and program.group(2) not in NOT_RUN and os.path.exists(f'{build}/bin/{program.group(2)}'):
                self.programs[program.group(2)] = program.group(1)
        self.users = collections.defaultdict(set)  # file of the project -> objects that include it
        self.read_dependencies()

    def ninja(self, *arguments):
        return subprocess.run(['ninja', '-C', self.build, '--quiet', *arguments], check=True, capture_output=True, text=True).stdout

    def read_dependencies(self):
        target = ''
        for line in self.ninja('-t', 'deps').splitlines():
            if line.endswith('(VALID)') or line.endswith('(STALE)'):
                target = line.split(':')[0]
            elif line.startswith('    ') and target in self.commands:
                path = os.path.relpath(os.path.normpath(os.path.join(self.build, line.strip())), self.root)
                path = path.removeprefix(f'{os.path.relpath(self.build, self.root)}/include/sinew/')
                if not path.startswith('..') and not path.startswith('build/'):
                    self.users[path].add(target)

    def objects_of(self, program):
        """All objects that a program can link."""
        words = self.programs[program].split()
        found = [word for word in words if word.endswith('.o')]
        for word in words:
            found += self.libraries.get(word, [])
        return set(found)

    def product_object(self, path):
        """The object of a library that shows clang the file: its own, one of the same stem, or one that includes it."""
        libraries = {object_ for objects in self.libraries.values() for object_ in objects}
        users = sorted(o for o in self.users.get(path, ()) if o in libraries and not self.source[o].startswith('tests/'))
        stem = os.path.splitext(path)[0]
        near = os.path.dirname(path)
        users.sort(key=lambda o: (os.path.splitext(self.source[o])[0] != stem, os.path.dirname(self.source[o]) != near, o))
        return users[0] if users else None

    def tests_of_room(self, path):
        """Programs whose sources lie in the folder of tests that bears the name of the file's folder."""
        parts = path.split('/')
        room = parts[1] if parts[0] == 'runtime' else parts[0]
        if ('geometry_cache' in path or '/bake/' in path) and '/cost/' not in path:
            room = 'geometry_cache'
        return [name for name, command in sorted(self.programs.items()) if f' tests/{room}/' in command]
