"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "pipe": {
        "time": (1e3, "ms"), "length": (1e3, "mm"), "box": (-360, 360, -10, 360), "size": 5,
        "gas": {"field": "1e-5*p", "label": "pressure [bar]", "limits": (1, 5)},
        "points": [{"phases": ("plug",), "colour": "#d9cbb3", "close": 1, "section": 1e-2}],
    },
}
