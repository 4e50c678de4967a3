"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "tube": {
        "time": (1e6, "us"), "length": (1e3, "mm"), "mirror": "up", "box": (0, 160, -90, 90),
        "size": 5.6,
        "gas": {"field": "1 - alpha.water", "label": "share of products, air and vapour",
                "limits": (0, 1), "colours": "PART"},
        "points": [{"phases": ("tube",), "colour": "BODY"}],
    },
}
