"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "plates": {
        "time": (1e6, "us"), "length": (1e3, "mm"),
        "gas": {"field": "1e-5*p", "label": "pressure of the air [bar]", "limits": (0.5, 1.5)},
        "points": [{
            "phases": ("target", "flyer"), "colour": "BODY", "failed": ("damage", 0.5),
            "close": 0.2, "outline": "0.3"}],
    },
}
