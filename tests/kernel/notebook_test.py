"""The supplied notebooks: executed as nbconvert does, and in the classic notebook in Chromium."""

import glob
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest

import nbformat
from nbclient import NotebookClient

from client import home, limit

notebooks = sorted(glob.glob(home + "/share/notebooks/*.ipynb"))


def outputs_of(notebook):
    return [output for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs]


class Notebooks(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()

    def tearDown(self):
        self.folder.cleanup()

    def test_every_notebook_runs(self):
        self.assertTrue(notebooks)
        for name in notebooks:
            notebook = nbformat.read(name, 4)
            nbformat.validate(notebook)
            self.assertEqual(outputs_of(notebook), [], f"{name} contains outputs")
            NotebookClient(notebook, timeout=limit, kernel_name="signorini",
                           resources={"metadata": {"path": self.folder.name}}).execute()
            self.assertEqual([output for output in outputs_of(notebook) if output.output_type == "error"], [])

    def test_ironing(self):
        notebook = nbformat.read(home + "/share/notebooks/ironing.ipynb", 4)
        NotebookClient(notebook, timeout=limit, kernel_name="signorini",
                       resources={"metadata": {"path": self.folder.name}}).execute()
        outputs = outputs_of(notebook)
        texts = [output.data["text/plain"] for output in outputs if "data" in output]
        self.assertTrue(any(text.startswith("plane-strain model of die, slab") for text in texts))
        self.assertTrue(any("slide     40" in text for text in texts))
        self.assertIn("press: 10 steps", texts[1])
        images = [output.data for output in outputs if "data" in output and "image/png" in output.data]
        self.assertEqual([("image/svg+xml" in data) for data in images], [False, True])
        self.assertIn("<table>", outputs[-1].data["text/html"])
        self.assertTrue(os.path.isdir(self.folder.name + "/out/press"))

    def test_in_a_browser(self):
        shutil.copy(home + "/share/notebooks/ironing.ipynb", self.folder.name)
        screenshot = sys.argv[1] if len(sys.argv) > 1 else self.folder.name + "/screenshot.png"
        server = subprocess.Popen(
            ["/usr/bin/jupyter-notebook", "--no-browser", "--allow-root", "--ip=127.0.0.1", "--port=0", "--NotebookApp.token=",
             "--NotebookApp.password=", f"--notebook-dir={self.folder.name}"],
            stderr=subprocess.PIPE, text=True, env={**os.environ, "HOME": self.folder.name}, start_new_session=True)
        try:
            address = next(word for line in server.stderr for word in line.split() if word.startswith("http://127.0.0.1:"))
            from browser import look
            self.assertEqual(look(address + "notebooks/ironing.ipynb", screenshot, self.folder.name), [])
        finally:
            os.killpg(server.pid, signal.SIGKILL)
            server.wait()
            server.stderr.close()


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
