# SPDX-License-Identifier: MIT
"""Compiles mutated files beside a finished build and links test programs with them. Nothing of the checkout or of that
build is written: mutated files lie in a folder that stands first among those for includes."""
import concurrent.futures
import hashlib
import os
import re
import shutil
import subprocess
import threading

import mutant as mutants_of

HERE = os.path.dirname(os.path.abspath(__file__))
# Two instruction sets tell what a mutant does: the widest that every machine of today has, and none.
TARGETS = 'HWY_SSSE3|HWY_SSE4|HWY_AVX3|HWY_AVX3_DL'
# An index behind the end of a container or an array, and a broken contract, are faults that other builds see with their sanitizers and
# asserts. Here the process ends at them too: what is read there otherwise, and so the verdict, would depend on the machine.
TELLS = '-D_GLIBCXX_ASSERTIONS -UNDEBUG -fsanitize=bounds -fsanitize-undefined-trap-on-error'
LOADER = 'viewer/device/shader_loader.cpp'


class MutatedBuild:
    """`numbered`: number -> mutant. Switched: all of them in one build, behind their numbers; otherwise the only one in place."""

    def __init__(self, tree, folder, numbered, jobs, switched=True):
        self.tree, self.folder, self.jobs, self.switched = tree, folder, jobs, switched
        self.numbered, self.stillborn = dict(numbered), set()
        self.overlay = f'{folder}/files'
        self.linked, self.lock = {}, threading.Lock()
        self.launcher = ['ccache'] if shutil.which('ccache') else []
        shutil.rmtree(folder, ignore_errors=True)
        os.makedirs(self.overlay)
        self.files = {m.file for m in self.numbered.values() if not is_shader(m.file)}
        if any(is_shader(m.file) for m in self.numbered.values()):
            self.files.add(LOADER)
        for file in self.files:
            self.write(file)
        affected = set().union(*(self.tree.users[file] for file in self.files)) if self.files else set()
        self.wanted = {o for o in affected if o in self.tree.commands}
        self.compiled = {}

    def write(self, file):
        with open(f'{self.tree.root}/{file}', 'rb') as source:
            text = source.read()
        here = [(n, m) for n, m in self.numbered.items() if m.file == file]
        if self.switched:
            text = mutants_of.set_switched(text, here)
        elif here:
            text = mutants_of.set_alone(text, here[0][1])
        if file == LOADER and self.switched:
            text = with_shaders_of_files(text)
        for path in (f'{self.overlay}/{file}', f'{self.overlay}/sinew/{file}'):
            os.makedirs(os.path.dirname(path), exist_ok=True)
            if path.endswith(file) and 'sinew/' + file in path:
                os.path.lexists(path) or os.symlink(f'{self.overlay}/{file}', path)
            else:
                with open(path + '.new', 'wb') as out:
                    out.write(text)
                os.replace(path + '.new', path)  # others compile at this moment

    # -- compiling

    def compile(self, objects):
        todo = [o for o in sorted(objects) if o in self.wanted and o not in self.compiled]
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            for target, path in zip(todo, pool.map(self.compile_one, todo)):
                self.compiled[target] = path

    def compile_one(self, target):
        for _ in range(12):
            errors = self.try_compile(target)
            if errors is None:
                return f'{self.folder}/objects/{target}'
            with self.lock:
                if not self.drop_where(errors):
                    raise RuntimeError(f'{target} does not compile:\n{errors[:3000]}')
        raise RuntimeError(f'{target} does not compile')

    def try_compile(self, target):
        source = self.tree.source[target]
        out = f'{self.folder}/objects/{target}'
        os.makedirs(os.path.dirname(out), exist_ok=True)
        command = self.tree.commands[target]
        command = re.sub(r'\(HWY_SSSE3\)', f'({TARGETS})', command)
        compiler, rest = re.sub(r' -Werror\b| -W[a-z][\w-]*| -O3', '', command).split(' ', 1)
        command = f'{compiler} -I{self.overlay} {rest}'
        command = command.replace(' -o ' + target, f' -O1 -w {TELLS} -fmax-errors=200 -include {HERE}/mutation_switch.h -o {out}')
        if source in self.files:
            command = command.replace(f' -c {self.tree.root}/{source}', f' -c {self.overlay}/{source}')
        elif os.path.basename(source).startswith('unity_'):
            batch = os.path.normpath(f'{self.tree.root}/{source}')
            command = command.replace(f' -c {batch}', f' -c {self.batch(batch)}')
        done = subprocess.run(' '.join(self.launcher) + ' ' + command, shell=True, cwd=self.tree.build, capture_output=True, text=True)
        return None if done.returncode == 0 else done.stderr

    def batch(self, path):
        """A copy of CMake's file that includes several sources, with the mutated ones in their places."""
        with open(path, encoding='utf-8') as file:
            text = re.sub(f'"{re.escape(self.tree.root)}/([^"]+)"', lambda m: f'"{self.overlay}/{m[1]}"' if m[1] in self.files else m[0], file.read())
        copy = f'{self.folder}/batches/{hashlib.sha256(path.encode()).hexdigest()[:16]}.cxx'
        os.makedirs(os.path.dirname(copy), exist_ok=True)
        with open(copy, 'w', encoding='utf-8') as out:
            out.write(text)
        return copy

    def drop_where(self, errors):
        """Takes back the mutants of lines that do not compile: they are none."""
        dropped = set()
        place = r'/files/(?:sinew/)?([\w/.-]+):(\d+)'
        for file, line in re.findall(place + r'(?::\d+)?: error', errors) or re.findall(place, errors):
            for number, m in self.numbered.items():
                last = m.line + self.lines_of(m)
                if m.file == file and m.line <= int(line) <= last:
                    dropped.add(number)
        exact = {n for n in dropped if not self.lines_of(self.numbered[n])}
        for number in exact or dropped:
            self.stillborn.add(number)
            del self.numbered[number]
        for file in self.files:
            self.write(file)
        return bool(dropped)

    def lines_of(self, m):
        with open(f'{self.tree.root}/{m.file}', 'rb') as source:
            return source.read()[m.start:m.end].count(b'\n')

    # -- linking

    def program(self, name):
        """The program linked with what is mutated; the first call for it compiles."""
        if name in self.linked:
            return self.linked[name]
        if not self.tree.objects_of(name) & self.wanted:
            return None
        self.compile(self.tree.objects_of(name))
        words = []
        for word in self.tree.programs[name].split():
            if word in self.tree.libraries:
                word = self.library(word)
            elif word == f'bin/{name}':
                os.makedirs(f'{self.folder}/bin', exist_ok=True)
                word = f'{self.folder}/bin/{name}'
            words.append(self.compiled.get(word, word))
        at = words.index('-o')
        words.insert(at, self.switch())
        subprocess.run(' '.join(words), shell=True, cwd=self.tree.build, check=True)
        self.linked[name] = f'{self.folder}/bin/{name}'
        return self.linked[name]

    def library(self, archive):
        objects = self.tree.libraries[archive]
        # The build's own archives hide their copies of inline functions; a mutant in one of those must be seen by all.
        if not any(o in self.compiled for o in objects):
            return archive
        path = f'{self.folder}/lib/{os.path.basename(archive)}'
        os.makedirs(os.path.dirname(path), exist_ok=True)
        if os.path.exists(path):
            os.remove(path)
        subprocess.run(['ar', 'qcT', path, *(self.compiled.get(o, f'{self.tree.build}/{o}') for o in objects)], cwd=self.tree.build, check=True)
        return path

    def switch(self):
        path = f'{self.folder}/mutation_switch.o'
        if not os.path.exists(path):
            subprocess.run([*self.launcher, 'c++', '-std=c++20', '-O1', f'-I{HERE}/../..', '-c', f'{HERE}/mutation_switch.cpp', '-o', path], check=True)
        return path


