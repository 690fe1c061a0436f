#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Holds comments to plain words: openings, case codes, sentence length, and blocks that the formatter tore.

comment_words.py FOLDER|FILE...   prints each finding as PATH:LINE: RULE: TEXT; exit code 1 when there is one
"""
import pathlib
import re
import sys

SUFFIXES = {".h", ".cpp", ".c", ".glsl", ".vert", ".frag", ".comp", ".inc"}
LONGEST_SENTENCE = 25  # words
OPENING = re.compile(r"^(What|Whether|Of which|The same for|Those)\b")
CODE = re.compile(r"\b[GTNCUP][0-9]{2}\b")
ONLY_COMMENT = re.compile(r"^\s*//(/<|/|!)?\s?(.*)$")
TRAILING = re.compile(r"^(?=.*\S\s*///?<?\s).*?[;,{})\]\w]\s*//(/<|/)?\s(.*)$")
# Lines of a table or a field list: `eq`, `in`, `out`, ... open a line of their own and are no sentences.
FIELD = re.compile(r"^(eq|in|out|in/out|in,out|owns|err|warning|info|cost|time|see)\b\s")


def blocks(lines):
    """Yields (line number, [texts]) for each comment: lines of comment alone that follow each other, or one behind code."""
    block, start = [], 0
    for number, line in enumerate(lines, 1):
        alone = ONLY_COMMENT.match(line)
        if alone:
            if not block:
                start = number
            block.append(alone.group(2).rstrip())
            continue
        if block:
            yield start, block
            block = []
        if "//" in line and '"' not in line.split("//")[0]:
            behind = TRAILING.match(line)
            if behind:
                block, start = [behind.group(2).rstrip()], number
    if block:
        yield start, block


def sentences(texts):
    """Splits a block into (offset of its first line, sentence)."""
    found, words, first = [], [], 0

    def close():
        nonlocal words
        if words:
            found.append((first, " ".join(words)))
        words = []

    for offset, text in enumerate(texts):
        if not text.strip() or FIELD.match(text.strip()) or text.startswith("    ") or text.lstrip().startswith(("|", "-", "*")):
            close()
        for word in text.split():
            if not words:
                first = offset
            words.append(word)
            if re.search(r"[.?!][)\"'`]*$", word) and not re.search(r"\b(e\.g|i\.e|vs|cf|ch|no|etc)\.$", word, re.I):
                close()
    close()
    return found


def findings(path, text):
    lines = text.splitlines()
    for start, texts in blocks(lines):
        while texts and "SPDX" in texts[0]:  # the block may go on with the file's purpose
            start, texts = start + 1, texts[1:]
        if not texts or "clang-format off" in texts[0]:
            continue
        for offset, sentence in sentences(texts):
            if FIELD.match(sentence):
                continue
            if OPENING.match(sentence) and not sentence.endswith("?"):
                yield start + offset, "opening", sentence
            for code in CODE.finditer(sentence):
                before = sentence[: code.start()]
                if "(" not in before or len(before.split("(")[0].split()) < 3:
                    yield start + offset, "code without its words", sentence
                    break
            if len(re.findall(r"[A-Za-z]{2,}[\w']*", sentence)) > LONGEST_SENTENCE:
                yield start + offset, "longer than 25 words", sentence
        for offset, (line, following) in enumerate(zip(texts, texts[1:])):
            if not line or not following or FIELD.match(following.strip()) or line.endswith((".", ":", ";", "|")):
                continue
            word = following.split()[0]
            indent = len(lines[start - 1 + offset]) - len(line)
            if following[0].islower() and 0 < len(line) < 25 and indent + len(line) + 1 + len(word) < 75 and not line.startswith(" "):
                yield start + offset, "torn", line + " / " + following


def main():
    count = 0
    for name in sys.argv[1:]:
        root = pathlib.Path(name)
        files = [root] if root.is_file() else sorted(p for p in root.rglob("*") if p.suffix in SUFFIXES)
        for file in files:
            for line, rule, text in findings(file, file.read_text(encoding="utf-8", errors="replace")):
                print(f"{file}:{line}: {rule}: {text[:200]}")
                count += 1
    if count:
        print(f"{count} findings", file=sys.stderr)
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main())
