"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "blast": {
        "time": (1e3, "ms"), "mirror": "up", "box": (-0.5, 1.3, -0.9, 0.9), "size": 3.9,
        "gas": {"field": "1e-5*p", "label": "pressure [bar]", "limits": (0.2, 20),
                "log": True},
        "points": [
            {"phases": ("mortar",), "colour": "#8a7f70", "failed": ("damage", 1)},
            {"phases": ("blocks",), "colour": "#d9cbb3", "failed": ("damage", 1)}],
    },
}
