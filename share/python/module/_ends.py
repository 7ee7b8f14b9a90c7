"""What ends a run before its time: an exception of its function of inputs, or a signal."""
import ctypes
import signal

ASK = ctypes.CFUNCTYPE(ctypes.c_int)
FAILED = -1000   # INFO of a routine that is called no more
SIGNALS = [getattr(signal, name) for name in ('SIGINT', 'SIGTERM', 'SIGALRM')
           if hasattr(signal, name)]


class Ends:
    """No exception may cross the C of a run: the first one is kept, the run ends at once, and the
    caller raises it.

        with ends:
            the run, which calls ends.ask (None: there is nothing to ask) now and then

    In the main thread, where Python handles signals, their handlers are called by way of this
    object meanwhile: what they raise (Ctrl-C: KeyboardInterrupt) is kept as well.
    """

    def __init__(self):
        self.failure = None
        self.ask = None
        self._inside = False   # in a function of the user, which an exception may leave
        self._handlers = {}

    def call(self, function, *values):
        """0, or FAILED where the function has raised something, now or before."""
        if self.failure is None:
            try:
                self._inside = True
                function(*values)
                self._inside = False
            except BaseException as problem:
                self._inside = False
                self.failure = self.failure or problem
        return 0 if self.failure is None else FAILED

    def __enter__(self):
        for number in SIGNALS:
            handler = signal.getsignal(number)
            if callable(handler):
                self._handlers[number] = handler
                try:
                    signal.signal(number, self._handle)
                except ValueError:   # not in the main thread
                    self._handlers.clear()
                    return self
        if self._handlers:
            self.ask = ASK(lambda: 0 if self.failure is None else FAILED)
        return self

    def _handle(self, number, frame):
        try:
            self._handlers[number](number, frame)
        except BaseException as problem:
            self.failure = self.failure or problem
            if self._inside:
                raise

    def __exit__(self, *_):
        for number, handler in self._handlers.items():
            signal.signal(number, handler)
        return False
