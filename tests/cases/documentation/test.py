#!/usr/bin/env python3
"""The documentation against the sources; no solver runs but in the commands.

entries     doc/entries.md has every word of a dictionary that the sources read
            (sourceWords.py), and no other; removing a word is found
messages    every message of doc/guide/troubleshooting.md is one of the sources
links       links between the project's pages resolve, also to headings and lines;
            paths in code quotes exist; lines of tables have at most 160 characters
pictures    those of doc/pictures are small, those of README.md's row of one height; each
            tutorial's README and the index of the tutorials have one
commands    commands of README.md and doc run, in a copy of a case
"""

import glob
import os
import re
import shutil
import struct
import subprocess
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "../../lib"))
sys.path.insert(0, HERE)
from foamCase import PROJECT, RUN, runParts
from pages import Page, pages
from sourceWords import sourceFiles, sourceWords, withoutComments

MOST = 160


# --- entries -----------------------------------------------------------------

def compare(page, words):
    """Words that the page lacks, as "word (file:line)"; words that nobody reads, as
    "word (section)"; files of no section."""
    lacking, unread, nowhere = [], [], []
    sections = page.claims()
    for path, found in sorted(words.items()):
        having = [s for s in sections if s.claims(path)]
        if not having:
            nowhere.append(path)
        known = set().union(*(s.allWords for s in having))
        lacking += [f"{w} ({path}:{n})" for w, n in found.items() if w not in known]
    for section in sections:
        read = set()
        for path, found in words.items():
            if section.claims(path):
                read.update(found)
        unread += [f"{w} ({section.title})" for w in sorted(section.words - read)]
    return lacking, unread, nowhere


def entries(table):
    path = os.path.join(PROJECT, "doc/entries.md")
    words = sourceWords(PROJECT)
    page = Page(path)
    lacking, unread, nowhere = compare(page, words)
    table.row("files of the sources that read words", 60, len(words), 60, "atLeast")
    table.row("words that the sources read",
              250, len(set().union(*map(set, words.values()))), 250, "atLeast")
    table.check("doc/entries.md has them all", not lacking, " ".join(lacking))
    table.check("all words of doc/entries.md are read", not unread, " ".join(unread))
    table.check("all files are in a section of doc/entries.md", not nowhere,
                " ".join(nowhere))

    # The comparison finds what is missing: without each of some words it fails, and
    # with a word more
    missed = []
    for word in ("strength", "poreFloor", "pointsPerCell", "maxTravel", "nBins"):
        without = Page(path, page.text.replace(f"`{word}`", "`another`"))
        lacks, extra, _ = compare(without, words)
        if not any(w.startswith(word + " ") for w in lacks) \
                or not any(w.startswith("another ") for w in extra):
            missed.append(word)
    table.check("a word taken from the page is found", not missed, " ".join(missed))


# --- messages ----------------------------------------------------------------

def strings(text):
    """Strings of a source; those that follow each other in an output are one."""
    text = re.sub(r'"\s*(?:<<\s*(?:nl\s*<<\s*)*)?"', "", withoutComments(text))
    return "\n".join(re.findall(r'"((?:\\.|[^"\\\n])*)"', text))


def messages(table):
    """The pieces of a message between its dots stand in the strings of one source."""
    sources = []
    for path in sourceFiles(PROJECT):
        with open(os.path.join(PROJECT, path)) as f:
            sources.append(strings(f.read()))

    def isOne(message):
        pieces = [p.strip() for p in message.split("...") if p.strip()]
        return any(all(p in text for p in pieces) for text in sources)

    found = Page(os.path.join(PROJECT, "doc/guide/troubleshooting.md")).messages()
    bad = [m for m in found if not isOne(m)]
    table.row("messages of doc/guide/troubleshooting.md", 40, len(found), 40, "atLeast")
    table.check("they are those of the sources", not bad, " | ".join(bad))
    changed = [m for m in found if isOne(m + "qz")]
    table.check("a message with letters more is found", not changed,
                " | ".join(changed))


# --- links -------------------------------------------------------------------

def hasPlace(page, path, place):
    """Has a page the heading, or a source the line?"""
    if page:
        return place in page.anchors()
    line = re.fullmatch(r"L(\d+)", place)
    with open(os.path.join(PROJECT, path)) as f:
        return bool(line) and int(line.group(1)) <= len(f.readlines())


def links(table):
    every = {os.path.relpath(p, PROJECT): Page(p) for p in pages(PROJECT)}
    bad, number, long = [], 0, []
    for name, page in every.items():
        for target in page.links():
            number += 1
            file, _, heading = target.partition("#")
            goal = os.path.normpath(os.path.join(os.path.dirname(name), file)) \
                if file else name
            if not os.path.exists(os.path.join(PROJECT, goal)) \
                    or heading and not hasPlace(every.get(goal), goal, heading):
                bad.append(f"{name}: {target}")
        bad += [f"{name}: {p}" for p in page.paths()
                if not os.path.exists(os.path.join(PROJECT, p))]
        long += [f"{name}:{n}" for n, line in enumerate(page.text.split("\n"), 1)
                 if line.lstrip().startswith("|") and len(line) > MOST]
    table.row("links between pages", 50, number, 50, "atLeast")
    table.check(f"links of {len(every)} pages resolve", not bad, " ".join(bad))
    table.check(f"lines of tables have at most {MOST} characters", not long, " ".join(long))


# --- pictures ----------------------------------------------------------------

