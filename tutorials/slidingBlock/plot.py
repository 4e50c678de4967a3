"""Velocity of the blocks along the slope beside Coulomb's, and their acceleration."""

import numpy as np

from mpm.case import Case
from mpm.pictures import plt, save

G, SLOPE, RAMP = 9.81, np.radians(30), 0.2

figure, axis = plt.subplots(figsize=(7, 4.5))
for k, (name, mu) in enumerate((("mu0", 0.0), ("mu3", 0.3), ("mu6", 0.6))):
    record = Case().series("balance", f"{name}.dat")
    record = record[record[:, 0] > 0]
    t, u = record[:, 0], record[:, 3]/record[:, 2]
    exact = max(0.0, G*(np.sin(SLOPE) - mu*np.cos(SLOPE)))
    late = t > 0.3
    a = np.polyfit(t[late], u[late], 1)[0]
    if exact > 0:
        print(f"mu {mu}: acceleration {a:.4f} m/s2, g (sin - mu cos) = {exact:.4f},"
              f" {100*(a/exact - 1):+.2f} %")
    else:
        print(f"mu {mu}: velocity at the end {u[-1]:.1e} m/s, sticks; without friction"
              f" {G*np.sin(SLOPE)*(t[-1] - 0.5*RAMP):.2f}")
    axis.plot(t, u, f"C{k}", label=f"mu {mu}")
    axis.plot(t, exact*np.where(t < RAMP, t**2/(2*RAMP), t - 0.5*RAMP), "k:", lw=1,
              label=None if k else "rigid block")
axis.set(xlabel="time [s]", ylabel="velocity along the slope [m/s]")
axis.legend()
save(figure, "slidingBlock.png")
