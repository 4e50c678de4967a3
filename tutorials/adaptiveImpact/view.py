"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "impact": {
        "time": (1e6, "us"), "length": (1e3, "mm"), "box": (-31, 31, -36, 8),
        "mirror": "across",
        "points": [{
            "phases": ("target", "rod"), "field": "100*plasticStrain",
            "label": "plastic strain [%]", "limits": (0, 100), "colours": "HEAT",
            "close": 1, "section": 1e-3}],
    },
}
