"""matplotlib in the style of the tutorials' pictures, without a screen."""

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

plt.rcParams.update({"figure.constrained_layout.use": True, "legend.fontsize": 8,
                     "savefig.dpi": 130})
