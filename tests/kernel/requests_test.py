"""The requests of the protocol: cells and their output, values, errors, completion, help, history."""

import base64
import tempfile
import unittest

from client import Case, home, limit


class Cells(Case):
    def test_output_and_value(self):
        result = self.run_cell('print "one"\nio.stderr:write "two\\n"\nio.write "three"\n6 * 7')
        self.assertEqual(result.text(), "one\nthree")
        self.assertEqual(result.text("stderr"), "two\n")
        self.assertEqual(result.value, "42")
        self.assertEqual(result.reply["status"], "ok")
        self.assertEqual(self.run_cell("_ + 1").value, "43")

    def test_all_messages_precede_the_end(self):
        result = self.run_cell("for i = 1, 20000 do print(i) end\n'last'")
        self.assertEqual(result.text(), "".join(f"{i}\n" for i in range(1, 20001)))
        kinds = [kind for kind, _ in result.messages]
        self.assertEqual(kinds[:2], ["status", "execute_input"])
        self.assertEqual(kinds[-2:], ["execute_result", "status"])
        self.assertLess(len(kinds), 1000)  # not one message per line

    def test_output_of_other_processes(self):
        result = self.run_cell('os.execute "echo out; echo err >&2"')
        self.assertEqual((result.text(), result.text("stderr")), ("out\n", "err\n"))
        with tempfile.TemporaryDirectory() as folder:
            result = self.run_cell(f"""
                study = sg.study{{ name = "s", folder = "{folder}/s", cases = sg.grid{{ a = {{1, 2, 3}} }},
                  run = function(case) print("case " .. case.a) return {{ b = 2 * case.a }} end }}
                study:execute()""")
        self.assertEqual(sorted(result.text().split("\n")), ["", "case 1", "case 2", "case 3"])
        self.assertHolds(result.contents("display_data")[0]["data"]["text/plain"], "s [", "of 3 done")
        value = result.contents("execute_result")[0]["data"]
        self.assertHolds(value["text/plain"], "s: 3 of 3 cases are done")
        self.assertHolds(value["text/html"], "<table>", "<th", ">6</td>")

    def test_last_expression(self):
        for code, value in [("x = 3; x", "3"), ("local y = 4\ny", "4"), ("f = function() return 1 end\nf(\n)\n-- end", "1"),
                            ("1, 'two'", '1\n"two"'), ("y = {\n1 }\n#y", "1"), ("nil", "nil"), ("{1, 2}", "{1, 2}"),
                            ("'ü'", '"ü"')]:
            self.assertEqual(self.run_cell(code).value, value)
        for code in ["for i = 1, 2 do\nprint(i)\nend", "x = math.abs\n(-3)", "s = [[\n1\n]]", "x = 1", "io.write 'a'",
                     "print(1)", "-- nothing", "", "x = 5\n- 1"]:
            result = self.run_cell(code)
            self.assertEqual((result.reply["status"], result.contents("execute_result")), ("ok", []), code)
        self.assertEqual(self.run_cell("x").value, "4")

    def test_invalid_utf8(self):
        self.assertEqual(self.run_cell('io.write("a\\xff\\xfeb")').text(), "a\ufffd\ufffdb")
        self.assertEqual(self.run_cell('"\\xe2\\x82"').reply["status"], "ok")

    def test_picture(self):
        result = self.run_cell("""
            print "before"
            sg.chart{ x = {1, 2}, { y = {1, 2} }, size = {800, 500}, title = "url(#q)" }""")
        kinds = [kind for kind, _ in result.messages]
        self.assertLess(kinds.index("stream"), kinds.index("display_data"))
        chart = result.contents("display_data")[0]
        png = base64.b64decode(chart["data"]["image/png"])
        self.assertEqual(png[:4], b"\x89PNG")
        self.assertEqual([int.from_bytes(png[i:i + 4], "big") for i in (16, 20)], [800, 500])
        self.assertEqual(chart["metadata"]["image/png"], {"width": 400, "height": 250})
        self.assertTrue(chart["data"]["image/svg+xml"].startswith("<svg "))
        self.assertHolds(chart["data"]["image/svg+xml"], 'width="400" height="250"', ">url(#q)<")
        self.assertEqual(chart["data"]["text/plain"], "chart of 1 curve")
        self.assertNotIn("image/svg+xml", chart["metadata"])
        self.assertEqual(self.run_cell("tostring(_)").value, '"chart of 1 curve"')
        # Names in two charts differ, because a page contains both.
        other = self.run_cell("sg.chart{ x = {1, 2}, { y = {1, 2} } }").contents("display_data")[0]
        name = chart["data"]["image/svg+xml"].split(' id="')[1].split('"')[0]
        self.assertNotIn(f'id="{name}"', other["data"]["image/svg+xml"])
        self.assertEqual(other["metadata"]["image/png"], {"width": 720, "height": 450})

    def test_picture_of_a_model(self):
        result = self.run_cell("""
            block = sg.body{ patch = sg.shapes.rectangle{ width = 1, height = 1 }, elements = {2, 2}, order = "N2",
              material = sg.neo_hookean{ E = 1, nu = 0.3 } }
            model = sg.model{ bodies = { block = block }, supports = { bed = { on = block:face "south", fix = "xy" },
              top = { on = block:face "north", drive = "y" } } }
            run = model:run{ { name = "press", steps = 2, top = -0.1 } }
            sg.picture{ model = model, field = "uy" }""")
        progress, picture = result.contents("display_data")
        self.assertHolds(progress["data"]["text/plain"], "press: 2 steps, ")
        self.assertIn("image/png", picture["data"])
        self.assertNotIn("image/svg+xml", picture["data"])
        self.assertEqual(result.text("stderr"), "")

    def test_silent(self):
        before = self.run_cell("1").reply["execution_count"]
        result = self.run_cell("print 'quiet' x = 7\nx", silent=True)
        self.assertEqual([kind for kind, _ in result.messages], ["status", "status"])
        result = self.run_cell("error 'quiet'", silent=True)
        self.assertEqual([kind for kind, _ in result.messages], ["status", "status"])
        self.assertEqual(result.reply["status"], "error")
        after = self.run_cell("x")
        self.assertEqual((after.value, after.reply["execution_count"]), ("7", before + 1))

    def test_user_expressions(self):
        self.run_cell("_ = 'kept'")
        values = self.run_cell("x = 2", user_expressions={"double": "2 * x", "wrong": "x.y.z", "bad": "x ="}).reply[
            "user_expressions"]
        self.assertEqual(values["double"]["data"]["text/plain"], "4")
        self.assertEqual(values["wrong"]["status"], "error")
        self.assertHolds(values["wrong"]["evalue"], "user expression:1: ", "attempt to index")
        self.assertEqual(values["bad"]["status"], "error")
        self.assertEqual(self.run_cell("_").value, '"kept"')

    def test_stop_on_error(self):
        def failing(message, **options):  # a cell that fails once it gets an input: others wait by then
            request = self.kernel.client.execute(f"io.read() error '{message}'", allow_stdin=True, **options)
            self.kernel.client.get_stdin_msg(timeout=limit)
            return request

        first = failing("stop")
        second, info = self.kernel.client.execute("never = 1"), self.kernel.client.kernel_info()
        self.kernel.client.input("")
        self.assertEqual([self.kernel.reply(each)["status"] for each in (first, second, info)],
                         ["error", "aborted", "ok"])
        after = self.run_cell("rawget(_G, 'never')")
        while after.reply["status"] == "aborted":  # sent before the kernel has seen that no cell waits
            after = self.run_cell("rawget(_G, 'never')")
        self.assertEqual(after.value, "nil")
        failing("go on", stop_on_error=False)
        last = self.kernel.client.execute("1")
        self.kernel.client.input("")
        self.assertEqual(self.kernel.reply(last)["status"], "ok")

    def test_commands(self):
        self.run_cell("own = 1")
        self.assertRegex(self.run_cell("%who").text(), r"^variable +type +value\nown +number +1\n$")
        result = self.run_cell("local y = 2\n%time y * 21")
        self.assertHolds(result.text(), "wall-clock time ")
        self.assertEqual(result.value, "42")
        self.assertHolds(self.run_cell("?sg.body").text(), "Returns a solid body")
        self.assertHolds(self.run_cell("%tim 3").error, "unknown command '%tim'; did you mean '%time'?")

    def test_input(self):
        request = self.kernel.client.execute("io.write 'name? '\nname = io.read()\nn = io.read('n', 'L')", allow_stdin=True)
        for answer in ("Ada", "42", "end"):
            asked = self.kernel.client.get_stdin_msg(timeout=limit)
            self.assertEqual(asked["msg_type"], "input_request")
            self.kernel.client.input(answer)
        self.assertEqual(self.kernel.reply(request)["status"], "ok")
        self.kernel.collect(request)
        self.assertEqual(self.run_cell("name, n").value, '"Ada"\n42')
        self.assertHolds(self.run_cell("x = io.read()").error, "cell ", ":1: io.read: this front end has no input. Hint: ")
        self.assertHolds(self.run_cell("x = io.read 'a'").error, 'io.read: format must be "l", "L" or "n"')
        self.assertEqual(self.run_cell("io.stdin:read 'a'").value, '""')


