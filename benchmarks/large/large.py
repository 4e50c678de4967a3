"""The block of 8 k^3 points of benchmarks/block on two processors (arguments: k, 24 and 108):
seconds and memory of each program, of the solver also ns per point and step, for the run and
for a run that goes on from the written time. In benchmarks/run/large; 10 GB of memory and
10 GB of disk for k = 108, which is removed at the end."""

import os
import re
import resource
import shutil
import subprocess
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
RUN = os.path.join(HERE, "../run/large")
MPI = ("mpirun", "--allow-run-as-root", "-np", "2")


def change(path, *pairs):
    with open(path) as f:
        text = f.read()
    for pattern, new in pairs:
        assert re.search(pattern, text, re.M), (path, pattern)
        text = re.sub(pattern, new, text, flags=re.M)
    with open(path, "w") as f:
        f.write(text)


def program(case, *command):
    """Seconds, largest memory of one process [GB] and the log."""
    log = os.path.join(case, "log." + [c for c in command if not c.startswith("-")][-1])
    start = time.time()
    code = ("import resource, subprocess, sys;"
            "e = subprocess.call(sys.argv[1:]);"
            "print('kB', resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss); sys.exit(e)")
    with open(log, "w") as f:
        subprocess.run([sys.executable, "-c", code, *command], cwd=case, stdout=f, stderr=f,
                       check=True)
    with open(log) as f:
        text = f.read()
    return time.time() - start, 1e-6*int(re.findall(r"^kB (\d+)", text, re.M)[-1]), text


def run(k):
    case = os.path.join(RUN, f"k{k}")
    shutil.rmtree(case, ignore_errors=True)
    shutil.copytree(os.path.join(HERE, "../block"), case)
    steps, dt = (200 if k < 50 else 20), 2.5e-4*32/k
    nx, nz = round(k*40/32), round(k*36/32)
    control = os.path.join(case, "system/controlDict")
    change(os.path.join(case, "system/blockMeshDict"), (r"\(40 40 36\)", f"({nx} {nx} {nz})"))
    change(control, ("^deltaT .*", f"deltaT {dt!r};"), ("^endTime .*", f"endTime {dt*steps!r};"),
           ("^writeInterval .*", f"writeInterval {steps};"),
           ("^startFrom .*", "startFrom latestTime;"))
    with open(os.path.join(case, "system/decomposeParDict"), "w") as f:
        f.write("FoamFile { version 2.0; format ascii; class dictionary; object d; }\n"
                "numberOfSubdomains 2; method simple; simpleCoeffs { n (2 1 1); delta 0.001; }\n")
    print(f"k {k}:")
    for command in (("blockMesh",), ("setMaterialPoints",),
                    (*MPI, "redistributeCase", "-parallel")):
        seconds, memory, _ = program(case, *command)
        print(f"    {[c for c in command if not c.startswith('-')][-1]}: {seconds:.1f} s,"
              f" {memory:.3f} GB a process", flush=True)
    for n in (1, 2):
        change(control, ("^endTime .*", f"endTime {n*dt*steps!r};"))
        seconds, memory, log = program(case, *MPI, "materialPointFoam", "-parallel")
        points = int(re.findall(r"^Material points: (\d+)", log, re.M)[0])
        wall = float(re.search(r"^Parts of the steps' (\S+) s", log, re.M)[1])
        print(f"    {points} points, {'goes on' if n == 2 else 'run'}: {seconds:.1f} s,"
              f" {memory:.3f} GB a process, {1e9*wall/steps/points:.1f} ns per point and step of"
              " both", flush=True)
    if k > 50:
        shutil.rmtree(case)


if __name__ == "__main__":
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    for size in sys.argv[1:] or ("24", "108"):
        run(int(size))
