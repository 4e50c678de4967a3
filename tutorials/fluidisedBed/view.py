"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "bed": {
        "time": (1e3, "ms"), "length": (1e3, "mm"),
        "gas": {"field": "theta.air", "label": "share of air", "limits": (0.35, 1),
                "colours": "PART"},
    },
}