class Errors(Case):
    def error(self, code):
        return self.run_cell(code).error

    def test_place(self):
        result = self.run_cell("-- a comment\nsg.body{}")
        number = result.reply["execution_count"]
        self.assertHolds(result.error, f"cell {number}:2: sg.body: patch", "is missing")
        self.assertEqual(result.reply["evalue"], result.error)
        self.assertEqual(len(result.contents("error")[0]["traceback"]), 1)

    def test_traceback_has_the_users_frames(self):
        first = self.run_cell("function outer()\n  return (sg.median{})\nend").reply["execution_count"]
        result = self.run_cell("\nouter()")
        self.assertHolds(result.error, f"cell {first}:2: sg.median")
        frames = "\n".join(result.contents("error")[0]["traceback"])
        self.assertHolds(frames, f"cell {first}:2: in function 'outer'", f"cell {first + 1}:2: in main chunk")
        self.assertNotIn(".lua:", frames)
        self.assertHolds(self.run_cell("traceback()").text(), "in field 'median'")

    def test_messages(self):
        for code, message in [
                ("x = = 2", "unexpected symbol near '='"), ("for i = 1, 2 do", "'end' expected"), ("'abc", "unfinished string"),
                ("error{ a = 1 }", "{a = 1}"), ("error()", "error without a message"), ("unknown_name", "undefined variable 'unknown_name'"),
                ("sg.bdy", "did you mean"), ("sg.median{ 'a' }", "sg.median"), ("os.exit()", "os.exit is not available in a notebook"),
                ("exit", "exit is not available in a notebook"), ("quit()", "exit is not available in a notebook"),
                ("ü = 3", "put other characters in quotes"), ("error(setmetatable({}, { __tostring = error }))", ""),
                ("string.rep('x', -1):bad()", "attempt to call"), ("local function f() return f() + 1 end f()", "stack overflow")]:
            self.assertHolds(self.error(code), message)
        self.run_cell("local short = 1")
        self.assertHolds(self.error("short"), "it was local to its cell")
        self.assertEqual(self.run_cell("1 + 1").value, "2")

    def test_a_case_shows_no_picture(self):
        with tempfile.TemporaryDirectory() as folder:
            result = self.run_cell(f"""
                local display = require "signorini.prompt.display"
                sg.study{{ name = "s", folder = "{folder}/s", cases = sg.grid{{ a = {{1}} }},
                  run = function() display.show(sg.chart{{ x = {{1, 2}}, {{ y = {{1, 2}} }} }}) return {{}} end }}:execute()""")
        self.assertHolds(result.value, "a notebook shows no pictures")


