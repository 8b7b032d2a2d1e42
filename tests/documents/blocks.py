"""The pieces of a document of Markdown that somebody may copy and run."""

import dataclasses
import re


@dataclasses.dataclass(frozen=True)
class Block:
    """Attributes:
        kind: "shell", "console" (commands behind "$ " and what they print),
            "pycon" (the same behind ">>> "), or what the fence names: "python",
            "cpp", "cmake".
        line: the number of its first line.
        text: without fence and indentation.
        file: for "cpp" and "cmake", the file that the text before it names last.
    """

    kind: str
    line: int
    text: str
    file: str = ""


_FILE = re.compile(r"`([a-z_]+\.cc|CMakeLists\.txt)`")


def _kind(text, fence):
    if fence:
        return fence
    if text.startswith("$ "):
        return "console"
    return "pycon" if text.startswith(">>> ") else "shell"


def extract(document):
    """All blocks, in order: fenced ones, those indented by four blanks, and the
    commands of the program `geodesic` in the cells of tables.

    Errors: ValueError for a fence that does not end.
    """
    lines = document.splitlines()
    blocks = []
    file = ""
    at = 0
    while at < len(lines):
        line = lines[at]
        first = at + 1
        found = []
        if line.startswith("```"):
            at += 1
            while not lines[at:at + 1] == ["```"]:
                if at >= len(lines):
                    raise ValueError(f"line {first}: the fence does not end")
                found.append(lines[at])
                at += 1
            first += 1
        elif line.startswith("    ") and not lines[at - 1].strip():
            while at < len(lines) and (lines[at].startswith("    ") or
                                       not lines[at].strip()):
                found.append(lines[at][4:])
                at += 1
            at -= 1
        elif line.startswith("|"):
            for command in re.findall(r"`(geodesic [^`]*)`", line):
                blocks.append(Block("shell", first, command))
        else:
            file = (_FILE.findall(line) or [file])[-1]
        if found:
            text = "\n".join(found).rstrip()
            kind = _kind(text, line[3:] if line.startswith("```") else "")
            blocks.append(Block(kind, first, text,
                                file if kind in ("cpp", "cmake") else ""))
        at += 1
    return blocks


def commands(text):
    """(the number of lines before it, the command) of each in a block for the
    shell; lines that end with a backslash are one with the next."""
    number = 0
    for command in re.findall(r"(?:[^\n]*\\\n)*[^\n]*\n?", text):
        if command.strip():
            yield number, command.rstrip("\n")
        number += command.count("\n")
