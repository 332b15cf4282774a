"""Writes the pictures of share/doc/use/report.md: tests/browser/screenshots.py <report of share/starter.lua> <folder>"""

import sys

from devtools import Page

report, folder = sys.argv[1:]
page = Page()
try:
    page.size(1100, 820)
    page.open(report)
    x, y = page.center("figure.chart svg .spots circle:nth-of-type(2)")
    y += page.run("(() => { const before = scrollY; scrollTo({ top: 0, behavior: 'instant' }); return before; })()")
    page.settle()
    page.mouse("mouseMoved", x + 2, y + 2)
    page.screenshot(f"{folder}/desktop.png")
    page.size(390, 760, phone=True)
    page.dark()
    page.open(report)
    page.center("#cases h2")
    page.click(".table th:nth-child(3) button")
    page.screenshot(f"{folder}/phone.png")
finally:
    page.close()
