"""instance.py: an instance of the FMU that the command line names, SCRIPT SCENE FOLDER STANDARD (it
is unpacked in FOLDER), and what the scripts that call one share."""
import ctypes as c
import glob
import math
import re
import sys

scene, folder, standard = sys.argv[1], sys.argv[2], int(sys.argv[3])
text = open(folder + '/modelDescription.xml').read()
token = re.search('(guid|instantiationToken)="([^"]*)"', text).group(2).encode()
kind_of = 'ScalarVariable' if standard == 2 else 'Float64'
ref = {n: int(r) for n, r in re.findall(f'<{kind_of} name="([^"]*)" valueReference="(\\d+)"', text)}
so = c.CDLL(glob.glob(folder + '/binaries/*linux*/*.so')[0])
P, D, N = c.c_void_p, c.c_double, c.c_size_t
B = c.c_int if standard == 2 else c.c_bool
log = []


class Callbacks(c.Structure):
    LOG = c.CFUNCTYPE(None, P, c.c_char_p, c.c_int, c.c_char_p, c.c_char_p, c.c_char_p)
    _fields_ = [('logger', LOG), ('allocate', P), ('free', P), ('finished', P), ('env', P)]


class Events(c.Structure):
    _fields_ = [(n, c.c_int) for n in ('needed', 'terminate', 'nominals', 'values', 'defined')]
    _fields_.append(('next', D))


@Callbacks.LOG
def logger(environment, name, status, category, form, words):
    log.append(words.decode() if form == b'%s' else form.decode())


log3 = c.CFUNCTYPE(None, P, c.c_int, c.c_char_p, c.c_char_p)(
    lambda environment, status, category, words: log.append(words.decode()))
libc = c.CDLL(None)
callbacks = Callbacks(logger, c.cast(libc.calloc, P), c.cast(libc.free, P), None, None)


def told(good, what):
    print('%s %s %d.0: %s' % ('ok' if good else 'not ok', scene, standard, what))


def near(error, most, what):
    told(abs(error) <= most, '%s: %.1e (at most %.0e)' % (what, abs(error), most))


class Instance:
    def __init__(self, exchange, start, end=10.0):
        if standard == 2:
            so.fmi2Instantiate.restype = P
            self.m = P(so.fmi2Instantiate(b'one', 0 if exchange else 1, token, b'',
                                          c.byref(callbacks), 0, 0))
            self('SetupExperiment', 1, D(1e-10), D(0), 1, D(end))
            self('EnterInitializationMode')
        else:
            make = so['fmi3Instantiate' + ('ModelExchange' if exchange else 'CoSimulation')]
            make.restype = P
            more = [] if exchange else [B(0), B(1), None, N(0)]
            self.m = P(make(b'one', token, b'', B(0), B(0), *more, None, log3, None))
            self('EnterInitializationMode', B(1), D(1e-10), D(0), B(1), D(end))
        self.put(start)
        self('ExitInitializationMode')
        self.n = len(re.findall('<(?:Unknown|ContinuousStateDerivative) ', re.sub(
            '(?s)<Outputs>.*?</Outputs>|<InitialUnknowns>.*?</InitialUnknowns>', '', text)))
        self.nz = len([n for n in ref if re.match(r'event\[', n)])

    def status(self, name, *arguments):
        return so['fmi%d%s' % (standard, name)](self.m, *arguments)

    def __call__(self, name, *arguments):
        if self.status(name, *arguments) != 0:
            sys.exit('not ok %s %d.0: %s failed: %s' % (scene, standard, name, log[-1:]))

    def put(self, values):
        for name, value in values.items():
            self('SetReal' if standard == 2 else 'SetFloat64', c.byref(c.c_uint(ref[name])), N(1),
                 c.byref(D(value)), *([] if standard == 2 else [N(1)]))

    def __getitem__(self, name):
        v = D()
        self('GetReal' if standard == 2 else 'GetFloat64', c.byref(c.c_uint(ref[name])), N(1),
             c.byref(v), *([] if standard == 2 else [N(1)]))
        return v.value

    def step(self, t, h):
        """has an event ended the run? and when"""
        if standard == 2:
            status, last, ended = self.status('DoStep', D(t), D(h), 1), D(t + h), c.c_int(0)
            if status == 2:
                self('GetRealStatus', 2, c.byref(last))
                self('GetBooleanStatus', 3, c.byref(ended))
            return status > 2 or ended.value, last.value
        event, end, early, last = B(), B(), B(), D()
        status = self.status('DoStep', D(t), D(h), B(1), c.byref(event), c.byref(end),
                             c.byref(early), c.byref(last))
        return status > 2 or end.value, last.value

    def events(self):
        """does the run end here? next: the time of the next event that is known"""
        if standard == 2:
            e = Events()
            self('NewDiscreteStates', c.byref(e))
            self.next = e.next if e.defined else math.inf
            return e.terminate
        e, next_ = [B() for k in range(5)], D()
        self('UpdateDiscreteStates', *map(c.byref, e), c.byref(next_))
        self.next = next_.value if e[4].value else math.inf
        return e[1].value

    def states(self):
        x = (D*self.n)()
        self('GetContinuousStates', x, N(self.n))
        return list(x)

    def at(self, t, x):
        self('SetTime', D(t))
        self('SetContinuousStates', (D*self.n)(*x), N(self.n))

    def rates(self, t, x):
        d = (D*self.n)()
        self.at(t, x)
        self('GetDerivatives' if standard == 2 else 'GetContinuousStateDerivatives', d, N(self.n))
        return list(d)

    def signs(self, t, x):
        z = (D*self.nz)()
        self.at(t, x)
        self('GetEventIndicators', z, N(self.nz))
        return [one > 0 for one in z]

    def keep(self):
        """a saved state"""
        state = P()
        self('GetFMUstate' if standard == 2 else 'GetFMUState', c.byref(state))
        return state

    def take(self, state):
        self('SetFMUstate' if standard == 2 else 'SetFMUState', state)

    def in_bytes(self, state):
        """a state, written and read again"""
        n, other = N(), P()
        words = (['SerializedFMUstateSize', 'SerializeFMUstate', 'DeSerializeFMUstate']
                 if standard == 2 else
                 ['SerializedFMUStateSize', 'SerializeFMUState', 'DeserializeFMUState'])
        self(words[0], state, c.byref(n))
        text = c.create_string_buffer(n.value)
        self(words[1], state, text, n)
        self(words[2], text, n, c.byref(other))
        return other
