"""Runs the two disks with several schemes in schemes/ and compares the error of
the total energy with what other codes reach on the same case."""

from energies import Energies, endAndLargest
from mpm.case import Case, RunFailed
from mpm.pictures import plt, save

TRANSFERS = (("FLIP", "transfer FLIP; PICfraction 0;"),
             ("FLIP 1 % PIC", "transfer FLIP; PICfraction 0.01;"),
             ("FMPM 2", "transfer FMPM; order 2;"),
             ("FMPM 4", "transfer FMPM; order 4;"),
             ("XPIC 2", "transfer XPIC; order 2;"),
             ("APIC", "transfer APIC;"))
UPDATES = ("MUSL", "USL", "USF", "USAVG")

#: shape function, transfer, stress update, maxCo, stress of the law
RUNS = [(shape, name, entry, update, 0.2, "Kirchhoff")
        for shape in ("linear", "GIMP", "quadraticBSpline")
        for name, entry in TRANSFERS for update in UPDATES]
RUNS += [("GIMP", *TRANSFERS[0], update, co, "Kirchhoff")
         for update in ("MUSL", "USAVG") for co in (0.4, 0.1, 0.05)]
RUNS += [("GIMP", *TRANSFERS[0], "USAVG", 0.2, "Cauchy")]

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


def run(shape, name, entry, update, co, stress):
    """Energies of the run; None if it did not reach the end."""
    case = Case(f"schemes/{shape}-{name}-{update}-{co}-{stress}".replace(" ", "")
                .replace("%", ""))
    case.copy(("U.disks",))
    case.change("system/fvSolution", r"(?s)^materialPoints\s*\{.*?\}",
                f"materialPoints\n{{\n    shapeFunction {shape}; {entry} stressUpdate {update};\n}}")
    case.change("constant/phaseProperties", r"\bstress\s.*?;", f"stress {stress};")
    case.change("system/controlDict", r"^maxCo\s.*?;", f"maxCo {co};")
    case.change("system/controlDict", r"^writeInterval\s.*?;", "writeInterval 3;")
    case.run("blockMesh")
    case.run("setMaterialPoints")
    try:
        case.run("materialPointFoam")
    except RunFailed:
        return None
    return Energies(case.path)


print("In per cent of the energy at the start. Error of the total energy at t = 3 s\n"
      "(largest of 0..3 s); transfer and residual of the budget at 3 s; change of\n"
      "momentum and angular momentum over those of a disk\n")
print(f"{'scheme':30s} {'stress update':13s} {'maxCo':>5s} {'steps':>5s}  {'error':>8s} (largest)  "
      f"{'transfer':>8s} {'residual':>8s}  {'K left':>6s}  momentum  angular")
figure, axes = plt.subplots(1, 2, figsize=(11, 4.2))
for shape, name, entry, update, co, stress in RUNS:
    label = f"{shape}, {name}" + ("" if stress == "Kirchhoff" else ", " + stress)
    e = run(shape, name, entry, update, co, stress)
    if e is None:
        print(f"{label:30s} {update:13s} {co:5g}  does not reach the end", flush=True)
        continue
    end, largest = endAndLargest(e.error)
    print(f"{label:30s} {update:13s} {co:5g} {len(e.t):5d}  {end:+8.3f} ({largest:7.3f})  "
          f"{e.transfer[-1]:+8.3f} {e.residual[-1]:+8.3f}  {100*e.kinetic[-1]/e.start:6.1f}  "
          f"{e.momentumError:8.1e}  {e.angularError:.1e}", flush=True)
    if co == 0.2 and shape == "GIMP" and stress == "Kirchhoff" and update == "USAVG":
        axes[0].plot(e.t, e.error, lw=1, label=name)
    if (shape, name, stress, co) == ("GIMP", "FLIP", "Kirchhoff", 0.2):
        axes[1].plot(e.t, e.error, lw=1, label=update)
for ax, title in zip(axes, ("GIMP, USAVG, maxCo 0.2: transfers",
                            "GIMP, FLIP, maxCo 0.2: stress updates")):
    ax.axhline(0, color="k", lw=0.5)
    ax.set_title(title, fontsize=9)
    ax.set_xlabel("time [s]")
    ax.legend(fontsize=7)
axes[0].set_ylabel("error of the total energy [%]")
save(figure, "schemes.png")

print("\nOther codes")
for name, end, largest in PEERS:
    print(f"{name:32s} {end:>12s} ({largest})")
