"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "penetration": {
        "time": (1e6, "us"), "length": (1e3, "mm"), "mirror": "up",
        "box": (-42, 40, -20, 20), "size": 7,
        "points": [
            {"phases": ("target",), "colour": "BODY", "close": 1},
            {"phases": ("rod",), "colour": "#d98b3a", "close": 1},
            {"phases": ("debris",), "colour": "FAILED", "close": 1}],
    },
}
