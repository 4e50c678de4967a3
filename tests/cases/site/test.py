#!/usr/bin/env python3
"""doc/Allmake: the pages as a site.

pages       every page of the project is one of the site; each link, anchor and picture is
            there, nothing is loaded from elsewhere; the gallery has all tutorials; the index
            of the search has the names of models
bad         links and pictures of pages that lead nowhere are errors that name them, anchors
            are found here; a missing package and a folder that is no site are refused
browser     in Chromium from files, at two widths: no error, no page wider than the window,
            equations drawn; the search for nodeDual finds the pages that have it

Skipped where Sphinx, its theme or KaTeX is missing, the browser's where there is none.
"""

import glob
import html.parser
import json
import os
import re
import shutil
import subprocess
import sys
import urllib.parse

TESTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../..")
sys.path.insert(0, os.path.join(TESTS, "lib"))
from browser import Browser, inBrowser
from foamCase import PROJECT, RUN, runParts

FOLDER = os.path.join(RUN, "site")
SITE = os.path.join(FOLDER, "html")


class Page(html.parser.HTMLParser):
    """Links, what is loaded, anchors and pictures of a page."""

    def __init__(self, path):
        super().__init__()
        self.links, self.loads, self.pictures, self.anchors = [], [], [], []
        with open(path, encoding="utf-8") as f:
            self.text = f.read()
        self.feed(self.text)

    def handle_starttag(self, tag, attributes):
        data = dict(attributes)
        self.anchors += [data["id"]] if "id" in data else []
        if tag == "a":
            self.links += [data["href"]] if "href" in data else []
        elif tag == "link" and data.get("rel") not in ("stylesheet", "icon"):
            self.links.append(data["href"])
        else:
            self.loads += [v for k, v in attributes if k in ("src", "href", "data")]
            if tag == "img":
                self.pictures.append(os.path.basename(data["src"]))


def make(*arguments, project=PROJECT, **environment):
    """Exit code and words of doc/Allmake."""
    run = subprocess.run(["bash", os.path.join(project, "doc/Allmake"), *arguments],
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                         stdin=subprocess.DEVNULL, timeout=400,
                         env={**os.environ, **environment})
    return run.returncode, run.stdout.decode()


def site(table):
    """Makes the site where a part is the first to need it; False where it cannot be."""
    if os.path.exists(os.path.join(SITE, ".made")):
        return True
    code, said = make("-output", SITE)
    if code and "missing:" in said:
        table.skip("the site", said.strip())
        return False
    if not table.check("doc/Allmake makes it, without a warning", code == 0, said[-600:]):
        return False
    open(os.path.join(SITE, ".made"), "w").close()
    return True


def read(folder):
    """All pages of a site, by their paths."""
    return {os.path.relpath(p, folder): Page(p)
            for p in glob.glob(os.path.join(folder, "**/*.html"), recursive=True)}


def broken(pages, folder):
    """Links, anchors and loads of pages that lead nowhere."""
    bad = []
    for name, page in pages.items():
        for uri in page.links + page.loads:
            parts = urllib.parse.urlsplit(uri)
            if parts.scheme or parts.netloc:
                if uri in page.loads:
                    bad.append(f"{name} loads {uri}")
                continue
            goal = os.path.normpath(os.path.join(os.path.dirname(name), urllib.parse.unquote(
                parts.path))) if parts.path else name
            there = pages.get(goal)
            if not os.path.isfile(os.path.join(folder, goal)) or parts.fragment and not (
                    there and urllib.parse.unquote(parts.fragment) in there.anchors):
                bad.append(f"{name}: {uri}")
    return bad


def sources():
    """Pages of the project as files and their text."""
    found = {}
    for pattern in ("*.md", "doc/*.md", "doc/guide/*.md", "tutorials/README.md",
                    "tutorials/*/README.md", "benchmarks/README.md"):
        for path in glob.glob(os.path.join(PROJECT, pattern)):
            with open(path, encoding="utf-8") as f:
                found[os.path.relpath(path, PROJECT)] = f.read()
    return found


def index():
    with open(os.path.join(SITE, "searchindex.js"), encoding="utf-8") as f:
        return json.loads(re.fullmatch(r"Search.setIndex\((.*)\)\s*", f.read(), re.S)[1])


