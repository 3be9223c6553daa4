"""A built wheel carries everything: installed elsewhere, it finds its own masks and checks them."""

import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[1]


def python(*arguments, cwd, path=None):
    """A run of this interpreter whose imports look into `path` first."""
    environment = {**os.environ, "PYTHONPATH": str(path)} if path else None
    run = subprocess.run(
        [sys.executable, *arguments], cwd=cwd, env=environment, capture_output=True, text=True, check=False
    )
    assert run.returncode == 0, run.stdout + run.stderr
    return run.stdout


def test_a_wheel_installed_elsewhere_checks_its_own_masks(tmp_path):
    python("-m", "build", "--wheel", "--outdir", str(tmp_path), str(ROOT), cwd=tmp_path)
    (wheel,) = tmp_path.glob("subdiv_cli-*.whl")
    home = tmp_path / "elsewhere"
    python("-m", "pip", "install", "--quiet", "--no-deps", "--target", str(home), str(wheel), cwd=tmp_path)

    where = "from subdiv_cli.catalog import masks_directory; print(masks_directory())"
    masks = Path(python("-c", where, cwd=tmp_path, path=home).strip())
    assert masks == home / "subdiv_cli" / "masks"
    shipped = {path.relative_to(masks) for path in masks.rglob("*.toml")}
    assert shipped == {path.relative_to(ROOT / "masks") for path in (ROOT / "masks").rglob("*.toml")}

    report = python("-m", "subdiv_cli", "check", str(masks / "scalar" / "four_point.toml"), cwd=tmp_path, path=home)
    assert "C^1, not C^2" in report
    page = python("-m", "subdiv_cli", "explain", "SD201", cwd=tmp_path, path=home)
    assert "SD201" in page