class Typing(Case):
    def complete(self, code, cursor=None):
        reply = self.kernel.ask("complete", code, cursor)
        self.assertEqual(reply["status"], "ok")
        return reply["matches"], reply["cursor_start"], reply["cursor_end"]

    def test_names(self):
        self.assertEqual(self.complete("sg.shapes.rect"), (["sg.shapes.rectangle"], 0, 14))
        self.assertEqual(self.complete("x = sg.shapes.rect(1)", 18), (["sg.shapes.rectangle"], 4, 18))
        self.run_cell("my_variable = 1")
        self.assertEqual(self.complete("my_v"), (["my_variable"], 0, 4))
        self.assertEqual(self.complete("xyz_unknown"), ([], 0, 11))
        self.assertIn("sg", self.complete("")[0])
        self.assertEqual(self.complete("sg.med", 1000), (["sg.median"], 0, 6))
        self.assertEqual(self.complete("sg.med", -1), (["sg.median"], 0, 6))

    def test_arguments_in_a_cell_of_several_lines(self):
        code = 'print("größe")\nbody = sg.body{ order = "N2",\n  mate }\nprint(1)'
        cursor = code.index("mate") + 4
        self.assertEqual(self.complete(code, cursor), (["material = "], cursor - 4, cursor))

    def test_texts_in_quotes(self):
        code = 'sg.picture{ model = model, field = "von'
        self.assertEqual(self.complete(code), (["von_mises"], len(code) - 3, len(code)))

    def test_characters_beyond_the_first_plane(self):
        code = "s = '𝛔𝛔' sg.med"
        self.assertEqual(self.complete(code), (["sg.median"], 9, 15))

    def inspect(self, code, cursor=None):
        reply = self.kernel.ask("inspect", code, cursor)
        self.assertEqual(reply["status"], "ok")
        return reply["found"] and reply["data"]

    def test_help(self):
        page = self.inspect("x = sg.median{1}", 8)
        self.assertHolds(page["text/plain"], "sg.median(numbers)", "Returns the median")
        self.assertHolds(page["text/markdown"], "### sg.median", "```lua\n")
        self.assertEqual(self.inspect("sg.median{1, 2", 14)["text/plain"], page["text/plain"])
        self.run_cell("p = sg.shapes.rectangle{ width = 3, height = 1 }")
        self.assertHolds(self.inspect("p")["text/plain"], "control points in x 0 … 3")
        self.assertHolds(self.inspect("p:refine{ elements = {2, 2} }", 4)["text/plain"], "patch:refine")
        self.assertHolds(self.inspect("p:refine{ elements = {2, 2} }", 20)["text/plain"], "patch:refine")
        for code in ("unknown_name", "", "1 + ", "p.q.r"):
            self.assertFalse(self.inspect(code), code)

    def test_completeness(self):
        def test(code):
            reply = self.kernel.ask("is_complete", code)
            return reply["status"], reply.get("indent", "")
        for code in ("x = 1", "2 + 2", "", "?sg.body", "for i = 1, 2 do end", "x = 1\nx", "local a = 1; a"):
            self.assertEqual(test(code)[0], "complete", code)
        self.assertEqual(test("x = = 1")[0], "invalid")
        self.assertEqual(test("for i = 1, 2 do"), ("incomplete", "  "))
        self.assertEqual(test("for i = 1, 2 do\n  sg.body{"), ("incomplete", "    "))
        self.assertEqual(test("f = function(a, b)"), ("incomplete", "  "))
        self.assertEqual(test("for i = 1, 2 do\n  print(i)"), ("incomplete", "  "))
        self.assertEqual(test("x = ")[0], "incomplete")


