"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

# Nearly all debris has failed: the colours are those of the materials
VIEWS = {
    "debris": {
        "time": (1e6, "us"), "length": (1e3, "mm"), "mirror": "up", "box": (-18, 58, -25, 25),
        "points": [
            {"phases": ("plate",), "colour": "#5b86a3"},
            {"phases": ("ball",), "colour": "#e08a3c"}],
    },
}
