#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the window shows is the picture that --headless writes: from the same options, and after keys and mouse have asked for the same.
usage: window_pictures_test.py SINEW-VIEWER    Exit code 77 = skipped, because a tool is missing."""
import base64
import json
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import time

VIEWER = sys.argv[1]
WIDTH, HEIGHT = 320, 200
NEAR_RED, FAR_BLUE = (220, 30, 30), (30, 30, 220)
PATIENCE_S = 120  # only what never happens takes so long: machines differ in speed


def model():
    """An arm of skin that keys of step twist, so that a picture does not depend on its second, before a small red square and a
    larger blue one behind it. Two clips, a camera, a variant."""
    binary, views, accessors = b'', [], []

    def add(numbers, code, component, kind, **bounds):
        nonlocal binary
        data = struct.pack(f'<{len(numbers)}{code}', *numbers)
        views.append({'buffer': 0, 'byteOffset': len(binary), 'byteLength': len(data)})
        binary += data + b'\0' * (-len(data) % 4)
        width = {'SCALAR': 1, 'VEC3': 3, 'VEC4': 4, 'MAT4': 16}[kind]
        accessors.append({'bufferView': len(views) - 1, 'componentType': component, 'count': len(numbers) // width, 'type': kind, **bounds})
        return len(accessors) - 1

    rows = 13
    places, joints, weights, triangles = [], [], [], []
    for row in range(rows):
        up = 2.0 * row / (rows - 1)
        share = min(max(1.5 * (up - 0.66), 0.0), 1.0)
        for x, z in ((-0.3, 0.3), (0.3, 0.3), (0.3, -0.3), (-0.3, -0.3)):
            places += [x, up, z]
            joints += [0, 1, 0, 0]
            weights += [1.0 - share, share, 0.0, 0.0]
    for row in range(rows - 1):
        for side in range(4):
            a, b = 4 * row + side, 4 * row + (side + 1) % 4
            triangles += [a, b, a + 4, b, b + 4, a + 4]
    arm = {'attributes': {'POSITION': add(places, 'f', 5126, 'VEC3', min=[-0.3, 0, -0.3], max=[0.3, 2, 0.3]),
                          'JOINTS_0': add(joints, 'B', 5121, 'VEC4'), 'WEIGHTS_0': add(weights, 'f', 5126, 'VEC4')},
           'indices': add(triangles, 'H', 5123, 'SCALAR'), 'material': 2,
           'extensions': {'KHR_materials_variants': {'mappings': [{'material': 1, 'variants': [0]}]}}}

    def square(half, z, material):
        corners = [-half, -half, z, half, -half, z, half, half, z, -half, half, z]
        return {'attributes': {'POSITION': add(corners, 'f', 5126, 'VEC3', min=[-half, -half, z], max=[half, half, z])},
                'indices': add([0, 1, 2, 0, 2, 3], 'H', 5123, 'SCALAR'), 'material': material}

    def unlit(color):
        return {'doubleSided': True, 'pbrMetallicRoughness': {'baseColorFactor': [*color, 1]}, 'extensions': {'KHR_materials_unlit': {}}}

    red, blue = square(0.15, 1.2, 0), square(0.5, -1.2, 1)
    times = add([0.0, 1000.0, 2000.0], 'f', 5126, 'SCALAR', min=[0], max=[2000])
    turns = add([0, 0, 0, 1, 0, 0.866025, 0, 0.5, 0.5, 0.5, 0.5, 0.5], 'f', 5126, 'VEC4')
    moves = add([0, 0.5, 0, 0.8, 0.5, 0, -0.8, 0.5, 0], 'f', 5126, 'VEC3')
    unbound = add([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1], 'f', 5126, 'MAT4')

    def clip(name, node, path, output):
        return {'name': name, 'samplers': [{'input': times, 'output': output, 'interpolation': 'STEP'}],
                'channels': [{'sampler': 0, 'target': {'node': node, 'path': path}}]}

    return {'asset': {'version': '2.0'}, 'scene': 0, 'scenes': [{'nodes': [0, 1, 3, 4, 5]}],
            'extensionsUsed': ['KHR_materials_unlit', 'KHR_materials_variants'],
            'extensions': {'KHR_materials_variants': {'variants': [{'name': 'other'}]}},
            'nodes': [{'mesh': 0, 'skin': 0}, {'children': [2]}, {'translation': [0, 1, 0]}, {'mesh': 1, 'translation': [0, 0.5, 0]},
                      {'mesh': 2, 'translation': [0, 0.5, 0]}, {'camera': 0, 'translation': [0.5, 1.2, 5]}],
            'meshes': [{'primitives': [arm]}, {'primitives': [red]}, {'primitives': [blue]}],
            'skins': [{'joints': [1, 2], 'inverseBindMatrices': unbound}],
            'cameras': [{'type': 'perspective', 'perspective': {'yfov': 0.7, 'znear': 0.1}}],
            'materials': [unlit([0.9, 0, 0]), unlit([0, 0, 0.9]), {'pbrMetallicRoughness': {'metallicFactor': 0}, 'doubleSided': True}],
            'animations': [clip('twist', 2, 'rotation', turns), clip('move', 4, 'translation', moves)],
            'bufferViews': views, 'accessors': accessors,
            'buffers': [{'byteLength': len(binary), 'uri': 'data:application/octet-stream;base64,' + base64.b64encode(binary).decode()}]}


class Picture:
    def __init__(self, ppm):
        magic, self.width, self.height, largest, self.rgb = *(int(word) if word.isdigit() else word for word in ppm.split(maxsplit=4)[:4]), b''
        assert magic == b'P6' and largest == 255
        self.rgb = ppm[-3 * self.width * self.height:]

    def distance(self, other):
        """The largest difference of a colour, in steps of 256."""
        if (self.width, self.height) != (other.width, other.height):
            return 256
        return max(abs(a - b) for a, b in zip(self.rgb, other.rgb))

    def of_color(self, color):
        """How many pixels have it, and their middle."""
        near = [i for i in range(self.width * self.height) if all(abs(self.rgb[3 * i + c] - color[c]) < 48 for c in range(3))]
        count = max(len(near), 1)
        return len(near), sum(i % self.width for i in near) / count, sum(i // self.width for i in near) / count


class Failure(Exception):
    pass


def new_server():
    """A server, and the name of its display, which it picks itself: two tests at the same time do not take the same one. It would
    begin anew when its last window closes, and the next one might find it closed."""
    ours, theirs = os.pipe()
    server = subprocess.Popen(['Xvfb', '-displayfd', str(theirs), '-screen', '0', '1280x800x24', '-nolisten', 'tcp', '-noreset'], pass_fds=[theirs],
                              stderr=subprocess.DEVNULL)
    os.close(theirs)
    with os.fdopen(ours) as told:
        return server, ':' + told.readline().strip()


class Desk:
    """A virtual display, a folder with the model, and at most one window."""

    def __init__(self, folder):
        self.folder, self.window, self.program = folder, None, None
        self.file = f'{folder}/model.gltf'
        self.save(model())
        self.environment = {**os.environ, 'SINEW_CACHE': f'{folder}/cache', 'MAGICK_THREAD_LIMIT': '1'}
        self.environment.pop('WAYLAND_DISPLAY', None)
        self.server, self.environment['DISPLAY'] = new_server()

    def save(self, json_of_file):
        """Moves the new file over the old one at once, as programs save."""
        with open(f'{self.folder}/new', 'w', encoding='utf-8') as out:
            json.dump(json_of_file, out)
        os.replace(f'{self.folder}/new', self.file)

    def end(self):
        for process in (self.program, self.server):
            if process is not None:
                process.terminate()  # a server that is killed leaves its display locked
                process.wait()

    def run(self, *command, **more):
        return subprocess.run(command, env=self.environment, check=True, capture_output=True, timeout=PATIENCE_S, **more).stdout

    def until(self, what, holds):
        last = time.monotonic() + PATIENCE_S
        while not holds():
            if self.program.poll() is not None:
                raise Failure(f'the viewer ended by itself before: {what}')
            if time.monotonic() > last:
                raise Failure(what)
            time.sleep(0.2)

    def all_options(self, options, size=(WIDTH, HEIGHT)):
        smoothing = [] if '--smoothing' in options else ['--smoothing', 'off']
        return [VIEWER, '--size', '{}x{}'.format(*size), *smoothing, *options, self.file]

    def headless(self, options, size=(WIDTH, HEIGHT)):
        self.run(*self.all_options(['--headless', f'{self.folder}/picture.png', *options], size))
        return Picture(self.run('convert', f'{self.folder}/picture.png', '-depth', '8', 'ppm:-'))

    def open(self, options, size=(WIDTH, HEIGHT)):
        self.program = subprocess.Popen(self.all_options(['--validate', *options], size), env=self.environment, stderr=subprocess.PIPE, text=True)

        def found():
            names = subprocess.run(['xdotool', 'search', '--onlyvisible', '--name', 'sinew$'], env=self.environment, capture_output=True, text=True, check=False)
            self.window = names.stdout.split()[0] if names.stdout else None
            return self.window is not None
        self.until('the window opens', found)
        self.run('xdotool', 'windowfocus', self.window)

    def close(self):
        self.press('q')
        said = self.program.communicate(timeout=PATIENCE_S)[1]
        code, self.program = self.program.returncode, None
        said = [line for line in said.splitlines() if 'ambient visibility' not in line and not line.endswith(': read again')]
        if code != 0 or said:
            raise Failure(f'closing ends with {code}: {said}')

    def press(self, *keys):
        self.run('xdotool', 'key', '--clearmodifiers', *keys)

    def mouse(self, *words):
        self.run('xdotool', *(self.window if word == 'WINDOW' else str(word) for word in words))

    def drag(self, button, start, end):
        self.mouse('mousemove', '--window', 'WINDOW', *start, 'mousedown', button)
        for step in range(1, 5):
            time.sleep(0.1)
            self.mouse('mousemove', '--window', 'WINDOW', *(a + (b - a) * step // 4 for a, b in zip(start, end)))
        time.sleep(0.1)
        self.mouse('mouseup', button)

    def shot(self):
        return Picture(self.run('import', '-silent', '-window', self.window, '-depth', '8', 'ppm:-'))

    def still(self):
        """The picture once it stays as it is for a second."""
        last = [self.shot(), self.shot()]

        def stands():
            time.sleep(0.5)
            last.append(self.shot())
            return last[-1].rgb == last[-2].rgb == last[-3].rgb
        self.until('the picture stands still', stands)
        return last[-1]

    def sees(self, what, holds):
        """Waits until the picture is one of which that holds, and answers it."""
        last = []

        def seen():
            last.append(self.shot())
            return holds(last[-1])
        self.until(what, seen)
        print('ok:', what, flush=True)
        return last[-1]

    def shows(self, what, options, size=(WIDTH, HEIGHT)):
        expected, last = self.headless(options, size), []

        def same():
            last.append(self.shot())
            return last[-1].distance(expected) <= 1
        try:
            self.until(what, same)
        except Failure:
            raise Failure(f'{what}: it differs by {last[-1].distance(expected)} from the picture of {options}') from None
        print('ok:', what, flush=True)


OF_OPTIONS = {
    'the first clip, framed': [],
    'a clip and a time': ['--clip', '1', '--time', '1500'],
    'the rest pose': ['--clip', 'none'],
    'a placed camera': ['--eye', '1,2,3', '--target', '0.2,0.8,0', '--fov', '30', '--time', '1500', '--smoothing', 'on'],
    'the camera of the file, another skinning': ['--camera', '0', '--skinning', 'center-of-rotation', '--time', '1500'],
    'one pose framed, another variant, rays': ['--frame', 'pose', '--clip', '1', '--time', '1500', '--variant', '0', '--ao', 'rays', '--key-poses', '2'],
    'the skeleton in other light': ['--skeleton', '--ground', 'grid', '--exposure', '1', '--environment', 'plain', '--no-shadows', '--frame', 'follow', '--clip', '1', '--time', '1500'],
}


def options_of_the_window_are_those_of_a_picture(desk):
    for what, options in OF_OPTIONS.items():
        desk.open(options)
        desk.press('h')
        desk.shows(what, options)
        desk.close()


# Each step is taken from where the one before it ended.
KEYS = [
    ('d', ['--skinning', 'dual-quaternion']), ('d', ['--skinning', 'center-of-rotation']), ('d', []),
    ('a', ['--no-ao']), ('a', []), ('o', ['--show', 'ao']), ('o', []),
    ('v', ['--show', 'ao']), ('v', ['--show', 'normals']), ('v', ['--show', 'depth']), ('v', ['--show', 'level']), ('v', []),
    ('g', ['--ground', 'grid']), ('g', ['--ground', 'none']), ('g', []), ('s', ['--skeleton']), ('s', []),
    ('Tab', []),
]


def keys_do_what_options_do(desk):
    at = ['--time', '1500']
    desk.open(at)
    desk.press('h')
    for key, options in KEYS:
        desk.press(key)
        desk.shows(f'after {key}', at + options)
    desk.press('n', 'f')
    desk.shows('the next clip, framed', ['--clip', '1'])
    desk.press('p', 'f')
    desk.shows('the one before it', ['--clip', '0'])
    size = (420, 200)
    desk.run('xdotool', 'windowsize', desk.window, *map(str, size))
    expected = desk.headless([], size)

    def is_framed():  # the display knows the new size before the viewer does
        desk.press('f')
        return desk.shot().distance(expected) <= 1
    desk.until('a wider window, framed again', is_framed)
    desk.close()


def the_mouse_moves_the_camera(desk):
    middle, right, down, turned = (160, 100), (200, 100), (160, 130), (190, 100)
    options = ['--environment', 'none', '--ground', 'none', '--no-shadows', '--eye', '0,0.5,6', '--target', '0,0.5,0']
    desk.open(options)
    desk.press('h')
    desk.shows('the arm between two squares', options)
    count, x, y = desk.still().of_color(NEAR_RED)
    at_rest = lambda picture: abs(picture.of_color(NEAR_RED)[1] - x) < 2 and abs(picture.of_color(NEAR_RED)[2] - y) < 2
    is_right = lambda picture: picture.of_color(NEAR_RED)[1] > x + 30 and abs(picture.of_color(NEAR_RED)[2] - y) < 2
    is_down = lambda picture: picture.of_color(NEAR_RED)[2] > y + 20 and abs(picture.of_color(NEAR_RED)[1] - x) < 2
    for name, button in (('the right button', 3), ('the middle button', 2)):
        for way, end, holds in (('to the right', right, is_right), ('down', down, is_down)):
            desk.drag(button, middle, end)
            desk.sees(f'{name} moves {way}', holds)
            desk.drag(button, end, middle)
            desk.sees('and back', at_rest)
    desk.mouse('keydown', 'shift')
    desk.drag(1, middle, down)
    desk.mouse('keyup', 'shift')
    far_blue = desk.sees('shift and the left button move down', is_down).of_color(FAR_BLUE)
    if far_blue[2] < y + 10:
        raise Failure('and do not turn: what is far goes along')
    desk.drag(3, down, middle)
    desk.sees('and the right one back', at_rest)
    desk.mouse('click', 4, 'click', 4)
    desk.sees('the wheel goes nearer', lambda picture: picture.of_color(NEAR_RED)[0] > 1.2 * count)
    desk.mouse('click', 5, 'click', 5, 'click', 5, 'click', 5)
    desk.sees('and away', lambda picture: 0 < picture.of_color(NEAR_RED)[0] < 0.9 * count)
    desk.mouse('click', 4, 'click', 4)
    desk.sees('and nearer again', lambda picture: picture.of_color(NEAR_RED)[0] == count)
    desk.drag(1, middle, turned)
    desk.sees('the left button turns what is near to the right', lambda picture: picture.of_color(NEAR_RED)[1] > picture.of_color(FAR_BLUE)[1] + 5)
    desk.close()


def dragging_goes_on_from_the_camera_of_the_file(desk):
    options = ['--camera', '0', '--environment', 'none', '--ground', 'none', '--no-shadows']
    desk.open(options)
    desk.press('h')
    desk.shows('the camera of the file', options)
    before = desk.still()
    _, x, y = before.of_color(NEAR_RED)
    desk.drag(3, (160, 100), (172, 100))
    desk.sees('it moves on from there', lambda p: 8 < p.of_color(NEAR_RED)[1] - x < 40 and abs(p.of_color(NEAR_RED)[2] - y) < 3)
    desk.press('f')
    desk.sees('framing everything shows more', lambda p: p.distance(before) > 100)
    desk.close()
    desk.open(options)
    desk.press('h')
    desk.shows('the camera of the file again', options)
    desk.press('f')
    desk.sees('framing everything leaves it', lambda p: p.distance(before) > 100)
    desk.close()


def the_panel_leaves_the_picture_its_room(desk):
    desk.open(['--environment', 'none', '--ground', 'none', '--no-shadows'], (640, 400))
    desk.press('space')  # the panel shows the time
    beside = desk.still().of_color(FAR_BLUE)
    desk.press('h')
    desk.sees('the scene is framed beside the panel', lambda p: p.of_color(FAR_BLUE)[1] < beside[1] - 20)
    whole = desk.still()
    desk.press('h')
    desk.sees('and again', lambda p: abs(p.of_color(FAR_BLUE)[1] - beside[1]) < 2)
    desk.press('h')
    desk.sees('and without it as before', lambda p: p.rgb == whole.rgb)
    desk.drag(1, (320, 200), (350, 200))
    desk.sees('the camera turns', lambda p: p.rgb != whole.rgb)
    turned = desk.still()
    desk.press('h')
    desk.sees('the panel is back', lambda p: p.distance(turned) > 30)
    desk.still()
    desk.drag(1, (60, 20), (80, 20))
    desk.still()
    desk.press('h')
    desk.sees('the view stays where the user turned it, whatever the panel does', lambda p: p.rgb == turned.rgb)
    desk.close()


def a_file_that_is_read_again_keeps_what_was_chosen(desk):
    options = ['--variant', '0', '--frame', 'follow', '--clip', '1', '--time', '1500']
    desk.open(['--watch', *options])
    desk.press('h')
    desk.shows('a file that is watched', options)
    changed = model()
    changed['materials'][1]['pbrMetallicRoughness']['baseColorFactor'] = [0, 0.9, 0, 1]
    desk.save(changed)
    desk.sees('the variant of the changed file', lambda p: p.of_color((30, 220, 30))[0] > 100)
    desk.save(model())
    desk.shows('the file as it was', options)
    desk.close()


def main():
    for tool in ('Xvfb', 'xdotool', 'import', 'convert'):
        if shutil.which(tool) is None:
            print(f'skipped: {tool} is not installed')
            return 77
    with tempfile.TemporaryDirectory() as folder:
        desk = Desk(folder)
        try:
            for part in (options_of_the_window_are_those_of_a_picture, keys_do_what_options_do, the_mouse_moves_the_camera,
                         dragging_goes_on_from_the_camera_of_the_file, the_panel_leaves_the_picture_its_room,
                         a_file_that_is_read_again_keeps_what_was_chosen):
                part(desk)
        except Failure as failure:
            print('FAILED:', failure)
            if desk.program is not None:
                desk.program.kill()
                print('--- what the viewer wrote:', desk.program.communicate()[1])
            return 1
        finally:
            desk.end()
    return 0


if __name__ == '__main__':
    sys.exit(main())
