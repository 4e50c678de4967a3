"""Runs of programs without loading their libraries each time.

    ended = launch(("materialPointFoam",), folder, log, limit=60)
    ended.status     exit status; minus the signal that ended it; None: stopped at the limit
    ended.seconds    of one core

The first run of a program loads it into a server (forkServer.C), which every run forks.
Programs that are not OpenFOAM's, those with sanitizers and those whose libraries lack symbols
(setExprFields of v1912) are started as usual, and all with MPM_FORK=0.
"""

import atexit
import contextlib
import fcntl
import functools
import os
import select
import shutil
import signal
import subprocess
import time
from collections import namedtuple

LIB = os.path.dirname(os.path.abspath(__file__))
RUN = os.path.join(os.path.dirname(LIB), "run")
FORK = os.environ.get("MPM_BUILD") != "sanitize" and os.environ.get("MPM_FORK") != "0"

Ended = namedtuple("Ended", "status seconds")

#: What programs load later: a tenth of a second of each run
_LATER = {"postProcess": ("libfieldFunctionObjects.so",)}


@functools.cache
def library(name):
    """A source of this folder, compiled if it is newer than what tests/run has of it."""
    source, made = os.path.join(LIB, name + ".C"), os.path.join(RUN, name + ".so")
    os.makedirs(RUN, exist_ok=True)
    with open(made + ".lock", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not os.path.exists(made) or os.path.getmtime(made) < os.path.getmtime(source):
            subprocess.run(["g++", "-std=c++17", "-O1", "-shared", "-fPIC", source, "-o", made,
                            "-ldl"], check=True)
    return made


@functools.cache
def _ofOpenFOAM(program, _changed):
    with open(program, "rb") as f:
        text = f.read()
    return text[:4] == b"\x7fELF" and b"libOpenFOAM.so" in text


class _Server:
    def __init__(self, program, environment):
        preload = ":".join((library("forkServer"), *_LATER.get(os.path.basename(program), ())))
        self.process = subprocess.Popen(
            [program], stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0,
            env={**environment, "LD_PRELOAD": preload, "LD_BIND_NOW": "1"})

    def run(self, command, folder, log, limit, session):
        """None: the program did not start."""
        words = (folder, log, "session" if session else "", *command)
        text = b"".join(os.fsencode(w) + b"\0" for w in words)
        out = self.process.stdout
        with contextlib.suppress(BrokenPipeError):      # it ended, as one whose program is new
            self.process.stdin.write(b"%d\n" % len(text) + text)
        first = out.readline()
        if not first:
            return None
        pid = int(first)
        stopped = not select.select([out], [], [], limit)[0]
        if stopped:
            # It may have ended meanwhile
            with contextlib.suppress(ProcessLookupError):
                (os.killpg if session else os.kill)(pid, signal.SIGKILL)
        status, seconds = out.readline().split()
        status = os.waitstatus_to_exitcode(int(status))
        return Ended(None if stopped else status, float(seconds))


#: Idle ones
_servers = {}


@atexit.register
def _stop():
    for server in sum(_servers.values(), []):
        server.process.stdin.close()
        server.process.wait()


def launch(command, folder, log, limit=None, session=False, environment=None):
    """Run a command in a folder; its output is added to the log. A session of its own is
    stopped with all that it started."""
    command, folder, log = tuple(map(str, command)), os.path.abspath(folder), os.path.abspath(log)
    environment = {**os.environ, **(environment or {})}
    program = FORK and shutil.which(command[0], path=environment.get("PATH"))
    if program and "LD_PRELOAD" not in environment and os.path.isdir(folder):
        changed = os.stat(program).st_mtime_ns
        if _ofOpenFOAM(program, changed):
            environment.pop("PWD", None)
            key = program, changed, *sorted(environment.items())
            idle = _servers.setdefault(key, [])
            server = idle.pop() if idle else _Server(program, environment)
            ended = server.run(command, folder, log, limit, session)
            if ended:
                idle.append(server)
                return ended
    return _start(command, folder, log, limit, session, environment)


def _start(command, folder, log, limit, session, environment):
    with open(log, "ab") as out:
        process = subprocess.Popen(
            command, cwd=folder, stdout=out, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
            start_new_session=session, env={**environment, "PWD": folder})
    last, stopped = limit and time.monotonic() + limit, False
    while True:
        pid, status, used = os.wait4(process.pid, os.WNOHANG if limit else 0)
        if pid:
            break
        if limit and time.monotonic() > last:
            (os.killpg if session else os.kill)(process.pid, signal.SIGKILL)
            stopped, limit = True, None
        time.sleep(0.005)
    process.returncode = os.waitstatus_to_exitcode(status)
    return Ended(None if stopped else process.returncode, used.ru_utime + used.ru_stime)
