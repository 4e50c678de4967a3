"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "slab": {
        "case": "slab", "time": (1e3, "ms"),
        "profile": ("pressure of the air [bar]", (0, 18)),
        "gas": {"field": "1e-5*p"},
        "points": [{"phases": ("slab",)}],
    },
    "cylinder": {
        "case": "cylinder", "time": (1e3, "ms"), "length": (1e3, "mm"),
        "gas": {"field": "1e-5*p", "label": "pressure [bar]", "limits": (1, 12)},
        "points": [{"phases": ("disc",), "colour": "BODY", "outline": "k"}],
    },
    "wedge": {
        "case": "wedge", "time": (1e3, "ms"), "box": (0, 1, 0, 0.5),
        "gas": {"field": "1e-5*p", "label": "p/p1", "limits": (1, 1.8)},
        "points": [{"phases": ("wedge",), "colour": "BODY", "outline": "k"}],
    },
}
