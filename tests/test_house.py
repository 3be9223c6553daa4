"""The house: which room may import which, who stays away from terminals and floats, and what stands where."""

import ast
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1] / "subdiv_cli"

ARROWS = {
    "model": set(),
    "checker": set(),
    "exact": {"model"},
    "spaces": {"exact", "model"},
    "jsr": {"exact", "model"},
    "maskfile": {"model"},
    "certificate": {"model"},
    "kinds": {"spaces", "maskfile", "certificate", "jsr", "exact", "model"},
    "pipeline": {"kinds", "certificate", "checker", "jsr", "exact", "model"},
    "catalog": {"pipeline", "kinds", "maskfile", "checker", "model"},
    "report": {"model"},
    "plot": {"model"},
    "explain": {"model"},
    "cli": {"catalog", "report", "plot", "explain", "pipeline", "kinds", "maskfile", "checker", "model"},
    "__main__": {"cli"},
    "__init__": set(),
}
"""Room -> the rooms it may import."""
BETWEEN_KINDS = {
    "scalar": set(),
    "matrices": set(),
    "multivariate": {"scalar"},
    "vector": {"scalar", "matrices"},
    "hermite": {"scalar", "vector"},
    "piecewise": {"scalar"},
}
"""Kind -> the kinds below it. All of them may import the hallway of kinds, the files beside their folders."""
TERMINAL = {"click", "rich"}
TO_TERMINALS = {"cli", "report", "__main__"}
FLINT = {"exact", "spaces", "jsr", "kinds"}
PICTURES = {"figure.py", "reliefs.py"}
"""Files of plot/ that may load matplotlib, and numpy with it."""
SPEECH = {"found", "said", "told", "asked"}
"""What happened to a thing is no name of it."""

FILES = sorted(ROOT.rglob("*.py"))
TREES = {file: ast.parse(file.read_text(encoding="utf-8")) for file in FILES}


def room(file):
    return file.relative_to(ROOT).parts[0].removesuffix(".py")


def kind(name):
    """The kind that a dotted name of a module belongs to, None where it is none's."""
    parts = name.split(".")
    return parts[2] if parts[:2] == ["subdiv_cli", "kinds"] and len(parts) > 2 and parts[2] in BETWEEN_KINDS else None


