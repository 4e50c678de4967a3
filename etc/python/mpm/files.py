"""Files of OpenFOAM: columns of points, fields on cells and mesh points, dictionaries.

Values of dictionaries: text goes in as it is, numbers with all digits, True and
False as yes and no, lists in parentheses, dictionaries in braces.
"""

import gzip
import os
import re

import numpy as np


def foamText(value, indent=0):
    """A value as OpenFOAM's dictionaries have it."""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, (float, np.floating)):
        return repr(float(value))
    if isinstance(value, dict):
        pad = " "*indent
        lines = []
        for key, entry in value.items():
            if isinstance(entry, dict):
                lines.append(f"{pad}{key}\n{pad}{{\n"
                             f"{foamText(entry, indent + 4)}{pad}}}\n")
            else:
                lines.append(f"{pad}{key} {foamText(entry)};\n")
        return "".join(lines)
    if isinstance(value, (list, tuple, np.ndarray)):
        return "(" + " ".join(foamText(v) for v in value) + ")"
    return str(value)


def fileHeader(objectName, kind="dictionary"):
    return ("FoamFile\n{\n    version 2.0;\n    format ascii;\n"
            f"    class {kind};\n    object {objectName};\n}}\n\n")


class Points:
    """Columns of a cloud, read when asked for: points["sigma"]. place: named in errors."""

    def __init__(self, paths, place=""):
        self.paths, self.place = paths, place

    def __getitem__(self, name):
        if name not in self:
            around = os.path.dirname(self.place)
            there = ("columns: " + " ".join(self.keys()) if self.paths else "clouds: " + " ".join(
                os.listdir(around)) if os.path.isdir(around) else "no clouds at this time")
            raise FileNotFoundError(f"{os.path.join(self.place, name)} is not there; {there}")
        return np.concatenate([readField(os.path.join(p, name)) for p in self.paths])

    def __contains__(self, name):
        return bool(self.paths) and any(
            os.path.exists(os.path.join(self.paths[0], n)) for n in (name, name + ".gz"))

    def keys(self):
        """Names of the columns."""
        places = {"positions", "coordinates"}       # OpenFOAM's own files
        return sorted({n.removesuffix(".gz") for n in os.listdir(self.paths[0])} - places) \
            if self.paths else []

    def byId(self, name):
        """The column in the order of the points' ids."""
        return self[name][np.argsort(self["id"])]


def readRaw(path):
    """Bytes of a file, or of it compressed (writeCompression)."""
    if not os.path.exists(path) and os.path.exists(path + ".gz"):
        with gzip.open(path + ".gz") as f:
            return f.read()
    with open(path, "rb") as f:
        return f.read()


_KINDS = {"scalarField": ("f8", 1), "vectorField": ("f8", 3),
          "symmTensorField": ("f8", 6), "tensorField": ("f8", 9),
          "labelField": ("i4", 1)}


def readField(path):
    """A field of a cloud, ascii or binary, as an array."""
    raw = readRaw(path)
    head = re.search(rb"FoamFile\s*\{(.*?)\}", raw, flags=re.S)
    kind, size = _KINDS[re.search(rb"class\s+(\w+)\s*;", head[1])[1].decode()]
    binary = re.search(rb"format\s+(\w+)\s*;", head[1])[1] == b"binary"
    body = re.sub(rb"\A(\s*//[^\n]*\n)*\s*", b"", raw[head.end():], count=1)
    count = re.match(rb"(\d+)\s*", body)
    n, body = int(count[1]), body[count.end():]
    if n == 0:
        values = np.zeros(0, kind)
    elif body[:1] == b"{":
        one = np.array(body[1:body.index(b"}")].translate(None, b"()").split(), kind)
        values = np.tile(one, n)
    elif binary:
        values = np.frombuffer(body, kind, n*size, 1)
    else:
        text = body[:body.index(b"// ***")] if b"// ***" in body else body
        values = np.array(text.translate(None, b"()").split(), kind)
    return values.reshape(n, size) if size > 1 else values


def readLists(path, flat=False):
    """The lists of labels of a mesh's file, faces or owner, ascii or binary: arrays; flat:
    of faces all labels one after the other, and the number of each face."""
    raw = readRaw(path)
    head = re.search(rb"FoamFile\s*\{(.*?)\}", raw, flags=re.S)
    kind = re.search(rb"class\s+(\w+)\s*;", head[1])[1]
    binary = re.search(rb"format\s+(\w+)\s*;", head[1])[1] == b"binary"
    body = re.sub(rb"\s*//[^\n]*\n", b"", raw[head.end():], count=1)
    if not binary and kind == b"faceList":
        faces = [np.array(f.split(), int) for f in re.findall(rb"\d+\(([\d\s]*)\)", body)]
        return (np.concatenate(faces or [np.zeros(0, int)]),
                np.array([len(f) for f in faces], int)) if flat else faces
    lists, at = [], 0
    for _ in range(1 + (kind == b"faceCompactList")):
        count = re.compile(rb"\s*(\d+)\s*\(").match(body, at)
        n, at = int(count[1]), count.end()
        if binary:
            lists.append(np.frombuffer(body, "i4", n, at))
            at += 4*n + 1
        else:
            end = body.index(b")", at)
            lists.append(np.array(body[at:end].split(), int))
            at = end + 1
    if flat:
        return lists[1], np.diff(lists[0])
    return lists[0] if len(lists) == 1 else np.split(lists[1], lists[0][1:-1])


_TYPES = {"scalar": 1, "vector": 3, "symmTensor": 6, "tensor": 9}


def readInternal(path):
    """Inner values of a field on cells or mesh points; one if it is uniform."""
    raw = readRaw(path)
    binary = re.search(rb"format\s+(\w+)\s*;", raw)[1] == b"binary"
    head = re.search(rb"(?:internalField|value)\s+(?:uniform\s+([^;]*);"
                     rb"|nonuniform\s+List<(\w+)>\s*(\d+)\s*\()", raw)
    if head[1] is not None:
        one = np.array([head[1].translate(None, b"()").split()], float)
        return one if one.size > 1 else one[0]
    n, size = int(head[3]), _TYPES[head[2].decode()]
    body = raw[head.end():]
    if binary:
        values = np.frombuffer(body, "f8", n*size)
    else:
        values = np.array(body[:body.index(b";")].translate(None, b"()").split(), float)
    return values.reshape(n, size) if size > 1 else values


def writeField(path, values):
    """A field of a cloud in ascii with all digits."""
    values = np.asarray(values)
    kind = {1: "scalarField", 3: "vectorField", 6: "symmTensorField"}[
        1 if values.ndim == 1 else values.shape[1]]
    with open(path, "w") as f:
        f.write(fileHeader(os.path.basename(path), kind))
        f.write(f"{len(values)}\n(\n")
        for v in values:
            f.write(foamText(v if values.ndim > 1 else float(v)) + "\n")
        f.write(")\n")
