"""Completions of the shell: finding codes, parameters of the named files, properties. Files the shell knows itself."""

from __future__ import annotations

import os
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING

import click

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem


def complete_page(ctx: click.Context, param: click.Parameter, incomplete: str) -> list[CompletionItem]:
    """The completions with the names of pages: subjects, then codes."""
    from click.shell_completion import CompletionItem

    from subdiv_cli.explain import subjects

    known = [CompletionItem(name) for name in subjects() if name.startswith(incomplete.lower())]
    return known + complete_code(ctx, param, incomplete)


def complete_code(ctx: click.Context, param: click.Parameter, incomplete: str) -> list[CompletionItem]:
    """The completions with finding codes, with their names."""
    from click.shell_completion import CompletionItem

    from subdiv_cli.explain import codes, title

    wanted = incomplete.upper()
    return [CompletionItem(code, help=title(code)) for code in codes() if code.startswith(wanted)]


def complete_property(ctx: click.Context, param: click.Parameter, incomplete: str) -> list[CompletionItem]:
    """The completions `C0`, `C1`, … and the properties of [expect]."""
    from click.shell_completion import CompletionItem

    from subdiv_cli.maskfile.properties import KEYS, TRUTHS

    known = [*(f"C{n}" for n in range(4)), *(key if key in TRUTHS else f"{key}>=" for key in KEYS)]
    return [CompletionItem(name) for name in known if name.startswith(incomplete)]


def complete_parameter(ctx: click.Context, param: click.Parameter, incomplete: str) -> list[CompletionItem]:
    """The completions `w=` for each parameter of the mask files named so far, with its default."""
    from click.shell_completion import CompletionItem

    from subdiv_cli.kinds.reading import read_path
    from subdiv_cli.maskfile import MaskFileError

    defaults: dict[str, str] = {}
    for word in _words():
        with suppress(MaskFileError, OSError, ValueError):
            if Path(word).is_file():
                for name, default in read_path(word).parameters.items():
                    defaults.setdefault(name, "" if default is None else default.text)
    return [CompletionItem(f"{n}=", help=default) for n, default in defaults.items() if f"{n}=".startswith(incomplete)]


def _words() -> list[str]:
    """The words of the line that is completed: an option without its value keeps click from parsing it."""
    from click.shell_completion import split_arg_string

    return split_arg_string(os.environ.get("COMP_WORDS", ""))
