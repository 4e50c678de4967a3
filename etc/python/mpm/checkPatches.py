"""Conditions of fields against the patches of the mesh: names that are none of its, patches that
have no condition, types that are none of OpenFOAM's.

As OpenFOAM reads boundaryField: an entry by the name of a patch, then by one of its groups, then
by a pattern; the last of each counts.
"""

import difflib
import os
import re

from mpm.checkFinding import Finding
from mpm.dictionaries import DictionaryError, parse, value
from mpm.files import readRaw

#: Types of patches that prescribe their own condition: entries of these names may be of other
#: meshes (setConstraintTypes)
CONSTRAINTS = ("empty", "wedge", "cyclic", "cyclicAMI", "cyclicACMI", "cyclicSlip", "processor",
               "processorCyclic", "symmetry", "symmetryPlane", "nonuniformTransformCyclic")


def patchesOf(case):
    """Patches of the mesh: (type, groups)."""
    with open(case.file("constant/polyMesh/boundary"), "rb") as f:
        text = re.sub(r"/\*.*?\*/|//[^\n]*", "", f.read().decode("latin-1"), flags=re.S)
    found = {}
    for name, body in re.findall(r"(\S+)\s*\{([^}]*)\}", text.split("}", 1)[1]):
        kind = re.search(r"\btype\s+(\w+);", body)
        groups = re.search(r"\binGroups[^(;]*\(([^)]*)\)", body)
        if kind:
            found[name] = kind[1], {kind[1], *(groups[1].split() if groups else ())}
    return found


def boundary(case, field):
    """boundaryField of a file, ascii or binary; lists of values count as none."""
    raw = readRaw(case.file(field))
    binary = b"binary" in raw[:1000]
    if not binary and (b"nonuniform" not in raw or b"#include" in raw):
        return case.get(field).get("boundaryField", {})
    raw, n = raw[raw.index(b"boundaryField"):], {b"scalar": 8, b"vector": 24}
    while found := re.search(rb"nonuniform\s+List<(\w+)>\s*(\d+)\s*\(", raw):
        end = found.end() + int(found[2])*n.get(found[1], 8) + 1 if binary \
            else raw.index(b";", found.end())
        raw = raw[:found.start()] + b"none" + raw[end:]
    text = raw.decode("latin-1")
    try:
        return value(text, parse(text)).get("boundaryField", {})
    except DictionaryError:
        return {}


def conditions(given, patches):
    """Patches: the dictionary of their condition. given: boundaryField; patches: patchesOf."""
    given = {key: of for key, of in given.items() if isinstance(of, dict)}
    found = {p: of for key, of in given.items() for p in patches if _matches(key, p)}
    found.update({p: of for key, of in given.items() for p, (_, groups) in patches.items()
                  if key in groups})
    found.update({p: given[p] for p in patches if p in given})
    return found


def _matches(pattern, name):
    try:
        return bool(re.fullmatch(pattern, name))
    except re.error:
        return False


def names(case, shown):
    """Findings of the files of 0 whose entries are not the patches of the mesh; shown: folder
    in which the user has them."""
    patches = patchesOf(case)
    for file in sorted(os.listdir(case.file("0"))):
        path = os.path.join("0", file)
        if not os.path.isfile(case.file(path)) or not re.search(
                rb"class\s+(vol|point|surface)\w+Field\s*;", readRaw(case.file(path))[:2000]):
            continue
        try:
            given = boundary(case, path)
        except DictionaryError:     # the program that reads it says what is wrong
            continue
        yield from _ofFile(os.path.join(shown, file), given, patches)


def _ofFile(file, given, patches):
    known = {"wall", *CONSTRAINTS, *patches, *(g for _, groups in patches.values() for g in groups)}
    strange = [key for key, of in given.items() if isinstance(of, dict) and key not in known
               and not re.search(r"[][.*+?()|^$\\]", key)]
    has = conditions(given, patches)
    bare = [p for p, (kind, _) in patches.items() if p not in has and kind not in CONSTRAINTS]
    near = {key: difflib.get_close_matches(key, bare or patches, 1, 0.6 if bare else 0.8)
            for key in strange}
    if not bare:        # others may be of another mesh
        near = {key: n for key, n in near.items() if n}
    if not near and not bare:
        return
    words = [f"the mesh has no patch {key}" + (f" (nearest: {n[0]})" if n else "")
             for key, n in near.items()]
    if bare:
        words.append(f"{' and '.join(bare)} of the mesh {'have' if len(bare) > 1 else 'has'} no "
                     "entry")
    right = [f"{n[0]} in place of {key}" for key, n in near.items() if n]
    yield Finding("error" if bare else "warning", file,
                  "boundaryField" + "".join(f".{key}" for key in list(near)[:1]),
                  f"{'; '.join(words)}; its patches: {', '.join(patches)}",
                  ", ".join(right) or "an entry for each patch, its group, or a pattern",
                  "meshes.md#what-patches-need")


def nearestFirst(message):
    """OpenFOAM's words on a type that it has not: the nearest before all others."""
    unknown = re.search(r"Unknown [^\n]*?\btype (\S+)[^\n]*", message)
    valid = re.search(r"\bValid [^\n]*:\s*(?:\d+\s*)?\(\s*(.*?)\s*\)", message, re.S)
    if not unknown or not valid:
        return message
    types = valid[1].split()
    near = difflib.get_close_matches(unknown[1], types, 2)
    return unknown[0] + (f"; nearest: {', '.join(near)}" if near else "") \
        + f". Of {len(types)}: {' '.join(types)}"
