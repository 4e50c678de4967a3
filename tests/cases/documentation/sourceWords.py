"""Words of dictionaries that the sources read.

    words = sourceWords(project)        # {file: {word: line}}

Taken are, comments left out,

- strings in the arguments of calls that read a dictionary or an option (READING);
- lists of strings in braces that are a wordList: valid keywords, valid choices;
- names of models: TypeName("...") of classes that are in a run-time selection table,
  and other names under which they are there;
- tables of quantities, {"sigma", 6, "[Pa]"}.

Left out is what a run reads of the files that it has written itself (dictionaries
with a name of STATE, files of WRITTEN), and words that are none of a dictionary
(NOT_ENTRIES).
"""

import os
import re

READING = set("""
    lookup get getOrDefault lookupOrDefault found findEntry lookupEntry subDict
    subOrEmptyDict isDict New addOption addBoolOption readListIfPresent
    requireKeyword required requiredDict positive bounded boundedOrDefault
    boundedLabelOrDefault oneOf oneOfOrDefault checkKeywords justOne wordList
    key keys append add failureModel addGimpPasses addLinearPasses
    addCubicBSplinePasses addQuadraticBSplinePasses
    """.split())

#: Dictionaries of the restart state
STATE = {"state", "energy", "body", "failed", "before", "record", "now"}

#: Files that read only what a run or setMaterialPoints has written
WRITTEN = {"materialPointCloudWrite.C", "materialPointCloudIO.C", "startState.C",
           "caseTime.H", "materialPointSystemOutput.C"}

#: What pages do not count either
SWITCHES = {"yes", "no"}

#: Words that the above takes and that are none of a dictionary: {file: words}
NOT_ENTRIES = {
    # Names of parts of the step
    "pointEnergy.H": "energy", "pointErosion.H": "eroded outflow",
    "rigidBodies.H": "rigid",
    # Columns of points
    "materialPointPhase.C": "failedTime", "isotropicElastic.H": "leftStretch",
    "JohnsonCookDamage.C": "damageStrain", "TulerButcher.C": "tensileImpulse",
    "maxPrincipalStrain.C": "leftStretch", "maxPrincipalStress.C": "crack",
    # Files
    "materialPointBalance.C": "total mixture", "materialPointEnergy.C": "energy",
    "materialPointPatchForces.C": "total", "surfaceShape.C": "triSurface",
    "phaseNames.C": "FoamFile", "meshPlaces.C": "boundaryField",
    "meshFilesCheck.C": "type nFaces startFace neighbourPatch coupleGroup",
    "flowOutput.C": "state",
    # A default
    "blastProbes.C": "p",
    # Asked for where they are not read
    "simulation.C": "gas", "regionTable.C": "gas contact",
    "setMaterialPoints.C": "gas velocity stress pressure",
    "materialPointSystem.C": "outflow", "materialPointSystemStop.C": "adjustTimeStep",
    "gasCoupling.C": "stick type",
    "stepEntry.H": "adjustTimeStep",
    "phaseWatches.C": "failureModel none", "phaseWatches.H": "materials",
    "pointRegionRead.C": "scale surface",
    "functionChecks.C": "functions timeStep",
    "startHints.C": "regions phase density contact normal fields gas "
                    "constitutiveModel failureModel type",
}

_TOKEN = re.compile(r'"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])\'|//[^\n]*|/\*.*?\*/', re.S)
_STRING = re.compile(r'"([A-Za-z][A-Za-z0-9_]*)(?:\(([A-Za-z]*)\)?)?"')
_CALL = re.compile(r"([A-Za-z_]\w*)\s*(?:<[^;(){}]*>)?\s*$")
_TYPE = re.compile(r"TypeName\w*\s*\(\s*$")
_CLASS = re.compile(r"\bclass (\w+)\s*:")
_ADD = re.compile(r"\badd(?:Template)?ToRunTimeSelectionTable\s*\(\s*\w+,\s*"
                  r"(?:whenMade,\s*)?(\w+),")
