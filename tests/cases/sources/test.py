#!/usr/bin/env python3
"""The sources keep to the sizes that a reader can hold in mind.

No file of src and applications has more than 600 lines, no function more than
120 (from its first line to its last brace), and none asks which OpenFOAM it is
compiled with. The count is tried on functions of known length. What a source calls
is declared in a header that it includes: Allwmake joins sources, where a missing
include is not seen.
"""

import glob
import os
import re
import sys

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from foamCase import PROJECT
from report import Report

FILE, FUNCTION = 600, 120

# Comments, strings, characters and lines of the preprocessor
HIDDEN = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"'
    r"|(?<![0-9a-zA-Z])'(?:\\.|[^'\\\n])+'|^[ \t]*\#(?:\\\n|[^\n])*", re.S | re.M)
SCOPE = re.compile(r"\b(?:namespace|class|struct|union|enum)\b|\bextern\s*$")


def withoutTemplates(head):
    """The words before a brace without template<...>, whose "class" makes no scope."""
    while True:
        start = re.search(r"\btemplate\s*<", head)
        if not start:
            return head
        i, depth = start.end(), 1
        while depth and i < len(head):
            depth += {"<": 1, ">": -1}.get(head[i], 0)
            i += 1
        head = head[:start.start()] + head[i:]


def functions(text):
    """(name, first line, lines) of the functions of a file."""
    text = HIDDEN.sub(lambda m: re.sub(r"[^\n]", " ", m[0]), text)
    found, scopes, head = [], [], 0     # scopes: is it one of a class or namespace
    inside = 0                          # braces open in a function
    for brace in re.finditer(r"[{};]|\b(?:public|private|protected)\s*:", text):
        if inside:
            inside += {"{": 1, "}": -1}.get(brace[0], 0)
            if inside == 0 and name:
                found.append((name, text.count("\n", 0, first) + 1,
                              text.count("\n", first, brace.end()) + 1))
            if inside:
                continue
        elif brace[0] == "{":
            words = withoutTemplates(text[head:brace.start()])
            if SCOPE.search(words):
                scopes.append(head)
            else:
                # Others with braces and no arguments are lists of values
                call = re.search(r"([\w:~]+|operator\W+)\s*\(", words)
                name = call[1].lstrip(":") if call else ""
                first = head + len(text[head:]) - len(text[head:].lstrip())
                inside = 1
                continue
        elif brace[0] == "}" and scopes:
            scopes.pop()
        head = brace.end()
    return found


def count(table):
    """Functions in all the places where they stand, of known length."""
    body = "{\n" + "    if (x) { y(); }\n"*5 + "}\n"        # 7 lines
    text = (
        '/* { */ // {\n#define BRACE {\nconst char* s = "{";\nconst char c = \'{\';\n'
        "namespace A\n{\nstatic const int list[] = {1, 2};\n"
        "int plain(int x)\n" + body
        + "template<template<int> class S, class T>\nvoid S<T>::made() const\n" + body
        + "class B\n:\n    public C\n{\npublic:\n    //- Comment\n    B()\n    :\n"
        "        C(1)\n" + body + "private:\n    int x_ = 1;\n    void f() {}\n};\n}\n")
    lengths = {name: n for name, _, n in functions(text)}
    table.check("count of lines", lengths == {"plain": 8, "made": 9, "B": 10, "f": 1},
                f"{lengths}")


def declared(text):
    """Names of the functions, classes and structs that a header has in its namespaces."""
    found, scopes, head = set(), [], 0  # scopes: is it one of a namespace
    for end in re.finditer(r"[{};]", text):
        words = withoutTemplates(text[head:end.start()])
        space = bool(re.search(r"\bnamespace\b", words))
        if end[0] != "}" and all(scopes) and not space:
            kind = re.search(r"\b(?:class|struct)\s+(\w+)", words)
            call = re.search(r"^[^=]*?(?<!:)\b(\w+)\s*\(", words)
            if kind and end[0] == "{" or call and not kind:
                found.add((kind or call)[1])
        if end[0] == "{":
            scopes.append(space)
        elif end[0] == "}" and scopes:
            scopes.pop()
        head = end.end()
    return found - {"decltype", "bool"}


