"""The kernel as a process: interrupts, restart, end, connection files, installation."""

import json
import os
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

from client import Case, Kernel, data, home, limit, program

scene = """
    block = sg.body{ patch = sg.shapes.rectangle{ width = 1, height = 1 }, elements = {2, 2}, order = "N2",
      material = sg.neo_hookean{ E = 1, nu = 0.3 } }
    model = sg.model{ bodies = { block = block }, supports = { bed = { on = block:face "south", fix = "xy" },
      top = { on = block:face "north", drive = "y" } } }
    stages = { { steps = 10000000, top = -0.1 } }
"""


def status_of(pid):
    """State and parent of a process; None if there is none."""
    try:
        with open(f"/proc/{pid}/stat") as file:
            state, parent = file.read().rpartition(")")[2].split()[:2]
            return state, int(parent)
    except OSError:
        return None


def is_alive(pid):
    """Whether a process exists and has not ended."""
    status = status_of(pid)
    return status is not None and status[0] != "Z"


def wait_until(condition):
    end = time.monotonic() + limit
    while not condition():
        if time.monotonic() > end:
            raise AssertionError("timed out")
        time.sleep(0.05)


def descendants(pid):
    children = [int(name) for name in os.listdir("/proc") if name.isdigit() and (status_of(name) or (0, 0))[1] == pid]
    return children + [each for child in children for each in descendants(child)]


class Interrupts(Case):
    def interrupted(self, code, event, how=None, **options):
        """Runs a cell, interrupts it once its output has an event, or progress appears; returns its error."""
        options.setdefault("allow_stdin", False)
        request = self.kernel.client.execute(code, **options)
        self.kernel.collect(request, lambda kind, content: kind == "display_data" if event == "progress"
                            else kind == "stream" and event in content["text"])
        (how or self.kernel.manager.interrupt_kernel)()
        messages = self.kernel.collect(request)
        self.assertEqual(self.kernel.reply(request)["status"], "error")
        return [content for kind, content in messages if kind == "error"][0]

    def by_message(self):
        client = self.kernel.client
        message = client.session.msg("interrupt_request", {})
        client.control_channel.send(message)
        self.assertEqual(self.kernel.reply(message["header"]["msg_id"], "control")["status"], "ok")

    def test_the_run_is_kept(self):
        for how in (None, self.by_message):
            self.run_cell(scene)
            error = self.interrupted("run = model:run(stages)", "progress", how)
            self.assertEqual((error["ename"], error["evalue"]), ("interrupted", "interrupted; _ is the run so far"))
            self.assertEqual(self.run_cell("_.reason, _.steps > 0, run == _").value, '"interrupted"\ntrue\ntrue')
            more = self.run_cell("model:run({ { steps = 1, top = model:target 'top' } }).reason")
            self.assertEqual(more.value, '"completed"')

    def test_loops(self):
        for how in (None, self.by_message):
            error = self.interrupted("print 'on'\nwhile true do end", "on", how)
            self.assertEqual(error["evalue"], "interrupted")
            self.assertEqual(self.run_cell("1").value, "1")

    def test_a_study(self):
        with tempfile.TemporaryDirectory() as folder:
            self.interrupted(f"""
                study = sg.study{{ name = "s", folder = "{folder}/s", cases = sg.grid{{ a = {{1, 2, 3}} }},
                  run = function() print "begun" while true do end end }}
                study:execute()""", "begun")
        self.assertEqual(descendants(self.kernel.pid), [])

    def interrupt_input(self, kernel):
        request = kernel.client.execute("io.read()", allow_stdin=True)
        kernel.client.get_stdin_msg(timeout=limit)
        kernel.manager.interrupt_kernel()
        # Until it is idle, a kernel refuses the cells that wait behind one that failed.
        kernel.collect(request)
        self.assertEqual(kernel.reply(request)["ename"], "interrupted")
        self.assertEqual(kernel.run("1").value, "1")

    def test_input(self):
        self.interrupt_input(self.kernel)

    def test_input_before_the_wait(self):
        kernel = Kernel(LD_PRELOAD=os.environ["SLOW_RECEIVE"])
        self.interrupt_input(kernel)
        kernel.end()

    def test_between_cells(self):
        self.kernel.manager.interrupt_kernel()
        self.by_message()
        self.assertEqual(self.run_cell("print 'well'").text(), "well\n")


