"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "wall": {
        "time": (1e3, "ms"), "box": (-2.4, 1.2, 0, 1.8), "size": 4.5,
        "gas": {"field": "1e-5*p", "label": "pressure [bar]", "limits": (0.3, 30),
                "log": True},
        "points": [
            {"phases": ("mortar",), "colour": "#8a7f70", "failed": ("damage", 1)},
            {"phases": ("blocks",), "colour": "#d9cbb3", "failed": ("damage", 1)}],
    },
}
