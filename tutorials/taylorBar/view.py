"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "strain": {
        "time": (1e6, "us"), "length": (1e3, "mm"), "axes": "yx", "mirror": "across",
        "box": (-9, 9, -0.8, 26.5), "floor": True, "size": 4.2,
        "points": [{
            "phases": ("bar",), "field": "plasticStrain", "label": "plastic strain",
            "limits": (0, 2), "close": 2.5}],
    },
}
