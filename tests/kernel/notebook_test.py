"""The supplied notebooks: executed as nbconvert does, and in the classic notebook in Chromium."""

import functools
import glob
import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import unittest

import nbformat
from nbclient import NotebookClient

from client import home, limit

folder = tempfile.TemporaryDirectory()
ironing = home + "/share/notebooks/ironing.ipynb"
notebooks = sorted(glob.glob(home + "/share/notebooks/*.ipynb"))


def outputs_of(notebook):
    return [output for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs]


def free_port():
    with socket.socket() as found:
        found.bind(("127.0.0.1", 0))
        return found.getsockname()[1]


@functools.cache
def executed(name):
    """The notebook with outputs."""
    notebook = nbformat.read(name, 4)
    nbformat.validate(notebook)
    NotebookClient(notebook, timeout=limit, kernel_name="signorini",
                   resources={"metadata": {"path": folder.name}}).execute()
    return notebook


class Notebooks(unittest.TestCase):
    def test_every_notebook_runs(self):
        self.assertTrue(notebooks)
        for name in notebooks:
            self.assertEqual(outputs_of(nbformat.read(name, 4)), [], f"{name} contains outputs")
            self.assertEqual([output for output in outputs_of(executed(name)) if output.output_type == "error"], [])

    def test_ironing(self):
        outputs = outputs_of(executed(ironing))
        texts = [output.data["text/plain"] for output in outputs if "data" in output]
        self.assertTrue(any(text.startswith("plane-strain model of die, slab") for text in texts))
        self.assertTrue(any("slide     40" in text for text in texts))
        self.assertTrue(any(text.startswith("press: 10 steps") for text in texts))
        images = [output.data for output in outputs if "data" in output and "image/png" in output.data]
        self.assertEqual([("image/svg+xml" in data) for data in images], [False, True])
        self.assertIn("<table>", outputs[-1].data["text/html"])
        self.assertTrue(os.path.isdir(folder.name + "/out/press"))

    def test_in_a_browser(self):
        shutil.copy(ironing, folder.name)
        screenshot = sys.argv[1] if len(sys.argv) > 1 else folder.name + "/screenshot.png"
        server = subprocess.Popen(
            ["/usr/bin/jupyter-notebook", "--no-browser", "--allow-root", "--ip=127.0.0.1", f"--port={free_port()}", "--NotebookApp.token=",
             "--NotebookApp.password=", f"--notebook-dir={folder.name}"],
            stderr=subprocess.PIPE, text=True, env={**os.environ, "HOME": folder.name}, start_new_session=True)
        try:
            address = next(word for line in server.stderr for word in line.split() if word.startswith("http://127.0.0.1:"))
            from browser import look
            self.assertEqual(look(address + "notebooks/ironing.ipynb", screenshot), [])
        finally:
            os.killpg(server.pid, signal.SIGKILL)
            server.wait()
            server.stderr.close()


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
