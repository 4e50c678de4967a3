"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "plates": {
        "time": (1e6, "us"), "length": (1e3, "mm"), "box": (-4.3, 4.3, -0.8, 6.3),
        "points": [{
            "phases": ("target", "flyer"), "field": "1e-6*sigma_yy",
            "label": "stress along y [MPa]", "limits": (-700, 700), "colours": "SIGNED",
            "failed": ("damage", 0.5), "close": 0.2, "outline": "0.3"}],
    },
}
