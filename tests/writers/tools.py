"""tools.py: the writers by the program that they run in, for tests/writers/check.

A Session runs jobs [writer, folder, version] one after the other in one process and has for each
whether it succeeded and what it said.
"""
import os
import shutil
import signal
import subprocess
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
TOOLS = {
    'maxima': ['fortran', 'c', 'graph', 'page', 'tex', 'urdf', 'import', 'package', 'python',
               'fmu'],
    'octave': ['csv', 'figure', 'animation', 'report', 'controller'],
    'c': ['chunk'],
    'shell': ['derive', 'html', 'picture', 'put', 'fmu_derive'],
}
# what takes long: only in the whole table
LONG = ['package', 'python', 'fmu', 'derive', 'html', 'fmu_derive', 'animation']
SCENE = '''scene : gsmbp_scene("rod", link(a, mass = m, inertia = [1, 1, 1]),
  revolute(p, ground, a, axis = z, coordinate = q), parameters = [m = %d*kg])$
requests : '[mass]$
'''
COMMANDS = {
    'derive': 'share/make/derive {scene} {folder}',
    'html': 'share/make/page {scene} {folder}/rod.html',
    'picture': 'share/make/picture {dot} {folder}/rod.png',
    'put': 'share/make/place put put {scene} {folder}/rod.mac {dot} {folder}/rod.dot',
    'fmu_derive': 'share/fmu/derive {scene} {folder}',
}


def started(tool):
    return shutil.which({'maxima': 'maxima', 'octave': 'octave-cli', 'shell': 'dot',
                         'c': 'gcc'}[tool])


class Session:
    def __init__(self, tool, jobs, work, wrap=(), env=None):
        self.tool, self.jobs = tool, jobs
        self.home = tempfile.mkdtemp(dir=work)
        os.chmod(self.home, 0o755)
        lines = ['%s\t%s\t%d' % tuple(job) for job in jobs]
        with open(os.path.join(self.home, 'jobs'), 'w') as file:
            file.write('\n'.join(lines) + '\n')
        self.log = open(os.path.join(self.home, 'log'), 'w+')
        self.process = subprocess.Popen(
            list(wrap) + getattr(self, tool)(), cwd=ROOT, stdin=subprocess.DEVNULL,
            stdout=self.log, stderr=subprocess.STDOUT, start_new_session=True,
            env=dict(os.environ, **(env or {})))

    def maxima(self):
        for v in (1, 2):
            with open(os.path.join(self.home, 'robot%d.urdf' % v), 'w') as file:
                file.write('<robot name="rod"><link name="a"/><link name="b"><inertial>'
                           '<mass value="%d"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" '
                           'iyz="0"/></inertial></link><joint name="j" type="continuous">'
                           '<parent link="a"/><child link="b"/></joint></robot>\n' % v)
        with open(os.path.join(self.home, 'run.mac'), 'w') as file:
            file.write('gs__job_robots : ["%s/robot1.urdf", "%s/robot2.urdf"]$\n'
                       'load("tests/writers/writers.mac")$\ngs__all_jobs("%s/jobs")$\n'
                       % (self.home, self.home, self.home))
        return ['maxima', '--very-quiet', '--init=none', '-b', self.home + '/run.mac']

    def octave(self):
        return ['octave-cli', '-qf', '--no-history', '--path', ROOT + '/octave', '--path',
                ROOT + '/octave/hand', '--path', ROOT + '/tests/writers', '--eval',
                'gsmbp_writers ("%s/jobs")' % self.home]

    def c(self):
        glue = ROOT + '/octave/glue'
        program = self.home + '/chunks'
        subprocess.check_call(['gcc', '-std=gnu99', '-O1', '-w', '-I' + glue, '-o', program,
                               ROOT + '/tests/writers/chunks.c', glue + '/sweep_files.c',
                               glue + '/sweep_place.c'])
        return [program, self.home + '/jobs']

    def shell(self):
        lines = ['echo READY']
        for v in (1, 2):
            os.mkdir('%s/%d' % (self.home, v))
            with open('%s/%d/rod.mac' % (self.home, v), 'w') as file:
                file.write(SCENE % v)
            with open('%s/%d/rod.dot' % (self.home, v), 'w') as file:
                file.write('digraph { a -> b%d }\n' % v)
        for writer, folder, v in self.jobs:
            command = COMMANDS[writer].format(folder="'%s'" % folder,
                                              scene='%s/%d/rod.mac' % (self.home, v),
                                              dot='%s/%d/rod.dot' % (self.home, v))
            lines += ['echo "JOB %s"' % writer,
                      'if %s; then echo DONE; else echo FAILED; fi' % command]
        with open(self.home + '/run', 'w') as file:
            file.write('\n'.join(lines + ['echo END']) + '\n')
        return ['sh', self.home + '/run']

    def text(self):
        self.log.flush()
        with open(self.log.name, errors='replace') as file:
            return file.read()

    def wait_ready(self):
        for _ in range(3000):
            if '\nREADY' in '\n' + self.text() or self.process.poll() is not None:
                return
            time.sleep(0.02)

    def kill(self):
        """all of its processes, and until nobody has to be told of their end"""
        os.killpg(self.process.pid, signal.SIGKILL)
        self.process.wait()
        for _ in range(500):
            try:
                os.killpg(self.process.pid, 0)
            except ProcessLookupError:
                return
            time.sleep(0.02)

    def finish(self):
        """(succeeded, what was said) of each job"""
        why = 'the session ended: '
        try:
            self.process.wait(timeout=6000)
        except subprocess.TimeoutExpired:
            why = 'the session was stopped after 6000 s: '
            self.kill()
        said = ('\n' + self.text()).split('\nJOB ')[1:]
        found = []
        for text in said:
            lines = text.split('\n')[1:]
            ends = [k for k, line in enumerate(lines) if line in ('DONE', 'FAILED')]
            k = ends[0] if ends else len(lines)
            found.append((bool(ends) and lines[k] == 'DONE',
                          '\n'.join(line for line in lines[:k] if line.strip())))
        return found + [(False, why + self.text()[-300:])] * (
            len(self.jobs) - len(found))
