"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "rod": {
        "time": (1e3, "ms"), "length": (1e3, "mm"), "box": (-96, 184, -320, 80), "axes": "xz",
        "size": 4, "from": (0.42, -0.86, 0.28),
        "points": [
            {"phases": ("pad",), "field": "1e-3*sigmaEq", "label": "equivalent stress [kPa]",
             "limits": (0, 250)},
            {"phases": ("rod",), "colour": "RIGID", "close": 1}],
    },
}
