"""A front end for the tests: starts the kernel as Jupyter does and collects its messages.

No test depends on time: the limit only ends a test whose message never comes."""

import os
import subprocess
import sys
import tempfile
import unittest

from jupyter_client.kernelspec import KernelSpecManager
from jupyter_client.manager import KernelManager

limit = 60  # s
program = os.path.abspath(sys.argv.pop(1)) if len(sys.argv) > 1 else ""
home = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
data = tempfile.TemporaryDirectory()
os.environ.update(SIGNORINI_HOME=home, JUPYTER_DATA_DIR=data.name, JUPYTER_RUNTIME_DIR=data.name + "/runtime")
subprocess.run([program, "--install-kernel"], check=True, stdout=subprocess.DEVNULL)


class Result:
    """What a cell has sent: messages as (type, content), and the reply."""

    def __init__(self, messages, reply):
        self.messages, self.reply = messages, reply

    def text(self, stream="stdout"):
        return "".join(content["text"] for kind, content in self.messages
                       if kind == "stream" and content["name"] == stream)

    def contents(self, kind):
        return [content for name, content in self.messages if name == kind]

    @property
    def value(self):
        if self.reply["status"] != "ok":
            raise AssertionError(self.reply)
        return self.contents("execute_result")[0]["data"]["text/plain"]

    @property
    def error(self):
        return self.contents("error")[0]["evalue"]


class Kernel:
    def __init__(self, **environment):
        self.manager = KernelManager(kernel_name="signorini", kernel_spec_manager=KernelSpecManager())
        self.manager.start_kernel(stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                  env={**os.environ, **environment})
        self.connect()

    @property
    def pid(self):
        return self.manager.provisioner.pid

    def connect(self):
        self.client = self.manager.client()
        self.client.start_channels()
        self.client.wait_for_ready(timeout=limit)

    def collect(self, request, until=lambda kind, content: False):
        """The messages about a request, to the end of it or to one that a function accepts."""
        messages = []
        while True:
            message = self.client.get_iopub_msg(timeout=limit)
            if message["parent_header"].get("msg_id") != request:
                continue
            kind, content = message["msg_type"], message["content"]
            messages.append((kind, content))
            if content.get("execution_state") == "idle" or until(kind, content):
                return messages

    def reply(self, request, channel="shell"):
        while True:
            message = getattr(self.client, f"get_{channel}_msg")(timeout=limit)
            if message["parent_header"].get("msg_id") == request:
                return message["content"]

    def run(self, code, **options):
        options.setdefault("allow_stdin", False)
        request = self.client.execute(code, **options)
        return Result(self.collect(request), self.reply(request))

    def ask(self, name, *arguments, **options):
        return self.reply(getattr(self.client, name)(*arguments, **options))

    def end(self):
        self.client.stop_channels()
        self.manager.shutdown_kernel()


class Case(unittest.TestCase):
    """Tests with one kernel."""

    @classmethod
    def setUpClass(cls):
        cls.kernel = Kernel()

    @classmethod
    def tearDownClass(cls):
        cls.kernel.end()

    def run_cell(self, code, **options):
        return self.kernel.run(code, **options)

    def assertHolds(self, text, *parts):
        for part in parts:
            self.assertIn(part, text)
