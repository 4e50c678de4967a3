"""Pages of the documentation (Markdown) as the tests see them."""

import os
import re

from sourceWords import SWITCHES

_IDENTIFIER = re.compile(r"[A-Za-z][A-Za-z0-9_]*")
_SPAN = re.compile(r"`([^`]+)`")
_CLAIM = re.compile(r"<!-- read in: ([^>]*?) -->", re.S)
_COMMANDS = ("cp|mkdir|touch|git|wmake|mpirun|blockMesh|setMaterialPoints|materialPointFoam"
             r"|foam[A-Z]\w+|decomposePar|reconstructPar|compareMaterialPoints|redistributeCase|paraview"
             r"|\./All\w+|(tests|tutorials|benchmarks)/[\w/]*All\w+|\. etc/\w+")


def pages(project):
    """Paths of all pages of the project, without those of runs."""
    for root, folders, names in os.walk(project):
        if root == project:
            folders[:] = [f for f in folders if f not in (".git", "platforms")]
        if root == os.path.join(project, "tests"):
            folders[:] = [f for f in folders if f != "run"]
        for name in sorted(names):
            if name.endswith(".md"):
                yield os.path.join(root, name)


class Section:
    """A heading with its text. words: those of first columns and of columns values;
    allWords: with the defaults."""

    def __init__(self, title, text):
        self.title = title
        self.sources = [s for claim in _CLAIM.findall(text) for s in claim.split()]
        self.words, self.allWords = set(), set()
        columns = 1
        for line in text.split("\n"):
            if not line.startswith("|"):
                continue
            cells = [c.strip() for c in line.strip().strip("|").split("|")]
            if set(line) <= set("|- "):
                continue
            if cells[0] and "`" not in cells[0]:
                columns = 2 if len(cells) > 1 and cells[1] == "values" else 1
                continue
            self.words |= self._of(cells[:columns])
            self.allWords |= self._of(cells[:columns + 1])

    @staticmethod
    def _of(cells):
        return {word for cell in cells for span in _SPAN.findall(cell)
                for word in _IDENTIFIER.findall(span)} - SWITCHES

    def claims(self, path):
        return any(path == s or path.startswith(s + "/") for s in self.sources)


class Page:
    def __init__(self, path, text=None):
        if text is None:
            with open(path) as f:
                text = f.read()
        self.text = text

    def _withoutBlocks(self):
        return re.sub(r"^```.*?^```", "", self.text, flags=re.S | re.M)

    def headings(self):
        return re.findall(r"^#+ +(.*?) *$", self._withoutBlocks(), re.M)

    def anchors(self):
        """Names of the headings in links."""
        return {re.sub(r"[^\w\- ]", "", h.lower()).replace(" ", "-")
                for h in self.headings()}

    def claims(self):
        """Sections that name the sources which read their words."""
        parts = re.split(r"^#+ +(.*?) *$", self.text, flags=re.M)
        found = [Section(t, text) for t, text in zip(parts[1::2], parts[2::2])]
        return [s for s in found if s.sources]

    def links(self):
        """Targets of links and pictures within the project."""
        text = re.sub(r"`[^`\n]*`", "", self._withoutBlocks())
        return [t for t in re.findall(r"\]\(([^)\s]+)\)", text)
                + re.findall(r'<(?:img src|a href)="([^"]+)"', text)
                if not re.match(r"[a-z]+:", t)]

    def blocks(self, language):
        return re.findall(rf"^```{language}\n(.*?)^```", self.text, re.S | re.M)

    def paths(self):
        """Files and folders of the project that stand in code quotes."""
        return [span for span in _SPAN.findall(self._withoutBlocks())
                if re.fullmatch(r"(src|applications|doc|etc|tests|tutorials|benchmarks)"
                                r"/[\w./]*\w", span) and "tests/run" not in span]

    def hiddenCommands(self):
        """Commands in blocks that are not of the language sh."""
        lines = [line for line in self._withoutBlocks().split("\n")
                 if line.startswith("    ")]
        for language, block in re.findall(r"^```(\w*)\n(.*?)^```", self.text, re.S | re.M):
            if language != "sh":
                lines += block.split("\n")
        return [line.strip() for line in lines
                if re.match(rf"\s*({_COMMANDS})(\s|$)", line)]

    def messages(self):
        """Messages in the first column of tables."""
        return [span for line in self.text.split("\n") if line.startswith("|")
                for span in _SPAN.findall(line.split("|")[1])]
