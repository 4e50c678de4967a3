"""Single changes of a case's files, made from the files' own entries.

entries(text) finds the entries of a dictionary with their places in the text;
dictionaryChanges, fieldChanges and fileChanges give Change objects: the file,
the entry (keywords joined by dots), the kind of change and the new bytes (None:
the file goes; a Folder: a folder stands in its place).
"""

import os
import random
import re
import struct
from collections import namedtuple

Change = namedtuple("Change", "file entry kind new")
Entry = namedtuple("Entry", "path start end valueStart valueEnd isDict")

#: Stands for a folder in place of the file
Folder = object()

_TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|"[^"]*"|[{};()\[\]]|[^\s{};()\[\]"]+',
                    re.S)
NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"


def _tokens(text):
    return [m for m in _TOKEN.finditer(text)
            if not m.group().startswith(("//", "/*"))]


def entries(text):
    """All entries, those of sub-dictionaries and of dictionaries in lists as
    well; macros like $base; are left out."""
    found, tokens = [], _tokens(text)

    def scope(i, path):
        """Entries up to the closing brace or the end; the index behind it."""
        while i < len(tokens) and tokens[i].group() != "}":
            key = tokens[i]
            if i + 1 == len(tokens):
                return i + 1
            if tokens[i + 1].group() == "{":
                end = scope(i + 2, path + [key.group()])
                close = tokens[min(end, len(tokens)) - 1]
                found.append(Entry(".".join(path + [key.group()]), key.start(),
                                   close.end(), tokens[i + 1].start(),
                                   close.end(), True))
                i = end
                continue
            j = i + 1
            while j < len(tokens) and tokens[j].group() != ";":
                if tokens[j].group() == "{":
                    j = scope(j + 1, path + [key.group(), tokens[j - 1].group()])
                else:
                    j += 1
            if j < len(tokens) and j > i + 1 and not key.group().startswith("$"):
                found.append(Entry(".".join(path + [key.group()]), key.start(),
                                   tokens[j].end(), tokens[i + 1].start(),
                                   tokens[j - 1].end(), False))
            i = j + 1
        return i + 1

    scope(0, [])
    return sorted(found, key=lambda e: e.start)


def _misspelt(word):
    """The last two letters the other way round, or one letter more."""
    if len(word) > 1 and word[-1] != word[-2] and word[-2:].isalpha():
        return word[:-2] + word[-1] + word[-2]
    return word + "x"


def _values(old):
    """Other values for a value: kind and text."""
    if re.fullmatch(NUMBER, old):
        numbers = [("negative", "-" + old if float(old) else "-1"),
                ("huge", "1e300"), ("tiny", "1e-300"), ("zero", "0"),
                ("nan", "nan"), ("inf", "inf"), ("word for number", "much"),
                ("list for number", "(1 2)"), ("two numbers", old + " " + old),
                ("rubbish in number", old + "@1")]
        return [n for n in numbers
                if not re.fullmatch(NUMBER, n[1]) or float(n[1]) != float(old)]
    if re.match(r"[(\[]", old) or "(" in old:
        inside = re.search(rf"(?<![\w.$-]){NUMBER}(?![\w.$-])", old)
        kinds = [("empty list", "()"), ("number for list", "7"),
                 ("bracket missing", re.sub(r"[)\]]\s*$", "", old))]
        last = re.search(r"[^\s()\[\]]+(?=\s*[)\]]\s*$)", old)
        if last:
            kinds.append(("short list", old[:last.start()] + old[last.end():]))
        if inside:
            before, after = old[:inside.start()], old[inside.end():]
            kinds += [(name, before + value + after) for name, value in
                      (("nan in list", "nan"), ("huge in list", "1e300"),
                       ("negative in list", "-" + inside.group().lstrip("-0.")
                        if float(inside.group()) else "-1"),
                       ("word in list", "some"))]
        return kinds
    return [("misspelt value", _misspelt(old)), ("number for word", "3"),
            ("list for word", f"({old} {old})"), ("empty text", '""')]


