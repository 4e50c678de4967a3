"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "cylinder": {
        "time": (1e3, "ms"), "length": (1e3, "mm"), "box": (-400, 300, 0, 200), "size": 6,
        "gas": {"field": "1e-5*p", "label": "pressure [bar]", "limits": (0.1, 12), "log": True},
        "points": [{"phases": ("dust",), "colour": "k", "section": 4e-9}],
    },
}
