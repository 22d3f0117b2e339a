#!/usr/bin/env python3
"""What an installed Python package says of itself: its name, version and needs, in the file METADATA.

    python_metadata.py          prints it
"""

import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent

HEAD = """\
Metadata-Version: 2.1
Name: overbend
Version: {version}
Summary: Offshore pipelay analysis: statics, dynamics, code checks, studies
License: MIT
Platform: Linux
Classifier: Development Status :: 5 - Production/Stable
Classifier: Intended Audience :: Science/Research
Classifier: License :: OSI Approved :: MIT License
Classifier: Operating System :: POSIX :: Linux
Classifier: Programming Language :: C++
Classifier: Programming Language :: Python :: 3
Classifier: Topic :: Scientific/Engineering
Classifier: Typing :: Typed
Requires-Python: >=3.11
Requires-Dist: numpy>=1.20
Provides-Extra: all
Requires-Dist: xarray; extra == "all"
Requires-Dist: matplotlib; extra == "all"
Description-Content-Type: text/markdown

"""


def version() -> str:
    """The project's version, as CMake has it."""
    return re.search(r"project\(overbend VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")).group(1)


def metadata() -> str:
    """The text of METADATA."""
    return HEAD.format(version=version()) + (ROOT / "README.md").read_text(encoding="utf-8")


if __name__ == "__main__":
    print(metadata(), end="")
