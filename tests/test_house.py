"""The house: which room may import which, who stays away from terminals and floats, and how long files grow."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1] / "subdiv_cli"

ARROWS = {
    "model": set(),
    "exact": {"model"},
    "schemes": {"exact", "model"},
    "maskfile": {"schemes", "model"},
    "jsr": {"exact", "model"},
    "quantities": {"jsr", "schemes", "exact", "model"},
    "stages": {"quantities", "jsr", "schemes", "exact", "model"},
    "certificate": {"model"},
    "checker": set(),
    "pipeline": {"surfaces", "stages", "jsr", "certificate", "checker", "schemes", "model"},
    "surfaces": {"pipeline", "maskfile", "stages", "certificate", "schemes", "model"},
    "portrait": {"pipeline", "stages", "schemes", "model"},
    "relief": {"pipeline", "surfaces", "stages", "schemes", "model"},
    "catalog": {"pipeline", "maskfile", "checker", "model"},
    "report": {"model"},
    "plot": {"model"},
    "explain": {"model"},
    "cli": {
        "catalog",
        "maskfile",
        "report",
        "plot",
        "explain",
        "model",
        "pipeline",
        "portrait",
        "relief",
        "checker",
        "schemes",
    },
    "__main__": {"cli"},
    "__init__": set(),
}
NO_TERMINAL = {
    "certificate",
    "checker",
    "model",
    "exact",
    "schemes",
    "quantities",
    "jsr",
    "stages",
    "pipeline",
    "portrait",
    "surfaces",
    "relief",
    "maskfile",
    "catalog",
    "explain",
    "plot",
}
NO_FLINT = {
    "certificate",
    "checker",
    "model",
    "maskfile",
    "report",
    "plot",
    "explain",
    "cli",
    "catalog",
    "pipeline",
    "portrait",
    "surfaces",
    "relief",
}

FILES = sorted(ROOT.rglob("*.py"))


def room(file):
    return file.relative_to(ROOT).parts[0].removesuffix(".py")


def imports(file):
    """(module, line) of every import, wherever it stands in the file."""
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from ((alias.name, node.lineno) for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{file}:{node.lineno}: relative import"
            module = node.module or ""
            if module == "subdiv_cli":
                yield from ((f"subdiv_cli.{alias.name}", node.lineno) for alias in node.names)
            else:
                yield module, node.lineno


@pytest.mark.parametrize("file", FILES, ids=lambda f: str(f.relative_to(ROOT)))
def test_arrows_run_one_way(file):
    here = room(file)
    for module, line in imports(file):
        top, _, rest = module.partition(".")
        if top == "subdiv_cli" and rest:
            there = rest.split(".")[0]
            assert there in {here, "__version__", *ARROWS[here]}, f"{file}:{line}: {here} imports {there}"
        if top in {"click", "rich"}:
            assert here not in NO_TERMINAL, f"{file}:{line}: {here} imports {top}"
        if top == "flint":
            assert here not in NO_FLINT, f"{file}:{line}: {here} imports flint"
        draws = file.name in ("figure.py", "reliefs.py")
        assert top not in ("matplotlib", "mpl_toolkits") or draws, f"{file}:{line}: {top} is for plot/figure.py"
        assert top != "numpy" or here == "jsr" or draws, f"{file}:{line}: {here} imports numpy"


@pytest.mark.parametrize("file", FILES, ids=lambda f: str(f.relative_to(ROOT)))
def test_files_and_functions_stay_short(file):
    text = file.read_text(encoding="utf-8")
    assert text.count("\n") <= 500
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.FunctionDef):
            assert (node.end_lineno or 0) - node.lineno < 55, f"{file}:{node.lineno}: {node.name} is too long"


@pytest.mark.parametrize(
    "file",
    [f for f in FILES if room(f) in {"stages", "exact", "schemes", "certificate", "checker"}],
    ids=lambda f: f.name,
)
def test_no_tolerance_in_a_proof_path(file):
    constants = [
        node.value for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))) if isinstance(node, ast.Constant)
    ]
    assert not [c for c in constants if isinstance(c, float) and c not in (0.0, 1.0)]


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
    for arguments in (["--help"], ["check", "--help"], ["show", "--help"], ["plot", "--help"], ["--version"]):
        assert not {"numpy", "flint", "rich", "matplotlib"} & loaded_by(*arguments)


@pytest.mark.parametrize("mask", ["[1, 3, 3, 1]/4", "[-1, 0, 9, 16, 9, 0, -1]/16", "[1, 4, 4, 1]/5"])
def test_a_mask_that_needs_no_polytope_loads_no_numpy(mask):
    modules = loaded_by("check", "--mask", mask, "--format", "concise")
    assert "flint" in modules
    assert "numpy" not in modules


def test_a_mask_that_needs_a_polytope_loads_numpy():
    assert "numpy" in loaded_by("check", "--mask", "[-1, 0, 6, 10, 6, 0, -1]/10", "--format", "concise")
