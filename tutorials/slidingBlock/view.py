"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "blocks": {
        "box": (0, 8, 0, 0.8), "floor": True, "size": 7,
        "points": [{
            "phases": ("mu6", "mu3", "mu0"), "field": "U_x", "label": "velocity [m/s]",
            "limits": (0, 5), "outline": "0.3"}],
    },
}
