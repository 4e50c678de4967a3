#!/usr/bin/env python3
"""Bodies of material points that turn in a gas, points in disorder, and a slab
across the mesh hit by a shock. Air of 1e5 Pa and 1.2 kg/m3, solid of 70 GPa and
2700 kg/m3 where not said otherwise, gas of first order, pore floor 0.01.

rotation   disc of radius 10 cells, edge speed 100 m/s, for the time of half a turn; the
           gas in its pores turns with it, that outside is at rest. Gas means cells
           without solid (theta.air >= 0.99), second half of the run: |dP|/P <= 3e-2, no
           fix-up; Theta in 0.998..1.002 with 4 x 4 points per cell (2 x 2: printed, a
           little more, as the points lose their order at the edge)
disorder   points moved by up to half their distance along x and y: rotation with 10
           m/s (1/40 turn), translation of 20 cells: no pressure set to the isentrope,
           |dP|/P <= 0.1; with rotation in the gas only. In cells with points it is
           printed, and larger (0.1 to 0.3). There the points overlap by up to 19 %, so
           that the outflow is limited and theta is kept from falling: printed
slab       shock of Mach 1.2, 2, 3 on a slab at 45 degrees to the mesh. The box is
           cyclic along x and y, so that slab and gas are the same along (1 1), exactly
           a plane problem: reflected pressure within 3 %
products   a charge with the JWL equation of state, all reacted, in air. Points that have
           grown beyond a cell fill it unevenly: the run stops with the reason, before
           fix-ups have a share in the energy; the gas has no more than the charge gave
           (with 9 points per cell it had 2e9 J of 3e5). 36 points go further
blow       a block of nylon of 140 m/s hits a plate of aluminium in air, on boxes and on any
           cells, also with ten steps of the points in one of the gas: the plate gets what it
           gets in a gas of 1 Pa within 4 %, as the air leaves the gap, most by contact
overlapping    two bodies at one place: the stop says so
stopped    a slab flies out of the mesh: the state before the step has the gas' fields, and
           the next start begins where the message says

MPM_VERIFY=1: the slab on twice as many cells.
"""

import os
import re
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from coupledCases import ambient, coupledCase, gasLog
from foamCase import VERIFY, RunFailed, readField, writeField
from gasCases import OPEN, volField
from report import Report
from surfaces import prisms, surfaceRegion

GAMMA, P0, RHO0 = 1.4, 1e5, 1.2
C0 = np.sqrt(GAMMA*P0/RHO0)
H, R, N = (1e-4, 10, 40) if VERIFY else (1e-4, 8, 32)
CENTRE = ((0.5*N + 0.5)*H,)*2
SOLID = {"constitutiveModel": {"type": "linearElastic", "rho": 2700, "E": 70e9, "nu": 0}}
CYCLIC = {"left": ("cyclic; neighbourPatch right", ("x-",)),
          "right": ("cyclic; neighbourPatch left", ("x+",)),
          "bottom": ("cyclic; neighbourPatch top", ("y-",)),
          "top": ("cyclic; neighbourPatch bottom", ("y+",))}


# --- discs -------------------------------------------------------------------

def turning(x, y, edge):
    """Velocity of a disc of the edge speed."""
    U = np.zeros((len(x), 3))
    U[:, 0] = -(y - CENTRE[1])*edge/(R*H)
    U[:, 1] = (x - CENTRE[0])*edge/(R*H)
    return U


def moveAside(case, spacing, seed=1):
    """Each point by up to half the spacing, along x and y."""
    path = case.file("0/lagrangian/disc/x")
    x = readField(path).copy()
    x[:, :2] += np.random.default_rng(seed).uniform(-0.5, 0.5, (len(x), 2))*spacing
    writeField(path, x)


