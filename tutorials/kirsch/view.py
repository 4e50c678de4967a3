"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "hole": {
        "time": (1e6, "us"), "length": (1e3, "mm"), "box": (0, 30, 0, 30),
        "points": [{
            "phases": ("plate",), "field": "1e-6*sigma_xx", "label": "stress along x [MPa]",
            "limits": (-100, 300), "close": 1, "section": 10e-3}],
    },
}
