"""A few steps of a case, and what the whole run will be by them.

    trial = Trial(case, ranks=1)        # case: a copy that may be written into
    trial.run()
    trial.steps, trial.seconds, trial.memory

The run stops at its first write, after so many steps (stopAt nextWrite). Steps to come are the
time that is left over the time step of the last of them, with the steps that are shortened to
meet the times of writing. Seconds are those of the processor per step; nothing is known of what
changes later: waves that steepen, debris, an adaptive mesh.
"""

import math
import os
import re
import subprocess

from mpm.case import Case, RunFailed

FIRST, MOST, LEAST_SECONDS = 40, 2000, 2.0
MPIRUN = ("mpirun", "--bind-to", "none", "-np")


class Trial:
    """What a few steps of a case tell. memory: MB of the largest process; perWrite: seconds,
    bytes of a written time; setBy: what set the least time step."""

    def __init__(self, case, ranks=1):
        self.case, self.ranks = case, ranks
        control = case.get("system/controlDict")
        self.end = float(control.get("endTime", math.nan))
        self.startTime = float(control.get("startTime", 0)) \
            if control.get("startFrom") == "startTime" else 0.0
        interval = control.get("writeInterval")
        self.interval = interval if isinstance(interval, (int, float)) else None
        self.inSteps = control.get("writeControl", "timeStep") == "timeStep"
        self.adjustable = control.get("writeControl") in ("adjustableRunTime", "adjustable")
        self.steps = self.seconds = self.memory = self.written = math.nan

    def run(self, steps=None):
        """Some steps; some more of a small case, whose first ones take too little to tell."""
        self._run(steps or FIRST)
        spent = self.perStep*self.nTrial
        if steps or self.nTrial < FIRST or spent >= LEAST_SECONDS:
            return
        n = min(MOST, max(self.steps, FIRST), int(FIRST*LEAST_SECONDS/max(spent, 1e-3)))
        if n >= 2*FIRST:
            self._run(n)

    def _run(self, n):
        case = self.case
        for entry, value in (("stopAt", "nextWrite"), ("writeControl", "timeStep"),
                             ("writeInterval", n), ("startFrom", "startTime"),
                             ("startTime", self.startTime), ("purgeWrite", 0)):
            case.set("system/controlDict", entry, value, add=True)
        for name in case.times():
            if float(name) > self.startTime:
                subprocess.run(["rm", "-rf", case.file(name)], check=True)
        command = ["materialPointFoam"]
        if self.ranks > 1:
            self._decompose()
            command = [*MPIRUN, str(self.ranks), *command, "-parallel"]
        with open(case.file("log.materialPointFoam"), "w") as log:
            run = subprocess.Popen(
                command, cwd=case.path, stdout=log, stderr=subprocess.STDOUT,
                stdin=subprocess.DEVNULL, env={
                    **os.environ, "PWD": case.path, "OMPI_ALLOW_RUN_AS_ROOT": "1",
                    "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
                    "OMPI_MCA_rmaps_base_oversubscribe": "1"})
            _, status, used = os.wait4(run.pid, 0)
            run.returncode = os.waitstatus_to_exitcode(status)
        if run.returncode:
            raise RunFailed(case.reason(log.name))
        self.memory = used.ru_maxrss/1024
        self.read()

    def _decompose(self):
        """Into slabs along the longest side, unless decomposeParDict has that number of ranks."""
        case, path = self.case, "system/decomposeParDict"
        try:
            own = case.get(path, "numberOfSubdomains") == self.ranks
        except Exception:
            own = False
        if not own:
            sides = [x[-1] - x[0] for x in case.edges()]
            n = [self.ranks if d == sides.index(max(sides)) else 1 for d in range(3)]
            case.write(path, {
                "numberOfSubdomains": self.ranks, "method": "hierarchical",
                **({"weightField": "cellWeights"}
                   if os.path.exists(case.file("0/cellWeights")) else {}),
                "hierarchicalCoeffs": {"n": n, "delta": 0.001, "order": "xyz"}})
        case.run("decomposePar", "-force")

    def read(self):
        """Time step, cost of a step and of a write from the log."""
        case, log = self.case, self.case.log()
        reports = [(int(a), float(b)) for a, b in re.findall(
            r"^Progress:.* step (\d+).*\nExecutionTime = ([\d.e+-]+) s", log, re.M)]
        times = [float(t) for t in re.findall(r"^Time = (\S+)", log, re.M)]
        limits = re.findall(r"^deltaT = (\S+)\ndeltaT set by (.*)", log, re.M)
        self.nTrial = case.nSteps()
        if not reports or not limits:
            raise RunFailed("the log of the trial has no reports")
        self.deltaT, self.setBy = min(((float(d), who) for d, who in limits), key=lambda x: x[0])
        steps = [float(d) for d, _ in limits]
        now = steps[-1]
        #: The step at half of the trial, if it has grown since by a tenth or more
        half = steps[len(steps)//2]
        self.grows = half if now > 1.1*half else 0.0
        said = re.search(r"points per processor: .* imbalance (\S+) %", log)
        self.imbalance = float(said[1]) if said else 0.0
        inner = reports[1:-1] if len(reports) > 4 else reports
        if len(inner) > 1 and inner[-1][0] > inner[0][0]:
            self.perStep = (inner[-1][1] - inner[0][1])/(inner[-1][0] - inner[0][0])
        else:
            self.perStep = reports[-1][1]/max(reports[-1][0], 1)
        self.steps = self._stepsTo(times[-1] if times else 0.0, now)
        self.writes = self._writes()
        last = reports[-2:] if len(reports) > 1 else reports*2
        self.perWrite = max(0.0, last[1][1] - last[0][1] - (last[1][0] - last[0][0])*self.perStep)
        self.written = _size(case) if self.ranks == 1 else sum(map(_size, map(
            Case, case.processors())))
        self.seconds = self.steps*self.perStep + self.writes*self.perWrite

    def _stepsTo(self, time, deltaT):
        done, left = self.nTrial, self.end - time
        if left <= 0:       # the trial was longer than the run
            done, left = 0, self.end - self.startTime
        if self.adjustable and self.interval and self.interval > deltaT:
            each = math.ceil(self.interval/deltaT*(1 - 1e-9))
            return done + math.ceil(left/self.interval*each)
        return done + math.ceil(left/deltaT*(1 - 1e-9))

    def _writes(self):
        """How often the run writes: its end at least."""
        if not self.interval:
            return 1
        if self.inSteps:
            return max(1, int(self.steps/self.interval))
        return max(1, round((self.end - self.startTime)/self.interval))


def _size(case):
    """Bytes of the last time."""
    times = case.times()
    return sum(os.path.getsize(os.path.join(root, n)) for root, _, names in os.walk(
        case.file(times[-1])) for n in names) if times else 0
