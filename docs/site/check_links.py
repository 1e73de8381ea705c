#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every link, picture and script of a built site leads to a file of it, and every anchor to an element.

usage: check_links.py FOLDER    each link that leads nowhere as PAGE: LINK; exit 1 where there is one
"""
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit


class Page(HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.links, self.ids = [], set()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("href", "src") and value:
                self.links.append(value)
            if name in ("id", "name") and value:
                self.ids.add(value)


def main(words):
    if len(words) != 1:
        print(__doc__.strip())
        return 2
    folder = Path(words[0]).resolve()
    pages = {path: Page(path.read_text(encoding="utf-8")) for path in folder.rglob("*.html")}
    wrong = 0
    for path, page in sorted(pages.items()):
        for link in page.links:
            parts = urlsplit(link)
            if parts.scheme in ("http", "https", "mailto", "data") or link == "#":
                continue
            target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            anchored = not parts.fragment or target not in pages or unquote(parts.fragment) in pages[target].ids
            if folder not in target.parents or not target.exists() or not anchored:
                print(f"{path.relative_to(folder)}: {link}")
                wrong += 1
    if not pages:
        print(f"{folder}: no pages")
    return 1 if wrong or not pages else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
