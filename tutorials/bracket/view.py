"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "bends": {
        "box": (-0.15, 0.6, -0.75, 0.02),
        "points": [{
            "phases": ("bracket",), "field": "1e-3*sigma_xx", "label": "stress along x [kPa]",
            "limits": (-40, 40), "colours": "SIGNED", "close": 1, "section": 8e-3}],
    },
}
