"""Compiles the C of the scene into a library that the module loads.

The wheel is py3-none-<platform>. The scene is the folder that holds table.json; render.py makes
of the table what the module does not read at run time: the loops over states in C, the stubs for
type checkers; stub.py the rest of these.
"""
import glob
import json
import os
import subprocess
import sys
import tempfile

from setuptools import Distribution, setup
from setuptools._distutils.ccompiler import new_compiler
from setuptools._distutils.sysconfig import customize_compiler
from setuptools.command.build_py import build_py
try:
    from setuptools.command.bdist_wheel import bdist_wheel
except ImportError:
    from wheel.bdist_wheel import bdist_wheel

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)   # pip does not
import render  # noqa: E402
import stub  # noqa: E402

NAME = os.path.basename(os.path.dirname(glob.glob(os.path.join(HERE, 'src', '*', 'table.json'))[0]))
with open(os.path.join(HERE, 'src', NAME, 'table.json'), encoding='utf-8') as file:
    TABLE = json.load(file)
FLAGS = ['-std=c99', '-O2', '-fPIC', '-ffp-contract=off', '-fcx-limited-range', '-g0']
SUNDIALS = ['sundials_cvode', 'sundials_nvecserial', 'sundials_sunmatrixdense',
            'sundials_sunlinsoldense']


def run_time(compiler, folder):
    """The objects of the run time in the new FOLDER, kept in the user's cache folder (cache)."""
    def cache(*words, **options):
        return subprocess.run(['sh', os.path.join(HERE, 'cache'), *words], check=False, **options)
    before = os.getcwd()
    os.chdir(os.path.join(HERE, 'c'))
    try:
        names = [name for name in sorted(glob.glob('**/*.[ch]', recursive=True))
                 if os.path.dirname(name) not in ('scene', 'host/cvode', 'host/ipopt',
                                                  'host/nlopt')]
        texts = b''
        for name in names:
            with open(name, 'rb') as file:
                texts += name.encode() + b'\n' + file.read()
        said = cache('key', *compiler.compiler_so, *FLAGS, input=texts, stdout=subprocess.PIPE)
        key = said.stdout.decode().strip()
        if cache('take', key, folder).returncode != 0:
            compiler.compile([name for name in names if name.endswith('.c')], output_dir=folder,
                             include_dirs=['.'], extra_postargs=FLAGS)
            cache('add', key, folder)
    finally:
        os.chdir(before)
    return sorted(glob.glob(os.path.join(folder, '**', '*.o'), recursive=True))


def found(compiler, name):
    """The words by which the compiler finds a library of others; None: it is not installed."""
    header = os.path.join(HERE, 'c', 'host', name, 'header_%s.h' % name)
    said = subprocess.run(['sh', os.path.join(HERE, 'find_header'), header, *compiler.compiler_so],
                          check=False, stdout=subprocess.PIPE)
    return said.stdout.decode().split() if said.returncode == 0 else None


def build_library(compiler, name, common, libraries, target):
    """A library of its own over SUNDIALS, Ipopt or NLopt, where that is installed: what else the
    module does needs none of them."""
    home = os.path.join(HERE, 'c')
    words = found(compiler, name)
    if words is None:
        return
    with tempfile.TemporaryDirectory() as folder:
        own = compiler.compile([os.path.join(home, 'host', name, name + '.c')], output_dir=folder,
                               include_dirs=[home], extra_postargs=[*FLAGS, *words])
        compiler.link_shared_object(own + common, os.path.join(target, '_%s.so' % name),
                                    libraries=[*libraries, 'm'], extra_postargs=words)


class Build(build_py):
    """The module with its library and stubs."""

    def run(self):
        super().run()
        target = os.path.join(self.build_lib, NAME)
        os.makedirs(target, exist_ok=True)
        render.write(os.path.join(target, '_routines.pyi'), render.stubs(TABLE))
        render.write(os.path.join(target, '__init__.pyi'),
                     stub.filled(os.path.join(HERE, 'c'), os.path.join(HERE, 'src', NAME)))
        self.build_scene(target)

    def build_scene(self, target):
        compiler = new_compiler()
        customize_compiler(compiler)
        home = os.path.join(HERE, 'c')
        sources = sorted(glob.glob(os.path.join(home, 'scene', '*.c')))
        with tempfile.TemporaryDirectory() as folder:
            loops = os.path.join(folder, 'loops.c')
            render.write(loops, render.loops(TABLE))
            objects = compiler.compile(
                sources + [loops], output_dir=folder,
                include_dirs=[home, os.path.join(home, 'scene')], extra_postargs=FLAGS)
            kept = os.path.join(folder, 'common')   # those of the module lie there itself
            common = run_time(compiler, kept)
            compiler.link_shared_object(objects + common, os.path.join(target, '_scene.so'),
                                        libraries=['m'])
            engine = [o for o in common if os.path.dirname(o) != kept]
            build_library(compiler, 'cvode', engine, SUNDIALS, target)
            clock = [o for o in engine if o.endswith('wall_clock.o')]
            build_library(compiler, 'ipopt', clock, ['ipopt'], target)
            build_library(compiler, 'nlopt', clock, ['nlopt'], target)


class Wheel(bdist_wheel):
    """One wheel for every Python 3 of a platform: the library knows nothing of Python."""

    def finalize_options(self):
        super().finalize_options()
        self.root_is_pure = False

    def get_tag(self):
        return 'py3', 'none', super().get_tag()[2]


class Compiled(Distribution):
    def has_ext_modules(self):
        return True


setup(name=NAME.replace('_', '-'), version=TABLE['gsmbp_version'],
      description='The scene ' + NAME + ', derived by GSMBP', python_requires='>=3.9',
      install_requires=['numpy'], packages=[NAME], package_dir={'': 'src'},
      package_data={NAME: ['*.so', '*.pyi', '*.json', 'py.typed']}, distclass=Compiled,
      cmdclass={'build_py': Build, 'bdist_wheel': Wheel}, zip_safe=False)
