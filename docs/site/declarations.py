"""What C++ headers and protos declare, with the comments before it.

Both are written alike: a comment says what the declarations below it are, up to the
next empty line. Bodies of functions and what is private are left out.
"""

import re

_NAME = re.compile(r"^(?:template <.*> )?(?:(?:class|struct|enum class|enum|union|using|"
                   r"concept|service|message|rpc)\s+(?:alignas\(\d+\) )?(\w+)"
                   r"|[^(=]*?\b(operator\S+|\w+)\s*\("
                   r"|[^(]*?\b(k[A-Z]\w*))")
# What needs no comment of its own.
_PLAIN = re.compile(r"^(?:(?:class|struct) \w+;|static_assert|friend |explicit |template class"
                    r"|message \w+(?:Request|Response|Header|Chunk|Trailer) "
                    r"|.*(?:= default|= delete|override);|~?[A-Z]\w*\()|.*\boperator\W")
_BODY = re.compile(r"\)((?: const| noexcept| override)*) \{")
_NO_CODE = re.compile(r"#|namespace |\}  // namespace|syntax |package |import |option ")


def _without_preprocessor(lines):
    continued = False
    for line in lines:
        if not (continued or _NO_CODE.match(line.lstrip() if "#" in line else line)):
            yield line
        continued = line.endswith("\\") and (continued or line.lstrip().startswith("#"))


def _public(lines):
    """Without bodies of functions and private parts."""
    skipped = None  # the indentation of the line that ends what is left out
    for line in lines:
        indent = len(line) - len(line.lstrip())
        if skipped is not None:
            if line.strip() and indent <= skipped and not line.lstrip().startswith("//"):
                ends_class = line.strip() == "};"
                skipped = None
                if ends_class:
                    yield line
            continue
        if line.strip() in ("private:", "protected:"):
            skipped = indent - 1
            continue
        body = _BODY.search(line)
        if body and not line.lstrip().startswith("//"):
            yield line[:body.end(1)] + ";"
            if not line.rstrip().endswith("}"):
                skipped = indent
            continue
        yield line


def _blocks(lines):
    """Runs of lines between empty ones; what stands in braces stays together."""
    block, depth = [], 0
    for line in [*lines, ""]:
        if not line.strip() and depth == 0:
            if block:
                yield block
            block = []
            continue
        block.append(line)
        code = line.split("//")[0]
        depth += code.count("{") - code.count("}")


def _split(block):
    """The comment at the head of a block, and the rest."""
    end = next((i for i, line in enumerate(block)
                if not line.lstrip().startswith("//")), len(block))
    return [line.strip()[3:] for line in block[:end]], block[end:]


def _statements(code):
    """The first line of each declaration."""
    depth, begins = 0, True
    for line in code:
        text = line.split("//")[0].strip()
        if re.fullmatch("template <.*>", text):
            continue
        if begins and depth == 0 and text and text != "};":
            yield text
        depth += sum(text.count(c) for c in "{(") - sum(text.count(c) for c in "})")
        begins = not text or text[-1] in ";{}:"


def _names(code):
    found = (_NAME.match(statement) for statement in _statements(code))
    return list(dict.fromkeys(name for match in found if match
                              for name in match.groups() if name))


def _undocumented(comment, code):
    """The names that no comment tells of."""
    if not comment and not all(map(_PLAIN.match, _statements(code))):
        yield from _names(code)
    if code and re.match(r"class \w+.*\{|service ", code[0]):
        for block in _blocks(line[2:] for line in code[1:-1]):
            if block[0].strip() == "public:":
                block = block[1:]
            if not any("//" in line for line in block):
                for statement in _statements(block):
                    if "(" in statement and not _PLAIN.match(statement):
                        yield from filter(None, _NAME.match(statement).groups())


def read(text):
    """The comment at the head of a file; then (names, comment, code) of each block;
    and the names that have no comment."""
    lines = text.splitlines()
    if lines[0].startswith("//"):
        intro, lines = _split(lines)
    else:
        intro = []
    found, undocumented = [], []
    for block in _blocks(_public(_without_preprocessor(lines))):
        comment, code = _split(block)
        names = _names(code)
        if names and not all(re.match(r"(?:class|struct) \w+;", s) for s in _statements(code)):
            found.append((names, comment, code))
            undocumented += _undocumented(comment, code)
        elif not code and not found:
            intro += [""] + comment if intro else comment
    return intro, found, undocumented
