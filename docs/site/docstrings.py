"""What the Python package offers, with its docstrings, without importing it."""

import ast
import itertools
import pathlib

# Beside what `geodesic` itself names.
_MODULES = {"service": ("Service", "connect"), "asynchronous": ("AsyncMesh",),
            "batches": ("matrix", "open_matrix", "BlockMatrix")}


def _signature(node, name):
    if any(getattr(d, "id", "") in ("property", "cached_property")
           or getattr(d, "attr", "") == "cached_property" for d in node.decorator_list):
        return f"{name}: {ast.unparse(node.returns)}" if node.returns else name
    result = f" -> {ast.unparse(node.returns)}" if node.returns else ""
    return f"{name}({ast.unparse(node.args)}){result}"


def _of(node, module, classes):
    """(name, signature, docstring) of a function, or of a class and its methods,
    those of what it is derived from included."""
    name = f"{module}.{node.name}"
    if isinstance(node, ast.FunctionDef):
        yield name, _signature(node, name), ast.get_docstring(node)
        return
    yield name, f"class {name}", ast.get_docstring(node)
    bases = [classes[base.id].body for base in node.bases
             if getattr(base, "id", "") in classes]
    for member in itertools.chain(*bases, node.body):
        if not isinstance(member, ast.FunctionDef):
            continue
        if member.name == "__init__":
            if ast.get_docstring(member):
                yield name, _signature(member, name), ast.get_docstring(member)
        elif not member.name.startswith("_") and not any(
                getattr(d, "attr", "") == "setter" for d in member.decorator_list):
            of = f"{node.name}.{member.name}"
            yield of, _signature(member, of), ast.get_docstring(member)


def read(package):
    """(module, [(name, signature, docstring)]) for each module."""
    trees = {path.stem: ast.parse(path.read_text(encoding="utf-8"))
             for path in pathlib.Path(package).glob("*.py")}
    defined = {(module, node.name): node for module, tree in trees.items()
               for node in tree.body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
    classes = {name: node for (_, name), node in defined.items()
               if isinstance(node, ast.ClassDef)}
    names, origins = [], {}
    for node in trees["__init__"].body:
        if isinstance(node, ast.ImportFrom) and node.module:
            origins.update({a.name: node.module for a in node.names})
        elif isinstance(node, ast.Assign) and node.targets[0].id == "__all__":
            names = ast.literal_eval(node.value)
    yield "geodesic", [entry for name in names for entry in
                       _of(
                           defined[origins.get(name, "__init__"), name], "geodesic",
                           classes)]
    for module, members in _MODULES.items():
        yield f"geodesic.{module}", [
            entry for name in members
            for entry in _of(defined[module, name], f"geodesic.{module}",
                             classes)]
