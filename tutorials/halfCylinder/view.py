"""What Allrun -animate and ParaView show of this case: etc/python/mpm/views.py."""

# Of constant/phaseProperties and the mesh; the band of a crack is as wide as a cell
E, STRENGTH, GF, CELL = 2e9, 2e6, 100.0, 0.05/40
R = 2*E*GF/(STRENGTH**2*CELL)

VIEWS = {
    "crack": {
        "time": (1e6, "us"), "length": (1e3, "mm"), "box": (-57, 57, -3, 57), "floor": True,
        "points": [{
            "phases": ("body",), "field": f"damage/(damage + {R:.6g}*(1 - damage))",
            "label": "spent fracture energy", "limits": (0, 1), "colours": "DAMAGE",
            "failed": ("damage", 1)}],
    },
}
