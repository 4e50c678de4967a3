"""Changes of a polyMesh, one at a time, and what must come of them.

MUTATIONS: name of the change, what must come of it, meshes on which it is tried, the
change itself: a function of the mesh, a place in it (the body is there) and a
random.Random. What must come of it:

    SAME     the mesh is the same with other numbers: result of the unchanged mesh
    VALID    another mesh that is right: a result whose sums hold
    REFUSED  a message
    EITHER   a message or a result whose sums hold
"""

import numpy as np

SAME, VALID, REFUSED, EITHER = "same", "valid", "refused", "either"

ALL = ("boxes", "moved", "linear", "prisms", "tets", "polyhedra", "gas")
SOLID = ("boxes", "moved", "prisms", "tets", "polyhedra")


# --- faces --------------------------------------------------------------------

def reverseInner(m, at, rnd):
    m.faces[m.near(at)].reverse()


def reverseOuter(m, at, rnd):
    m.faces[m.near(at, inner=False)].reverse()


def rotateFaces(m, at, rnd):
    for f, face in enumerate(m.faces):
        k = rnd.randrange(len(face))
        m.faces[f] = face[k:] + face[:k]


def crossFace(m, at, rnd):
    f = m.faces[m.near(at)]
    f[0], f[1] = f[1], f[0]