def pictures(table):
    folder = os.path.join(PROJECT, "doc/pictures")
    files = sorted(glob.glob(os.path.join(folder, "*.png")))
    sizes = {os.path.basename(f): os.path.getsize(f) for f in files}
    table.row("largest picture of doc/pictures [kB]", 150, max(sizes.values())/1e3, 150,
              "atMost")
    sizes = [os.path.getsize(f) for f in glob.glob(os.path.join(folder, "*.gif"))]
    table.row("largest animation of doc/pictures [kB]", 500, max(sizes)/1e3, 500, "atMost")
    heights = []
    for path in re.findall(r'src="(doc/pictures/\w+\.png)"', Page(
            os.path.join(PROJECT, "README.md")).text):
        with open(os.path.join(PROJECT, path), "rb") as f:
            heights.append(struct.unpack(">II", f.read(24)[16:])[1])
    table.row("pictures in the row of README.md", 4, len(heights), 4, "atLeast")
    table.check("the row has one height", len(set(heights)) == 1, heights)
    index = Page(os.path.join(PROJECT, "tutorials/README.md")).text
    lacking = [name for name in sorted(os.listdir(os.path.join(PROJECT, "tutorials")))
               if os.path.exists(os.path.join(PROJECT, "tutorials", name, "README.md"))
               and not (f"doc/pictures/{name}.png" in index
                        and f"doc/pictures/{name}.png" in Page(os.path.join(
                            PROJECT, "tutorials", name, "README.md")).text)]
    table.check("each tutorial has its picture, and the index has it", not lacking,
                " ".join(lacking))


# --- commands ----------------------------------------------------------------

def commands(table):
    """Blocks of the language sh. The first line of a block may say that it is not run
    here: "# not run by the tests", or "# run by tests/Alltest <name>". Blocks of other
    languages and indented ones have no commands."""
    unknown, nBlocks, hidden = [], 0, []
    ran = afterAllrun(table)
    for path in [os.path.join(PROJECT, "README.md")] + sorted(glob.glob(
            os.path.join(PROJECT, "doc/**/*.md"), recursive=True)):
        name = os.path.relpath(path, PROJECT)
        here = []
        hidden += [f"{name}: {line}" for line in Page(path).hiddenCommands()]
        for block in Page(path).blocks("sh"):
            nBlocks += 1
            other = re.match(r"# run by tests/Alltest(.*)\n", block)
            if other:
                unknown += [f"{name}: {t}" for t in other.group(1).split() if t != "unit"
                            and not os.path.exists(os.path.join(HERE, "..", t, "test.py"))]
            elif not block.startswith("# not run by the tests"):
                here.append(block)
        if here:
            runBlocks(table, name, here, ran)
    table.row("blocks of commands", 10, nBlocks, 10, "atLeast")
    table.check("no commands in other blocks", not hidden, " | ".join(hidden))
    table.check("tests that run the others exist", not unknown, " ".join(unknown))


def coarse(path):
    """The plates of tutorials/spall with 60 cells in place of 100. Its probes in the
    mid-plane have points down to 50."""
    with open(path) as f:
        text = f.read()
    for name, n in (("n", 100), ("nx", 240), ("ny", 200)):
        text, nChanged = re.subn(rf"(?m)^({name} +){n};", rf"\g<1>{6*n//10};", text)
        assert nChanged == 1, name
    with open(path, "w") as f:
        f.write(text)


def afterAllrun(table):
    """tutorials/spall with a coarse mesh after its Allrun, the first command of README.md:
    what a reader copies has results in it."""
    folder = os.path.join(RUN, "documentation", "spall")
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(os.path.join(PROJECT, "tutorials/spall"), folder)
    subprocess.run(["./Allclean"], cwd=folder, check=True)
    coarse(os.path.join(folder, "system/blockMeshDict"))
    status = inEnvironment(["./Allrun"], folder, "log.Allrun")
    table.check("tutorials/spall/Allrun runs, coarse", status == 0
                and os.path.exists(os.path.join(folder, "0/lagrangian")), f"exit {status}")
    return folder


def inEnvironment(command, folder, log):
    """Exit status of a command in a folder, which writes to a file of it."""
    with open(os.path.join(folder, log), "w") as out:
        return subprocess.run(
            command, cwd=folder, stdout=out, stderr=subprocess.STDOUT,
            stdin=subprocess.DEVNULL, timeout=300,
            env={**os.environ, "PWD": folder, "MPM_PROJECT_DIR": PROJECT,
                 "MPM_PREPARED": "1"}).returncode


def runBlocks(table, name, blocks, ran):
    """The blocks of a page one after the other, in a folder with a copy of the project's
    tutorials, spall as its Allrun leaves it; other cases end early (runShort)."""
    folder = os.path.join(RUN, "documentation", name.replace("/", "-")[:-3])
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    os.symlink(os.path.join(PROJECT, "etc"), os.path.join(folder, "etc"))
    shutil.copytree(os.path.join(PROJECT, "tutorials"), os.path.join(folder, "tutorials"),
                    ignore=shutil.ignore_patterns(
                        "log.*", "postProcessing", "processor*", "VTK", "polyMesh", "*.png",
                        "lagrangian", "variants", "schemes", "uniform", "[1-9]*", "0.[0-9]*"))
    shutil.rmtree(os.path.join(folder, "tutorials/spall"))
    shutil.copytree(ran, os.path.join(folder, "tutorials/spall"))
    script = os.path.join(folder, "commands.sh")
    with open(script, "w") as f:
        f.write(f"set -e\n. {HERE}/runShort\n" + "\n".join(blocks))
    start = time.time()
    status = inEnvironment(["bash", script], folder, "log.commands")
    table.check(f"{name}: {len(blocks)} blocks of commands run", status == 0,
                f"exit {status}, {time.time() - start:.0f} s, see {os.path.relpath(folder, PROJECT)}")


if __name__ == "__main__":
    sys.exit(runParts("documentation", entries, messages, links, pictures, commands))
