"""The fonts that a browser under test sees: those of tests/fonts, and not what the machine happens to have."""

import os
import pathlib
import subprocess

FOLDER = pathlib.Path(__file__).resolve().parents[1] / "fonts"
FAMILIES = {"dejavu": "DejaVu Sans", "liberation": "Liberation Sans"}


def chosen(fonts):
    return {**os.environ, "FONTCONFIG_FILE": str(FOLDER / f"{fonts}.conf")}


def installed(fonts):
    found = subprocess.run(["fc-match", "sans", "family"], env=chosen(fonts), capture_output=True, encoding="utf-8",
                           check=True).stdout
    return FAMILIES[fonts] in found


def environment(fonts="dejavu"):
    """The environment of a browser with these fonts. Raises FileNotFoundError if they are not installed."""
    if not installed(fonts):
        raise FileNotFoundError(f"{FAMILIES[fonts]} is not installed: scripts/install.sh test")
    return chosen(fonts)
