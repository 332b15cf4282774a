"""Opens the reports of tests/lua/output/report_test.lua in a browser and uses them as a reader does; exits with a message at
the first fault. Arguments: the report of a study, and those of a run and of a convergence map."""

import json
import sys

import html5lib

from devtools import Page

study, others = sys.argv[1], sys.argv[2:]


def expect(what, actual, wanted):
    if actual != wanted:
        sys.exit(f"{what}: expected {json.dumps(wanted)}, got {json.dumps(actual)}")


def well_formed(file):
    with open(file, "rb") as source:
        html5lib.HTMLParser(strict=True).parse(source.read())


CELLS = "[...document.querySelectorAll('.table tbody tr:not([hidden])')].map(r => r.cells[%d].textContent)"


def column(page, number):
    return page.run(CELLS % number)


for file in [study, *others]:
    well_formed(file)

page = Page()
try:
    for file in [study, *others]:
        page.size(1280, 900)
        page.open(file)
        expect("requested addresses of " + file, len(page.requests()), 1)
        for width in (1280, 390):
            page.size(width, 844, phone=width == 390)
            page.open(file)
            expect(f"width of {file} in {width} pixels", page.run("document.documentElement.scrollWidth"), width)
        expect("equal ids in " + file, page.run("(() => { const ids = [...document.querySelectorAll('[id]')].map(e => "
                                                "e.id); return ids.length - new Set(ids).size; })()"), 0)
        expect("references without target in " + file, page.run(
            "[...document.querySelectorAll('[href^=\"#\"]')].filter(e => !document.getElementById(e.getAttribute("
            "'href').slice(1))).length"), 0)

    # ── The table of the study: columns order, mesh, error, note, wall, outcome, reason ──
    page.size(1280, 900)
    page.open(study)
    expect("rows", column(page, 1), ["1", "2", "10", "1", "2", "10"])
    head = ".table th:nth-child(%d) button"
    page.click(head % 3)  # error, missing in the failed case
    expect("sorted by error", column(page, 2), ["0.3", "1", "5", "10", "25", "–"])
    expect("state of the sorted head", page.run("document.querySelector('.table th:nth-child(3)').ariaSort"), "ascending")
    page.click(head % 3)
    expect("sorted down by error", column(page, 2), ["25", "10", "5", "1", "0.3", "–"])
    page.click(head % 3)
    expect("in the order of the cases again", column(page, 1), ["1", "2", "10", "1", "2", "10"])
    page.click(head % 2)
    expect("sorted by mesh as numbers", column(page, 1), ["1", "1", "2", "2", "10", "10"])
    page.run(f"document.querySelector('{head % 1}').focus()")
    page.call("Input.dispatchKeyEvent", type="keyDown", key="Enter", windowsVirtualKeyCode=13, text="\r")
    page.call("Input.dispatchKeyEvent", type="keyUp", key="Enter", windowsVirtualKeyCode=13)
    expect("sorted by order with the keyboard", column(page, 0), ["N2", "N2", "N2", "N4", "N4", "N4"])

    page.type(".table input", "mesh>=2 N4")
    expect("filtered", column(page, 1), ["2", "10"])
    expect("count of rows", page.run("document.querySelector('.table .count').textContent"), "2 of 6 rows")
    page.run("Blob = class { constructor(parts) { window.saved = parts.join(''); } }; "
             "URL.createObjectURL = () => '#saved'; HTMLAnchorElement.prototype.click = function() { window.named = "
             "this.download; }; 0")
    page.click(".table .download")
    saved = page.run("window.saved").splitlines()
    expect("name of the CSV file", page.run("window.named"), "press_script_.csv")
    expect("comments of the CSV file", saved[1], "# error (%)")
    expect("first row of the CSV file", saved[4].split(",")[:3], ["N4", "2", "1"])
    expect("text with a comma and quotes", saved[4].split(",", 3)[3].startswith('"a ""note"", <b>"'), True)
    expect("number of lines of the CSV file", len(saved), 6)
    page.run("document.querySelector('.table input').value = ''; "
             "document.querySelector('.table input').dispatchEvent(new Event('input'))")
    expect("all rows again", len(column(page, 0)), 6)

    # ── Values of a chart, with the mouse, a finger and the keyboard ──
    x, y = page.center("figure.chart svg .spots circle:nth-of-type(2)")
    expect("no value at first", page.run("document.getElementById('tip').hidden"), True)
    page.mouse("mouseMoved", x + 4, y - 3)
    shown = "(() => { const t = document.getElementById('tip'); return t.hidden ? null : t.textContent; })()"
    expect("value below the mouse", page.run(shown), "order: N2\nmesh: 2\nerror (%): 5")
    page.mouse("mouseMoved", 2, 2)
    expect("no value elsewhere", page.run(shown), None)
    page.call("Input.dispatchTouchEvent", type="touchStart", touchPoints=[{"x": x, "y": y}])
    page.call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])
    expect("value after a touch", page.run(shown), "order: N2\nmesh: 2\nerror (%): 5")
    page.run("document.querySelector('figure.chart svg').focus()")
    for key in ("ArrowRight", "ArrowRight", "ArrowLeft"):
        page.call("Input.dispatchKeyEvent", type="keyDown", key=key)
    text = page.run(shown)
    expect("value with the keyboard", text is not None and text.startswith("order: N2\nmesh: "), True)
    page.call("Input.dispatchKeyEvent", type="keyDown", key="Escape")
    expect("no value after Escape", page.run(shown), None)
    x, y = page.center("#maps svg .spots rect")
    page.mouse("mouseMoved", x, y)
    expect("value of a cell", page.run(shown).splitlines()[-1], "done")

    # ── Texts of the user are texts ──
    expect("title", page.run("document.title"), "Errors <b>& \"more\"</b> </title>")
    expect("elements made by texts", page.run("document.querySelectorAll('h1 *, li *, pre b, td b').length"), 0)
    expect("script", "</script>" in page.run("document.querySelector('pre').textContent"), True)
    expect("broken text", page.run("document.querySelector('main > p').textContent"), "Bytes \ufffd and \ufffd.")
    expect("complaints of the console", page.complaints, [])
finally:
    page.close()
