"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "waterAir": {
        "case": "waterAir", "time": (1e6, "us"),
        "profile": ("pressure [bar]", (0, 10500)),
        "gas": {"field": "1e-5*p"},
    },
    "productsWater": {
        "case": "productsWater", "time": (1e6, "us"),
        "profile": ("pressure [bar]", (0, 90000)),
        "gas": {"field": "1e-5*p"},
    },
    "vanDerWaals": {
        "case": "vanDerWaals", "time": (1e6, "us"),
        "profile": ("pressure [bar]", (0, 10500)),
        "gas": {"field": "1e-5*p"},
    },
}