def imports(file):
    """(module, line) of every import wherever it stands in the file, and of every module that is named as a text."""
    for node in ast.walk(TREES[file]):
        if isinstance(node, ast.Import):
            yield from ((alias.name, node.lineno) for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{file}:{node.lineno}: relative import"
            module = node.module or ""
            yield from (
                (f"{module}.{alias.name}" if module == "subdiv_cli" else module, node.lineno) for alias in node.names
            )
        elif isinstance(node, ast.Constant) and re.fullmatch(r"subdiv_cli(\.[a-z_]+)+", str(node.value)):
            yield str(node.value), node.lineno


def unwelcome(file, module):
    """Why a file may not import a module; None where it may."""
    here, (top, _, rest) = room(file), module.partition(".")
    if top == "subdiv_cli" and rest:
        there = rest.split(".")[0]
        if there not in {here, "__version__", *ARROWS[here]}:
            return f"{here} imports {there}"
        ours = kind(".".join(("subdiv_cli", *file.relative_to(ROOT).with_suffix("").parts)))
        other = kind(module)
        if ours and other and other not in {ours, *BETWEEN_KINDS[ours]}:
            return f"kind {ours} imports kind {other}"
    if top in TERMINAL and here not in TO_TERMINALS:
        return f"{here} imports {top}"
    if top == "flint" and here not in FLINT:
        return f"{here} imports flint"
    draws = here == "plot" and file.name in PICTURES
    if (top in ("matplotlib", "mpl_toolkits") and not draws) or (top == "numpy" and here != "jsr" and not draws):
        return f"{here} imports {top}"
    return None


def test_arrows_run_one_way():
    offences = [
        f"{file.relative_to(ROOT)}:{line}: {why}"
        for file in FILES
        for module, line in imports(file)
        if (why := unwelcome(file, module)) is not None
    ]
    assert not offences, "\n".join(offences)


def test_files_and_functions_stay_short():
    long = []
    for file in FILES:
        lines = file.read_text(encoding="utf-8").count("\n")
        long += [f"{file.relative_to(ROOT)}: {lines} lines"] if lines > 500 else []
        for node in ast.walk(TREES[file]):
            if isinstance(node, ast.FunctionDef):
                start = node.body[1].lineno if ast.get_docstring(node) and len(node.body) > 1 else node.lineno
                if (node.end_lineno or 0) - start >= 55:
                    long.append(f"{file.relative_to(ROOT)}:{node.lineno}: {node.name}")
    assert not long, "\n".join(long)


def literals(file):
    """The strings of a file that are no docstrings, with their lines."""
    documentation = {node.value for node in ast.walk(TREES[file]) if isinstance(node, ast.Expr)}
    for node in ast.walk(TREES[file]):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and node not in documentation:
            yield node.value, node.lineno


def test_codes_stand_in_rules_only():
    offences = [
        f"{file.relative_to(ROOT)}:{line}: {text[:60]}"
        for file in FILES
        if file.name != "rules.py"
        for text, line in literals(file)
        if re.fullmatch(r"SD\d{3}", text)
    ]
    assert not offences, "\n".join(offences)


def test_only_a_kind_asks_whether_a_scheme_is_of_it():
    """Elsewhere `scheme.kind` says it: no isinstance on a class of schemes outside the folders of kinds."""
    schemes = {
        node.name
        for file in FILES
        if file.name in ("scheme.py", "text.py") and room(file) == "kinds"
        for node in ast.walk(TREES[file])
        if isinstance(node, ast.ClassDef) and any(getattr(each, "name", "") == "kind" for each in node.body)
    }
    assert {"ScalarScheme", "MultivariateScheme", "MatrixFamily"} <= schemes
    offences = [
        f"{file.relative_to(ROOT)}:{node.lineno}"
        for file in FILES
        for node in ast.walk(TREES[file])
        if isinstance(node, ast.Call)
        and getattr(node.func, "id", "") == "isinstance"
        and schemes & {name.id for name in ast.walk(node.args[1]) if isinstance(name, ast.Name)}
        and len(file.relative_to(ROOT / "kinds").parts if room(file) == "kinds" else ()) < 2
    ]
    assert not offences, "\n".join(offences)


def test_no_class_name_stands_twice():
    places = {}
    for file in FILES:
        for node in ast.walk(TREES[file]):
            if isinstance(node, ast.ClassDef):
                places.setdefault(node.name, []).append(f"{file.relative_to(ROOT)}:{node.lineno}")
    offences = [f"{name}: {', '.join(where)}" for name, where in sorted(places.items()) if len(where) > 1]
    assert not offences, "\n".join(offences)


def identifiers(file):
    """(name, line) of all that has a name in a file: variables, parameters, attributes, functions, imports."""
    for node in ast.walk(TREES[file]):
        for field in ("id", "arg", "attr", "name", "asname"):
            if isinstance(name := getattr(node, field, None), str):
                yield name, getattr(node, "lineno", 1)


def test_names_say_what_a_thing_is():
    offences = [
        f"{file.relative_to(ROOT)}:{line}: {name}"
        for file in FILES
        for line, name in sorted({(line, name) for name, line in identifiers(file) if name in SPEECH})
    ]
    assert not offences, "\n".join(offences)


def test_no_tolerance_in_a_proof_path():
    offences = [
        f"{file.relative_to(ROOT)}:{node.lineno}: {node.value}"
        for file in FILES
        if room(file) in {"exact", "certificate", "checker"} or {"stages", "claims"} & set(file.parts)
        for node in ast.walk(TREES[file])
        if isinstance(node, ast.Constant) and isinstance(node.value, float) and node.value not in (0.0, 1.0)
    ]
    assert not offences, "\n".join(offences)


def loaded_by(*arguments):
    """The modules in sys.modules after a run of the command line, in a process of its own."""
    code = (
        "import sys\n"
        "from subdiv_cli.cli import main\n"
        "try:\n"
        f"    main({list(arguments)!r})\n"
        "except SystemExit:\n"
        "    pass\n"
        "print(*sys.modules, sep='\\n', file=sys.stderr)\n"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return set(run.stderr.split())


def test_help_loads_neither_numpy_nor_flint_nor_rich():
    helps = [[command, "--help"] for command in ("check", "show", "plot", "sweep")]
    for arguments in (["--help"], *helps, ["--version"]):
        assert not {"numpy", "flint", "rich", "matplotlib"} & loaded_by(*arguments)


@pytest.mark.parametrize("mask", ["[1, 3, 3, 1]/4", "[-1, 0, 9, 16, 9, 0, -1]/16", "[1, 4, 4, 1]/5"])
def test_a_mask_that_needs_no_polytope_loads_no_numpy(mask):
    modules = loaded_by("check", "--mask", mask, "--format", "concise")
    assert "flint" in modules
    assert "numpy" not in modules


def test_a_mask_that_needs_a_polytope_loads_numpy():
    assert "numpy" in loaded_by("check", "--mask", "[-1, 0, 6, 10, 6, 0, -1]/10", "--format", "concise")


def documented(node, name="module", public=True):
    """(name, node, whether it is public) of a module, its classes and its functions, wherever they stand."""
    yield name, node, public
    for each in node.body:
        if isinstance(each, ast.FunctionDef | ast.ClassDef):
            seen = public and not isinstance(node, ast.FunctionDef) and not each.name.startswith("_")
            yield from documented(each, each.name if name == "module" else f"{name}.{each.name}", seen)


def raised(function):
    """The names of the exception classes that stand behind a `raise` in a function."""
    calls = (node.exc for node in ast.walk(function) if isinstance(node, ast.Raise) and isinstance(node.exc, ast.Call))
    return {call.func.id for call in calls if isinstance(call.func, ast.Name) and call.func.id[0].isupper()}


def complaints(node, public):
    """What is wrong with the docstring of a module, a class or a function."""
    text = ast.get_docstring(node) or ""
    summary, _, rest = text.partition("\n")
    if text and (summary[-1] not in ".?:" or re.match(r"\s*([a-z]{2}|[…,;])", rest)):
        yield "its first line is no whole sentence"
    classes = raised(node) if public and isinstance(node, ast.FunctionDef) else ()
    if classes and not any(word in text for word in ("Raise", *classes)):
        yield f"it does not say that it raises {' or '.join(sorted(classes))}"


def test_docstrings_begin_with_a_sentence_and_name_what_is_raised():
    offences = [
        f"{file.relative_to(ROOT)}:{getattr(node, 'lineno', 1)}: {name}: {complaint}"
        for file in FILES
        for name, node, public in documented(TREES[file])
        for complaint in complaints(node, public)
    ]
    assert not offences, "\n".join(offences)
