#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Sentences that a reader may have to read twice (docs/development.md, "The English of the pages").

usage: sentences.py PAGE...    each finding as PAGE:LINE: what: the sentence; exit 1 where there is one
       sentences.py --self     planted sentences are found, good ones are not

The sentences that were mended, page by page, are in mended.tsv: what was mended stays so.

A comment <!-- plain: REASON --> on the line before a paragraph leaves that paragraph out: this is a help, no cage.
"""
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
LONGEST = 35  # words
FEWEST = 8  # words of a sentence that was mended: fewer may be right elsewhere
# Everybody who reads these pages knows them.
COMMON = set("""AMD ASCII AVX AVX2 BSD CPU CSV DNS EPYC GB GNU GPU HTML HTTP HTTPS ID II III IV JSON KB LF MB MIT OK OS
PDF PNG README RAM SHA SI SVG TODO URL UTF VM XML YAML YYYY ZIP MPa GPa kPa GiB MiB KiB CRLF BOM PyYAML CITATION
CONTRIBUTING CHANGELOG LICENSE IEEE ISO DOI ORCID JOSS PR FAQ OpenMP MPI FIFO NaN NaNs CMake VTK DOCTYPE LS DYNA""".split())
# pattern: what to write instead. At the beginning of a sentence, or anywhere.
OPENINGS = {
    r"Of (?!course\b)": "a sentence that opens with 'Of': write 'For X, ...' or put the subject first",
    r"What is not ": "an inverted opening: put the subject first",
}
PHRASES = {
    r"\b(?:dies|died|kills|killed by the)\b(?! of signal)": "a run becomes unstable or diverges, a test detects",
    r"\bhas its way\b": "wins, takes precedence",
    r"\bby its own word\b": "rejects",
    r"\bout of nothing\b": "say what is wrong with the numbers",
    r"\btake[sn]? .{0,20}\balong\b": "say what is computed besides",
    r"\bof such an? (?:one\b|\w+ )": "for such a ...",
    r"\bthat of one that\b": "repeat the noun",
    r"\b(?:thereof|wherein|hereby|therein)\b": "the plain word",
}
ENDS = re.compile(r"(?<=[.!?])[\"')\]*]*\s+(?=[\"'(\[*`$]*[A-Z0-9`$\u0370-\u03ff])")
SHORT = re.compile(r"\b(e\.g|i\.e|cf|vs|etc|resp|approx|Fig|Eq|Eqs|No|Sect|Dr|St|al)\.$")


def paragraphs(text):
    """(line, text) of each paragraph, list item, heading-less; tables by cells; code, comments and pictures left out."""
    fence = skip = False
    begin, words = 0, []
    for number, line in enumerate(text.splitlines() + [""], 1):
        bare = line.strip()
        ends = not bare or bare.startswith(("```", "#", "|", "<", "$$")) or re.match(r"([-*+]|\d+\.)\s", bare)
        if ends and words:
            if not skip:
                yield begin, " ".join(words)
            words, skip = [], False
        if bare.startswith("```"):
            fence = not fence
        elif fence or bare.startswith("#"):
            continue
        elif bare.startswith("<!-- plain:"):
            skip = True
        elif bare.startswith("<"):
            continue
        elif bare.startswith("|"):
            for cell in bare.strip("|").split("|"):
                if not skip and not re.fullmatch(r"[\s:-]*", cell):
                    yield number, cell.strip()
        elif bare:
            if not words:
                begin = number
            words.append(re.sub(r"^([-*+]|\d+\.)\s+", "", bare))


def plain(text):
    """Links are their text; code, equations and pictures are one word."""
    text = re.sub(r"!\[[^\]]*\]\([^)]*\)", "", text)
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text)
    text = re.sub(r"`[^`]*`", "`x`", text)
    text = re.sub(r"\$\$[^$]*\$\$|\$[^$]*\$", "$x$", text)
    return re.sub(r"[*_]{1,2}(?=\S)|(?<=\S)[*_]{1,2}", "", text)


def sentences(text):
    parts = []
    for part in ENDS.split(text):
        if parts and SHORT.search(parts[-1]):
            parts[-1] += " " + part
        else:
            parts.append(part)
    return parts


def glossary():
    """The terms of docs/glossary.md: of the first section by name, and every abbreviation that is explained."""
    own, terms, section = [], set(), ""
    for line in (ROOT / "docs/glossary.md").read_text(encoding="utf-8").splitlines():
        if line.startswith("## "):
            section = line[3:]
        elif line.startswith("### "):
            names = [name.strip() for name in line[4:].split(",")]
            terms.update(names)
            if section.startswith("Words of"):
                own += names
    return own, terms


def mended():
    """{page: [(before, after)]} of mended.tsv; rows that were shortened by '...' are left out."""
    rows = {}
    for line in (Path(__file__).parent / "mended.tsv").read_text(encoding="utf-8").splitlines()[1:]:
        page, before, after = line.split("\t")
        if "..." not in before and len(before.split()) >= FEWEST:
            rows.setdefault(page, []).append((before, after))
    return rows


def findings(name, text, own, terms):
    flat = re.sub(r"\s+", " ", text)
    for before, after in mended().get(Path(name).stem, []):
        if before in flat:
            yield 1, f"was mended to '{after[:60]}'", before[:80]
    abbreviation = re.compile(r"\b(?:[a-z]{0,2}[A-Z]{2,}[A-Za-z]*\d*)\b")
    seen, unknown = "", set()
    for line, raw in paragraphs(text):
        body = plain(raw)
        seen += " " + body
        for sentence in sentences(body):
            count = len(re.findall(r"[\w$`][\w$`'’.,/^-]*", sentence))
            if count > LONGEST:
                yield line, f"{count} words", sentence
            for pattern, instead in OPENINGS.items():
                if re.match(r"[\"'(*]*" + pattern, sentence):
                    yield line, instead, sentence
            for pattern, instead in PHRASES.items():
                if re.search(pattern, sentence):
                    yield line, instead, sentence
        for word in abbreviation.findall(body):
            stem = word[:-1] if word.endswith("s") and word[:-1] in terms | COMMON else word
            if stem not in terms | COMMON and word not in unknown:
                unknown.add(word)
                yield line, f"'{word}' is in no glossary", body[:80]
    if name.endswith("glossary.md"):
        return
    for term in own:
        anchor = "glossary.md#" + term.lower().replace(" ", "-")
        used = re.search(r"\b" + re.escape(term) + r"s?\b", seen, re.IGNORECASE)
        plain_english = term in ("Cause", "Description", "Effect", "Regime", "Response", "Scene", "Screen", "Study", "Finding")
        if used and not plain_english and anchor not in text:
            yield 1, f"'{term.lower()}' is used and not linked", f"[{term.lower()}]({anchor})"


BAD = [
    ("Of what breaks, the rest stays.\n", "opens with 'Of'"),
    ("word " * 36 + ".\n", "36 words"),
    ("A run dies early.\n", "unstable"),
    ("A XYZZY method.\n", "no glossary"),
    ("| a | Of a cell |\n", "opens with 'Of'"),
    ("- An item.\n- Of an item, too.\n", "opens with 'Of'"),
    ("An axis has its way.\n", "wins"),
    ("Good. What is not given is zero.\n", "inverted"),
    ("A sheet is used.\n", "not linked"),
]
GOOD = [
    "For what breaks, the rest stays. Word " + "word " * 30 + ".\n",
    "```sh\nOf code XYZZY\n```\n# Of a heading\n",
    "The `XYZZY` key. A process died of signal 11. Of course.\n",
    "<!-- plain: a quotation -->\nOf all that is, " + "word " * 40 + "\n",
    "A [sheet](glossary.md#sheet) of FLIP runs by CPDI, e.g. Two words.\n",
]


def self_test():
    own, terms = glossary()
    wrong = [text for text, what in BAD if not any(what in f[1] for f in findings("p.md", text, own, terms))]
    wrong += [text for text in GOOD if list(findings("p.md", text, own, terms))]
    for text in wrong:
        print("sentences.py: misjudged:", text.strip()[:100])
    return 1 if wrong else 0


def main(words):
    if words == ["--self"]:
        return self_test()
    if not words:
        print(__doc__.strip())
        return 2
    own, terms = glossary()
    count = 0
    for name in words:
        for line, what, sentence in findings(name, Path(name).read_text(encoding="utf-8"), own, terms):
            print(f"{name}:{line}: {what}: {sentence}")
            count += 1
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
