"""The command `subdiv clean`, which empties the cache."""

from __future__ import annotations

import sys

import click

from subdiv_cli.cli.exits import ExitCode
from subdiv_cli.cli.settings import SettingsError, find
from subdiv_cli.cli.streams import complain, emit

_EPILOG = """\b
The directory is that of `check`: --cache-dir, SUBDIV_CACHE_DIR, cache-dir in
[tool.subdiv] of the nearest pyproject.toml, or else the user's. Only results that
subdiv has kept are removed, whatever else is there.

\b
Exit codes:
  0    done, also where there was nothing
  2    something cannot be removed
"""


@click.command("clean", epilog=_EPILOG)
@click.option(
    "--cache-dir", metavar="DIR", type=click.Path(file_okay=False), envvar="SUBDIV_CACHE_DIR", show_envvar=True,
    help="The cache to empty.",
)  # fmt: skip
def command(cache_dir: str | None) -> ExitCode:
    """Remove the results kept of earlier runs."""
    from subdiv_cli.catalog.cache import Cache, directory

    try:
        where = directory(cache_dir or _settled())
        count, size = (0, 0) if where is None else Cache(where).clean()
    except SettingsError as error:
        return complain([error.problem])
    except OSError as error:
        raise click.ClickException(f"the cache cannot be emptied: {error}") from None
    emit(f"removed {count} result{'' if count == 1 else 's'}, {size / 1e6:.1f} MB, from {where}\n", sys.stdout)
    return ExitCode.PASSED


def _settled() -> str | None:
    """The cache-dir of the nearest pyproject.toml, None without one."""
    settings = find(())
    path = None if settings is None else settings[2].get("cache-dir")
    return None if settings is None or not isinstance(path, str) else str(settings[0].parent / path)
