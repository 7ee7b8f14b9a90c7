"""calls_fmu.py FILE FOLDER OUT: the calls of FILE (calls.json) by co-simulation of the FMUs 2.0 of
its scenes, unpacked in FOLDER/SCENE; a line for each into OUT: what the log has, or why an FMU has
no such call."""
import ctypes as c
import glob
import json
import re
import sys

P, D, N = c.c_void_p, c.c_double, c.c_size_t
ELSEWHERE = '(no such call: %s)'
log = []


class Callbacks(c.Structure):
    LOG = c.CFUNCTYPE(None, P, c.c_char_p, c.c_int, c.c_char_p, c.c_char_p, c.c_char_p)
    _fields_ = [('logger', LOG), ('allocate', P), ('free', P), ('finished', P), ('env', P)]


@Callbacks.LOG
def logger(environment, name, status, category, form, words):
    log.append(words.decode() if form == b'%s' else form.decode())


libc = c.CDLL(None)
callbacks = Callbacks(logger, c.cast(libc.calloc, P), c.cast(libc.free, P), None, None)


class Refused(Exception):
    """The log has the reason."""


class Instance:
    def __init__(self, name, folder):
        self.so = c.CDLL(glob.glob('%s/%s/binaries/*linux*/*.so' % (folder, name))[0])
        text = open('%s/%s/modelDescription.xml' % (folder, name)).read()
        self.ref = {n: int(r) for n, r in re.findall(
            '<ScalarVariable name="([^"]*)" valueReference="(\\d+)"', text)}
        self.states = re.findall('<ScalarVariable name="([^"]*)"[^>]*initial="(?:approx|exact)" '
                                 'description="(?:coordinate|speed|state)', text)
        self.inputs = re.findall('<ScalarVariable name="([^"]*)"[^>]*causality="input"', text)
        self.so.fmi2Instantiate.restype = P
        token = re.search('guid="([^"]*)"', text).group(1).encode()
        self.m = P(self.so.fmi2Instantiate(b'one', 1, token, b'', c.byref(callbacks), 0, 0))

    def __call__(self, name, *arguments):
        if self.so['fmi2' + name](self.m, *arguments) > 1:
            raise Refused

    def put(self, names, values):
        for name, value in zip(names, values):
            self('SetReal', c.byref(c.c_uint(self.ref.get(name, 10**6))), N(1), c.byref(D(value)))


def inexpressible(fmu, given):
    """Why there is no such call, or None."""
    options = dict(given.get('options', {}))
    numbers = [options.pop('rtol', 0), *given.get('par', {}).values(), *given['times']]
    if any(isinstance(a, (str, list)) for a in [*numbers, *given['x0']]):
        return 'variables, times and the tolerance are numbers'
    given_inputs = options.pop('input', [])
    if len(given['x0']) != len(fmu.states):
        return 'states are set one by one'
    if not isinstance(given_inputs, list) or len(given_inputs) not in (0, len(fmu.inputs)):
        return 'inputs are set one by one, by numbers'
    if len(given['times']) < 2:
        return 'a run begins at a time and goes by steps'
    if options:
        return 'no option %s' % ', '.join(options)
    return None


def run(fmu, given):
    options, times = given.get('options', {}), given['times']
    rtol = options.get('rtol')
    fmu('SetupExperiment', rtol is not None, D(rtol or 0), D(times[0]), 1, D(times[-1]))
    fmu.put(given.get('par', {}), given.get('par', {}).values())
    fmu('EnterInitializationMode')
    fmu.put(fmu.states, given['x0'])
    fmu.put(fmu.inputs, options.get('input', []))
    fmu('ExitInitializationMode')
    for t, after in zip(times, times[1:]):
        fmu('DoStep', D(t), D(after - t), 1)


def message(name, folder, given):
    fmu = Instance(name, folder)
    why = inexpressible(fmu, given) if isinstance(given['times'], list) and isinstance(
        given['x0'], list) else 'variables, times and the tolerance are numbers'
    if why:
        return ELSEWHERE % why
    log.clear()
    try:
        run(fmu, given)
    except Refused:
        pass
    return '; '.join(log) or 'accepted'


table = json.load(open(sys.argv[1]))
with open(sys.argv[3], 'w') as out:
    for name, given in table['calls']:
        out.write(message(name, sys.argv[2], {**table['scenes'][name], **given}) + '\n')
