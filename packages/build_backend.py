"""What `pip install .` calls (PEP 517): the package is built by CMake, and packed here.

Nothing is fetched: neither setuptools nor any other build requirement, so that it works on a closed network. What is
needed is a compiler, CMake and the libraries of `scripts/install.sh build`.

A build folder that is configured for this Python is used again: `build/release`, or the one named with
`--config-settings=build-dir=FOLDER`. Else one is made in `build/wheel-TAG`.
"""

import base64
import hashlib
import os
import pathlib
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import zipfile

from python_metadata import ROOT, metadata, version

PYTHON = f"cp{sys.version_info[0]}{sys.version_info[1]}"
TAG = f"{PYTHON}-{PYTHON}-" + sysconfig.get_platform().replace("-", "_").replace(".", "_")
NAME = f"overbend-{version()}"


class BuildFailed(Exception):
    """CMake could not build the package."""


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """Builds the package and writes its wheel; returns the wheel's name."""
    with tempfile.TemporaryDirectory() as folder:
        files = installed_files(build_folder(config_settings), pathlib.Path(folder))
        return write_wheel(wheel_directory, files)


def build_editable(wheel_directory, config_settings=None, metadata_directory=None):
    """A wheel that only points to the package in the build folder (`pip install -e .`); returns its name."""
    build = build_folder(config_settings)
    run("cmake", "--build", str(build), "--target", "overbend_python_installed")
    return write_wheel(wheel_directory, {"overbend.pth": f"{build / 'python'}\n".encode()})


def build_sdist(sdist_directory, config_settings=None):
    """Packs the sources that git knows; returns the archive's name."""
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, encoding="utf-8")
    if listed.returncode != 0:
        raise BuildFailed(f"a source archive is made in a clone of the repository: {listed.stderr.strip()}")
    archive = f"{NAME}.tar.gz"
    with tarfile.open(pathlib.Path(sdist_directory, archive), "w:gz", format=tarfile.PAX_FORMAT) as tar:
        for name in filter(None, listed.stdout.split("\0")):
            tar.add(ROOT / name, f"{NAME}/{name}")
        with tempfile.NamedTemporaryFile("w") as info:
            info.write(metadata())
            info.flush()
            tar.add(info.name, f"{NAME}/PKG-INFO")
    return archive


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    """Writes what the package says of itself, without building it."""
    info = pathlib.Path(metadata_directory, f"{NAME}.dist-info")
    info.mkdir()
    (info / "METADATA").write_text(metadata(), encoding="utf-8")
    (info / "WHEEL").write_text(wheel_text(TAG), encoding="utf-8")
    return info.name


prepare_metadata_for_build_editable = prepare_metadata_for_build_wheel


def build_folder(config_settings):
    """A configured build folder whose module this Python can load."""
    asked = (config_settings or {}).get("build-dir")
    if asked:
        build = pathlib.Path(asked).resolve()
        if not fits(build):
            configure(build)
        return build
    release = ROOT / "build" / "release"
    if fits(release):
        return release
    build = ROOT / "build" / f"wheel-{TAG}"
    configure(build)
    return build


def fits(build):
    """Whether the folder is configured for these sources and a Python that takes the same modules."""
    cache = build / "CMakeCache.txt"
    if not cache.is_file():
        return False
    entries = dict(line.split("=", 1) for line in cache.read_text(encoding="utf-8").splitlines() if "=" in line)
    python = entries.get("OVERBEND_PYTHON:FILEPATH", "")
    if entries.get("CMAKE_HOME_DIRECTORY:INTERNAL") != str(ROOT) or not os.access(python, os.X_OK):
        return False
    if entries.get("OVERBEND_PYTHON_MODULE:BOOL") != "ON" or entries.get("CMAKE_BUILD_TYPE:STRING") != "Release":
        return False
    suffix = "import sysconfig; print(sysconfig.get_config_var('EXT_SUFFIX'))"
    suffix_run = subprocess.run([python, "-c", suffix], capture_output=True, encoding="utf-8")
    return suffix_run.stdout.strip() == sysconfig.get_config_var("EXT_SUFFIX")


def configure(build):
    """Makes a build folder for this Python, with the package alone."""
    run("cmake", "-S", str(ROOT), "-B", str(build), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DOVERBEND_TESTS=OFF",
        "-DOVERBEND_BENCH=OFF", "-DOVERBEND_PYTHON_MODULE=ON", f"-DOVERBEND_PYTHON={sys.executable}",
        f"-DPython_EXECUTABLE={sys.executable}")  # also where an earlier environment is gone


def installed_files(build, folder):
    """Builds the package and has CMake install it into `folder`; name in the wheel -> content."""
    run("cmake", "--build", str(build), "--target", "overbend_python_installed", "--parallel", str(os.cpu_count()))
    run("cmake", "--install", str(build), "--prefix", str(folder), "--component", "python", "--strip")
    package = next(folder.rglob("overbend/__init__.py")).parent
    files = {f"overbend/{path.relative_to(package)}": path.read_bytes()
             for path in sorted(package.rglob("*")) if path.is_file()}
    licence = next(folder.rglob("copyright"))
    return {**files, f"{NAME}.dist-info/LICENSE": licence.read_bytes()}


def wheel_text(tag):
    """The file WHEEL of a wheel with this tag."""
    return f"Wheel-Version: 1.0\nGenerator: overbend\nRoot-Is-Purelib: false\nTag: {tag}\n"


def write_wheel(directory, files, tag=TAG):
    """Packs the files with what a wheel has to say of itself; returns its name."""
    info = f"{NAME}.dist-info"
    files = {**files, f"{info}/METADATA": metadata().encode(), f"{info}/WHEEL": wheel_text(tag).encode()}
    rows = [f"{name},sha256={digest(content)},{len(content)}\n" for name, content in files.items()]
    files[f"{info}/RECORD"] = ("".join(rows) + f"{info}/RECORD,,\n").encode()
    wheel = f"{NAME}-{tag}.whl"
    with zipfile.ZipFile(pathlib.Path(directory, wheel), "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            entry = zipfile.ZipInfo(name)
            entry.external_attr = (0o755 if name.endswith(".so") else 0o644) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, content)
    return wheel


def digest(content):
    """As RECORD has it."""
    return base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()


def run(*command):
    """Runs a command of the build; its output is pip's."""
    try:
        done = subprocess.run(command, cwd=ROOT)
    except FileNotFoundError:
        raise BuildFailed(f"{command[0]} is not installed; on Debian `scripts/install.sh build` installs all that the "
                          "build needs") from None
    if done.returncode != 0:
        raise BuildFailed(f"`{' '.join(command)}` failed; on Debian `scripts/install.sh build` installs all that the "
                          "build needs")


if __name__ == "__main__":  # build_backend.py BUILD TAG FOLDER: a wheel of a build folder for another Python
    build, tag, wheels = sys.argv[1:]
    with tempfile.TemporaryDirectory() as made:
        print(write_wheel(wheels, installed_files(build, pathlib.Path(made)), tag))
