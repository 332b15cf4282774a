-- Types of arguments, as used in the tables of the functions (signorini.pages): plain data { kind, … }, against which
-- check.lua checks values, and which describe.lua puts into words. words, several: such words, where the kind's are not
-- specific. cures of named arguments: hints by the kind of object that was given in their place.

local merged = require("signorini.call.lists").merged

local types = {
  any = { kind = "any" },
  flag = { kind = "flag" },
  text = { kind = "text" },
  data = { kind = "data" }, -- can be written to a file: numbers, strings, true, false, tables of these
  cells = { kind = "cells" }, -- a row of a table, with nil where a value is missing
  rows = { kind = "rows" }, -- rows of a table, which may have names as well
  callback = { kind = "function" },
  number = { kind = "number" },
  positive = { kind = "number", above = 0 },
  non_negative = { kind = "number", low = 0 },
  share = { kind = "number", above = 0, high = 1 },
  count = { kind = "integer", low = 1 },
  point = { kind = "point", low = 2, high = 3 },
  plane_point = { kind = "point", low = 2, high = 2 },
  space_point = { kind = "point", low = 3, high = 3 },
  points = { kind = "points" },
}

--- A number from `low` to `high`; nil for no limit.
function types.range(low, high) return { kind = "number", low = low, high = high } end

--- A whole number from `low` to `high`; nil for no limit.
function types.integer(low, high) return { kind = "integer", low = low, high = high } end

--- One of a list of texts.
function types.choice(of) return { kind = "choice", of = of } end

--- A string that Tab completes from a list, or from the result of a function of the object on which the method is
--- called; `noun`: its name in messages.
function types.name(of, noun) return { kind = "text", of = of, noun = noun } end

--- A string that Tab completes from the columns of a study: of that on which a method is called, or of the argument
--- before.
types.column = { kind = "text", noun = "column",
                 of = function(study) return require("signorini.study.values").columns(study) end }

--- This value alone.
function types.only(value) return { kind = "only", value = value } end

--- An object of the library: "patch", "body", "run".
function types.object(name) return { kind = "object", name = name } end

--- A list of entries of one type; exactly `size` or at least `least`, if given.
function types.list(of, size, least) return { kind = "list", of = of, size = size, least = least } end

--- A list of entries of one type that may have entries with names, rows, too.
function types.list_with(of, fields) return { kind = "list", of = of, least = 1, fields = fields } end

--- A list of entries of one type or of lists of these, or a single one.
function types.flat(of) return { kind = "list", of = of, least = 1, single = true, flat = true } end

--- A list of entries of one type, or a single one without braces, which becomes a list of one.
function types.one_or_more(of) return { kind = "list", of = of, least = 1, single = true } end

--- A list of numbers; `gaps`: nan and infinity are allowed.
function types.numbers(size, gaps) return types.list({ kind = "number", gaps = gaps }, size) end

--- Values of these types in order, of which the first `least` are required: {1, "m1"}.
function types.tuple(of, least) return { kind = "tuple", of = of, least = least } end

--- {low, high}, increasing.
types.interval = { kind = "tuple", of = { types.number, types.number }, least = 2, rising = true,
                   words = "a list of 2 increasing numbers {low, high}" }

--- A table of named arguments: rows, as a function has them, or the name of a page with rows. `rest`: the type of
--- entries with other keys; by default these are errors. `names`: a function of the object on which the method is
--- called, which returns these other keys for Tab.
function types.named(rows, rest, names) return { kind = "named", rows = rows, rest = rest, names = names } end

--- The last argument of a function with positional arguments: named arguments, which messages name without a prefix. It
--- may be omitted if none of them is required. `or_result_of`: the page of a function whose result can be given as it
--- is, for editors.
function types.options(rows, rest, or_result_of)
  return { kind = "named", rows = rows, rest = rest, last = true, or_result_of = or_result_of }
end

--- A table with any names as keys and values of one type.
function types.map(of, least) return { kind = "map", of = of, least = least } end

--- A table of named arguments, or the value of one of them, a row.
function types.short(rows, row) return { kind = "named", rows = rows, short = row } end

--- A value of a type, or true for the value `on`, or false for none.
function types.switch(of, on) return { kind = "switch", of = of, on = on } end

--- Any table; `words`: its description.
function types.table(words, cure) return { kind = "table", words = words, cure = cure } end

--- A type with its description for messages and help; `several`: the plural.
function types.worded(of, words, several) return merged(of, { words = words, several = several }) end

--- A value of one of several types; the first that fits is used.
function types.either(...) return { kind = "either", ... } end

--- A type that depends on the call: help, Tab and the tests use `general`; the call is checked against the type that
--- special(owner, given, raw) returns, or against `general` if that is nil. owner: the object on which a method is
--- called; given: the named arguments of the rows before; raw: all of them, unchecked. every: a type that covers all of
--- these, if `general` does not, for editors.
function types.by(general, special, every) return merged(general, { special = special, every = every }) end

--- A point or vector with as many coordinates as the argument `key` of a row before.
function types.point_like(key)
  return types.by(types.point, function(_, given)
    return #given[key] == 2 and types.plane_point or types.space_point
  end)
end

-- ── Results and callbacks ────────────────────────────────────────────────────────────────────────────────────────────

--- A table with these fields, as a result: names and their type in turn, record("from to", t.number, "why?", t.text); a
--- name with a question mark may be missing.
function types.record(...)
  local rows, given = {}, { ... }
  for i = 1, #given, 2 do
    for name in given[i]:gmatch "%S+" do
      rows[#rows + 1] = { name:match "^[^?]*", given[i + 1], optional = name:find("?", 1, true) ~= nil }
    end
  end
  return { kind = "named", rows = rows, is_result = true }
end

--- A table with these fields among others.
function types.with_fields(...) return merged(types.record(...), { rest = types.any }) end

--- A result, or an entry of a table that a script fills, that may be nil.
function types.or_nil(of) return merged(of, { may_be_nil = true }) end

--- A function: rows of its parameters, { name, type }, and the types of its results.
function types.callback_of(takes, ...) return { kind = "function", takes = takes, gives = { ... } } end

--- A function of a row or a case of a study, a table by name.
function types.of_row(...) return types.callback_of({ { "row", types.map(types.any) } }, ...) end

return types
