"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "disks": {
        "box": (-0.05, 1.05, -0.05, 1.05),
        "points": [{
            "phases": ("lower", "upper"), "field": "-pPoint", "label": "mean stress [Pa]",
            "limits": (-150, 150), "colours": "SIGNED", "close": 1, "outline": "0.3"}],
    },
}