class Life(Case):
    def test_restart(self):
        self.run_cell("kept = 1")
        before = self.kernel.pid
        self.kernel.client.stop_channels()
        self.kernel.manager.restart_kernel()
        self.kernel.connect()
        self.assertNotEqual(self.kernel.pid, before)
        self.assertFalse(is_alive(before))
        self.assertEqual(self.run_cell("rawget(_G, 'kept')").value, "nil")

    def test_two_kernels(self):
        other = Kernel()
        self.run_cell("shared = 1")
        other.run("shared = 2")
        self.assertEqual((self.run_cell("shared").value, other.run("shared").value), ("1", "2"))
        other.end()

    def test_end(self):
        for code in ("", "print 'on' while true do end", """
                sg.study{ name = "s", folder = os.getenv "JUPYTER_DATA_DIR" .. "/study", cases = sg.grid{ a = {1, 2} },
                  run = function() print "on" while true do end end }:execute()"""):
            kernel = Kernel()
            if code:
                request = kernel.client.execute(code)
                kernel.collect(request, lambda kind, content: kind == "stream")
                kernel.client.execute("io.open(os.getenv 'JUPYTER_DATA_DIR' .. '/executed', 'w')")
            processes = [kernel.pid] + descendants(kernel.pid)
            kernel.client.shutdown()
            wait_until(lambda: not any(is_alive(process) for process in processes))
            kernel.end()
        self.assertFalse(os.path.exists(data.name + "/executed"))

    def test_reply_to_shutdown(self):
        for restart in (False, True):
            kernel = Kernel()
            request = kernel.client.shutdown(restart)
            self.assertEqual(kernel.reply(request, "control"), {"restart": restart, "status": "ok"})
            wait_until(lambda: not kernel.manager.is_alive())
            kernel.end()

    def test_killed_parent(self):
        parent = subprocess.Popen([sys.executable, "-c", """
import sys
sys.argv.insert(1, sys.argv.pop())
from client import Kernel
kernel = Kernel()
print(kernel.pid, flush=True)
kernel.run("print 'on' while true do end")
""", program], stdout=subprocess.PIPE, text=True, cwd=os.path.dirname(os.path.abspath(__file__)))
        pid = int(parent.stdout.readline())
        self.assertTrue(is_alive(pid))
        parent.kill()
        parent.wait()
        parent.stdout.close()
        wait_until(lambda: not is_alive(pid))


