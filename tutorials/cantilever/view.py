"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "beam": {
        "box": (-0.03, 1.15, -0.55, 0.15),
        "points": [
            {"phases": ("beam",), "field": "1e-3*sigma_xx", "label": "stress along x [kPa]",
             "limits": (-2, 2), "colours": "SIGNED", "close": 1},
            {"phases": ("weight",), "colour": "RIGID", "close": 1}],
    },
}
