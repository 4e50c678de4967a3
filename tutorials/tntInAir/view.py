"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "pressure": {
        "time": (1e3, "ms"), "profile": ("pressure [bar]", (0, 12)),
        "gas": {"field": "1e-5*p"},
    },
}
