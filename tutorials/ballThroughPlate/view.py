"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "debris": {
        "time": (1e6, "us"), "length": (1e3, "mm"), "mirror": "up", "box": (-18, 58, -25, 25),
        "points": [
            {"phases": ("plate",), "colour": "#9db7c9", "failed": ("damage", 1)},
            {"phases": ("ball",), "colour": "#e08a3c", "failed": ("damage", 1)}],
    },
}
