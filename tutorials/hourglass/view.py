"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "hourglass": {
        "length": (1e3, "mm"), "box": (0, 50, -180, 180), "size": 4,
        "points": [{
            "phases": ("sand",), "field": "sqrt(U_x*U_x + U_y*U_y)", "label": "speed [m/s]",
            "limits": (0, 1.5), "close": 3}],
    },
}
