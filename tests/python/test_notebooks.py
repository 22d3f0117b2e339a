"""Every notebook runs from the first cell to the last, and its numbers hold: the notebooks assert them."""

import json
import os
import pathlib
import sys
import tempfile
import time
import unittest

import nbformat
from jupyter_client.kernelspec import KernelSpecManager
from jupyter_client.manager import AsyncKernelManager
from nbclient import NotebookClient

ROOT = pathlib.Path(__file__).resolve().parents[2]
NOTEBOOKS = sorted((ROOT / "docs" / "python").glob("*.ipynb"))
LONGEST = 120  # [s] on a machine with other work; each takes below 20 s on a free one


def kernels(folder):
    """Kernels of which there is one: the Python that runs this test, with the package that it sees."""
    spec = pathlib.Path(folder) / "kernels" / "python3"
    spec.mkdir(parents=True)
    variables = {"PYTHONPATH": os.pathsep.join(p for p in sys.path if p), "PYDEVD_DISABLE_FILE_VALIDATION": "1",
                 "MPLBACKEND": "module://matplotlib_inline.backend_inline"}
    (spec / "kernel.json").write_text(json.dumps({
        "argv": [sys.executable, "-m", "ipykernel_launcher", "-f", "{connection_file}"], "display_name": "Python 3",
        "language": "python", "env": variables}))
    return KernelSpecManager(kernel_dirs=[str(spec.parent)], ensure_native_kernel=False)


class Notebooks(unittest.TestCase):
    def run_notebook(self, path):
        notebook = nbformat.read(path, as_version=4)
        nbformat.validate(notebook)
        with tempfile.TemporaryDirectory() as folder:
            manager = AsyncKernelManager(kernel_name="python3", kernel_spec_manager=kernels(folder))
            place = {"metadata": {"path": str(path.parent)}}
            client = NotebookClient(notebook, km=manager, timeout=LONGEST, resources=place)
            client.execute()
        return notebook

    def test_there_are_four(self):
        self.assertEqual(len(NOTEBOOKS), 4)

    def test_they_are_kept_without_results(self):
        for path in NOTEBOOKS:
            for cell in nbformat.read(path, as_version=4).cells:
                if cell.cell_type == "code":
                    self.assertEqual((cell.outputs, cell.execution_count), ([], None), path.name)

    def test_each_asserts_what_it_shows(self):
        for path in NOTEBOOKS:
            code = "\n".join(c.source for c in nbformat.read(path, as_version=4).cells if c.cell_type == "code")
            self.assertIn("\nassert ", code, path.name)


def case(path):
    def test(self):
        begun = time.monotonic()
        notebook = self.run_notebook(path)
        figures = sum("image/png" in out.get("data", {}) for cell in notebook.cells for out in cell.get("outputs", []))
        self.assertGreater(figures, 0, "no figure was drawn")
        print(f"{path.name}: {time.monotonic() - begun:.1f} s, {figures} figures", file=sys.stderr)

    return test


for each in NOTEBOOKS:
    setattr(Notebooks, f"test_{each.stem.replace('-', '_')}_runs", case(each))


if __name__ == "__main__":
    unittest.main()
