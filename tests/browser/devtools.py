"""A page in headless Chromium, driven by the DevTools protocol through pipes: no port, no network, no further package."""

import base64
import json
import os
import select
import shutil
import subprocess
import tempfile

FLAGS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
         "--disable-background-networking", "--disable-component-update", "--disable-sync", "--disable-extensions",
         "--disable-dev-shm-usage", "--hide-scrollbars", "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1",
         "--remote-debugging-pipe"]


class Page:
    def __init__(self):
        self.folder = tempfile.mkdtemp(prefix="signorini-browser-")
        command_read, self.commands = os.pipe()
        self.answers, answer_write = os.pipe()

        def connect():  # Chromium reads commands from 3 and writes answers to 4
            read, write = os.dup(command_read), os.dup(answer_write)
            os.dup2(read, 3)
            os.dup2(write, 4)

        self.browser = subprocess.Popen(["chromium", *FLAGS, f"--user-data-dir={self.folder}/profile", "about:blank"],
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, preexec_fn=connect,
                                        pass_fds=(3, 4), close_fds=True)
        os.close(command_read)
        os.close(answer_write)
        self.rest, self.count, self.session = b"", 0, None
        self.events, self.complaints = [], []
        page = next(one for one in self.call("Target.getTargets")["targetInfos"] if one["type"] == "page")
        self.session = self.call("Target.attachToTarget", targetId=page["targetId"], flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(f"{domain}.enable")

    def _receive(self):
        while b"\0" not in self.rest:
            if not select.select([self.answers], [], [], 120)[0]:  # a guard: the test must not hang
                raise RuntimeError("Chromium does not answer")
            part = os.read(self.answers, 1 << 20)
            if not part:
                raise RuntimeError("Chromium has ended")
            self.rest += part
        message, self.rest = self.rest.split(b"\0", 1)
        message = json.loads(message)
        if "method" in message:
            self._note(message["method"], message["params"])
        return message

    def _note(self, method, params):
        """Remembers events, and what a developer would see in the console."""
        self.events.append((method, params))
        if method == "Runtime.exceptionThrown":
            self.complaints.append(params["exceptionDetails"].get("exception", {}).get("description", "exception"))
        elif method == "Runtime.consoleAPICalled" and params["type"] in ("error", "warning", "assert"):
            self.complaints.append(str(params["args"]))
        elif method == "Log.entryAdded" and params["entry"]["level"] in ("error", "warning"):
            self.complaints.append(params["entry"]["text"])

    def call(self, method, **params):
        self.count += 1
        number = self.count
        message = {"id": number, "method": method, "params": params}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.commands, json.dumps(message).encode() + b"\0")
        while True:
            answer = self._receive()
            if answer.get("id") == number:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']}")
                return answer["result"]

    def wait(self, method):
        while not any(name == method for name, _ in self.events):
            self._receive()

    def size(self, width, height, phone=False):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=phone)

    def dark(self, on=True):
        self.call("Emulation.setEmulatedMedia",
                  features=[{"name": "prefers-color-scheme", "value": "dark" if on else "light"}])

    def open(self, place):
        """Opens a file or an http address."""
        self.events = []
        self.call("Page.navigate", url=place if place.startswith("http://") else "file://" + os.path.abspath(place))
        self.wait("Page.loadEventFired")

    def requests(self):
        """Addresses that the page has requested, except those within it."""
        return [params["request"]["url"] for method, params in self.events if method == "Network.requestWillBeSent"
                and not params["request"]["url"].startswith(("data:", "blob:"))]

    def run(self, expression):
        answer = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(answer["exceptionDetails"]["exception"]["description"])
        return answer["result"].get("value")

    def until(self, condition):
        """Waits until an expression is true."""
        self.run("new Promise(done => { const look = () => (%s) ? done(0) : setTimeout(look, 100); look() })" % condition)

    def mouse(self, kind, x, y, **more):
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)

    def center(self, selector):
        """Scrolls an element into view and returns its center."""
        element = "document.querySelector(%s)" % json.dumps(selector)
        self.run(element + ".scrollIntoView({ block: 'center', behavior: 'instant' })")
        self.settle()
        return self.run("(({ x, y, width, height }) => [x + width / 2, y + height / 2])(%s.getBoundingClientRect())"
                        % element)

    def settle(self):
        """Waits until the page has drawn what it has been told."""
        self.run("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done(0))))")

    def click(self, selector):
        x, y = self.center(selector)
        self.mouse("mouseMoved", x, y)
        self.mouse("mousePressed", x, y, button="left", clickCount=1)
        self.mouse("mouseReleased", x, y, button="left", clickCount=1)

    def type(self, selector, text):
        self.click(selector)
        self.call("Input.insertText", text=text)

    def screenshot(self, file, whole=False):
        answer = self.call("Page.captureScreenshot", format="png", captureBeyondViewport=whole)
        with open(file, "wb") as out:
            out.write(base64.b64decode(answer["data"]))

    def print(self, file):
        answer = self.call("Page.printToPDF", printBackground=False, preferCSSPageSize=True)
        with open(file, "wb") as out:
            out.write(base64.b64decode(answer["data"]))

    def close(self):
        self.call("Browser.close") if self.browser.poll() is None else None
        self.browser.wait()
        shutil.rmtree(self.folder, ignore_errors=True)
