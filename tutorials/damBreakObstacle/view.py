"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "obstacle": {
        "time": (1e3, "ms"), "length": (1e3, "mm"),
        "gas": {"field": "alpha.air", "label": "share of air", "limits": (0, 1),
                "colours": "PART"},
        "points": [{"phases": ("obstacle",), "colour": "BODY"}],
    },
}
