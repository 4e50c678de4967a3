"""Runs the two disks with several schemes in schemes/ and compares the error of
the total energy with what other codes reach on the same case."""

import os
import re
import shutil
import subprocess
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

from energies import Energies, endAndLargest

TRANSFERS = (("FLIP", "transfer FLIP; PICfraction 0;"),
             ("FLIP 1 % PIC", "transfer FLIP; PICfraction 0.01;"),
             ("FMPM 2", "transfer FMPM; order 2;"))

#: shape function, transfer, maxCo, stress of the law
RUNS = [(shape, name, entry, 0.2, "Kirchhoff") for shape in ("GIMP", "linear")
        for name, entry in TRANSFERS]
RUNS += [("GIMP", "FMPM 4", "transfer FMPM; order 4;", 0.2, "Kirchhoff")]
RUNS += [("GIMP", *TRANSFERS[0], co, "Kirchhoff") for co in (0.4, 0.1, 0.05, 0.02)]
RUNS += [("GIMP", *TRANSFERS[0], 0.02, "Cauchy"),
         ("linear", *TRANSFERS[0], 0.02, "Kirchhoff")]

#: The same case in other codes: error at t = 3 s, largest (absolute) in %
PEERS = (("Nairn, USAVG+, linear", "+0.03", "0.15"),
         ("Nairn, USAVG+, uGIMP", "-0.03", "0.10"),
         ("Nairn, USAVG+, B-spline", "-0.03", "0.09"),
         ("Nairn, USF", "+1.2 to +2.2", "4.5 to 4.7"),
         ("MPM3D-F90, MUSL, linear", "-1.1", "3.4"),
         ("Karamelo, FLIP 1, linear", "-0.5", "6.9"),
         ("Karamelo, FLIP 1, quadratic", "-0.7", "8.5"),
         ("Karamelo, FLIP 0.99", "-4.6", "-"),
         ("ExaGOOP, MUSL, linear, alpha 1", "+0.4", "6.7"),
         ("ExaGOOP, alpha 0.95", "-14.6", "-"))


def replace(path, pattern, text):
    with open(path) as f:
        old = f.read()
    new, count = re.subn(pattern, text, old, flags=re.S | re.M)
    if count != 1:
        sys.exit(f"compare.py: '{pattern}' is {count} times in {path}")
    with open(path, "w") as f:
        f.write(new)


def run(shape, name, entry, co, stress):
    case = f"schemes/{shape}-{name}-{co}-{stress}".replace(" ", "").replace("%", "")
    shutil.rmtree(case, ignore_errors=True)
    os.makedirs(os.path.join(case, "0"))
    for folder in ("constant", "system"):
        shutil.copytree(folder, os.path.join(case, folder))
    shutil.copy("0/U.disks", os.path.join(case, "0"))
    replace(os.path.join(case, "system/fvSolution"), r"^materialPoints\s*\{.*?\}",
            f"materialPoints\n{{\n    shapeFunction {shape}; {entry}\n}}")
    replace(os.path.join(case, "constant/phaseProperties"), r"\bstress\s.*?;",
            f"stress {stress};")
    control = os.path.join(case, "system/controlDict")
    replace(control, r"^maxCo\s.*?;", f"maxCo {co};")
    replace(control, r"^writeInterval\s.*?;", "writeInterval 3;")
    for application in ("setMaterialPoints", "materialPointFoam"):
        with open(os.path.join(case, "log." + application), "w") as log:
            code = subprocess.run([application, "-case", case], stdout=log,
                                  stderr=subprocess.STDOUT).returncode
        if code:
            sys.exit(f"compare.py: {application} failed, see {log.name}")
    return Energies(case)


print("Error of the total energy in per cent: at t = 3 s (largest of 0..3 s)\n"
      "K(n) + W(n): as recorded; same time: kinetic energy between the steps\n")
print(f"{'scheme':20s} {'stress':10s} {'maxCo':>6s} {'steps':>6s}   {'K(n) + W(n)':>18s}   {'same time':>18s}   "
      f"kinetic left")
figure, axes = plt.subplots(1, 2, figsize=(11, 4.2), constrained_layout=True)
for shape, name, entry, co, stress in RUNS:
    e = run(shape, name, entry, co, stress)
    end, largest = endAndLargest(e.error)
    endCentred, largestCentred = endAndLargest(e.errorCentred)
    print(f"{shape + ', ' + name:20s} {stress:10s} {co:6g} {len(e.t):6d}   "
          f"{end:+8.3f} ({largest:6.3f})   "
          f"{endCentred:+8.3f} ({largestCentred:6.3f})   {100*e.kinetic[-1]/e.start:6.1f} %",
          flush=True)
    if co == 0.2:
        axes[0].plot(e.t, e.error, lw=1, label=f"{shape}, {name}")
    if (shape, name, stress) == ("GIMP", "FLIP", "Kirchhoff"):
        axes[1].plot(e.t, e.error, lw=1, label=f"maxCo {co}")
for ax, title in zip(axes, ("schemes, maxCo 0.2", "GIMP, FLIP: time step")):
    ax.axhline(0, color="k", lw=0.5)
    ax.set_title(title, fontsize=9)
    ax.set_xlabel("time [s]")
    ax.legend(fontsize=7)
axes[0].set_ylabel("error of the total energy [%]")
figure.savefig("schemes.png", dpi=130)

print("\nOther codes")
for name, end, largest in PEERS:
    print(f"{name:32s} {end:>12s} ({largest})")
