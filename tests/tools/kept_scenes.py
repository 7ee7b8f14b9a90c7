#!/usr/bin/python3
"""Keeps what Maxima derived from the scenes of the tests in the user's cache folder: a later run of
the tests derives only scenes whose own text or whose sources have changed.

kept_scenes.py fetch FOLDER KEYS SCENE...  writes what is kept of the scenes into FOLDER, where it
                                           removes what is there of the others, and the key of
                                           every scene into KEYS
kept_scenes.py keep FOLDER KEYS SCENE...   keeps what was derived in FOLDER, if each key is still
                                           that in KEYS: the sources were not edited meanwhile
kept_scenes.py files SCENE                 prints the files on which the key of a scene depends
kept_scenes.py folder PART                 prints the cache folder of PART; nothing where none is

A key is a sum of the scene's file and the files that it names, of all sources that take part in a
derivation, and of the names of Maxima and Lisp (variable GSMBP_TEST_MAXIMA). An entry is one file:
a sum of the rest in the first line, then the compressed texts; it appears whole or not at all. An
entry that was damaged is removed and derived again. What was not used for 30 days is removed, and
all but the 1500 entries that were used last."""
import hashlib
import json
import os
import pathlib
import re
import sys
import tempfile
import time
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
# what only compilers, Octave or the documentation read
NOT_DERIVED = {'c', 'catalogue', 'engine', 'fmu', 'fortran', 'manual', 'package_c', 'python',
               'report', 'sweep'}
ENDINGS = '.f', '.json'
DAYS, MOST = 30, 1500


def cache(part):
    """The folder of a part in the user's cache folder, or None."""
    folder = pathlib.Path(os.environ['GSMBP_CACHE'], part)
    if not folder.is_absolute():
        return None
    try:
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        mine = folder.stat().st_uid == os.geteuid() and os.access(folder, os.W_OK)
    except OSError:
        return None
    return folder if mine else None


def sources():
    """All files that take part in a derivation, except the scenes."""
    for top in 'gsmbp', 'share':
        for folder, folders, names in os.walk(ROOT / top):
            if folder == str(ROOT / top):
                skipped = {'compiled'} if top == 'gsmbp' else NOT_DERIVED
                folders[:] = [name for name in folders if name not in skipped]
            yield from (pathlib.Path(folder, name) for name in names if not name.endswith('.md'))
    yield from (ROOT / 'tests/tools' / name for name in ('derive_lot', 'kept_scenes.py'))


def named(file, seen):
    """The file and those that its texts name, and so on."""
    if file in seen or not file.is_file():
        return seen
    seen.add(file)
    for name in re.findall(r'"([^"\n]+)"', file.read_text(errors='replace')):
        if '.' in name and '\0' not in name:
            named((file.parent / name).resolve(), seen)
    return seen


def sum_of(files, *words):
    """The SHA-256 sum of words, and names and contents of files."""
    total = hashlib.sha256(repr(words).encode())
    for file in sorted(files):
        data = file.read_bytes()
        total.update(f'{os.path.relpath(file, ROOT)} {len(data)}\n'.encode() + data)
    return total.hexdigest()


def keys_of(scenes):
    """The key of each scene."""
    common = sum_of(sources(), os.environ['GSMBP_TEST_MAXIMA'])
    return {scene: sum_of(named((ROOT / scene).resolve(), set()), common, scene)
            for scene in scenes}


def entry(folder, scene, key):
    return folder / f'{pathlib.Path(scene).stem}-{key}'


def fetch_one(file, target, scene):
    """Write the kept texts of a scene into the folder target."""
    try:
        head, _, body = file.read_bytes().partition(b'\n')
    except OSError:
        return
    if hashlib.sha256(body).hexdigest().encode() != head:
        file.unlink(missing_ok=True)
        return
    os.utime(file)   # the time of its last use
    for ending, text in json.loads(zlib.decompress(body)).items():
        (target / (pathlib.Path(scene).stem + ending)).write_bytes(text.encode('latin-1'))


def keep_one(file, target, scene):
    """Keep the texts of a scene from the folder target."""
    parts = {ending: target / (pathlib.Path(scene).stem + ending) for ending in ENDINGS}
    if file.exists() or not all(part.is_file() for part in parts.values()):
        return
    texts = {ending: part.read_bytes().decode('latin-1') for ending, part in parts.items()}
    body = zlib.compress(json.dumps(texts).encode(), 1)
    number, new = tempfile.mkstemp(dir=file.parent, prefix='.new-')
    with os.fdopen(number, 'wb') as out:
        out.write(hashlib.sha256(body).hexdigest().encode() + b'\n' + body)
    os.replace(new, file)


def prune(folder):
    """Remove entries that were not used for long, and parts that killed processes left."""
    def used(file):
        try:
            return file.stat().st_mtime
        except OSError:
            return 0
    now = time.time()
    files = sorted(((used(file), file) for file in folder.iterdir()), reverse=True)
    for k, (last, file) in enumerate(files):
        part = file.name.startswith('.new-') and last < now - 86400
        if part or k >= MOST or last < now - DAYS * 86400:
            file.unlink(missing_ok=True)


def main(task, *words):
    if task == 'folder':
        print(cache(words[0]) or '')
        return
    if task == 'files':
        for file in {*sources(), *named((ROOT / words[0]).resolve(), set())}:
            print(os.path.relpath(file, ROOT))
        return
    target, keys_file, *scenes = words
    target, keys_file, folder = pathlib.Path(target), pathlib.Path(keys_file), cache('derived')
    if not folder:
        return
    keys = keys_of(scenes)
    if task == 'fetch':
        keys_file.write_text(json.dumps(keys))
        for scene, key in keys.items():
            for ending in ENDINGS:
                (target / (pathlib.Path(scene).stem + ending)).unlink(missing_ok=True)
            fetch_one(entry(folder, scene, key), target, scene)
        prune(folder)
        return
    before = json.loads(keys_file.read_text())
    for scene, key in keys.items():
        if before.get(scene) == key:
            keep_one(entry(folder, scene, key), target, scene)


main(*sys.argv[1:])
