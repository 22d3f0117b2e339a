#!/usr/bin/env python3
"""Installs a build into a folder of its own: program, completions and manual page must lie where a shell looks.

    install_test.py BUILD-FOLDER
"""

import pathlib
import subprocess
import sys
import tempfile

WHERE = ["bin/overbend", "share/bash-completion/completions/overbend", "share/zsh/site-functions/_overbend",
         "share/man/man1/overbend.1"]


def main():
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(["cmake", "--install", sys.argv[1], "--prefix", folder], capture_output=True, text=True)
        missing = [name for name in WHERE if not pathlib.Path(folder, name).is_file()]
        if done.returncode != 0 or missing:
            sys.exit(f"{done.stderr}\nmissing: {missing}")
        said = subprocess.run([str(pathlib.Path(folder, WHERE[0])), "--version"], capture_output=True, text=True)
        if not said.stdout.startswith("overbend "):
            sys.exit("the installed program does not run")
        for name, mark in zip(WHERE[1:], ("complete -F _overbend", "#compdef overbend", ".TH OVERBEND")):
            if mark not in pathlib.Path(folder, name).read_text():
                sys.exit(f"{name} holds something else")


main()
