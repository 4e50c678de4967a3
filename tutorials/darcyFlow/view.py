"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "pressure": {
        "profile": ("pressure [kPa]", (99, 123)),
        "gas": {"field": "1e-3*p"},
        "points": [{"phases": ("block",)}],
    },
}
