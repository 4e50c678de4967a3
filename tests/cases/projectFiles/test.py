#!/usr/bin/env python3
"""The project's own files: version, style, and what doc/ says of the source.

    version    one number in src/core/version/version.H, CITATION.cff and the first entry of
               CHANGELOG.md; the solver and setMaterialPoints print it (-help, log) and it is
               in the files of points and of the state
    style      text files as .editorconfig says: no tabs, no blanks at the end of a line, lines
               end with LF, so does the file; no marks of a merge; src and applications: lines
               below 100 columns, files below 600 lines
    imports    what Python scripts take from modules of the project is defined there
    theory     doc/theory.md has equations (1) to (12), each a row with functions; each link to a
               function leads to its definition (within 25 lines)
    extending  doc/extending.md names each template of etc/codeTemplates, and there is one for
               each row of its table; its commands make a library that a case loads
    glossary   words in the order of the alphabet, links to functions as above

    test.py -update       sets the lines of the links in doc/ anew, after code has moved
"""

import ast
import glob
import os
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../lib"))
import sourceLinks
from bar import barRun
from foamCase import PROJECT, runParts

PAGES = ("theory.md", "extending.md", "glossary.md")


def text(*path):
    with open(os.path.join(PROJECT, *path), encoding="utf-8", newline="") as f:
        return f.read()


def only(pattern, where, flags=re.M):
    """The one match of a pattern, or all of them."""
    found = re.findall(pattern, where, flags)
    return found[0] if len(set(found)) == 1 else found


# --- version -----------------------------------------------------------------

def version(table):
    number = only(r'version = "materialPointFoam (\d+\.\d+\.\d+)"',
                  text("src/core/version/version.H"))
    table.check("version: one in the source", isinstance(number, str), number)
    table.check("version: CITATION.cff", only(r"^version: (\S+)$", text("CITATION.cff")) == number)
    table.check("version: first entry of CHANGELOG.md",
                re.search(r"^## (\S+)", text("CHANGELOG.md"), re.M).group(1) == number)
    line = f"materialPointFoam {number}"
    for tool in ("materialPointFoam", "setMaterialPoints"):
        run = subprocess.run([tool, "-help"], stdout=subprocess.PIPE, timeout=60)
        table.check(f"version: {tool} -help", line in run.stdout.decode().split("\n"))
    case = barRun("projectFiles", "bar", {"shapeFunction": "GIMP", "transfer": "FLIP"}, 8)[0]
    table.check("version: in the log, once", case.log().split("\n").count(line) == 1)
    for time, names in (("0", ("lagrangian/bar/m", "uniform/materialPointMesh")),
                        (case.times()[-1], ("lagrangian/bar/U", "lagrangian/bar/id",
                                            "uniform/materialPointMesh",
                                            "uniform/materialPointState"))):
        for name in names:
            with open(case.file(time, name), "rb") as f:
                head = f.read(2000).decode("latin-1")
            table.check(f"version: in {'0' if time == '0' else 'the end'}/{name}",
                        f'"{line}"' in head or head.startswith(f"// {line}\n"))


# --- style -------------------------------------------------------------------

def files():
    """Text files that belong to the project: those that git knows, or all."""
    run = subprocess.run(["git", "ls-files", "-z"], cwd=PROJECT, stdout=subprocess.PIPE,
                         stderr=subprocess.DEVNULL)
    names = [n for n in run.stdout.decode().split("\0") if n] if run.returncode == 0 else [
        os.path.relpath(p, PROJECT)
        for p in glob.glob(os.path.join(PROJECT, "**/*.[CH]"), recursive=True)]
    return [n for n in names if os.path.isfile(os.path.join(PROJECT, n))
            and not n.endswith((".png", ".gif", ".mp4", ".stl", ".gz"))]


def style(table):
    bad = {"tabs": [], "blanks at the end of a line": [], "CR": [],
           "no end of the last line": [], "a line above 100 columns": [],
           "a source file above 600 lines": [], "marks of a merge": []}
    names = files()
    for name in names:
        content = text(name)
        lines = content.split("\n")
        if any("\t" in x for x in lines) and "Allwmake" not in name and "Make/" not in name:
            bad["tabs"].append(name)
        if any(x.endswith(" ") for x in lines):
            bad["blanks at the end of a line"].append(name)
        if "\r" in content:
            bad["CR"].append(name)
        if content and not content.endswith("\n"):
            bad["no end of the last line"].append(name)
        if re.match("(src|applications)/.*[.][CH]$", name) and any(len(x) > 100 for x in lines):
            bad["a line above 100 columns"].append(name)
        if any(x.startswith(("<"*7, ">"*7)) for x in lines):
            bad["marks of a merge"].append(name)
        if name.startswith("src/") and len(lines) > 601:
            bad["a source file above 600 lines"].append(name)
    table.row("style: files looked at", 300, len(names), 300, "atLeast")
    for what, which in bad.items():
        table.row(f"style: files with {what}", 0, len(which), 0)
        if which:
            print("   ", *which)


