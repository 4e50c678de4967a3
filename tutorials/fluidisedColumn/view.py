"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "bed": {
        "profile": ("pressure over 1 bar [kPa]", (-0.5, 7)),
        "gas": {"field": "1e-3*p - 100"},
        "points": [{"phases": ("grid", "bed")}],
    },
}
