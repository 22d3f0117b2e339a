"""The examples that come with the program."""

from __future__ import annotations

import difflib
import pathlib


def example(name: str) -> pathlib.Path:
    """Path of an example: a model ('bgl1.yaml') or a study ('studies/bgl1-tension.yaml').

    Examples are searched for in the installation of the package, in the clone in which it was built, and in the folder
    `examples` of the current folder and its parents.

    Raises:
        FileNotFoundError: If there is no example of that name (the message lists them), or no examples are found.
    """
    package = pathlib.Path(__file__).resolve().parent
    current = pathlib.Path.cwd()
    installed = [above / "share" / "doc" / "overbend" for above in package.parents]
    prefixes = [*installed, *package.parents, current, *current.parents]
    folders = [prefix / "examples" for prefix in prefixes if (prefix / "examples" / "bgl1.yaml").is_file()]
    for folder in folders:
        if (folder / name).is_file():
            return folder / name
    if not folders:
        raise FileNotFoundError(f"the examples are not installed with '{package}' (share/doc/overbend/examples), and "
                                f"there is no folder 'examples' in '{current}' or above it")
    names = sorted(str(path.relative_to(folders[0])) for path in folders[0].rglob("*.yaml"))
    close = difflib.get_close_matches(name, names, n=1)
    meant = f"; did you mean '{close[0]}'?" if close else ""
    raise FileNotFoundError(f"there is no example '{name}'{meant}; there are: {', '.join(names)}")