_MACRO = re.compile(r"#define (add\w+)\(")
_ADD_NAMED = re.compile(
    r"\baddNamedToRunTimeSelectionTable\s*\(\s*\w+,\s*\w+,\s*\w+,\s*(\w+)\s*\)")
_TABLE = re.compile(r'\{"\w+", \d, "\[')
_LIST = re.compile(r"(?:\bwordList\b|\bkeywords\b|\breturn\b)[^;]*$")


def withoutComments(text):
    """Comments blank, strings and lines as they were."""
    def blank(match):
        found = match.group(0)
        return found if found[0] in "\"'" else re.sub(r"[^\n]", " ", found)
    return _TOKEN.sub(blank, text)


def _bracket(text, at):
    """Place of the bracket around a place of the same statement; None: there is none."""
    depth = 0
    for i in range(at - 1, -1, -1):
        c = text[i]
        if c in ")}]":
            depth += 1
        elif c in "({[":
            if depth == 0:
                return i
            depth -= 1
        elif c == ";" and depth == 0:
            return None
    return None


def _isRead(text, at):
    """Is the string at this place a word of a dictionary that a user writes?"""
    taken = False
    i = _bracket(text, at)
    for level in range(4):
        if i is None:
            break
        before = text[max(0, i - 500):i]
        if text[i] == "{":
            taken = taken or level == 0 and bool(_LIST.search(before))
        elif text[i] == "(":
            call = _CALL.search(before)
            if call and call.group(1) in READING:
                taken = True
                receiver = re.search(r"(\w+)(?:\.|->)$", before[:call.start()])
                first = re.match(r"\s*(\w+)", text[i + 1:])
                if (receiver or first) and (receiver or first).group(1) in STATE:
                    return False
        i = _bracket(text, i)
    return taken


def addedByMacro(text):
    """Names that macros of the file add to a table."""
    for macro in _MACRO.findall(text):
        yield from re.finditer(rf"^\s*{macro}\((\w+)\)", text, re.M)


def wordsOf(text, selectable, classes):
    """{word: line} of one source without comments; selectable: classes that are in a table;
    classes: all. A macro may add a template by the name that it is given."""
    words = {match.group(1): text.count("\n", 0, match.start()) + 1
             for match in _ADD_NAMED.finditer(text)}
    words.update({match.group(1): text.count("\n", 0, match.start()) + 1
                  for match in addedByMacro(text)
                  if match.group(1) not in classes})
    for match in _STRING.finditer(text):
        at = match.start()
        if _TYPE.search(text[max(0, at - 40):at]):
            names = _CLASS.findall(text, 0, at)
            taken = bool(names) and names[-1] in selectable
        elif _TABLE.match(text, at - 1):
            taken = True
        else:
            taken = _isRead(text, at)
        if taken:
            for word in filter(None, match.groups()):
                words.setdefault(word, text.count("\n", 0, at) + 1)
    return words


def sourceFiles(project):
    """Sources of the libraries and programs, as paths in the project."""
    for folder in ("src", "applications"):
        for root, folders, names in os.walk(os.path.join(project, folder)):
            folders[:] = [f for f in folders if f not in ("lnInclude", "Make")]
            for name in sorted(names):
                if name.endswith((".C", ".H")):
                    yield os.path.relpath(os.path.join(root, name), project)


def sourceWords(project):
    """{file: {word: line}} of all sources that read dictionaries."""
    texts = {}
    for path in sourceFiles(project):
        with open(os.path.join(project, path)) as f:
            texts[path] = withoutComments(f.read())
    classes = {name for text in texts.values() for name in _CLASS.findall(text)}
    selectable = {name for text in texts.values() for name in _ADD.findall(text)}
    selectable |= {match.group(1) for text in texts.values() for match in addedByMacro(text)}

    found = {}
    for path, text in texts.items():
        name = os.path.basename(path)
        if name in WRITTEN:
            continue
        words = wordsOf(text, selectable, classes)
        for word in {*SWITCHES, *NOT_ENTRIES.get(name, "").split()}:
            words.pop(word, None)
        if words:
            found[path] = words
    return found