def disc(name, edge, arc, drag, jitter=False, translation=None, **options):
    """A disc that turns by arc [cells at its edge], or moves on."""
    def initial(x, y, z):
        inside = (x - CENTRE[0])**2 + (y - CENTRE[1])**2 < (R*H)**2
        u = (np.zeros((len(x), 3)) + translation if translation is not None
             else turning(x, y, edge)*inside[:, None])
        return RHO0 + 0*x, u, P0 + 0*x

    end = arc*H/edge
    case = coupledCase(
        "bodiesInGas", name, (N, N, 1), (N*H, N*H, H), initial, end,
        {"disc": {"drag": {"type": drag}, **SOLID}},
        {"disc": {"type": "cylinder", "point1": (*CENTRE, -H), "point2": (*CENTRE, 2*H),
                  "radius": R*H, "stress": ambient(P0),
                  **({"velocity": translation} if translation else {})}},
        ends=OPEN, sides=OPEN, pointConditions="calculated",
        writeInterval=end/200, control={"reportInterval": 1}, **options)
    if jitter:
        moveAside(case, H/2)
    if translation is None:
        x = readField(case.file("0/lagrangian/disc/x"))
        writeField(case.file("0/lagrangian/disc/U"), turning(x[:, 0], x[:, 1], edge))
    case.run("materialPointFoam", limit=500)
    return case


def deviation(case, after):
    """Largest |dP|/P in gas, mixed cells and core from a time on, and speed of gas."""
    worst = np.zeros(3)
    for name in case.times()[1:]:
        if float(name) < after:
            continue
        p, theta = volField(case, name, "p"), volField(case, name, "theta.air")
        off = abs(p/P0 - 1)
        for i, where in enumerate((theta >= 0.99, (theta < 0.99) & (theta > 0.02),
                                   theta <= 0.02)):
            if where.any():
                worst[i] = max(worst[i], off[where].max())
    return worst


def angularMomentum(case, time):
    points = case.points(time, "disc")
    x, U, m = points["x"], points["U"], points["m"]
    return np.sum(m*((x[:, 0] - CENTRE[0])*U[:, 1] - (x[:, 1] - CENTRE[1])*U[:, 0]))


def turned(case):
    """Mean angle by which the points have turned, over their way round."""
    times = case.times()
    angle = 0
    old = None
    for name in times:
        x = case.points(name, "disc").byId("x")[:, :2] - CENTRE
        if old is not None:
            angle += np.arctan2(np.sum(old[:, 0]*x[:, 1] - old[:, 1]*x[:, 0]),
                                np.sum(old*x))
        old = x
    return angle/(2*np.pi)


def fixups(g):
    return g["limited"][-1] + g["kept"][-1] + g["isentropic"][-1]


def rotation(table):
    arc = np.pi*R
    for ppc, drag in ((2, "stick"), (2, "none"), (4, "stick")):
        case = disc(f"rotation-{drag}-{ppc}", 100, arc, drag, ppc=ppc)
        g = gasLog(case)
        gas, mixed, core = deviation(case, 0.5*arc*H/100)
        label = f"disc, 100 m/s, half a turn, {ppc} x {ppc} points, drag {drag}"
        table.row(f"{label}: |dP|/P in the gas", 0, gas, 3e-2, "atMost")
        table.row(f"{label}: fix-ups", 0, fixups(g), 0)
        if ppc > 2:
            table.row(f"{label}: least Theta", 0.998, g["ThetaMin"].min(), 0.998, "atLeast")
            table.row(f"{label}: largest Theta", 1.002, g["ThetaMax"].max(), 1.002, "atMost")
        L = angularMomentum(case, case.times()[-1])/angularMomentum(case, "0")
        print(f"{label}: Theta {g['ThetaMin'].min():.4f} to {g['ThetaMax'].max():.4f}; |dP|/P"
              f" in mixed cells {mixed:.2e}, in the core {core:.2e}; FLIP with 1 % PIC leaves"
              f" {L:.3f} of the angular momentum, turned by {turned(case):.3f} turns;"
              f" {case.nSteps()} steps, {case.solverSeconds():.1f} s", flush=True)


