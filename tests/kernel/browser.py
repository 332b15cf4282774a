"""Executes a notebook in the classic notebook in headless Chromium."""

import os
import sys

sys.path.append(os.path.join(os.path.dirname(__file__), "../browser"))
from devtools import Page

run = "Jupyter.notebook.execute_all_cells()"
is_ready = """typeof Jupyter !== "undefined" && !!Jupyter.notebook && Jupyter.notebook._fully_loaded
  && !!Jupyter.notebook.kernel && Jupyter.notebook.kernel.is_connected()"""
is_done = """Jupyter.notebook.get_cells().filter(cell => cell.cell_type === "code").every(cell =>
  cell.input_prompt_number > 0)"""
# An image that does not load has no size.
faults = """(() => {
  const wrong = [];
  document.querySelectorAll(".output_error, .output_stderr").forEach(output => wrong.push(output.innerText));
  document.querySelectorAll(".output img").forEach(image => {
    if (!image.complete || image.naturalWidth === 0) wrong.push("an image is broken") });
  const pictures = document.querySelectorAll(".output img, .output svg").length;
  if (pictures < 2) wrong.push(`${pictures} pictures`);
  if (!document.querySelector(".output table")) wrong.push("no table");
  return wrong })()"""


def look(address, screenshot):
    """Returns what is wrong on the page."""
    page = Page()
    try:
        page.size(1100, 3000)
        page.open(address)
        page.until(is_ready)
        page.run(run)
        page.until(is_done)
        page.run("document.activeElement.blur()")
        page.settle()
        page.screenshot(screenshot)
        return page.run(faults)
    finally:
        page.close()
