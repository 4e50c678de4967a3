"""Entries of OpenFOAM's dictionaries as text: comments, layout and $ entries stay.

    text = setEntry(text, "target.constitutiveModel.E", 7e10)   # where it is now
    text = setEntry(text, "target.E", 7e10)         # short: if there is only one of that name
    text = setEntry(text, "materialPoints.order", 3, add=True)      # that very path
    value = getEntry(text, "target.E")              # number, yes and no, list, dict or text
    tree = readDictionary("system/fvSolution")      # all, with $, #include, #calc done

Names stand as the file has them, parts of a path with dots or slashes between. An entry that
is not there is an error that lists those that are.
"""

import difflib
import os
import re
import subprocess

from mpm.files import foamText

_TOKEN = re.compile(
    r'(?P<skip>\s+|//[^\n]*|/\*.*?\*/)|"(?:\\.|[^"\\])*"|#\{.*?#\}|[{}();]'
    r'|[^\s{}();"]+(?:\([^\s{};"]*?\)[^\s{}();"]*)*', re.S)
_INCLUDE = re.compile(r"#s?include(Etc|IfPresent)?")
_LINES = re.compile(r"#(includeFunc|inputMode|remove|if|else|endif|func)")
_SWITCHES = {"yes": True, "on": True, "true": True, "no": False, "off": False, "false": False}


class DictionaryError(Exception):
    """A dictionary that cannot be read, or that has no such entry."""


class Entry:
    """A place in a text: a name, where its value starts and ends, entries within it (None: it
    is no dictionary)."""

    def __init__(self, name, start, end, entries=None):
        self.name, self.start, self.end, self.entries = name, start, end, entries


def _tokens(text):
    at = 0
    while at < len(text):
        match = _TOKEN.match(text, at)
        if not match:
            raise DictionaryError(f"line {_line(text, at)}: a quote does not end")
        if match["skip"] is None:
            yield match[0], match.start(), match.end()
        at = match.end()


def _line(text, at):
    return text.count("\n", 0, at) + 1


def _entries(text, tokens, opened):
    """Entries up to the brace that closes, and where that is; opened: place of the brace."""
    found = []
    for name, start, end in tokens:
        if name == "}" and opened is not None:
            return found, start
        if name == ";":
            continue
        if name in "{}()":
            raise DictionaryError(f"line {_line(text, start)}: a name expected, found {name}")
        if _INCLUDE.fullmatch(name):    # its line may go on behind the name of the file
            _, _, end = next(tokens, ("", start, end))
            found.append(Entry(name, start, end))
            continue
        if _LINES.match(name):
            last = text.find("\n", end)
            last = len(text) if last < 0 else last
            for _, _, end in _line_rest(tokens, text, end, last):
                pass
            found.append(Entry(name, start, end))
            continue
        found.append(_entry(text, tokens, name, start, end))
    if opened is not None:
        raise DictionaryError(f"line {_line(text, opened)}: a brace that nothing closes")
    return found, len(text)


def _line_rest(tokens, text, end, last):
    """Tokens of a directive: what stands behind it in its line."""
    while re.search(r"[^\s/]", text[end:last].split("//")[0]):
        token = next(tokens, None)
        if token is None:
            return
        end = token[2]
        yield token


def _entry(text, tokens, name, start, end):
    depth, first, last, named = 0, None, end, name.strip('"') if '"' in name else name
    for token, a, b in tokens:
        if token == "{" and first is None:
            entries, close = _entries(text, tokens, a)
            return Entry(named, a, close + 1, entries)
        if token == ";" and depth == 0:
            return Entry(named, last if first is None else first, last)
        depth += {"{": 1, "(": 1, "}": -1, ")": -1}.get(token, 0)
        if depth < 0:
            break
        first, last = a if first is None else first, b
    raise DictionaryError(f"line {_line(text, start)}: {name} has no ; at its end")


def parse(text):
    """The whole text as an Entry."""
    if re.match(r"[^{}]*FoamFile\s*\{[^}]*\bformat\s+binary\b", text):
        raise DictionaryError("its format is binary: only text can be read")
    return Entry("", 0, len(text), _entries(text, _tokens(text), None)[0])


def _exactly(entry, path):
    """The last entry of a path in a dictionary: the one that counts; None: there is none."""
    found = None
    for child in entry.entries or ():
        if child.name == path:
            found = child
        elif path.startswith((child.name + ".", child.name + "/")):
            found = _exactly(child, path[len(child.name) + 1:]) or found
    return found


def _within(entry, path, above=""):
    """(path, entry) of a short path: of the entries below whose last names these are."""
    for child in entry.entries or ():
        if child.name == "FoamFile":
            continue
        place = above + child.name
        if child.name == path:
            yield place, child
        elif path.startswith((child.name + ".", child.name + "/")):
            yield from _within(child, path[len(child.name) + 1:], place + ".")
        yield from _within(child, path, place + ".")


def findEntry(tree, path):
    """The entry of a path, or of a short one; None if there is none."""
    exact = _exactly(tree, path)
    if exact:
        return exact
    found = {}
    for place, entry in _within(tree, path):
        found[place] = entry
    if len(found) > 1:
        raise DictionaryError(f"{path} may be each of {', '.join(found)}: name one of them")
    return next(iter(found.values()), None)