def disorder(table):
    for label, options in (
            ("turning, 10 m/s, 1/40 turn", {"edge": 10, "arc": 2*np.pi*R/40}),
            ("moving 20 cells", {"edge": 100, "arc": 20, "translation": (80, 60, 0),
                                 "patches": CYCLIC})):
        case = disc("disorder-" + label.split(",")[0].replace(" ", ""), drag="stick",
                    jitter=True, **options)
        g = gasLog(case)
        gas, mixed, core = deviation(case, 0)
        label = f"points in disorder, {label}"
        if "translation" in options:
            table.row(f"{label}: |dP|/P, all cells", 0,
                      max(1 - g["pMin"].min()/P0, g["pMax"].max()/P0 - 1), 0.1, "atMost")
        else:
            table.row(f"{label}: |dP|/P in the gas", 0, gas, 0.1, "atMost")
        table.row(f"{label}: pressures set to the isentrope", 0, g["isentropic"][-1], 0)
        print(f"{label}: |dP|/P in the gas {gas:.2e}, in mixed cells {mixed:.2e}, in the core"
              f" {core:.2e}; Theta at the start {g['ThetaMin'][0]:.3f} to"
              f" {g['ThetaMax'][0]:.3f}, over all {g['ThetaMin'].min():.3f} to"
              f" {g['ThetaMax'].max():.3f}; outflow limited {g['limited'][-1]:g}, theta kept"
              f" {g['kept'][-1]:g}; {case.nSteps()} steps, {case.solverSeconds():.1f} s",
              flush=True)


# --- slab --------------------------------------------------------------------

def shockStates(Ms):
    """p, rho, u behind a shock of a Mach number, p reflected by a wall, speed of the
    reflected shock."""
    g = GAMMA
    p2 = P0*(1 + 2*g/(g + 1)*(Ms**2 - 1))
    rho2 = RHO0*(g + 1)*Ms**2/((g - 1)*Ms**2 + 2)
    u2 = 2*C0/(g + 1)*(Ms - 1/Ms)
    pr = p2*((3*g - 1)*p2 - (g - 1)*P0)/((g - 1)*p2 + (g + 1)*P0)
    W = (pr - p2)/(rho2*u2) - u2
    return p2, rho2, u2, pr, W


def slab(table):
    """The normal is (1 -1)/sqrt(2), s = (x - y)/sqrt(2) in cells, periodic in
    n/sqrt(2). What the shocked gas does behind the slab's back must not reach the
    window."""
    for m in (1, 2) if VERIFY else (0.5,):
        for Ms in (1.2, 2, 3):
            p2, rho2, u2, pr, W = shockStates(Ms)
            ahead, back, thick = 30*m, 30*m, 12*m  # cells
            time = ahead/(Ms*C0) + back/W
            away = time*(u2 + np.sqrt(GAMMA*p2/rho2))
            n = int(np.ceil(np.sqrt(2)*(away + back + thick + 20*m)))
            period = n/np.sqrt(2)
            face = period - thick - 0.3

            def s(x, y):
                return ((x - y)/H/np.sqrt(2)) % period

            def initial(x, y, z):
                at = s(x, y)
                low = (at < face - ahead) | (at > face + 0.5*thick)
                u = np.zeros((len(x), 3))
                u[:, 0] = low*u2/np.sqrt(2)
                u[:, 1] = -u[:, 0]
                return np.where(low, rho2, RHO0), u, np.where(low, p2, P0)

            def band(case):
                # x - y from d to d + width, and the same one period below
                d, width, long = np.sqrt(2)*face*H, np.sqrt(2)*thick*H, 3*n*H
                prisms(case, "slab.stl", [
                    [(a - long, -long), (a + width - long, -long), (a + width + long, long),
                     (a + long, long)] for a in (d, d - n*H)], -H, 2*H)

            case = coupledCase(
                "bodiesInGas", f"slab-{Ms}-{m}", (n, n, 1), (n*H, n*H, H), initial, time*H,
                {"slab": {"constitutiveModel": {"type": "linearElastic", "rho": 20000,
                                                "E": 5e10, "nu": 0}}},
                {"slab": surfaceRegion("slab.stl", stress=ambient(P0))},
                patches=CYCLIC, prepare=band, control={"reportInterval": 1})
            case.run("materialPointFoam", limit=1500)
            p = volField(case, case.timeName(time*H), "p").reshape(n, n)
            x = (np.arange(n) + 0.5)*H
            at = s(x[None, :], x[:, None])
            window = (at > face - 0.8*back) & (at < face - 4*m)
            g = gasLog(case)
            label = f"slab at 45 degrees, Ms {Ms}, {n} x {n} cells"
            table.row(f"{label}: pressure behind the reflected shock", pr, p[window].mean(),
                      3e-2, "relative")
            near = (at > face - 0.8*back) & (at < face)
            wave = (at > face - 1.6*back) & (at < face - 0.3*back)
            order = np.argsort(at[wave])
            where = np.interp(-0.5*(p2 + pr), -p[wave][order][::-1], at[wave][order][::-1])
            along = np.max(abs(p - np.roll(p, (1, 1), (0, 1))))
            print(f"{label}: highest p/p_r {g['pMax'].max()/pr:.4f}, in the window"
                  f" {p[window].min()/pr:.4f} to {p[window].max()/pr:.4f}, up to the slab"
                  f" {p[near].min()/pr:.4f}; reflected shock {(face - where)/back - 1:+.2e} of"
                  f" its way; along the slab |dp|/p {along/pr:.1e}; fix-ups {fixups(g):g};"
                  f" {case.nSteps()} steps, {case.solverSeconds():.1f} s", flush=True)


