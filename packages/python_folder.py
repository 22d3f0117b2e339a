#!/usr/bin/env python3
"""Prints the folder below an installation prefix in which this interpreter looks for packages.

    python_folder.py PREFIX

Debian's Python has folders of its own for /usr and /usr/local; below any other prefix, a home folder's ~/.local or a
virtual environment, packages lie in lib/pythonX.Y/site-packages.
"""

import os
import sys
import sysconfig


def folder_below(prefix: str) -> str:
    """The folder for packages, relative to `prefix`."""
    schemes = {"/usr": "deb_system", "/usr/local": "posix_local"}
    scheme = schemes.get(prefix)
    if scheme in sysconfig.get_scheme_names():
        base = "/usr"  # to which posix_local adds /local
    else:
        scheme, base = "posix_prefix", prefix
    return os.path.relpath(sysconfig.get_path("platlib", scheme, {"base": base, "platbase": base}), prefix)


if __name__ == "__main__":
    print(folder_below(os.path.normpath(sys.argv[1])))
