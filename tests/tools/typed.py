"""typed.py SECONDS LINE ...: types lines at Octave in a terminal, Ctrl-C SECONDS after the last
one has begun another process; prints how long the prompt then took, what a sum typed there gives,
and how many processes of the session are left a second later."""
import os
import pty
import select
import subprocess
import sys
import time

PROMPT = b"octave:"


def said(terminal, what, limit):
    """what the terminal says until it says `what`, a time in seconds at most"""
    heard, end = b"", time.time() + limit
    while what not in heard and time.time() < end:
        if select.select([terminal], [], [], 0.01)[0]:
            try:
                heard += os.read(terminal, 65536)
            except OSError:
                break
    return what in heard


def processes(session):
    """how many processes it has started that have not ended"""
    states = subprocess.run(["ps", "-o", "stat=", "--ppid", str(session)], capture_output=True,
                            text=True, check=False).stdout.split()
    return sum(not s.startswith("Z") for s in states)


def main(delay, lines):
    session, terminal = pty.fork()
    if session == 0:
        os.environ["TERM"] = "dumb"
        os.execvp("octave-cli", ["octave-cli", "-qf", "--no-history"])
    ready = said(terminal, PROMPT, 60)
    for line in lines:
        os.write(terminal, line.encode() + b"\n")
        ready = said(terminal, PROMPT, 120) if line != lines[-1] else ready
    end = time.time() + 60
    while processes(session) == 0 and time.time() < end:
        time.sleep(0.02)
    time.sleep(delay)
    start = time.time()
    os.write(terminal, b"\x03")
    ready = ready and said(terminal, PROMPT, 60)
    print("prompt after %.2f s" % (time.time() - start) if ready else "no prompt")
    os.write(terminal, b"x = 40 + 2\n")
    print("alive" if said(terminal, b"x = 42", 10) else "dead")
    time.sleep(1)
    print("left: %d" % processes(session))
    os.write(terminal, b"exit\n")
    said(terminal, b"\0", 2)


main(float(sys.argv[1]), sys.argv[2:])