# --- products of an explosion ------------------------------------------------

JWL = {"type": "JWL", "A": 3.712e11, "B": 3.231e9, "R1": 4.15, "R2": 0.95, "omega": 0.3,
       "E0": 7e9}


def products(table):
    n, h, radius = 60, 1/60, 0.05
    grown = {}
    for ppc in (3, 6):
        case = coupledCase(
            "bodiesInGas", f"products-{ppc}", (n, n, 1), (n*h, n*h, h),
            lambda x, y, z: (RHO0 + 0*x, 0*x, P0 + 0*x), 3e-4,
            {"charge": {"constitutiveModel": {"type": "NewtonianFluid", "rho": 1630, "mu": 0,
                                              "equationOfState": JWL}}},
            {"charge": {"type": "cylinder", "point1": (0.5, 0.5, -1), "point2": (0.5, 0.5, 1),
                        "radius": radius}},
            ppc=ppc, maxCo=0.3, ends=OPEN, sides=OPEN, control={"reportInterval": 5})
        label = f"charge of {ppc} x {ppc} points per cell in air"
        case.run("materialPointFoam", limit=200, fails=True)
        log = " ".join(case.log().split("FATAL ERROR")[-1].split())
        table.check(f"{label}: stops with the reason", "Points of charge fill" in log
                    and "pointsPerCell" in log, log[:150])
        grown[ppc] = float(re.search(r"volume is ([\d.e+]+) times", log)[1])
        g = gasLog(case)
        given = 7e9*np.pi*radius**2*h
        table.row(f"{label}: energy of the gas, over that of the charge", 0,
                  (g["energy"].max() - g["energy"][0])/given, 1, "atMost")
        fixed = np.array([float(x) for x in re.findall(r"\(energy ([-\d.e+]+) added",
                                                       case.log())])
        table.row(f"{label}: by fix-ups", 0, np.max(abs(fixed))/given, 0.01, "atMost")
    table.row("charge in air: growth of the volume until then, 36 points over 9", 4,
              grown[6]/grown[3], 1.5, "atLeast")
    print(f"charge in air: volume {grown[3]:.1f} and {grown[6]:.1f} times that at the start",
          flush=True)


def ownFields(case, phases):
    """A velocity of the nodes for each phase, as that of "solids"."""
    with open(case.file("0/U.solids")) as f:
        text = f.read()
    for name in phases:
        with open(case.file("0/U." + name), "w") as f:
            f.write(text)


