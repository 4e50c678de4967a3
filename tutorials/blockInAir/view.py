"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "moving": {
        "case": "moving", "time": (1e3, "ms"), "length": (1e3, "mm"),
        "gas": {"field": "theta.air", "label": "volume fraction of the air", "limits": (0, 1),
                "colours": "PART"},
        "points": [{"phases": ("block",), "colour": "BODY", "outline": "k"}],
    },
    "carried": {
        "case": "carried", "time": (1e3, "ms"), "length": (1e3, "mm"),
        "profile": ("velocity [m/s]", (-20, 60)),
        "gas": {"field": "U.air_x"},
        "points": [{"phases": ("block",), "field": "U_x"}],
    },
}