def pages(table):
    shutil.rmtree(FOLDER, ignore_errors=True)
    if not site(table):
        return
    found, texts = read(SITE), sources()
    lacking = [n for n in texts if n[:-3] + ".html" not in found]
    table.row("pages of the project", 70, len(texts), 70, "atLeast")
    table.check("each is a page of the site", not lacking, " ".join(lacking))
    number = sum(len(p.links) for p in found.values())
    table.row("links and anchors", 1000, number, 1000, "atLeast")
    bad = broken(found, SITE)
    table.check("none leads nowhere, nothing is loaded from elsewhere", not bad,
                " ".join(bad[:10]))
    twice = [n for n, p in found.items() if len(set(p.anchors)) < len(p.anchors)]
    table.check("no anchor twice in a page", not twice, " ".join(twice))

    # As many links, and of each page the same pictures, as the sources have
    lacking = []
    for name, text in texts.items():
        text = re.sub(r"^```.*?^```", "", text, flags=re.S | re.M)
        wanted = [os.path.basename(p) for p in re.findall(
            r'!\[[^\]]*\]\(([^)\s]+)\)|<img [^>]*src="([^"]+)"', text) for p in p if p]
        if sorted(wanted) != sorted(found[name[:-3] + ".html"].pictures):
            lacking.append(name)
    table.check("each page has its pictures", not lacking, " ".join(lacking))
    tutorials = {os.path.basename(os.path.dirname(p)) for p in glob.glob(
        os.path.join(PROJECT, "tutorials/*/README.md"))}
    gallery = found["tutorials/README.html"]
    shown = {p.rsplit(".", 1)[0] for p in gallery.pictures}
    table.check("the gallery has all tutorials and their pictures",
                shown == tutorials and 'class="gallery"' in gallery.text,
                " ".join(sorted(shown ^ tutorials)))
    displayed = sum(len(re.findall("^```math", t, re.M)) for t in texts.values())
    table.row("equations on lines of their own", displayed, sum(
        p.text.count('<div class="math">') for p in found.values()), 0)

    words = index()["terms"]        # stems
    lacking = [w for w in ("nodedu", "gimp", "fmpm", "kingeri", "reportinterv", "taylor")
               if w not in words]
    table.check("the search knows words of the pages", not lacking, " ".join(lacking))


# --- what is wrong -----------------------------------------------------------------

def copyOfPages(folder):
    """The pages with what they show and name; sources are links."""
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(os.path.join(PROJECT, "doc"), os.path.join(folder, "doc"),
                    ignore=shutil.ignore_patterns("html"))
    for name in ("src", "etc", "LICENSE", "CITATION.cff"):
        os.symlink(os.path.join(PROJECT, name), os.path.join(folder, name))
    for pattern in ("*.md", "tutorials/README.md", "tutorials/*/README.md",
                    "benchmarks/README.md", "benchmarks/*.png", "benchmarks/*/*.png"):
        for path in glob.glob(os.path.join(PROJECT, pattern)):
            goal = os.path.join(folder, os.path.relpath(path, PROJECT))
            os.makedirs(os.path.dirname(goal), exist_ok=True)
            shutil.copy(path, goal)


def bad(table):
    code, said = make("-output", os.path.join(FOLDER, "none"), MPM_KATEX="/nowhere")
    table.check("a missing package: its name, and how to get it", code == 1
                and re.search("missing:.*libjs-katex.*apt-get install", said), said)
    code, said = make("-outptu", "x")
    table.check("a wrong argument: said", code == 1 and "-outptu" in said, said)
    if not site(table):
        return
    code, said = make("-output", os.path.join(PROJECT, "doc/guide"))
    table.check("a folder that is no site: refused", code == 1 and "no site" in said, said)

    folder = os.path.join(FOLDER, "copy")
    copyOfPages(folder)
    faults = {"a link": "[one](nowhere.md)", "a link in HTML": '<a href="missing.md">b</a>',
              "a link to a source": "[s](../src/gone.C#L3)",
              "a picture": "![p](pictures/lost.png)"}
    with open(os.path.join(folder, "doc/glossary.md"), "a") as f:
        f.write("\n" + "\n\n".join(faults.values()) + "\n")
    code, said = make("-output", os.path.join(FOLDER, "wrong"), project=folder)
    for (what, _), word in zip(faults.items(), ("nowhere.md", "missing.md", "gone.C", "lost.png")):
        table.check(f"{what} that leads nowhere: an error, names it", code == 1
                    and re.search(f"glossary.*{re.escape(word)}", said), said[-600:])
    table.check("... and no site is left", not os.path.exists(os.path.join(FOLDER, "wrong")))

    found = read(SITE)
    page = found["doc/theory.html"]
    for link in ("entries.html#nothing", "#nothing", "../src/none.html", "../_images/no.png"):
        page.links.append(link)
        table.check(f"the check of links finds {link}", broken(found, SITE)
                    == [f"doc/theory.html: {link}"])
        page.links.pop()


