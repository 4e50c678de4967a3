"""Runs that are killed with kill -9 again and again, and the bits of their last time.

    kills(case, 8)              starts the solver 8 times and kills it
    killWhen(case, words, 2, 0) when its log has the words twice
    sameBits(a, b, time)        names of files that differ in this time
"""

import os
import random
import re
import signal
import subprocess
import time

from foamCase import PATIENCE, mpirun


def _children(pid):
    out = subprocess.run(["ps", "-o", "pid=", "--ppid", str(pid)], capture_output=True, text=True)
    return [int(p) for p in out.stdout.split()]


def times(case):
    """Time folders, of the last processor if the case is decomposed, in order."""
    folder = (case.processors() or [case.path])[-1]
    return sorted((f for f in os.listdir(folder) if re.fullmatch(r"\d[\d.e-]*", f)), key=float)


def kills(case, n, seed=7):
    """Starts and kills n times, each soon after a new time is there, at any moment of its
    writing; how many, what the runs said."""
    rng = random.Random(seed)
    parallel = len(case.processors())
    command = ([*mpirun(parallel), "materialPointFoam", "-parallel"] if parallel
               else ["materialPointFoam"])
    with open(case.file("log.killed"), "w") as log:
        for _ in range(n):
            before = len(times(case))
            p = subprocess.Popen(command, cwd=case.path, stdout=log, stderr=log,
                                 env={**os.environ, "PWD": case.path})
            last = time.monotonic() + 30*PATIENCE
            while p.poll() is None and len(times(case)) <= before and time.monotonic() < last:
                time.sleep(0.001)
            time.sleep(0.02*rng.random())
            for pid in _children(p.pid) if parallel else []:
                os.kill(pid, signal.SIGKILL)
            p.send_signal(signal.SIGKILL)
            p.wait()
    with open(case.file("log.killed")) as log:
        return n, log.read()


def killWhen(case, words, n, delay):
    """Starts a decomposed case and kills it when its log has the words for the nth time; 1 if
    it did not end before."""
    log = case.file("log.killed")
    with open(log, "w") as f:
        p = subprocess.Popen([*mpirun(len(case.processors())), "materialPointFoam", "-parallel"],
                             cwd=case.path, stdout=f, stderr=f,
                             env={**os.environ, "PWD": case.path})
    last = time.monotonic() + 60*PATIENCE
    while p.poll() is None and time.monotonic() < last:
        with open(log) as f:
            if f.read().count(words) >= n:
                break
        time.sleep(0.001)
    time.sleep(delay)
    ran = p.poll() is None
    for pid in _children(p.pid):
        os.kill(pid, signal.SIGKILL)
    p.send_signal(signal.SIGKILL)
    p.wait()
    return int(ran)


def sameBits(a, b, timeName, unlike=("uniform",)):
    """Files of this time that are not the same in both cases, and how many there are."""
    differ, count = [], 0
    for part, other in zip(a.processors() or [a.path], b.processors() or [b.path]):
        for root, folders, names in os.walk(os.path.join(part, timeName)):
            folders[:] = [f for f in folders if f not in unlike]
            for name in names:
                here = os.path.join(root, name)
                there = os.path.join(other, os.path.relpath(here, part))
                count += 1
                if not os.path.exists(there) or open(here, "rb").read() != open(there, "rb").read():
                    differ.append(os.path.relpath(here, part))
    return differ, count
