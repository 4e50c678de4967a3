"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "plates": {
        "time": (1e6, "us"), "length": (1e3, "mm"), "box": (-2.6, 2.6, -0.6, 6.2),
        "points": [{
            "phases": ("target", "flyer"), "field": "1e-6*sigma_yy",
            "label": "stress along y [MPa]", "limits": (-700, 700), "colours": "SIGNED",
            "failed": ("damage", 0.5), "close": 1, "section": 1e-3}],
    },
}
