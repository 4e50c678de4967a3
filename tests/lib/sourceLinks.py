"""Links from the pages of doc/ to functions of the source.

A page has [`class::function`], and at its end where that is:

    [`velocityField::velocity`]: ../src/phases/velocityField/velocityField.C#L226

    wrong(page, text)       # number of links, and those that lead elsewhere, as sentences
    updated(page, text)     # the text with the places at its end set anew

A function is where a line that is not indented has class::function (templates too), or else
where the class' files have it indented; a class, where its header, or its one file, begins it.
"""

import functools
import glob
import os
import re

from foamCase import PROJECT

#: Lines by which a link may be off before it is wrong
NEAR = 25

USE = re.compile(r"\[`([A-Za-z]\w*(?:::\w+)*)`\](?![(:])")
PLACE = re.compile(r"^\[`([\w:]+)`\]: (\S+?\.[CH])(?:#L(\d+))?$", re.M)


@functools.lru_cache(None)
def sources():
    """Lines of each file of src, by its path from the project's folder."""
    found = {}
    for kind in ("C", "H"):
        for path in sorted(glob.glob(os.path.join(PROJECT, "src/**/*." + kind), recursive=True)):
            if "lnInclude" not in path:
                with open(path, encoding="utf-8") as f:
                    found[os.path.relpath(path, PROJECT)] = f.read().split("\n")
    return found


@functools.lru_cache(None)
def places(name):
    """All (path, line) where a function, or a class without ::, is defined."""
    if "::" not in name:
        struct = re.compile(rf"^(?:class|struct) {name}\b(?!;)")
        # In a header, or where a model is one file in that
        found = [(path, i + 1) for path, lines in sources().items()
                 for i, line in enumerate(lines) if struct.match(line)]
        found.sort(key=lambda place: not place[0].endswith(".H"))
        return found or [(path, 1) for path in sources() if path.endswith(f"/{name}.H")]
    owner, function = name.rsplit("::", 1)
    qualified = re.compile(
        r"^(?:\S(?:.*\W)?)?" + "::".join(p + "(?:<[^>]*>)?" for p in owner.split("::"))
        + rf"::{function}\b")
    found = [(path, i + 1) for path, lines in sources().items()
             for i, line in enumerate(lines) if qualified.search(line)]
    if found:
        return found
    inside = re.compile(
        rf"^\s+(?!return\b|const\b\s*\w+\s*=)(?:[\w:<>,&*]+ )+{function}\s*(?:\(|$)")
    for path, _ in places(owner):
        for other in dict.fromkeys((path[:-1] + "C", path)):
            found += [(other, i + 1) for i, line in enumerate(sources().get(other, ()))
                      if inside.match(line)]
    return found


def uses(text):
    return sorted(set(USE.findall(text)))


def updated(page, text):
    text = PLACE.sub("", text).rstrip("\n") + "\n"
    lines = []
    for name in uses(text):
        if not places(name):
            raise LookupError(f"{page}: no definition of {name} in src")
        path, line = places(name)[0]
        path = os.path.relpath(os.path.join(PROJECT, path), os.path.join(PROJECT, "doc"))
        lines.append(f"[`{name}`]: {path}" + (f"#L{line}" if "::" in name else ""))
    return text + ("\n" + "\n".join(lines) + "\n" if lines else "")


def wrong(page, text):
    """(number of links, those that are wrong)."""
    known, bad = {}, []
    for name, path, line in PLACE.findall(text):
        known[name] = path
        path = os.path.normpath(os.path.join("doc", path))
        at = [i for p, i in places(name) if p == path]
        if not at:
            bad.append(f"{name} is not in {path}")
        elif "::" in name and not any(abs(i - int(line or 0)) <= NEAR for i in at):
            bad.append(f"{name} is at line {at} of {path}, not {line}")
    bad += [f"{page} has no place of {name}" for name in uses(text) if name not in known]
    bad += [f"{page} does not use {name}" for name in known if name not in uses(text)]
    return len(uses(text)), bad