class Session(Case):
    def test_info(self):
        info = self.kernel.ask("kernel_info")
        self.assertEqual(info["status"], "ok")
        self.assertEqual((info["implementation"], info["language_info"]["name"]), ("signorini", "lua"))
        self.assertEqual(info["language_info"]["pygments_lexer"], "lua")
        self.assertTrue(info["protocol_version"].startswith("5."))

    def test_history(self):
        for code in ("first = 1", "second = 2", "first = 1"):
            self.run_cell(code)
        self.run_cell("hidden = 1", store_history=False)
        tail = self.kernel.ask("history", hist_access_type="tail", n=2)["history"]
        self.assertEqual([entry[2] for entry in tail], ["second = 2", "first = 1"])
        number = tail[0][1]
        self.assertEqual(self.kernel.ask("history", hist_access_type="range", session=0, start=number, stop=number + 1)[
            "history"], [[0, number, "second = 2"]])
        found = self.kernel.ask("history", hist_access_type="search", pattern="*first*", n=10, unique=True)["history"]
        self.assertEqual([entry[2] for entry in found], ["first = 1"])
        found = self.kernel.ask("history", hist_access_type="tail", n=1, output=True)["history"]
        self.assertEqual(found[0][2], ["first = 1", None])

    def test_comms(self):
        self.assertEqual(self.kernel.ask("comm_info"), {"comms": {}, "status": "ok"})
        message = self.kernel.client.session.msg("comm_open", {"comm_id": "1", "target_name": "none", "data": {}})
        self.kernel.client.shell_channel.send(message)
        kinds = [kind for kind, _ in self.kernel.collect(message["header"]["msg_id"])]
        self.assertEqual(kinds, ["status", "comm_close", "status"])

    def test_wrong_messages(self):
        client = self.kernel.client
        client.shell_channel.send(client.session.msg("no_such_request", {}))
        message = client.session.msg("execute_request", {"code": 3})
        client.shell_channel.send(message)
        wrong_key = client.session.clone()
        wrong_key.key = b"wrong"
        wrong_key.send(client.shell_channel.socket, "execute_request", {"code": "forged = 1"})
        self.assertEqual(self.run_cell("rawget(_G, 'forged')").value, "nil")

    def test_home_is_the_program_under_test(self):
        self.assertEqual(self.run_cell("require('signorini.core').home").value, f'"{home}"')


if __name__ == "__main__":
    unittest.main()
