"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "dilute": {
        "case": "dilute", "time": (1e6, "us"), "profile": ("pressure [bar]", (0, 11)),
        "gas": {"field": "1e-5*p"},
    },
    "dense": {
        "case": "dense", "time": (1e6, "us"), "length": (1e3, "mm"), "box": (0, 60),
        "profile": ("pressure [bar]", (0, 110)),
        "gas": {"field": "1e-5*p"},
        "points": [{"phases": ("dust",)}],
    },
}