def blow(table):
    h, v, gap = 2e-3, 140.0, 5.3
    laws = {"block": {"type": "linearElastic", "rho": 1150, "E": 3e9, "nu": 0.4},
            "plate": {"type": "linearElastic", "rho": 2700, "E": 70e9, "nu": 0.33}}
    boxes = {"block": ((8.2, 10), (18.2, 22)), "plate": ((18.2 + gap, 4), (22.2 + gap, 28))}

    def prepare(case):
        case.set("constant/phaseProperties", "contact", {"all": {"type": "frictionless"}},
                 add=True)
        ownFields(case, laws)

    end = gap*h/v + 60e-6
    for shape in ("GIMP", "nodeDual"):
        found = []
        for name, p, subSteps in (("vacuum", 1.0, 1), ("air", P0, 1), ("steps", P0, 10)):
            case = coupledCase(
                "bodiesInGas", f"blow-{shape}-{name}", (40, 32, 1), (40*h, 32*h, h),
                lambda x, y, z, p=p: (RHO0*p/P0 + 0*x, 0*x, p + 0*x), end,
                {n: {"velocityField": n, "constitutiveModel": law} for n, law in laws.items()},
                {n: {"type": "box", "min": (low[0]*h, low[1]*h, 0),
                     "max": (high[0]*h, high[1]*h, h), "stress": ambient(p),
                     **({"velocity": (v, 0, 0)} if n == "block" else {})}
                 for n, (low, high) in boxes.items()},
                ends=OPEN, sides=OPEN, pointConditions="calculated", prepare=prepare,
                numerics={"shapeFunction": shape}, writeInterval=end,
                control={"reportInterval": 1, "maxSubSteps": subSteps})
            case.run("materialPointFoam", limit=100)
            last = case.points(case.times()[-1], "plate")
            found.append((float(re.findall(r"^Contact all .*impulse \((\S+) ", case.log(),
                                           re.M)[-1]), np.sum(last["m"]*last["U"][:, 0])))
        for name, (J, P) in zip(("", ", steps of the points in one of the gas 10"), found[1:]):
            table.row(f"blow in air, {shape}{name}: momentum of the plate over that in vacuum", 1,
                      P/found[0][1], 0.04)
            table.row(f"blow in air, {shape}{name}: share of it that contact gives", 1,
                      J/P, 0.7, "atLeast")


def overlapping(table):
    """Two bodies at one place: the stop says that they overlap, not that points have grown."""
    case = coupledCase(
        "bodiesInGas", "overlapping", (20, 1, 1), (20*H, H, H),
        lambda x, y, z: (RHO0 + 0*x, 0*x, P0 + 0*x), 1e-7,
        {n: {**SOLID, "velocityField": n} for n in ("one", "other")},
        {n: {"type": "box", "min": (a*H, 0, 0), "max": (b*H, H, H), "stress": ambient(P0)}
         for n, a, b in (("one", 4, 9), ("other", 6, 11))},
        ends=OPEN, pointConditions="calculated", writeInterval=1e-7,
        prepare=lambda case: ownFields(case, ("one", "other")))
    case.run("materialPointFoam", limit=100, fails=True)
    log = " ".join(case.log().split())
    table.check("overlapping points: the stop says so", "They have not grown, so they overlap" in
                log and "products of an explosion" not in log, log[-300:])


def stopped(table):
    end = 1e-6
    case = coupledCase(
        "bodiesInGas", "stopped", (20, 1, 1), (20*H, H, H),
        lambda x, y, z: (RHO0 + 0*x, 0*x, P0 + 0*x), end, {"slab": SOLID},
        {"slab": {"type": "box", "min": (14*H, 0, 0), "max": (19*H, H, H),
                  "stress": ambient(P0), "velocity": (500, 0, 0)}},
        ends=OPEN, pointConditions="calculated", writeInterval=end/10,
        control={"reportInterval": 1, "startFrom": "latestTime"})
    starts = []
    for _ in range(2):
        case.run("materialPointFoam", limit=100, fails=True)
        log = " ".join(case.log().split())
        starts.append(float(re.search(r" Time = (\S+)", log)[1]))
        written = re.search(r"is written to (\S+) for inspection; a restart begins at"
                            r" (\S+)\. ", log)
        table.check("slab that leaves: the message says where a restart begins",
                    bool(written), log[-300:])
        if not written:
            return
        last, begin = written.groups()
        missing = [f for f in ("p", "T.air", "U.air", "rho.air", "theta.air",
                               "lagrangian/slab/x")
                   if not os.path.isfile(case.file(f"{last}/{f}"))]
        table.check(f"slab that leaves: the gas is in the state before the step, {last}",
                    not missing, missing)
        table.check("slab that leaves: it is no state of a restart", not os.path.isfile(
            case.file(f"{last}/uniform/materialPointState")))
    table.check("slab that leaves: the next start puts it aside and begins where said",
                f"the run starts from {begin} " in log and starts[0] < float(begin)
                < starts[1], (begin, starts))


def main():
    table = Report("bodiesInGas")
    for part in (rotation, disorder, slab, products, blow, overlapping, stopped):
        try:
            part(table)
        except RunFailed as e:
            table.check(f"{part.__name__} runs", False, e)
    return table.finish()


if __name__ == "__main__":
    sys.exit(main())