def dictionaryChanges(file, text):
    for e in entries(text):
        key = e.path.split(".")[-1]
        head, old, tail = text[:e.start], text[e.start:e.end], text[e.end:]
        value = text[e.valueStart:e.valueEnd]
        wrong = _misspelt(key)
        kinds = [("deleted", ""), ("misspelt", wrong + old[len(key):]),
                 ("dictionary for value", key + " { a 1; }")]
        if e.isDict:
            kinds[2] = ("value for dictionary", key + " none;")
            kinds += [("empty dictionary", key + " {}"),
                      ("brace missing", old[:-1]),
                      ("unknown keyword", old[:-1] + "nobodyReadsThis 1; }")]
        else:
            kinds += [("no value", key + ";"), ("no semicolon", old[:-1])]
            kinds += [(kind, f"{key} {new};") for kind, new in _values(value)]
        if e.path.startswith("FoamFile"):
            kinds = [k for k in kinds if k[0] in ("deleted", "misspelt value",
                                                  "brace missing", "no value")]
        for kind, new in kinds:
            yield Change(file, e.path, kind, (head + new + tail).encode("latin-1"))


def fileChanges(file, data, isRead=True):
    """The file as a whole; without the comment at its end."""
    tokens = _tokens(data.decode("latin-1")) if b"// **" in data[-99:] else []
    end = tokens[-1].start() if tokens else len(data)
    dice = random.Random(file)
    rubbish = bytes(dice.randrange(256) for _ in range(64))
    yield Change(file, "", "file deleted", None)
    yield Change(file, "", "folder for file", Folder)
    percents = (0, 15, 40, 65, 90) + (100,)*bool(tokens)
    for percent in percents if isRead else (40,):
        yield Change(file, "", f"truncated to {percent} %",
                     data[:end*percent//100])
    yield Change(file, "", "binary rubbish alone", rubbish*8)
    for percent in (30, 70) if isRead else ():
        at = end*percent//100
        for t in tokens:
            at = t.start() if t.start() <= end*percent//100 else at
        yield Change(file, "", f"binary rubbish at {percent} %",
                     data[:at] + rubbish[:24] + data[at + 24:])


_SIZES = {"scalarField": 1, "vectorField": 3, "symmTensorField": 6,
          "tensorField": 9, "labelField": 1}


def fieldChanges(file, data):
    """A column of points, ascii or binary: its header, size and values."""
    head = re.match(rb".*?// (?:\* )+//\n", data, re.S)
    kind = re.search(rb"class\s+(\w+)\s*;", data)
    size = re.match(rb"\s*(\d+)\s*", data[head.end():]) if head else None
    if not size or not kind or kind[1].decode() not in _SIZES:
        return
    header, n = data[:head.end()], int(size[1])
    body = data[head.end() + size.end():]
    for name, old, new in (("class", rb"class\s+\w+", b"class tensorField"),
                           ("format", rb"format\s+\w+", b"format none")):
        yield Change(file, "header " + name, "header",
                     re.sub(old, new, header) + size[0] + body)
    for count in (0, n - 1, n + 1, -1, 2000000000, 99999999999):
        yield Change(file, "size", f"size {count if count < n - 1 else count - n:+d}",
                     header + str(count).encode() + b"\n" + body)

    values = [("nan", "nan"), ("inf", "inf"), ("huge", "1e300"),
              ("zero", "0"), ("tiny", "1e-300"), ("negative", None)]
    point = n//2
    if re.search(rb"format\s+binary", header) and body[:1] == b"(":
        isLabel = kind[1] == b"labelField"
        at = 1 + (4 if isLabel else 8*_SIZES[kind[1].decode()])*point
        code, width = ("i", 4) if isLabel else ("d", 8)
        old, = struct.unpack(code, body[at:at + width])
        for name, text in values:
            new = -abs(old) - 1 if text is None else float(text)
            if isLabel:
                if name not in ("zero", "negative"):
                    continue
                new = int(new)
            yield Change(file, f"point {point}", name, header + size[0]
                         + body[:at] + struct.pack(code, new) + body[at + width:])
        return
    same = re.match(rb"\{(.*?)\}", body, re.S)
    inner = body[body.find(b"(") + 1:body.rfind(b")")]
    words = [same[1]]*n if same else re.findall(rb"\([^()]*\)|[^\s()]+", inner)
    for name, text in values + [("word", "some"), ("nothing", "")]:
        def change(old):
            return b"-" + old[0].lstrip(b"-") if text is None else text.encode()
        new = list(words[:n])
        new[point] = re.sub(rb"[^\s()]+", change, new[point], count=1)
        yield Change(file, f"point {point}", name,
                     header + b"%d\n(\n" % n + b"\n".join(new) + b"\n)\n")


def cellFieldChanges(file, data):
    """A field of the cells with values of its own, binary or ascii: one of them, their
    number, dimensions, the conditions."""
    head = re.match(rb"(.*?(?:value|internalField)\s+nonuniform List<(\w+)>\s*)(\d+)(\s*)\(",
                    data, re.S)
    if not head:
        return
    n, start = int(head[3]), head.end()
    width = {b"scalar": 1, b"vector": 3}[head[2]]
    for count in (n - 1, n + 1, 3*n):
        yield Change(file, "size", f"size {count - n:+d}",
                     head[1] + str(count).encode() + head[4] + data[start - 1:])
    isBinary = re.search(rb"format\s+binary", head[1])
    end = start + 8*width*n if isBinary else data.index(b"\n)", start)
    point = n//2
    for name, text in (("nan", "nan"), ("inf", "inf"), ("huge", "1e300"), ("zero", "0"),
                       ("negative", None), ("tiny", "1e-300"), ("two", "2")):
        if isBinary:
            at = start + 8*width*point
            old, = struct.unpack("d", data[at:at + 8])
            new = -abs(old) - 1 if text is None else float(text)
            yield Change(file, f"cell {point}", name,
                         data[:at] + struct.pack("d", new) + data[at + 8:])
        else:
            words = data[start:end].split(b"\n")
            i = point + (not words[0].strip())
            words[i] = re.sub(rb"[^\s()]+", lambda m, text=text: b"-" + m[0].lstrip(b"-") + b"1"
                              if text is None else text.encode(), words[i], count=1)
            yield Change(file, f"cell {point}", name,
                         data[:start] + b"\n".join(words) + data[end:])
    for name, old, new in (
            ("dimensions", rb"dimensions\s+\[[^\]]*\]", b"dimensions [1 2 3 0 0 0 0]"),
            ("class", rb"class\s+\w+", b"class volTensorField"),
            ("internalField", rb"internalField\s+nonuniform", b"internalField uniform")):
        yield Change(file, name, "header", re.sub(old, new, data[:start], count=1) + data[start:])
    tail = data[end:]
    for kind, new in (("unknown condition", b"type zeroGradietn;"), ("no type", b"")):
        if re.search(rb"type\s+\w+;", tail):
            yield Change(file, "boundaryField", kind, data[:end]
                         + re.sub(rb"type\s+\w+;", new, tail, count=1))


def allChanges(case, files, unread):
    """Changes of the files of a case, which are given by their paths in it; of
    those that match the pattern unread only as a whole."""
    for file in files:
        with open(os.path.join(case, file), "rb") as f:
            data = f.read()
        isRead = not re.fullmatch(unread, file)
        yield from fileChanges(file, data, isRead)
        if isRead and "/lagrangian/" in file:
            yield from fieldChanges(file, data)
        elif isRead and b"nonuniform" not in data:
            yield from dictionaryChanges(file, data.decode("latin-1"))
        elif isRead:
            yield from cellFieldChanges(file, data)


def spread(changes, n):
    """About n of them: those that have the fewest of their kind and file so
    far first, in an order that only depends on the list."""
    def group(item):
        file = item[1].file
        return re.sub(r"^.*/", "", file) + str("/lagrangian/" in file), item[1].kind
    order = list(changes)
    random.Random(1912).shuffle(order)
    seen, ranked = {}, []
    for item in order:
        file, kind = group(item)
        rank = (seen.get((file, kind), 0), seen.get(kind, 0), seen.get(file, 0))
        for key in ((file, kind), kind, file):
            seen[key] = seen.get(key, 0) + 1
        ranked.append((rank, len(ranked), item))
    return [item for _, _, item in sorted(ranked, key=lambda r: r[:2])[:n]]
