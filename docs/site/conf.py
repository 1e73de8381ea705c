# SPDX-License-Identifier: BSD-3-Clause
"""The site: the pages of docs/ as HTML that works from file:// without a network. `./dev docs` builds it."""
import re
import shutil
from pathlib import Path

DOCS = Path(__file__).resolve().parent.parent
ROOT = DOCS.parent
MATHJAX = Path("/usr/share/javascript/mathjax")  # libjs-mathjax; what one configuration of it needs is copied
MATHJAX_PARTS = ["MathJax.js", "config/TeX-AMS_CHTML-full.js", "jax/output/CommonHTML", "jax/element/mml", "jax/input/TeX",
                 "fonts/HTML-CSS/TeX/woff", "extensions"]

project = "assay"
author = copyright = "the authors of assay"  # noqa: A001
release = re.search(r"^## \[?([0-9.]+)", (ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), re.MULTILINE)[1]
extensions = ["myst_parser", "sphinx.ext.mathjax"]
root_doc = "index"
exclude_patterns = ["site"]
source_suffix = {".md": "markdown"}
html_theme = "furo"
html_title = f"assay {release}"
html_copy_source = False
html_show_sphinx = False
html_static_path = []
html_theme_options = {"source_edit_link": "", "top_of_page_button": None}
myst_enable_extensions = ["dollarmath", "smartquotes"]
myst_heading_anchors = 4
mathjax_path = "mathjax/MathJax.js?config=TeX-AMS_CHTML-full"
mathjax_options = {"async": "async"}
myst_update_mathjax = False  # it writes the settings of MathJax 3
mathjax2_config = {"showMathMenu": False, "tex2jax": {"ignoreClass": "tex2jax_ignore", "processClass": "math",
                                                      "inlineMath": [["\\(", "\\)"]]}}
suppress_warnings = ["myst.header", "misc.highlighting_failure"]
highlight_language = "none"

LINK = re.compile(r"(?<!!)\[([^\]]*)\]\((\.\./[^)#\s]+)[^)\s]*\)")


def tables_of_contents(text):
    """The lists of links of index.md, once more as the menu on the left."""
    menu = ""
    for heading, part in re.findall(r"^## (.+?)\n(.*?)(?=^## |\Z)", text, re.MULTILINE | re.DOTALL):
        pages = [f"{title} <{page}>" for title, page in re.findall(r"^- \[([^\]]*)\]\(([\w/.-]+)\.md\)", part, re.MULTILINE)]
        menu += f"\n```{{toctree}}\n:hidden:\n:caption: {heading}\n" + "\n".join(pages) + "\n```\n"
    return text + menu


def read(app, name, source):
    text = source[0]
    up = "../" * name.count("/")

    def file_of_the_tree(link):  # beyond docs/: a copy beside the pages
        path = (DOCS / name).parent.joinpath(link[2]).resolve()
        if DOCS in path.parents:
            return link[0]
        app.tree.add(path)
        return f'<a href="{up}tree/{path.relative_to(ROOT)}">{link[1]}</a>'

    text = LINK.sub(file_of_the_tree, text)
    text = re.sub(r"^```csv", "```text", text, flags=re.MULTILINE)
    text = re.sub(r"^```(\w+)[^\n`]*$", r"```\1", text, flags=re.MULTILINE)  # title=FILE and skip are for the tests
    source[0] = tables_of_contents(text) if name == root_doc else text


def write(app, error):
    if error:
        return
    out = Path(app.outdir)
    for path in sorted(app.tree):
        to = out / "tree" / path.relative_to(ROOT)
        to.parent.mkdir(parents=True, exist_ok=True)
        shutil.copytree(path, to, dirs_exist_ok=True) if path.is_dir() else shutil.copyfile(path, to)
    for part in MATHJAX_PARTS:
        to = out / "_static/mathjax" / part
        to.parent.mkdir(parents=True, exist_ok=True)
        source = MATHJAX / part
        shutil.copytree(source, to, dirs_exist_ok=True) if source.is_dir() else shutil.copyfile(source, to)


def setup(app):
    app.tree = set()
    app.connect("source-read", read)
    app.connect("build-finished", write)