def swapPointsOfFaces(m, at, rnd):
    a = m.near(at)
    b = (a + m.nInternal//2) % m.nInternal
    m.faces[a], m.faces[b] = m.faces[b], m.faces[a]


def reorderInner(m, at, rnd):
    order = list(range(m.nInternal))
    rnd.shuffle(order)
    m.orderInner(order)


def reorderOuter(m, at, rnd):
    for _, p in m.patches:
        where = range(p["startFace"], p["startFace"] + p["nFaces"])
        order = list(where)
        rnd.shuffle(order)
        faces, owner = [m.faces[f] for f in order], [m.owner[f] for f in order]
        for i, f in enumerate(where):
            m.faces[f], m.owner[f] = faces[i], owner[i]


def removeInner(m, at, rnd):
    m.removeInner(m.near(at))


def removeOuter(m, at, rnd):
    f = m.near(at, inner=False)
    p = m.patchOf(f)
    del m.faces[f], m.owner[f]
    for _, q in m.patches:
        q["startFace"] -= q["startFace"] > p["startFace"]
    p["nFaces"] -= 1


def removeFromFacesOnly(m, at, rnd):
    del m.faces[m.near(at)]


def twice(m, at, rnd):
    """The same face twice between two cells."""
    f = m.near(at)
    for of in (m.faces, m.owner, m.neighbour):
        of.insert(f, of[f] if of is not m.faces else list(of[f]))
    for _, p in m.patches:
        p["startFace"] += 1


def baffle(m, at, rnd):
    """A face between two cells becomes a wall of both."""
    f = m.near((0.1, 0.1, 0.1))
    face, o, n = m.faces[f], m.owner[f], m.neighbour[f]
    m.removeInner(f)
    m.addOuter("walls", face, o)
    m.addOuter("walls", face[:1] + face[:0:-1], n)


def pointOfFace(value):
    def change(m, at, rnd):
        m.faces[m.near(at)][1] = value if value != "n" else len(m.points)
    return change


def repeatedPoint(m, at, rnd):
    f = m.faces[m.near(at)]
    f.insert(1, f[0])


def shortFace(n):
    def change(m, at, rnd):
        f = m.near(at)
        m.faces[f] = m.faces[f][:n]
    return change


# --- owner and neighbour ------------------------------------------------------

def exchangeCells(m, at, rnd):
    f = m.near(at)
    m.owner[f], m.neighbour[f] = m.neighbour[f], m.owner[f]


def exchangeAndReverse(m, at, rnd):
    m.exchange(m.near(at))


def setCell(of, value):
    def change(m, at, rnd):
        n = m.nCells
        labels = {"other": (m.owner[m.near(at)] + n//2) % n, "next": n, "far": n + 7,
                  "own": m.owner[m.near(at)]}
        getattr(m, of)[m.near(at)] = labels.get(value, value)
    return change


def ownerOfOuter(m, at, rnd):
    m.owner[m.near(at, inner=False)] = m.nCells//2


def shorter(of):
    def change(m, at, rnd):
        del getattr(m, of)[-1]
    return change


def longer(of):
    def change(m, at, rnd):
        getattr(m, of).append(1)
    return change


def padded(m, at, rnd):
    """As old versions of OpenFOAM wrote it."""
    m.neighbour += [-1]*(len(m.faces) - len(m.neighbour))


def unusedCell(m, at, rnd):
    m.owner = [c + (c > 3) for c in m.owner]
    m.neighbour = [c + (c > 3) for c in m.neighbour]


# --- points -------------------------------------------------------------------

def nearestPoint(m, at, inner=True):
    x = m.x()
    used = np.zeros(len(x), bool)
    used[[p for f in m.faces for p in f]] = True
    far = np.sum((x - at)**2, axis=1)
    far[~used] = np.inf
    return int(np.argmin(far))


def component(value):
    def change(m, at, rnd):
        p = nearestPoint(m, at)
        x = list(m.points[p])
        x[rnd.randrange(2)] = value
        m.points[p] = tuple(x)
    return change


def towards(fraction):
    """A point moves to (1) or beyond the point across a cell."""
    def change(m, at, rnd):
        p = nearestPoint(m, at)
        x = m.x()
        cell = min((c for c in range(m.nCells) if p in m.pointsOf(c)),
                   key=lambda c: np.sum((x[m.pointsOf(c)].mean(axis=0) - at)**2))
        points = np.array(m.pointsOf(cell))
        plane = np.abs(x[points] - x[p])[:, 2] < 1e-9
        if plane.sum() > 1:
            points = points[plane]
        across = max(points, key=lambda q: np.sum((x[q] - x[p])**2))
        move = fraction*(x[across] - x[p])
        for q in {p} | {q for q in range(len(x)) if len(set(x[:, 2])) == 2
                        and np.sum((x[q] - x[p])[:2]**2) < 1e-18}:
            m.points[q] = tuple((x[q] + move).tolist())
    return change


def merge(m, at, rnd):
    """A point at the place of its neighbour on a face."""
    f = m.faces[m.near(at)]
    m.points[f[0]] = m.points[f[1]]


def mergeLabels(m, at, rnd):
    f = m.faces[m.near(at)]
    a, b = f[0], f[1]
    m.faces = [[b if p == a else p for p in f] for f in m.faces]


def doublePoint(m, at, rnd):
    """One face has its own copy of a point: the same place, another label."""
    f = m.faces[m.near(at)]
    m.points.append(m.points[f[0]])
    f[0] = len(m.points) - 1


def outside(m, at, rnd):
    m.points[nearestPoint(m, at)] = (3.0, 3.0, 3.0)


def processorPoint(m, at, rnd):
    """The point of a processor side that is nearest, on this processor only."""
    side = next(p for name, p in m.patches if name.startswith("procBoundary"))
    points = sorted({p for f in m.faces[side["startFace"]:][:side["nFaces"]] for p in f})
    p = min(points, key=lambda p: np.sum((np.array(m.points[p]) - at)**2))
    x, y, z = m.points[p]
    m.points[p] = (x, y + 0.05, z + 0.03)


def unusedPoint(m, at, rnd):
    m.points += [(0.3, 0.3, 0.3), (9.0, 9.0, 9.0)]


def oneSide(m, at, rnd):
    """In 2D: a point of one empty side moves within it."""
    p = nearestPoint(m, at)
    x, y, z = m.points[p]
    m.points[p] = (x + 0.02, y - 0.03, z)


def thickness(m, at, rnd):
    """In 2D: a point of one empty side moves out of it."""
    p = nearestPoint(m, at)
    x, y, z = m.points[p]
    m.points[p] = (x, y, z + 0.02)


def renumberPoints(m, at, rnd):
    to = list(range(len(m.points)))
    rnd.shuffle(to)
    m.renumberPoints(to)


def renumberCells(m, at, rnd):
    to = list(range(m.nCells))
    rnd.shuffle(to)
    m.renumberCells(to)


def scaled(factor):
    def change(m, at, rnd):
        m.points = [tuple(factor*c for c in p) for p in m.points]
    return change


def allScaled(factor):
    """The mesh and, by the test, the body and the times."""
    def change(m, at, rnd):
        scaled(factor)(m, at, rnd)
    change.factor = factor
    return change


# --- patches ------------------------------------------------------------------

def patchEntry(name, key, value):
    def change(m, at, rnd):
        p = m.patch(name)
        p[key] = value(p[key]) if callable(value) else value
    return change


def wrongStart(m, at, rnd):
    m.patches[-1][1]["startFace"] += 1


def noStart(m, at, rnd):
    del m.patches[0][1]["startFace"]


def exchangeRanges(m, at, rnd):
    a, b = m.patches[0][1], m.patches[1][1]
    for key in ("nFaces", "startFace"):
        a[key], b[key] = b[key], a[key]


def swapTypes(m, at, rnd):
    a, b = m.patches[0][1], m.patches[-1][1]
    a["type"], b["type"] = b["type"], a["type"]


def sameName(m, at, rnd):
    m.patches[1][0] = m.patches[0][0]


def otherName(m, at, rnd):
    m.patches[0][0] = "entry"


def noPatches(m, at, rnd):
    m.patches = []


def fewerPatches(m, at, rnd):
    del m.patches[-1]


def zeroPatch(m, at, rnd):
    m.patches.append(["extra", {"type": "patch", "nFaces": 0,
                                "startFace": len(m.faces)}])


def zeroEmptyPatch(m, at, rnd):
    m.patches.insert(0, ["extra", {"type": "empty", "nFaces": 0,
                                   "startFace": m.nInternal}])


def split(kind, at=1, **entries):
    """A part of a patch becomes a patch of another type."""
    def change(m, _, rnd):
        p = m.patches[-1][1]
        n = p["nFaces"]//2
        p["nFaces"] -= n
        m.patches.append(["extra", {"type": kind, **entries, "nFaces": n,
                                    "startFace": p["startFace"] + p["nFaces"]}])
    return change


def outsideEmpty(m, at, rnd):
    for _, p in m.patches:
        p["type"] = "empty"


def noLongerEmpty(m, at, rnd):
    m.patch("sides")["type"] = "patch"


# --- files --------------------------------------------------------------------

def raw(name, text):
    def change(m, at, rnd):
        m.raw[name] = text
    return change


def cellZones(*labels):
    def change(m, at, rnd):
        text = " ".join(str(m.nCells if i == "n" else i) for i in labels)
        m.raw["cellZones"] = (
            "FoamFile { version 2.0; format ascii; class regIOobject; object cellZones; }"
            f"\n1\n(\nbody {{ type cellZone; cellLabels List<label> {len(labels)}({text});"
            " }\n)\n").encode()
    return change


def binaryNaN(m, at, rnd):
    x = m.x()
    x[nearestPoint(m, at)] = np.nan
    m.raw["points"] = (
        'FoamFile { version 2.0; format binary; arch "LSB;label=32;scalar=64";'
        f" class vectorField; object points; }}\n{len(x)}(").encode() + x.tobytes() + b")"


def noCells(m, at, rnd):
    m.points, m.faces, m.owner, m.neighbour = [], [], [], []
    for _, p in m.patches:
        p["nFaces"] = p["startFace"] = 0


CYCLIC = {"matchTolerance": 1e-4}

MUTATIONS = [
    ("face between cells reversed", REFUSED, ALL, reverseInner),
    ("face of the boundary reversed", REFUSED, ("boxes", "prisms", "tets"), reverseOuter),
    ("first points of all faces rotated", SAME,
     ("boxes", "linear", "prisms", "tets", "gas"), rotateFaces),
    # nodeDual cuts faces of more points into triangles from their first points
    ("first points of all faces rotated", VALID, ("moved", "polyhedra"), rotateFaces),
    ("two points of a face exchanged", REFUSED, ("boxes", "polyhedra", "moved"), crossFace),
    ("points of two faces swapped", REFUSED, ("moved", "tets"), swapPointsOfFaces),
    ("order of the inner faces", SAME, ("boxes", "tets", "gas"), reorderInner),
    ("order of the faces of a patch", SAME, ("boxes", "prisms", "gas"), reorderOuter),
    ("inner face removed", REFUSED, ("boxes", "linear", "prisms", "tets", "polyhedra"),
     removeInner),
    ("face of the boundary removed", REFUSED, ("boxes", "tets"), removeOuter),
    ("face removed from faces only", REFUSED, ("boxes",), removeFromFacesOnly),
    ("inner face twice", REFUSED, ("boxes", "tets"), twice),
    ("inner face becomes a wall of both cells", VALID, ("boxes", "tets", "prisms"),
     baffle),
    ("point of a face is the number of points", REFUSED, ("boxes", "polyhedra"),
     pointOfFace("n")),
    ("point of a face is 100000000", REFUSED, ("tets",), pointOfFace(100000000)),
    ("point of a face is -1", REFUSED, ("boxes", "prisms"), pointOfFace(-1)),
    ("point of a face is 1e12", REFUSED, ("boxes",), pointOfFace(1000000000000)),
    ("face with a point twice", REFUSED, ("boxes", "prisms", "tets"), repeatedPoint),
    ("face of two points", REFUSED, ("boxes", "tets"), shortFace(2)),
    ("face without points", REFUSED, ("moved",), shortFace(0)),

    ("owner and neighbour exchanged", REFUSED, ("boxes", "tets", "prisms"), exchangeCells),
    ("owner and neighbour exchanged and face reversed", EITHER, ("boxes", "tets", "gas"),
     exchangeAndReverse),
    ("owner is another cell", REFUSED, ("boxes", "tets", "polyhedra"),
     setCell("owner", "other")),
    ("owner is the neighbour", REFUSED, ("boxes",), setCell("neighbour", "own")),
    ("owner is one cell more", REFUSED, ("moved", "prisms"), setCell("owner", "next")),
    ("neighbour is far out of range", REFUSED, ("boxes",), setCell("neighbour", "far")),
    ("owner is 2000000000", REFUSED, ("boxes",), setCell("owner", 2000000000)),
    ("neighbour is 2000000000", REFUSED, ("tets",), setCell("neighbour", 2000000000)),
    ("neighbour is -5", REFUSED, ("boxes",), setCell("neighbour", -5)),
    ("owner is -1", REFUSED, ("tets",), setCell("owner", -1)),
    ("owner of a boundary face is another cell", REFUSED, ("boxes",), ownerOfOuter),
    ("owner shorter", REFUSED, ("boxes",), shorter("owner")),
    ("neighbour shorter", REFUSED, ("boxes",), shorter("neighbour")),
    ("owner longer", REFUSED, ("tets",), longer("owner")),
    ("neighbour longer", REFUSED, ("tets",), longer("neighbour")),
    ("neighbour with -1 for the boundary", SAME, ("boxes",), padded),
    ("a cell without faces", REFUSED, ("boxes",), unusedCell),

    ("point NaN", REFUSED, ("boxes", "tets", "gas"), component(float("nan"))),
    ("point NaN in a binary file", REFUSED, ("boxes", "tets"), binaryNaN),
    ("point infinite", REFUSED, ("moved",), component(float("inf"))),
    ("point 1e300", REFUSED, ("boxes", "prisms", "polyhedra"), component(1e300)),
    ("point 1e30", REFUSED, ("tets",), component(1e30)),
    ("point moved by a tenth of a cell", EITHER, ("boxes", "linear", "tets", "polyhedra"),
     towards(0.1)),
    ("point moved to the middle of a cell", EITHER, ("boxes", "linear", "tets"),
     towards(0.5)),
    ("point moved so that a cell is concave", EITHER, ("moved", "linear", "polyhedra"),
     towards(0.7)),
    ("point moved to the one across", REFUSED, ("boxes", "linear", "prisms", "tets"),
     towards(1)),
    ("point moved across a cell", REFUSED, ("boxes", "moved", "linear", "tets", "polyhedra",
                                            "gas"), towards(1.6)),
    ("point outside of the mesh", REFUSED, ("boxes", "tets", "linear"), outside),
    ("two points at one place", REFUSED, ("boxes", "tets", "polyhedra", "linear"), merge),
    ("two points with one label", REFUSED, ("boxes", "tets"), mergeLabels),
    ("a face has its own copy of a point", REFUSED, ("boxes", "tets", "prisms"),
     doublePoint),
    ("unused points", EITHER, ("boxes", "tets", "prisms"), unusedPoint),
    ("point of one empty side moved in it", EITHER, ("prisms", "gas"), oneSide),
    ("point of one empty side moved out of it", REFUSED, ("prisms",), thickness),
    ("points renumbered", SAME, ("boxes", "moved", "prisms", "tets", "polyhedra", "gas"),
     renumberPoints),
    ("cells renumbered", SAME, ("boxes", "moved", "prisms", "tets", "polyhedra", "gas"),
     renumberCells),
    ("mesh in 1e-9 of its size", REFUSED, ("boxes", "tets"), scaled(1e-9)),
    ("mesh in 1e9 of its size", REFUSED, ("boxes", "tets"), scaled(1e9)),

    ("all in 1e-9 of its size", SAME, ("boxes", "linear", "prisms", "tets", "polyhedra",
                                       "gas"), allScaled(1e-9)),
    ("all in 1e9 of its size", SAME, ("boxes", "linear", "prisms", "tets", "polyhedra",
                                      "gas"), allScaled(1e9)),

    ("nFaces of a patch too large", REFUSED, ("boxes",),
     patchEntry("walls", "nFaces", lambda n: n + 10)),
    ("nFaces of a patch too small", REFUSED, ("boxes",),
     patchEntry("walls", "nFaces", lambda n: n - 10)),
    ("nFaces of a patch negative", REFUSED, ("tets",),
     patchEntry("walls", "nFaces", -4)),
    ("nFaces of a patch no number", REFUSED, ("tets",),
     patchEntry("walls", "nFaces", "many")),
    ("startFace of a patch 0", REFUSED, ("boxes",), patchEntry("walls", "startFace", 0)),
    ("startFace of a patch 1e9", REFUSED, ("boxes",),
     patchEntry("walls", "startFace", 1000000000)),
    ("startFace of the last patch one more", REFUSED, ("boxes", "prisms"), wrongStart),
    ("startFace missing", REFUSED, ("boxes",), noStart),
    ("ranges of two patches exchanged", EITHER, ("boxes", "prisms"), exchangeRanges),
    ("types of two patches swapped", REFUSED, ("prisms", "gas"), swapTypes),
    ("two patches of one name", REFUSED, ("boxes",), sameName),
    ("no patches", REFUSED, ("boxes",), noPatches),
    ("last patch missing", REFUSED, ("boxes", "prisms"), fewerPatches),
    ("zero-size patch", SAME, ("boxes", "prisms", "gas"), zeroPatch),
    ("zero-size empty patch", SAME, ("boxes", "tets"), zeroEmptyPatch),
    ("patch type unknown", REFUSED, ("boxes",), patchEntry("walls", "type", "wal")),
    ("patch type empty on a 3D mesh", REFUSED, ("boxes", "moved", "tets"),
     patchEntry("walls", "type", "empty")),
    ("part of a patch empty", REFUSED, ("boxes", "tets", "polyhedra"), split("empty")),
    ("all patches empty", REFUSED, ("boxes",), outsideEmpty),
    ("sides no longer empty", REFUSED, ("prisms",), noLongerEmpty),
    ("patch type wedge on a 3D mesh", REFUSED, ("boxes",),
     patchEntry("walls", "type", "wedge")),
    ("part of a patch wedge", REFUSED, ("tets",), split("wedge")),
    ("sides wedge", REFUSED, ("prisms",), patchEntry("sides", "type", "wedge")),
    ("patch cyclic without partner", REFUSED, ("boxes",),
     patchEntry("walls", "type", "cyclic")),
    ("patch cyclic with itself", REFUSED, ("tets",),
     split("cyclic", neighbourPatch="extra")),
    ("patch cyclic with one that is not there", REFUSED, ("boxes",),
     split("cyclic", neighbourPatch="nowhere")),
    ("patch cyclic with one that is not cyclic", REFUSED, ("boxes",),
     split("cyclic", neighbourPatch="walls")),
    ("patch type symmetryPlane on all sides", REFUSED, ("boxes",),
     patchEntry("walls", "type", "symmetryPlane")),
    ("patch type processor in a serial run", REFUSED, ("boxes",),
     patchEntry("walls", "type", "processor; myProcNo 0; neighbProcNo 1")),

    ("faces missing", REFUSED, ("boxes",), raw("faces", None)),
    ("neighbour missing", REFUSED, ("boxes",), raw("neighbour", None)),
    ("owner rubbish", REFUSED, ("boxes",), raw("owner", b"\x00\x01rubbish")),
    ("points empty", REFUSED, ("boxes",), raw("points", b"")),
    ("mesh without cells", REFUSED, ("boxes",), noCells),
    ("cellZone with a label out of range", REFUSED, ("boxes", "tets"),
     cellZones(1, 2, "n")),
    ("cellZone with a label of -3", REFUSED, ("boxes",), cellZones(-3, 2)),
    ("cellZone with a cell twice", EITHER, ("tets",), cellZones(5, 6, 6)),
    ("cellZones without header, which OpenFOAM takes for no file", SAME, ("boxes",),
     raw("cellZones", b"2 (")),
]

#: Of the mesh of one of two processors: changes that must end in a message
ON_PROCESSORS = [
    ("face between cells reversed", ("boxes", "tets"), reverseInner),
    ("point NaN", ("boxes",), component(float("nan"))),
    ("point of a face is the number of points", ("boxes",), pointOfFace("n")),
    ("owner is another cell", ("tets",), setCell("owner", "other")),
    ("inner face removed", ("polyhedra",), removeInner),
    ("point moved on one side only", ("boxes", "tets"), processorPoint),
    ("nFaces of a patch too large", ("boxes",),
     patchEntry("walls", "nFaces", lambda n: n + 10)),
    ("another name of a patch", ("boxes",), otherName),
    ("point moved across a cell", ("tets",), towards(1.6)),
]