def pythonImports(table):
    """Names that scripts take from modules of the project."""
    folder, lacking, n = os.path.join(PROJECT, "etc/python"), [], 0

    def defined(path):
        return {x.id if isinstance(x, ast.Name) else (x.asname or x.name).split(".")[0] if
                isinstance(x, ast.alias) else x.name for x in ast.walk(ast.parse(text(path)))
                if isinstance(x, (ast.FunctionDef, ast.ClassDef, ast.alias))
                or isinstance(x, ast.Name) and isinstance(x.ctx, ast.Store)}
    for name in files():
        if not name.endswith(".py"):
            continue
        for node in ast.walk(ast.parse(text(name))):
            if not isinstance(node, ast.ImportFrom):
                continue
            source = next((p for p in (
                os.path.join(PROJECT, os.path.dirname(name), node.module + ".py"),
                os.path.join(PROJECT, "tests/lib", node.module + ".py"),
                os.path.join(folder, node.module.replace(".", "/") + ".py"))
                if os.path.isfile(p)), None)
            if source:
                n += 1
                known = defined(source)
                lacking += [f"{name}: {a.name} of {node.module}" for a in node.names
                            if a.name not in known]
    table.row("imports of the project's Python modules", 300, n, 300, "atLeast")
    table.check("each name is there", not lacking, "; ".join(lacking))


def layout(table):
    """.clang-format, by the version that it was written for."""
    what = "style: files that clang-format changes"
    try:
        version = subprocess.run(["clang-format", "--version"], stdout=subprocess.PIPE).stdout
    except OSError:
        version = b"none"
    if b"version 14." not in version:
        table.skip(what, "no clang-format 14")
        return
    names = [n for n in files() if re.match("(src|applications|tests|benchmarks)/.*[.][CH]$", n)]
    run = subprocess.run(["clang-format", "--dry-run", *names], cwd=PROJECT,
                         stderr=subprocess.PIPE)
    wrong = set(re.findall(r"^(\S+?):\d+:\d+: warning", run.stderr.decode(), re.M))
    table.row(what, 0, len(wrong), 0)
    print("   ", *sorted(wrong))


# --- pages of doc/ -----------------------------------------------------------

def links(table, page, least):
    n, wrong = sourceLinks.wrong(page, text("doc", page))
    table.row(f"{page}: links to functions", least, n, least, "atLeast")
    table.row(f"{page}: links that lead elsewhere (test.py -update)", 0, len(wrong), 0)
    for sentence in wrong:
        print("   ", sentence)


def theory(table):
    page = text("doc", "theory.md")
    table.check("theory.md: equations (1) to (12)",
                re.findall(r"\\tag\{(\d+)\}", page) == [str(i) for i in range(1, 13)])
    rows = re.findall(r"^\| ((?:section|\(\d+\)).*?) \| (.*?) \|", page, re.M)
    named = {n for equation, code in rows if sourceLinks.USE.search(code)
             for n in re.findall(r"\((\d+)\)", equation)}
    table.check("theory.md: each has a row with functions",
                named == {str(i) for i in range(1, 13)}, sorted(named, key=int))
    table.check("theory.md: mathematics opens and closes in a line",
                page.count("```") % 2 == 0 and not any(
                    line.count("$") % 2 for line in re.sub(
                        r"(?s)```.*?```", "", page).split("\n")))
    links(table, "theory.md", 55)


def extending(table):
    page = text("doc", "extending.md")
    named = set(re.findall(r"\(\.\./etc/codeTemplates/(\w+\.C)\)", page))
    there = {os.path.basename(p) for p in
             glob.glob(os.path.join(PROJECT, "etc/codeTemplates/*.C"))}
    table.check("extending.md: names each template, and no other", named == there,
                " ".join(sorted(named ^ there)))
    rows = [line for line in page.split("\n") if line.startswith("| ") and "---" not in line][1:]
    table.row("extending.md: extension points", 16, len(rows), 16, "atLeast")
    table.check("extending.md: each with a template, or in the tree only",
                all("etc/codeTemplates/" in r or "in the tree only" in r for r in rows))
    links(table, "extending.md", 16)

    # The commands, in an empty folder
    commands = re.search(r"(?m)^```sh\n# run by .*\n([^`]+)", page).group(1)
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run(["bash", "-ec", commands], cwd=folder, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, timeout=200,
                             env={**os.environ, "MPM_PROJECT_DIR": PROJECT})
        library = os.path.join(os.environ["FOAM_USER_LIBBIN"], "libmyModels.so")
        table.check("extending.md: its commands make a library",
                    run.returncode == 0 and os.path.exists(library),
                    " ".join(run.stdout.decode().split())[-200:])
        case = barRun("projectFiles", "loaded", {"shapeFunction": "GIMP", "transfer": "FLIP"},
                      8)[0]
        case.change("system/controlDict", r"^startFrom", 'libs ("libmyModels.so");\nstartFrom')
        case.change("constant/phaseProperties", r"type +\w+;", "type none;")
        case.run("materialPointFoam", fails=True)
        table.check("extending.md: a case that loads it knows the law", "Maxwell" in case.log())
    if os.path.exists(library):
        os.remove(library)


def glossary(table):
    page = text("doc", "glossary.md")
    words = [w.lower() for w in re.findall(r"^\| \*\*(.+?)\*\* \|", page, re.M)]
    table.row("glossary.md: words", 40, len(words), 40, "atLeast")
    table.check("glossary.md: in the order of the alphabet", words == sorted(words),
                next((b for a, b in zip(words, words[1:]) if a > b), ""))
    links(table, "glossary.md", 5)


if __name__ == "__main__":
    if sys.argv[1:] == ["-update"]:
        for name in PAGES:
            path = os.path.join(PROJECT, "doc", name)
            new = sourceLinks.updated(name, text("doc", name))
            with open(path, "w", encoding="utf-8") as f:
                f.write(new)
        sys.exit(0)
    sys.exit(runParts("projectFiles", version, style, pythonImports, layout, theory, extending, glossary))
