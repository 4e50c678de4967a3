"""The site of doc/Allmake: configuration of Sphinx.

The pages are written for GitHub and stay as they are. What differs is done here: blocks
"math" are equations; headings have GitHub's anchors; links to pages, also in HTML, lead to
their HTML; a source that is linked becomes a page of the site, with its lines as anchors.
"""

import json
import os
import re

import docutils.nodes as nodes
import pygments
from pygments.formatters import HtmlFormatter
from pygments.lexers import get_lexer_by_name
from sphinx.util import logging
from sphinx.util.osutil import relative_uri

HERE = os.path.dirname(os.path.abspath(__file__))
PROJECT = os.path.dirname(os.path.dirname(HERE))
LOG = logging.getLogger(__name__)

project = "materialPointFoam"
root_doc = "README"
extensions = ["myst_parser", "sphinx_rtd_theme"]
include_patterns = ["*.md", "doc/**.md", "tutorials/**README.md", "benchmarks/README.md"]
# Folders of runs are not even looked at
exclude_patterns = [".*", "src", "applications", "platforms", "tests", "etc", "benchmarks/*/*",
                    "doc/html", "doc/pictures", "doc/site", "tutorials/*/[!R]*"]
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 6
myst_all_links_external = True      # linked() sees to them
html_theme = "sphinx_rtd_theme"
html_title = "materialPointFoam"
html_static_path = [os.environ.get("MPM_KATEX", "/usr/share/javascript/katex"), "static"]
exclude_patterns += ["contrib", "katex.js", "katex.css", "*.mjs"]      # of KaTeX
html_css_files = ["site.css"]
html_math_renderer = "katex"
html_copy_source = False
html_show_sphinx = False
smartquotes = False

#: Pages below a page, in the order of the navigation; * for those of a folder
BELOW = {
    "README": ("doc/guide/README", "doc/entries", "tutorials/README", "doc/theory",
               "doc/architecture", "doc/extending", "doc/validation", "doc/misses",
               "doc/benchmarks", "benchmarks/README", "doc/glossary", "CONTRIBUTING",
               "CHANGELOG"),
    "doc/guide/README": ("*",),
    "tutorials/README": ("*/README",)}


def below(app, docname, source):
    if docname in BELOW:
        tree = "\n```{toctree}\n:hidden:\n:glob:\n\n" + "\n".join(BELOW[docname]) + "\n```\n"
        # Before the first section: below the page, not below its last section
        source[0] = re.sub("\n## ", lambda m: tree + m[0], source[0], count=1)


def read(app, doctree):
    """Blocks "math", and GitHub's anchors."""
    for node in list(doctree.findall(nodes.literal_block)):
        if node.get("language") == "math":
            node.replace_self(nodes.math_block(node.astext(), node.astext(), nowrap=True,
                                               number=None, label=None))
    for section in doctree.findall(nodes.section):
        slug = section.get("myst-anchor", "#").split("#")[1]
        if slug and slug not in section["ids"]:
            section["ids"].append(slug)


def linked(app, docname, uri):
    """Where a link of a page leads in the site."""
    if re.match(r"[a-z]+:|#|$", uri):
        return uri
    file, _, place = uri.partition("#")
    path = os.path.normpath(os.path.join(os.path.dirname(docname), file))
    if os.path.isdir(os.path.join(PROJECT, path)):
        path += "/README.md"
    if path.endswith(".md") and path[:-3] in app.env.found_docs:
        page = path[:-3]
    elif os.path.isfile(os.path.join(PROJECT, path)):
        page = path
        app.sources.add(path)
        place = re.sub(r"^L(?=\d)", "L-", place)
    else:
        LOG.warning("no such file: %s", uri, location=docname)
        return uri
    return app.builder.get_relative_uri(docname, page) + ("#" + place if place else "")


def resolved(app, doctree, docname):
    for node in doctree.findall(nodes.reference):
        if not node.get("internal") and "refuri" in node:
            node["refuri"] = linked(app, docname, node["refuri"])

    def picture(match):
        path = os.path.normpath(os.path.join(os.path.dirname(docname), match[1]))
        app.builder.images[path] = app.env.images.add_file(docname, path)
        return f'src="{relative_uri(app.builder.get_target_uri(docname), "_images")}/' \
            f'{app.builder.images[path]}"'

    words = doctree.astext()
    for node in list(doctree.findall(nodes.raw)):
        words = words.replace(node.astext(), re.sub("<.*?>", " ", node.astext(), flags=re.S))
        text = re.sub('href="([^"]*)"', lambda m: f'href="{linked(app, docname, m[1])}"',
                      node.astext())
        text = re.sub('src="([^":]*)"', picture, text)
        if docname == "tutorials/README":
            text = text.replace("<table>", '<table class="gallery">')
        node.replace_self(nodes.raw("", text, format="html"))
    app.texts[docname] = words


def sources(app):
    """Pages of the sources that are linked."""
    form = HtmlFormatter(linenos="inline", linespans="L")
    for path in sorted(app.sources):
        with open(os.path.join(PROJECT, path), encoding="utf-8") as f:
            text = f.read()
        kind = "cpp" if path.endswith((".C", ".H")) else "text"
        yield path, {"title": path, "body": f"<h1>{path}</h1>" + pygments.highlight(
            text, get_lexer_by_name(kind), form)}, "page.html"


def equation(self, node):
    """What site.js gives to KaTeX."""
    tag = "div" if isinstance(node, nodes.math_block) else "span"
    self.body.append(f'<{tag} class="math">{self.encode(node.astext())}</{tag}>')
    raise nodes.SkipNode


def scripts(app, pagename, templatename, context, doctree):
    if pagename == "search":
        app.add_js_file("texts.js")
        app.add_js_file("search.js")
    if doctree and any(isinstance(n, (nodes.math, nodes.math_block)) for n in doctree.findall()):
        app.add_css_file("katex.min.css")
        app.add_js_file("katex.min.js", loading_method="defer")
        app.add_js_file("site.js", loading_method="defer")


def ended(app, error):
    if error:
        return
    with open(os.path.join(app.outdir, "_static/texts.js"), "w", encoding="utf-8") as f:
        f.write(f"const pageTexts = {json.dumps(app.texts)};\n")
    with open(os.path.join(app.outdir, "index.html"), "w", encoding="utf-8") as f:
        f.write('<!DOCTYPE html>\n<title>materialPointFoam</title>\n'
                '<meta http-equiv="refresh" content="0; url=README.html">\n'
                '<a href="README.html">materialPointFoam</a>\n')


def setup(app):
    app.sources, app.texts = set(), {}
    app.add_html_math_renderer("katex", (equation, None), (equation, None))
    for event, function in (("source-read", below), ("doctree-read", read),
                            ("doctree-resolved", resolved), ("html-collect-pages", sources),
                            ("html-page-context", scripts), ("build-finished", ended)):
        app.connect(event, function)
