"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "helium": {
        "time": (1e6, "us"), "length": (1e3, "mm"),
        "gas": {"field": "rho", "label": "density [kg/m3]", "limits": (0.2, 1.8)},
    },
}
