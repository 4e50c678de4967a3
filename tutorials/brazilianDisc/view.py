"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "crack": {
        "box": (-0.6, 0.6, -0.68, 0.68), "size": 4.6,
        "points": [
            {"phases": ("caps", "upper", "lower"), "colour": "RIGID"},
            {"phases": ("disc",), "field": "sigma_xx", "label": "stress along x [Pa]",
             "limits": (-700, 700), "colours": "SIGNED", "failed": ("damage", 0.99),
             "outline": "0.3"}],
    },
}
