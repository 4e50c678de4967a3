#!/usr/bin/env python3
"""What tutorials show: view.py, animations, ParaView's states.

views       each tutorial has a view.py whose cases, phases, fields and colours are there; a
            wrong word in one is refused
animation   vibratingBar to 12.5 s by Allrun -animate 10: the run writes ten times more than
            its start, all of its own among them, and the GIF has a frame for each; controlDict
            is as before. A block in air: frame of points and gas where they are
paraview    etc/paraview/state on the same block: a state that gives the points back, and a
            picture; skipped where there is no pvbatch
"""

import glob
import os
import re
import shutil
import subprocess
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../lib"))
from foamCase import PROJECT, RUN, FoamCase, runParts
from mpm import views

END = 0.8e-4


def text(*path):
    with open(os.path.join(*path)) as f:
        return f.read()


def last(output):
    return " ".join(output.split())[-200:]


def block():
    """tutorials/blockInAir/moving to 0.08 ms, two written times, and a view of it."""
    case = FoamCase("pictures", "block/moving",
                    os.path.join(PROJECT, "tutorials/blockInAir/moving"))
    case.change("system/controlDict", r"^endTime .*;", f"endTime {END};")
    case.change("system/controlDict", r"^writeInterval .*;", f"writeInterval {0.5*END};")
    case.run("blockMesh")
    case.run("setMaterialPoints")
    case.run("materialPointFoam")
    source = text(PROJECT, "tutorials/blockInAir/view.py")
    folder = os.path.dirname(case.path)
    with open(os.path.join(folder, "view.py"), "w") as f:
        f.write(source + 'del VIEWS["carried"]\n')
    return case, folder


def frames(path):
    """Pictures of a GIF as arrays [row, column, colour]."""
    import PIL.Image
    with PIL.Image.open(path) as image:
        found = []
        for i in range(image.n_frames):
            image.seek(i)
            found.append(np.asarray(image.convert("RGB"), float))
    return found


# --- parts -------------------------------------------------------------------

def viewsOfTutorials(table):
    tutorials = sorted(os.path.dirname(p) for p in glob.glob(
        os.path.join(PROJECT, "tutorials/*/Allrun")))
    bad = []
    for folder in tutorials:
        name = os.path.basename(folder)
        if not os.path.exists(os.path.join(folder, "view.py")):
            bad.append(f"{name}: no view.py")
            continue
        for title, view in views.readViews(folder).items():
            case = os.path.join(folder, view.get("case", "."))
            phases = set(re.search(r"^phases\s*\((.*?)\)", text(
                case, "constant/phaseProperties"), re.M)[1].split())
            for layer in views.layers(view):
                bad += [f"{name}, {title}: no phase {p}" for p in layer.get("phases", ())
                        if p not in phases]
                if layer.get("colours", "VALUES") not in ("VALUES", "HEAT", *views.STOPS):
                    bad.append(f"{name}, {title}: {layer['colours']}")
                if "field" in layer:
                    views.evaluate(layer["field"], lambda n: np.ones((2, 6 if n == "sigma" else
                                                                      3)))
                    if not ("limits" in layer and "label" in layer or "profile" in view):
                        bad.append(f"{name}, {title}: {layer['field']} without label or limits")
    table.row("tutorials with a view.py", 22, len(tutorials), 22, "atLeast")
    table.check("their phases, fields, colours are there", not bad, " | ".join(bad))
    folder = os.path.join(RUN, "pictures", "wrong")
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, "view.py"), "w") as f:
        f.write('VIEWS = {"a": {"points": [{"phases": ("p",), "colur": "BODY"}]}}\n')
    try:
        views.readViews(folder)
        said = ""
    except SystemExit as error:
        said = str(error)
    table.check("a wrong word is refused", "unknown colur" in said and "colour" in said, said)
    sigma = np.arange(12.0).reshape(2, 6)
    table.row("expression: 2*sigma_yy - sqrt(p) of arrays", 2*9 - 2, views.evaluate(
        "2*sigma_yy - sqrt(p)", {"sigma": sigma, "p": np.full(2, 4.0)}.get)[1], 0)
    table.check("the same for ParaView", views.calculator("1e-6*sigma_yy - sqrt(rho.air)")
                == '1e-6*"sigma_YY" - sqrt("rho.air")')


