"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "pressure": {
        "time": (1e3, "ms"), "length": (1e3, "mm"), "box": (-30, 30, -3, 45),
        "mirror": "across", "floor": True,
        "points": [{
            "phases": ("cylinder",), "field": "-1e-6*sigma_yy", "label": "-sigma_yy [MPa]",
            "limits": (0, 3)}],
    },
}
