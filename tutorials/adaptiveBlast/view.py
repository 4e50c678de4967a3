"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py; plot.py makes
a film with the gas."""

VIEWS = {
    "front": {
        "time": (1e3, "ms"), "box": (0, 0.7, 0, 0.9), "axes": "zy", "size": 4,
        "from": (-0.8, 0.3, 0.5),
        "points": [{"phases": ("blocks", "mortar"), "field": "damage", "label": "damage",
                    "limits": (0, 1), "colours": "DAMAGE"}],
    },
}
