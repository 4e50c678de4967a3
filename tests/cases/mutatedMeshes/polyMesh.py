"""A polyMesh of ASCII files as lists that may be changed at will.

    mesh = PolyMesh(case.file("constant", "polyMesh"))
    mesh.faces[7].reverse()
    mesh.write(folder)

patches: [name, entries] each, entries in their order; raw: bytes that stand for a file
in place of what the lists give (None: no such file).
"""

import os
import re

import numpy as np

from mpm.files import fileHeader

KINDS = {"points": "vectorField", "faces": "faceList", "owner": "labelList",
         "neighbour": "labelList", "boundary": "polyBoundaryMesh"}


def _body(folder, name):
    with open(os.path.join(folder, name)) as f:
        text = re.sub(r"//.*|/\*(.|\n)*?\*/", "", f.read())
    text = text[text.index("}") + 1:]
    return text[text.index("(") + 1:text.rindex(")")]


class PolyMesh:
    def __init__(self, folder):
        self.points = [tuple(map(float, p)) for p in re.findall(
            r"\(\s*(\S+)\s+(\S+)\s+([^\s()]+)\s*\)", _body(folder, "points"))]
        self.faces = [list(map(int, f.split())) for f in
                      re.findall(r"\d+\(([\d\s]*)\)", _body(folder, "faces"))]
        self.owner = list(map(int, _body(folder, "owner").split()))
        self.neighbour = list(map(int, _body(folder, "neighbour").split()))
        self.patches = [[name, dict(e.strip().split(None, 1)
                                    for e in text.split(";") if e.strip())]
                        for name, text in re.findall(r"(\w+)\s*\{([^}]*)\}",
                                                     _body(folder, "boundary"))]
        for _, p in self.patches:
            p["nFaces"], p["startFace"] = int(p["nFaces"]), int(p["startFace"])
        self.raw = {}

    def write(self, folder):
        rows = {"points": ["({!r} {!r} {!r})".format(*p) for p in self.points],
                "faces": [f"{len(f)}({' '.join(map(str, f))})" for f in self.faces],
                "owner": map(str, self.owner), "neighbour": map(str, self.neighbour),
                "boundary": [f"{name} {{ " + " ".join(f"{k} {v};" for k, v in p.items())
                             + " }" for name, p in self.patches]}
        for name, kind in KINDS.items():
            lines = list(rows[name])
            with open(os.path.join(folder, name), "w") as f:
                f.write(fileHeader(name, kind) + f"{len(lines)}\n(\n"
                        + "\n".join(lines) + "\n)\n")
        for name, text in self.raw.items():
            file = os.path.join(folder, name)
            if text is None:
                os.remove(file)
            else:
                with open(file, "wb") as f:
                    f.write(text)

    # --- what changes need to know of it

    @property
    def nInternal(self):
        return len(self.neighbour)

    @property
    def nCells(self):
        return max(self.owner) + 1

    def x(self):
        return np.array(self.points)

    def facesOf(self, cell):
        return [i for i, o in enumerate(self.owner) if o == cell] + \
            [i for i, n in enumerate(self.neighbour) if n == cell]

    def pointsOf(self, cell):
        return sorted({p for f in self.facesOf(cell) for p in self.faces[f]})

    def centre(self, face):
        return self.x()[self.faces[face]].mean(axis=0)

    def near(self, at, inner=True):
        """The face (between cells, or of the boundary) nearest to a place."""
        of = range(self.nInternal) if inner else range(self.nInternal, len(self.faces))
        x = self.x()
        return min(of, key=lambda f: np.sum((x[self.faces[f]].mean(axis=0) - at)**2))

    def patch(self, name):
        return next(p for n, p in self.patches if n == name)

    def patchOf(self, face):
        return next(p for _, p in self.patches
                    if 0 <= face - p["startFace"] < p["nFaces"])

    # --- changes that keep it consistent

    def removeInner(self, face):
        for of in (self.faces, self.owner, self.neighbour):
            del of[face]
        for _, p in self.patches:
            p["startFace"] -= 1

    def addOuter(self, patch, face, owner):
        """Append a face to the last faces of a patch."""
        at = self.patch(patch)["startFace"] + self.patch(patch)["nFaces"]
        self.patch(patch)["nFaces"] += 1
        self.faces.insert(at, face)
        self.owner.insert(at, owner)
        behind = False
        for name, p in self.patches:
            p["startFace"] += behind
            behind = behind or name == patch

    def renumberPoints(self, to):
        """Point i becomes to[i]."""
        points = list(self.points)
        for i, j in enumerate(to):
            points[j] = self.points[i]
        self.points = points
        self.faces = [[to[p] for p in f] for f in self.faces]

    def renumberCells(self, to):
        """Cell i becomes to[i]: faces between cells point to the higher one."""
        self.owner = [to[c] for c in self.owner]
        self.neighbour = [to[c] for c in self.neighbour]
        for f in range(self.nInternal):
            if self.owner[f] > self.neighbour[f]:
                self.exchange(f)
        order = sorted(range(self.nInternal),
                       key=lambda f: (self.owner[f], self.neighbour[f]))
        self.orderInner(order)

    def orderInner(self, order):
        n = self.nInternal
        self.faces[:n] = [self.faces[f] for f in order]
        self.owner[:n] = [self.owner[f] for f in order]
        self.neighbour[:n] = [self.neighbour[f] for f in order]

    def exchange(self, face):
        """Owner and neighbour, and the face looks the other way."""
        self.owner[face], self.neighbour[face] = self.neighbour[face], self.owner[face]
        self.faces[face] = self.faces[face][:1] + self.faces[face][:0:-1]