def is_shader(file):
    return file.endswith(('.glsl', '.frag', '.vert', '.comp'))


def with_shaders_of_files(text):
    """The loader with shaders that come from files where those are named."""
    arrays = dict(re.findall(rb'(k\w+)\[\] =\n#include "([\w.]+)\.inc"', text))
    for array, shader in arrays.items():
        text = text.replace(b'return ' + array + b';', b'{ const auto changed = mutated_shader("' + shader + b'"); return changed.empty() ? '
                            b'std::span<const std::uint32_t>(' + array + b') : changed; }')
    return text.replace(b'namespace sinew::viewer {', b'std::span<const std::uint32_t> mutated_shader(const char* name); namespace sinew::viewer {', 1)


def compile_shaders(root, folder, mutant):
    """Every shader that includes the mutated file, as SPIR-V; None where one does not compile."""
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(f'{root}/viewer/shaders', f'{folder}/shaders')
    with open(f'{root}/{mutant.file}', 'rb') as source:
        text = source.read()
    lines = b'\n' * text[mutant.start:mutant.end].count(b'\n')
    with open(f'{folder}/shaders/{os.path.basename(mutant.file)}', 'wb') as out:
        out.write(text[:mutant.start] + mutant.mutated.encode() + lines + text[mutant.end:])
    os.makedirs(f'{folder}/spirv')
    names = set(os.listdir(f'{folder}/shaders'))
    for name in sorted(n for n in names if n.endswith(('.frag', '.vert'))):
        if os.path.basename(mutant.file) in included(f'{folder}/shaders', name, set()):
            done = subprocess.run(['glslc', '--target-env=vulkan1.3', '-O', '-o', f'{folder}/spirv/{name}.spv', f'{folder}/shaders/{name}'],
                                  capture_output=True)
            if done.returncode != 0:
                return None
    return f'{folder}/spirv'


def included(folder, name, seen):
    if name not in seen:
        seen.add(name)
        with open(f'{folder}/{name}', encoding='utf-8') as file:
            for other in re.findall(r'^\s*#include "([\w.]+)"', file.read(), re.M):
                included(folder, other, seen)
    return seen