def animation(table):
    case = FoamCase("pictures", "bar", os.path.join(PROJECT, "tutorials/vibratingBar"))
    case.change("system/controlDict", r"^endTime .*;", "endTime 12.5;")
    before = text(case.file("system/controlDict"))
    with open(case.file("log.Allrun"), "w") as log:
        status = subprocess.run(
            ["./Allrun", "-animate", "10"], cwd=case.path, stdout=log,
            stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, timeout=300,
            env={**os.environ, "PWD": case.path, "MPM_PROJECT_DIR": PROJECT,
                 "MPM_PREPARED": "1"}).returncode
    table.check("Allrun -animate 10", status == 0, last(text(case.file("log.Allrun"))))
    table.check("Allrun ends with report.html", os.path.exists(case.file("report.html"))
                and "report.html: " in text(case.file("log.Allrun")))
    times = case.times("lagrangian")
    table.row("written times, five intervals in two parts each", 11, len(times), 0)
    table.check("all of the case's own are there", {"2.5", "5", "7.5", "10", "12.5"} <= set(times))
    table.check("controlDict is as before", text(case.file("system/controlDict")) == before)
    path = case.file("velocity.gif")
    found = frames(path) if os.path.exists(path) else []
    table.row("frames of the GIF", len(times), len(found), 0)
    same = sum(np.array_equal(a, b) for a, b in zip(found, found[1:]))
    table.row("frames like the one before", 0, same, 0)

    case, folder = block()
    subprocess.run([sys.executable, "-m", "mpm.animate", folder], check=True, timeout=300,
                   stdout=subprocess.DEVNULL)
    found = frames(os.path.join(folder, "moving.gif"))
    times = case.times("theta.air")
    table.row("block in air: frames (none of the start: no gas is written there)", len(times),
              len(found), 0)
    # Grey pixels of the block over the blue to white ones of the air, which fill the axes
    grey = [np.abs(f - 0xc9).max(axis=2) < 12 for f in found]
    x = case.points(times[-1], "block")["x"]
    rows, columns = (np.nonzero(grey[-1].sum(axis=a) > 20)[0] for a in (1, 0))
    table.row("block in air: width over height in the picture", np.ptp(x[:, 0])/np.ptp(x[:, 1]),
              np.ptp(columns)/np.ptp(rows), 0.05, "relative")
    moved = [np.nonzero(g)[1].mean() for g in grey]
    table.check("block in air: moves to the right", np.all(np.diff(moved) > 0), moved)


#: Run by pvbatch: what a state has
CHECK = """
import sys
from paraview import simple as pv
pv.LoadState(sys.argv[1])
source = pv.FindSource("block")
source.UpdatePipeline(float(sys.argv[2]))
low, high = source.GetPointDataInformation().GetArray("id").GetRange()
print("block", source.GetDataInformation().GetNumberOfPoints(), int(low), int(high))
view = pv.GetActiveViewOrCreate("RenderView")
print("shown", sorted(str(r.Representation).strip("'") for r in view.Representations
                       if hasattr(r, "Representation") and r.Visibility))
"""


def paraview(table):
    pvbatch = os.environ.get("MPM_PVBATCH", "pvbatch")
    if not shutil.which(pvbatch):
        table.skip("etc/paraview/state", f"no {pvbatch} here")
        return
    case, folder = block()
    script = os.path.join(folder, "check.py")
    with open(script, "w") as f:
        f.write(CHECK)
    tool = os.path.join(PROJECT, "etc/paraview/state")
    state, picture = (os.path.join(folder, "moving" + e) for e in (".pvsm", "ParaView.png"))
    output = []
    for command in ([tool, folder], [tool, "-run", script, state, case.times()[-1]]):
        run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                             stdin=subprocess.DEVNULL, timeout=200)
        output.append(run.stdout.decode(errors="replace"))
        if "No module named 'paraview'" in output[-1]:
            table.skip("etc/paraview/state", f"{pvbatch} without its Python modules")
            return
    table.check("etc/paraview/state makes a state and a picture",
                os.path.exists(state) and os.path.exists(picture), last(output[0]))
    ids = case.points(case.times()[-1], "block")["id"]
    table.check("the state: points of the last time, with their columns",
                f"block {len(ids)} {ids.min()} {ids.max()}\n" in output[1], last(output[1]))
    table.check("the state: Point Gaussians, the gas as a surface",
                "shown ['Point Gaussian', 'Surface']\n" in output[1], last(output[1]))
    if os.path.exists(picture):
        import PIL.Image
        image = np.asarray(PIL.Image.open(picture).convert("RGB"), float)
        grey = (np.abs(image - 0xc9).max(axis=2) < 4).mean()
        x, half = (case.points(case.times()[-1], "block")[n] for n in ("x", "halfSize"))
        # The mesh, 40 mm by 40 mm, beside a bar of 150 pixels, within a margin of 10
        share = np.prod(np.ptp(x[:, :2], axis=0) + 2*half[0, :2])/0.04**2
        share *= (image.shape[0] - 20)**2/image[..., 0].size
        table.row("the picture: share of the block's colour", share, grey, 0.05, "relative")


if __name__ == "__main__":
    sys.exit(runParts("pictures", viewsOfTutorials, animation, paraview))
