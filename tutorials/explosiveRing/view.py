"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "ring": {
        "time": (1e6, "us"), "length": (1e3, "mm"), "size": 5,
        "gas": {"field": "alpha.tnt", "label": "share of products", "limits": (0, 1),
                "colours": "PART"},
        "points": [{"phases": ("ring",), "colour": "BODY", "failed": ("damage", 1)}],
    },
}
