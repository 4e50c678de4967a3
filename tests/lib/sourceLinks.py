"""Links from the pages of doc/ to functions of the source: [`class::function`](path#Lline).

    resolve("velocityField::velocity")      # (path, line) of its definition, or of its class
    wrong("theory.md", text)                # links that lead elsewhere, as sentences
    updated("theory.md", text)              # the text with the links set anew

A name in braces, {class::function}, becomes such a link. A function is where a line that is
not indented has class::function (templates too), or else where the class' header has it.
"""

import functools
import glob
import os
import re

from foamCase import PROJECT

#: Lines by which a link may be off before it is wrong
NEAR = 25

LINK = re.compile(r"\[`([\w:]+)`\]\((\.\./[\w/.]+\.[CH])(?:#L(\d+))?\)")
BRACES = re.compile(r"(?<![\\$\w^_}])\{([a-zA-Z]\w+(?:::\w+)*)\}")


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


def places(name):
    """All (path, line) where a function, or a class without ::, is defined."""
    if "::" not in name:
        struct = re.compile(rf"^(?:class|struct) {name}\b(?!;)")
        return [(path, i + 1) for path, lines in sources().items() if path.endswith(".H")
                for i, line in enumerate(lines) if struct.match(line)]
    owner, function = name.rsplit("::", 1)
    qualified = re.compile(
        r"^\S(?:.*\W)?" + "::".join(p + "(?:<[^>]*>)?" for p in owner.split("::"))
        + rf"::{function}\b|^{owner}::{function}\b")
    found = [(path, i + 1) for path, lines in sources().items()
             for i, line in enumerate(lines) if qualified.search(line)]
    if found:
        return found
    inside = re.compile(
        rf"^\s+(?!return\b|const\b\s*\w+\s*=)(?:[\w:<>,&*]+ )+{function}\s*(?:\(|$)")
    for path, _ in places(owner):
        for other in (path[:-1] + "C", path):
            found += [(other, i + 1) for i, line in enumerate(sources().get(other, ()))
                      if inside.match(line)]
    return found


def resolve(name):
    found = places(name)
    if not found:
        raise LookupError(f"no definition of {name} in src")
    return found[0]


def link(page, name):
    path, line = resolve(name)
    base = os.path.relpath(os.path.join(PROJECT, path),
                           os.path.dirname(os.path.join(PROJECT, "doc", page)))
    return f"[`{name}`]({base}{f'#L{line}' if '::' in name else ''})"


def updated(page, text):
    text = LINK.sub(lambda m: link(page, m.group(1)), text)
    return BRACES.sub(lambda m: link(page, m.group(1)), text)


def wrong(page, text):
    """(number of links, those that are wrong)."""
    bad, n = [], 0
    for name, path, line in LINK.findall(text):
        n += 1
        path = os.path.normpath(os.path.join("doc", os.path.dirname(page), path))
        at = [i for p, i in places(name) if p == path]
        if not at:
            bad.append(f"{name} is not in {path}")
        elif "::" in name and not any(abs(i - int(line or 0)) <= NEAR for i in at):
            bad.append(f"{name} is at line {at} of {path}, not {line}")
    return n, bad + [f"{m} is no link" for m in BRACES.findall(text)]