# --- in a browser ------------------------------------------------------------------

#: Pages that are looked at: raw HTML, gallery, equations, wide tables, a source of a long name
LOOKED = ("README", "tutorials/README", "tutorials/kirsch/README", "doc/theory",
          "doc/validation", "doc/entries", "benchmarks/README",
          "src/pointLaws/failureModels/maxPrincipalStress/maxPrincipalStress.C")


def browser(table):
    if not site(table):
        return
    if not Browser.find():
        table.skip("the site in a browser", "no chromium here")
        return
    inBrowser(table, os.path.join(FOLDER, "profile"), looks)


def looks(table, chromium):
    """The pages at two widths, and the search."""
    for width in (1400, 420):
        errors, wide, others, raw = [], [], [], []
        for name in LOOKED:
            page = chromium.open(os.path.join(SITE, name + ".html"), width, 900)
            # The theme wraps wide tables when all is loaded
            page.wait("!document.querySelector('table.docutils:not(.wy-table-responsive"
                      " *)')")
            errors += [f"{name}: {e}" for e in page.errors]
            others += [u for u in page.requests
                       if not u.startswith(("data:", "file://" + SITE))]
            if page.evaluate("document.documentElement.scrollWidth > window.innerWidth"):
                wide.append(name)
            if page.evaluate("[...document.querySelectorAll('.math')].some("
                             "m => !m.querySelector('.katex')) ||"
                             " document.querySelector('.katex-error') !== null"):
                raw.append(name)
            page.screenshot(os.path.join(
                FOLDER, f"{name.replace('/', '-')}-{width}.png"))
        text = f"{width} pixels: "
        table.check(text + "no error in the console", not errors, " ".join(errors))
        table.check(text + "nothing is loaded from elsewhere", not others, others)
        table.check(text + "no page is wider than the window", not wide, wide)
        table.check(text + "all equations are drawn", not raw, raw)
    search(table, chromium)


def search(table, chromium):
    """The form of the first page, by keys."""
    page = chromium.open(os.path.join(SITE, "README.html"), 1400, 900)
    page.evaluate("document.querySelector('input[name=q]').value = 'nodeDual';"
                  "setTimeout(() => document.querySelector('input[name=q]').form.submit())")
    page.wait("location.pathname.endsWith('search.html') && "
              "/found \\d+ page/.test(document.body?.textContent)")
    shown = page.evaluate("[...document.querySelectorAll('#search-results ul.search a')]"
                          ".map(a => a.href.replace(/[?#].*/, ''))")
    shown = {os.path.relpath(urllib.parse.unquote(u[len("file://"):]), SITE) for u in shown}
    having, parts = ({n[:-3] + ".html" for n, text in sources().items()
                      if re.search(word, re.sub(r"<!--.*?-->", "", text, flags=re.S), re.I)}
                     for word in (r"\bnodeDual\b", "nodeDual"))
    table.row("pages with nodeDual", 10, len(having), 10, "atLeast")
    table.check("the search finds them all", having <= shown, " ".join(having - shown))
    table.check("... and no others", shown <= parts, " ".join(shown - parts))
    page.wait(f"document.querySelectorAll('#search-results p.context').length >= {len(shown)}")
    places = page.evaluate("[...document.querySelectorAll('#search-results p.context')]"
                           ".map(p => p.textContent)")
    table.row("... each with the words about it", len(shown), sum(
        "nodedual" in p.lower() for p in places), 0)
    page.screenshot(os.path.join(FOLDER, "search.png"))
    table.check("search: no error in the console", not page.errors, page.errors)


if __name__ == "__main__":
    sys.exit(runParts("site", pages, bad, browser))
