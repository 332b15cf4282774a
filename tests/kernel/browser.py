"""Executes a notebook in the classic notebook in headless Chromium."""

from client import limit
from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.support.ui import WebDriverWait

run = "Jupyter.notebook.execute_all_cells()"
is_ready = """return typeof Jupyter !== "undefined" && !!Jupyter.notebook && Jupyter.notebook._fully_loaded
  && !!Jupyter.notebook.kernel && Jupyter.notebook.kernel.is_connected()"""
is_done = """return Jupyter.notebook.get_cells().filter(cell => cell.cell_type === "code").every(cell =>
  cell.input_prompt_number > 0)"""
# An image that does not load has no size.
faults = """
  const wrong = [];
  document.querySelectorAll(".output_error, .output_stderr").forEach(output => wrong.push(output.innerText));
  document.querySelectorAll(".output img").forEach(image => {
    if (!image.complete || image.naturalWidth === 0) wrong.push("an image is broken") });
  const pictures = document.querySelectorAll(".output img, .output svg").length;
  if (pictures < 2) wrong.push(`${pictures} pictures`);
  if (!document.querySelector(".output table")) wrong.push("no table");
  return wrong"""


def look(address, screenshot, profile):
    """Returns what is wrong on the page."""
    options = webdriver.ChromeOptions()
    options.binary_location = "/usr/bin/chromium"
    for argument in ("headless", "no-sandbox", "disable-gpu", "disable-quic", "no-first-run", "disable-background-networking",
                     "disable-component-update", "disable-sync", "disable-dev-shm-usage", "window-size=1100,3000",
                     f"user-data-dir={profile}/profile"):
        options.add_argument("--" + argument)
    driver = webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)
    try:
        driver.get(address)
        wait = WebDriverWait(driver, limit, 0.1)
        wait.until(lambda page: page.execute_script(is_ready))
        driver.execute_script(run)
        wait.until(lambda page: page.execute_script(is_done))
        driver.execute_script("document.activeElement.blur()")
        driver.save_screenshot(screenshot)
        return driver.execute_script(faults)
    finally:
        driver.quit()
