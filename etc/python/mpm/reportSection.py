"""Cells of a case's mesh cut by a plane, for the pictures of mpm.report."""

import os

import numpy as np

from mpm.case import Case
from mpm.files import readField, readLists


class Section:
    """Cells of a mesh of any kind, cut by the plane through its middle: polygons and values.
    Of a case that is not put together the meshes of all processors, of a mesh that changes
    that of the time."""

    def __init__(self, scene, normal):
        self.normal, self.known = normal, {}
        case = scene.case
        whole = os.path.exists(case.file("constant/polyMesh/owner")) and (
            len(case.times()) > 1 or not case.processors())
        self.pieces = [case] if whole else [Case(p) for p in case.processors()]
        # Not through points of the mesh
        low, high = scene.box[normal]
        self.place = 0.5*(low + high) + 1.234e-6*(high - low)

    def meshFile(self, piece, time, name):
        """The newest file of the mesh that is not after the time."""
        times = [t for t in piece.times(f"polyMesh/{name}") if float(t) <= float(time)]
        return piece.file(times[-1] if times else "constant", "polyMesh", name)

    def cut(self, piece, time):
        """Numbers of the cells that the plane meets, and their polygons [corner, 3]."""
        files = [self.meshFile(piece, time, n)
                 for n in ("points", "faces", "owner", "neighbour")]
        if tuple(files) in self.known:
            return self.known[tuple(files)]
        x = readField(files[0])
        first, size = readLists(files[1], flat=True)
        owner, neighbour = (readLists(f) for f in files[2:])
        if not len(size):
            return np.zeros(0, int), []
        face = np.repeat(np.arange(len(size)), size)
        start = np.cumsum(size) - size
        after = np.arange(len(first)) + 1
        after[start + size - 1] = start
        second = first[after]
        # Edges of faces that cross the plane: two of each face that does
        d = x[:, self.normal] - self.place
        cross = np.flatnonzero(d[first]*d[second] < 0)
        i, j, face = first[cross], second[cross], face[cross]
        point = x[i] + (d[i]/(d[i] - d[j]))[:, None]*(x[j] - x[i])
        inner = face < len(neighbour)
        cell = np.concatenate([owner[face], neighbour[face[inner]]])
        point = np.concatenate([point, point[inner]])
        if not len(cell):
            self.known[tuple(files)] = cell, []
            return cell, []
        # Corners of each cell in their order about its middle
        order = np.argsort(cell, kind="stable")
        cells, at, n = np.unique(cell[order], return_index=True, return_counts=True)
        point = point[order]
        across = [a for a in range(3) if a != self.normal]
        middle = np.repeat(np.add.reduceat(point, at)/n[:, None], n, axis=0)
        angle = np.arctan2(*(point - middle)[:, across].T)
        order = np.lexsort((angle, np.repeat(np.arange(len(cells)), n)))
        self.known[tuple(files)] = cells, np.split(point[order], at[1:])
        return self.known[tuple(files)]

    def cells(self, time, field):
        """Polygons [corner, 3] and values of the cells at a time."""
        corners, values = [], [np.zeros(0)]
        for piece in self.pieces:
            if os.path.exists(piece.file(time, field)):
                cells, polygons = self.cut(piece, time)
                some = np.atleast_1d(piece.field(time, field))
                corners += polygons
                values.append(some[cells] if len(some) > 1 else np.full(len(cells), some[0]))
        return corners, np.concatenate(values)

    def mixture(self, time, colours):
        """Polygons and colours of the cells: of all that flows by shares (colours: by name)."""
        corners, shares = zip(*(self.cells(time, f"alpha.{name}") for name in colours))
        shares = np.maximum(np.stack(shares, axis=1), 1e-9)
        return corners[0], shares/shares.sum(axis=1)[:, None] @ np.array([*colours.values()])
