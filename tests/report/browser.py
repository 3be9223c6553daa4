"""A headless Chromium, as Debian has it, for pages that must be seen to be believed."""

import os
import shutil
import subprocess

import pytest

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
FLAGS = [
    "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-dev-shm-usage",
    "--disable-background-networking", "--disable-component-update", "--disable-sync", "--hide-scrollbars",
]  # fmt: skip
needs_chromium = pytest.mark.skipif(CHROMIUM is None, reason="no Chromium: apt-get install chromium")


def chromium(directory, page, *options):
    """Open a page in a new profile; what is written to stdout."""
    profile = directory / f"profile-{os.urandom(4).hex()}"
    command = [CHROMIUM, *FLAGS, f"--user-data-dir={profile}", *options, page.as_uri()]
    return subprocess.run(command, capture_output=True, check=True, timeout=120).stdout.decode("utf-8")


def dom(directory, page, dark=False):
    """The document after its scripts have run."""
    return chromium(directory, page, *_theme(dark), "--virtual-time-budget=3000", "--dump-dom")


def screenshot(directory, page, file, width, height, dark=False):
    """A PNG of the page."""
    chromium(directory, page, *_theme(dark), f"--window-size={width},{height}", f"--screenshot={file}")


PHONE = """<!doctype html><body style="margin: 0">
<iframe src="{page}" style="border: 0; width: 400px; height: 1600px"></iframe>
<script>onmessage = (told) => {{ document.title = told.data; }}</script>
"""
"""A phone of 400 by 1600 pixels: no window of Chromium is narrower than 500. Its title is what the page posts to it."""


def phone(page):
    """A page that shows the other as a phone does."""
    host = page.with_name("phone.html")
    host.write_text(PHONE.format(page=page.name), encoding="utf-8")
    return host


def _theme(dark):
    return [f"--blink-settings=preferredColorScheme={0 if dark else 1}"]
