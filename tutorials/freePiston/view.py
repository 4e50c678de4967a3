"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "piston": {
        "time": (1e3, "ms"), "profile": ("velocity [m/s]", (-1.2, 1.2)),
        "gas": {"field": "U.air_x", "colours": "SIGNED"},
        "points": [{"phases": ("slab",), "field": "U_x", "colours": "SIGNED"}],
    },
}
