"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "velocity": {
        "profile": ("velocity [m/s]", (-0.11, 0.11)), "box": (0, 26),
        "points": [{"phases": ("bar",), "field": "U_x", "colours": "SIGNED"}],
    },
}
