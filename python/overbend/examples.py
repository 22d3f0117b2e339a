"""The examples that come with the program."""

from __future__ import annotations

import difflib
import pathlib


def example(name: str) -> pathlib.Path:
    """The path of an example: of a model ('bgl1.yaml') or a study ('studies/bgl1-tension.yaml').

    They are looked for where they are installed with the package, in the clone that it was built in, and in the folder
    `examples` of the current folder and of those above it.

    Raises:
        FileNotFoundError: Where there is none of that name, with those there are; or no examples at all.
    """
    package = pathlib.Path(__file__).resolve().parent
    here = pathlib.Path.cwd()
    installed = [above / "share" / "doc" / "overbend" for above in package.parents]
    prefixes = [*installed, *package.parents, here, *here.parents]
    folders = [prefix / "examples" for prefix in prefixes if (prefix / "examples" / "bgl1.yaml").is_file()]
    for folder in folders:
        if (folder / name).is_file():
            return folder / name
    if not folders:
        raise FileNotFoundError(f"the examples are not installed beside '{package}' (share/doc/overbend/examples), and "
                                f"there is no folder 'examples' in '{here}' or above it")
    there = sorted(str(path.relative_to(folders[0])) for path in folders[0].rglob("*.yaml"))
    close = difflib.get_close_matches(name, there, n=1)
    meant = f"; did you mean '{close[0]}'?" if close else ""
    raise FileNotFoundError(f"there is no example '{name}'{meant}; there are: {', '.join(there)}")
