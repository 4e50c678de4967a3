"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "disk": {
        "case": "disk", "time": (1e3, "ms"), "length": (100, "cm"),
        "points": [{"phases": ("disk",), "colour": "BODY", "outline": "0.3"}],
    },
    "ball": {
        "case": "ball", "time": (1e3, "ms"), "length": (100, "cm"), "from": (0.6, 0.5, 1),
        "points": [{"phases": ("ball",), "colour": "BODY", "outline": "0.3"}],
    },
}