class ConnectionFiles(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.file = self.folder.name + "/connection.json"
        sockets = [socket.socket() for _ in range(5)]
        for each in sockets:
            each.bind(("127.0.0.1", 0))
        ports = [each.getsockname()[1] for each in sockets]
        for each in sockets:
            each.close()
        names = ("shell_port", "iopub_port", "stdin_port", "control_port", "hb_port")
        self.good = dict(zip(names, ports), ip="127.0.0.1", key="secret", transport="tcp", signature_scheme="hmac-sha256")

    def tearDown(self):
        self.folder.cleanup()

    def fails(self, *parts, status=1, arguments=None):
        result = subprocess.run([program] + (arguments or ["--kernel", self.file]), capture_output=True, text=True,
                                stdin=subprocess.DEVNULL, timeout=limit)
        for part in ("signorini: ",) + parts:
            self.assertIn(part, result.stderr)
        self.assertEqual((result.returncode, result.stdout, result.stderr.count("\n")), (status, "", 1), result.stderr)

    def write(self, **changes):
        entries = {key: value for key, value in {**self.good, **changes}.items() if value is not None}
        with open(self.file, "w") as file:
            json.dump(entries, file)

    def test_wrong_files(self):
        self.fails(f"got '{self.file}', which does not exist. Hint: Jupyter writes this file")
        self.fails("which is not a file. Hint: ", arguments=["--kernel", self.folder.name])
        for text in ("", "{", "[1, 2]", "\xff", '{"ip": "127.0.0.1"'):
            with open(self.file, "w", encoding="latin-1") as file:
                file.write(text)
            self.fails("which is not a JSON object")

    def test_wrong_entries(self):
        for changes, message in [
                ({"shell_port": None}, "shell_port of the connection file"), ({"hb_port": 0}, "from 1 to 65535, got 0"),
                ({"hb_port": 70000}, "got 70000"), ({"stdin_port": "5"}, 'got "5"'), ({"iopub_port": 1.5}, "got 1.5"),
                ({"transport": "udp"}, "transport of the connection file"), ({"transport": None}, "which is missing"),
                ({"ip": 3}, "ip of the connection file"), ({"key": None}, "key of the connection file"),
                ({"signature_scheme": "sha"}, 'must be \'hmac-sha256\''), ({"signature_scheme": None}, "which is missing"),
                ({"ip": "300.1.1.1"}, "cannot listen at the ports")]:
            self.write(**changes)
            self.fails(message)

    def test_used_port(self):
        with socket.socket() as taken:
            taken.bind(("127.0.0.1", 0))
            taken.listen()
            self.write(control_port=taken.getsockname()[1])
            self.fails("cannot listen at the ports of", "Address already in use. Hint: another kernel may use this file")

    def test_command_line(self):
        self.write()
        self.fails("--kernel must be followed by a connection file", status=2, arguments=["--kernel"])
        self.fails("cannot be combined with the script 'study.lua'", status=2, arguments=["--kernel", self.file, "study.lua"])
        self.fails("cannot be combined with -i", status=2, arguments=["-i", "--kernel", self.file])
        self.fails("--install-kernel cannot be combined with the script 'folder'", "JUPYTER_DATA_DIR", status=2,
                   arguments=["--install-kernel", "folder"])
        result = subprocess.run([program, "-e", "error 'no'", "--kernel", self.file], capture_output=True, text=True)
        self.assertEqual(result.returncode, 1)
        self.assertIn("(command line):1: no", result.stderr)

    def test_messages_that_are_not_requests(self):
        """Any local user can reach the ports: messages without the key, without some or with other parts are dropped."""
        import zmq
        from jupyter_client.blocking import BlockingKernelClient
        for key in ("secret", ""):
            self.write(key=key)
            kernel = subprocess.Popen([program, "--kernel", self.file], stdin=subprocess.DEVNULL)
            self.addCleanup(kernel.kill)
            client = BlockingKernelClient(connection_file=self.file)
            client.load_connection_file()
            client.start_channels()
            client.wait_for_ready(timeout=limit)
            header = json.dumps(client.session.msg_header("kernel_info_request"), default=str).encode()
            mark, empty = b"<IDS|MSG>", b"{}"
            signed = client.session.sign([header, empty, empty, empty])
            broken = [[b""], [mark], [mark, b""], [mark, b"", empty, empty], [b"no mark"] * 7,
                      [mark, b"0" * 64, header, empty, empty, empty] if key else [mark, b"", b"{", empty, empty, empty],
                      [mark, client.session.sign([b"[]", empty, empty, empty]), b"[]", empty, empty, empty],
                      [mark, client.session.sign([b'{"msg_type": 5}', empty, empty, empty]), b'{"msg_type": 5}'] + [empty] * 3,
                      [mark, signed, header, empty, empty], [mark, signed, header, empty, empty, b"\xff\x00"]]
            context = zmq.Context()
            for port in ("shell_port", "control_port", "stdin_port"):
                one = context.socket(zmq.DEALER)
                one.connect(f"tcp://127.0.0.1:{getattr(client, port)}")
                for frames in broken:
                    one.send_multipart(frames)
                one.send_multipart([mark, signed, header, empty, empty, empty])  # behind the others, and answered
                if port != "stdin_port":
                    self.assertGreater(one.poll(limit * 1000), 0)
                one.close()
            client.execute("6 * 7")
            self.assertEqual(client.get_shell_msg(timeout=limit)["content"]["status"], "ok")
            client.shutdown()
            self.assertEqual(kernel.wait(limit), 0)
            client.stop_channels()
            context.term()

    def test_without_signatures(self):
        self.write(key="")
        kernel = subprocess.Popen([program, "-e", "preset = 5", "--kernel", self.file], stdin=subprocess.DEVNULL)
        from jupyter_client.blocking import BlockingKernelClient
        client = BlockingKernelClient(connection_file=self.file)
        client.load_connection_file()
        client.start_channels()
        client.wait_for_ready(timeout=limit)
        client.execute("preset")
        self.assertEqual(client.get_shell_msg(timeout=limit)["content"]["status"], "ok")
        client.shutdown()
        self.assertEqual(kernel.wait(limit), 0)
        client.stop_channels()


class Installation(unittest.TestCase):
    def install(self, *options, status=0, **environment):
        result = subprocess.run([program, *options, "--install-kernel"], capture_output=True, text=True,
                                env={"SIGNORINI_HOME": home, "PATH": os.environ["PATH"], **environment})
        self.assertEqual(result.returncode, status, result.stderr)
        return result

    def test_folders(self):
        with tempfile.TemporaryDirectory() as folder:
            for environment, place in [({"HOME": folder}, ".local/share/jupyter"), ({"XDG_DATA_HOME": folder + "/x"}, "x/jupyter"),
                                       ({"XDG_DATA_HOME": folder, "JUPYTER_DATA_DIR": folder + "/j"}, "j")]:
                output = self.install(**environment).stdout
                place = f"{folder}/{place}/kernels/signorini"
                self.assertIn(f"Written: {place}; ", output)
                with open(place + "/kernel.json") as file:
                    spec = json.load(file)
                self.assertEqual(spec["argv"], [os.path.realpath(program), "--kernel", "{connection_file}"])
                self.assertEqual((spec["language"], spec["display_name"]), ("lua", "Signorini"))
                for size in (32, 64):
                    with open(f"{place}/logo-{size}x{size}.png", "rb") as file:
                        self.assertEqual(int.from_bytes(file.read()[16:20], "big"), size)
            self.install("--threads", "2", "--jobs", "3", "-q", HOME=folder)
            with open(f"{folder}/.local/share/jupyter/kernels/signorini/kernel.json") as file:
                self.assertEqual(json.load(file)["argv"][1:-2], ["-q", "--threads", "2", "--jobs", "3"])

    def test_failures(self):
        self.assertIn("Hint: set HOME or JUPYTER_DATA_DIR", self.install(status=1).stderr)
        with tempfile.NamedTemporaryFile() as file:
            error = self.install(status=1, JUPYTER_DATA_DIR=file.name).stderr
        self.assertIn("--install-kernel: cannot create the folder", error)

    def test_doctor(self):
        output = subprocess.run([program, "--doctor"], capture_output=True, text=True).stdout
        self.assertRegex(output, r"Jupyter +xeus 2\.[0-9.]+, ZeroMQ 4")


if __name__ == "__main__":
    unittest.main()
