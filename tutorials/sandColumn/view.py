"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "heap": {
        "box": (0, 0.6, -0.01, 0.215), "floor": True, "size": 7,
        "points": [{
            "phases": ("sand",), "field": "sqrt(U_x*U_x + U_y*U_y)", "label": "speed [m/s]",
            "limits": (0, 1.5), "close": 3}],
    },
}
