"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "clamped": {
        "case": "clamped", "time": (1e3, "ms"), "length": (1e3, "mm"), "mirror": "up",
        "box": (-60, 130, -100, 100), "size": 5.6,
        "gas": {"field": "alpha.air", "label": "share of air", "limits": (0, 1),
                "colours": "PART"},
        "points": [{"phases": ("plate",), "colour": "BODY", "failed": ("damage", 1)}],
    },
}