class Includes:
    """The files that each includes, from texts = {path: text without comments}."""

    def __init__(self, texts, lines):
        self.texts, byName = texts, {}
        for name in texts:
            byName.setdefault(os.path.basename(name), []).append(name)
        self.direct = {}
        for name, text in lines.items():
            of = [byName.get(os.path.basename(i), []) for i in re.findall(
                r'^\s*#\s*include\s+"([^"]+)"', text, re.M)]
            self.direct[name] = [f for same in of for f in (
                [f for f in same if os.path.dirname(f) == os.path.dirname(name)] or same)]
        self.where = {}
        for name in texts:
            for word in declared(texts[name]) if name.endswith(".H") else ():
                self.where.setdefault(word, set()).add(name)

    def reached(self, name):
        """name and all that it includes."""
        found, left = {name}, [name]
        while left:
            new = set(self.direct[left.pop()]) - found
            found |= new
            left += new
        return found

    def missing(self, name):
        """"path: word of header" for each call without its header."""
        found, reached = [], self.reached(name)
        for word in set(re.findall(r"(?<![\w.>:])(?:Foam::)?(\w+)\s*[(<]",
                                   self.texts[name])) & set(self.where):
            # One of the same name: a member, a local function or variable
            own = re.compile(r"[\w>&*](?<!return)(?<!else)\s+\**&?(?:\w+::)*%s\s*[({=,;:)]"
                             % word)
            if not self.where[word] & reached and not any(
                    own.search(self.texts[f]) for f in reached):
                found.append(f"{name}: {word} of {min(self.where[word])}")
        return found


def includes(table, names):
    """Each source of a Make/files includes what it calls; a text without is found."""
    lines = {}
    for name in names:
        with open(name) as f:
            lines[os.path.relpath(name, PROJECT)] = f.read()
    texts = {name: HIDDEN.sub(" ", text) for name, text in lines.items()}
    sources = []
    for made in glob.glob(os.path.join(PROJECT, "*", "**", "Make", "files"), recursive=True):
        folder = os.path.relpath(os.path.dirname(os.path.dirname(made)), PROJECT)
        with open(made) as f:
            sources += [os.path.join(folder, line.strip()) for line in f]
    sources = [name for name in sources if name in lines]
    all_ = Includes(texts, lines)
    table.row("sources of Make/files", 250, len(sources), 250, "atLeast")
    found = [line for name in sources for line in all_.missing(name)]
    table.check("sources include what they call", not found, "; ".join(found))

    helper = "src/core/largestOfAll/largestOfAll.H"
    user = next(name for name in sources if helper in all_.direct[name]
                and helper not in {f for other in all_.direct[name] if other != helper
                                   for f in all_.reached(other)})
    all_.direct[user].remove(helper)
    table.check("a missing include is found", any(helper in line
                                                  for line in all_.missing(user)), user)


def main():
    table = Report("sources")
    count(table)
    names = [f for folder in ("src", "applications") for f in glob.glob(
        os.path.join(PROJECT, folder, "**", "*.[CH]"), recursive=True)
        if "lnInclude" not in f]
    longFiles, longFunctions, versions, longest, n = [], [], [], 0, 0
    for name in names:
        with open(name) as f:
            text = f.read()
        short = os.path.relpath(name, PROJECT)
        lines = text.count("\n")
        if lines > FILE:
            longFiles.append(f"{short}: {lines}")
        if re.search(r"^\s*#.*\bOPENFOAM", text, re.M):
            versions.append(short)
        for function, line, length in functions(text):
            n += 1
            longest = max(longest, length)
            if length > FUNCTION:
                longFunctions.append(f"{short}:{line} {function}: {length}")
    table.row("files read", 300, len(names), 300, "atLeast")
    table.row("functions found", 1500, n, 1500, "atLeast")
    table.check(f"no file over {FILE} lines", not longFiles, "; ".join(longFiles))
    table.row("lines of the longest function", FUNCTION, longest, FUNCTION, "atMost")
    table.check(f"no function over {FUNCTION} lines", not longFunctions,
                "; ".join(longFunctions))
    table.check("no condition on the version of OpenFOAM", not versions, "; ".join(versions))
    includes(table, names)
    return table.finish()


if __name__ == "__main__":
    sys.exit(main())
