"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

VIEWS = {
    "spheres": {
        "time": (1e3, "ms"), "length": (1e3, "mm"), "box": (-11, 11, -21, 21), "axes": "xz",
        "mirror": "across", "size": 3,
        "points": [{"phases": ("upper", "lower"), "field": "1e-3*sigmaEq",
                    "label": "equivalent stress [kPa]", "limits": (0, 700), "close": 0.5}],
    },
}
