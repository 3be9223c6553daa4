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


def dom(directory, page):
    """The document after its scripts have run."""
    return chromium(directory, page, "--virtual-time-budget=3000", "--dump-dom")


def screenshot(directory, page, file, width, height, dark=False):
    """A PNG of the page."""
    theme = ["--blink-settings=preferredColorScheme=0"] if dark else ["--blink-settings=preferredColorScheme=1"]
    chromium(directory, page, *theme, f"--window-size={width},{height}", f"--screenshot={file}")