def _lacking(tree, path):
    """What to say of an entry that is not there."""
    inside, rest = tree, path
    while True:
        child = next((c for c in inside.entries or ()
                      if rest.startswith((c.name + ".", c.name + "/"))), None)
        if child is None:
            break
        inside, rest = child, rest[len(child.name) + 1:]
    names = [c.name for c in inside.entries or () if c.name != "FoamFile"]
    return (f"no entry {path}; {inside.name or 'the file'} has "
            + (", ".join(dict.fromkeys(names)) if names else "none") + _nearest(tree, path))


def _nearest(tree, path):
    """Entries whose last word is nearly that of the path, those below its first word before
    others."""
    places = {}

    def add(entry, above=""):
        for child in entry.entries or ():
            places.setdefault(child.name.lower(), []).append(above + child.name)
            add(child, above + child.name + ".")
    add(tree)
    first, last = path.split(".")[0], path.split(".")[-1].lower()
    firsts = [e.name for e in tree.entries or ()]
    first = first if first in firsts else next(iter(difflib.get_close_matches(first, firsts)), first)
    near = [p for word in difflib.get_close_matches(last, places, 3, 0.75)
            for p in sorted(places[word], key=lambda p: not p.startswith(first + "."))]
    return f" (is {near[0]} meant?)" if near and near[0] != path else ""


def getEntry(text, path):
    """The value of an entry."""
    tree = parse(text)
    entry = findEntry(tree, path)
    if entry is None:
        raise DictionaryError(_lacking(tree, path))
    return value(text, entry)


def setEntry(text, path, new, add=False):
    """The text with another value of an entry. add: the path is no short one, and may be missing,
    but not the dictionary in which it belongs."""
    tree = parse(text)
    entry = _exactly(tree, path) if add else findEntry(tree, path)
    if entry:
        column = entry.start - text.rfind("\n", 0, entry.start) - 1
        written = _written(new, column if entry.entries is not None else 0)
        closing = "" if entry.entries is None or isinstance(new, dict) else ";"
        if entry.entries is None and isinstance(new, dict):
            return text[:entry.start] + written + text[text.index(";", entry.end) + 1:]
        return text[:entry.start] + written + closing + text[entry.end:]
    if not add:
        raise DictionaryError(_lacking(tree, path) + " (add=True puts it there)")
    above, name = re.fullmatch(r"(?:(.*)[./])?([^./]+)", path).groups()
    inside = _exactly(tree, above) if above else tree
    if inside is None or inside.entries is None:
        raise DictionaryError(_lacking(tree, above) + ": nothing to put " + name + " into")
    if inside is tree:
        return text.rstrip() + "\n\n" + foamText({name: new})
    close = inside.end - 1
    start = text.rfind("\n", 0, close) + 1
    if text[start:close].strip():       # all in one line
        return text[:close] + foamText({name: new}).replace("\n", " ") + text[close:]
    pad = len(text[start:close])
    return text[:start] + foamText({name: new}, pad + 4) + text[start:]


def _written(new, column):
    if not isinstance(new, dict):
        return foamText(new)
    return "{\n" + foamText(new, column + 4) + " "*column + "}"


def value(text, entry):
    """Number, True or False of a switch, list, dictionary, or the text as it stands."""
    if entry.entries is not None:
        return {e.name: value(text, e) for e in entry.entries if e.name != "FoamFile"}
    raw = [t[0] for t in _tokens(text[entry.start:entry.end])]
    items = []
    for i, token in enumerate(raw):
        if token == "{":
            break
        items.append(token)
    if len(items) == len(raw) == 1:
        return _word(raw[0])
    if raw[:1] == ["("] and len(items) == len(raw):
        made, rest = _list(raw[1:])
        if not rest:
            return made
    return text[entry.start:entry.end]


def _word(token):
    try:
        return float(token) if re.search(r"[.eEnN]", token) else int(token)
    except ValueError:
        return _SWITCHES.get(token, token.strip('"'))


def _list(tokens):
    made = []
    while tokens:
        token, tokens = tokens[0], tokens[1:]
        if token == ")":
            return made, tokens
        if token == "(":
            inner, tokens = _list(tokens)
            made.append(inner)
        else:
            made.append(_word(token))
    return made, ["lacks )"]


def readDictionary(path, case=None):
    """A file as dictionaries within each other, after OpenFOAM has done its $, #include and
    #calc (foamDictionary); without those no program runs."""
    with open(path, errors="replace") as f:
        text = f.read()
    if re.search(r"[$#]", re.sub(r'//[^\n]*|/\*.*?\*/|"[^"\n]*"', "", text, flags=re.S)):
        case = os.path.abspath(case or ".")
        done = subprocess.run(
            ["foamDictionary", "-case", case, "-expand", os.path.abspath(path)],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL)
        text = done.stdout.decode(errors="replace")
        if done.returncode:
            raise DictionaryError(f"{path}: " + " ".join(text.split())[-300:])
    tree = parse(text)
    return value(text, tree)
