-- Types of arguments, as the tables of the functions name them (signorini.pages): plain data { kind, … }, by which
-- check.lua reads values and which describe.lua puts into words. words, several: such words, where a type has better
-- ones than its kind. cures of named arguments: what to do, by the kind of object that stands in their place.

local merged = require("signorini.lists").merged

local types = {
  any = { kind = "any" },
  flag = { kind = "flag" },
  text = { kind = "text" },
  data = { kind = "data" }, -- what can be kept in a file: numbers, strings, true, false, tables of these
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

--- A text that Tab completes from a list, or from what a function of the object that the method is called on returns;
--- `noun`: what messages call it.
function types.name(of, noun) return { kind = "text", of = of, noun = noun } end

--- A text that Tab completes from the columns of a study: of the one that a method is called on, or of the argument
--- before.
types.column = { kind = "text", noun = "column",
                 of = function(study) return require("signorini.study.values").columns(study) end }

--- This value alone.
function types.only(value) return { kind = "only", value = value } end

--- An object of the language: "patch", "body", "run".
function types.object(name) return { kind = "object", name = name } end

--- A list of entries of one type; as many as `size`, or at least as many as `least`, where given.
function types.list(of, size, least) return { kind = "list", of = of, size = size, least = least } end

--- A list of entries of one type, or a single one of them without braces, which becomes a list of one.
function types.one_or_more(of) return { kind = "list", of = of, least = 1, single = true } end

--- A list of numbers; `gaps`: nan and infinity are allowed.
function types.numbers(size, gaps) return types.list({ kind = "number", gaps = gaps }, size) end

--- Values of these types in order, of which the first `least` are needed: {1, "m1"}.
function types.tuple(of, least) return { kind = "tuple", of = of, least = least } end

--- {low, high}, which rise.
types.interval = { kind = "tuple", of = { types.number, types.number }, least = 2, rising = true,
                   words = "a list of 2 rising numbers {low, high}" }

--- A table of named arguments: rows, as a function has them, or the name of a page that has them. `rest`: the type of
--- what has another key than these; by default such keys are errors. `names`: a function of the object that the method
--- is called on, which returns these other keys for Tab.
function types.named(rows, rest, names) return { kind = "named", rows = rows, rest = rest, names = names } end

--- The last argument of a function that takes others by place: named arguments, which messages name without its own
--- name. It may be left out where none of them is needed.
function types.options(rows, rest) return { kind = "named", rows = rows, rest = rest, last = true } end

--- A table whose keys are names of the user's own, with values of one type.
function types.map(of, least) return { kind = "map", of = of, least = least } end

--- A table of named arguments, in place of which the value of one of them, a row, may stand.
function types.short(rows, row) return { kind = "named", rows = rows, short = row } end

--- A value of a type, or true, which stands for the value `on`, or false for none.
function types.switch(of, on) return { kind = "switch", of = of, on = on } end

--- Any table; `words`: what it stands for.
function types.table(words, cure) return { kind = "table", words = words, cure = cure } end

--- A type as messages and help shall call it; `several`: what they call several of it.
function types.worded(of, words, several) return merged(of, { words = words, several = several }) end

--- A value of one of several types; the first that fits is taken.
function types.either(...) return { kind = "either", ... } end

--- A type that follows from the call: help, Tab and the tests see `general`, the call is checked against the type that
--- special(owner, given, raw) returns, or against `general` where that is nil. owner: the object that a method is
--- called on; given: the named arguments of the rows before; raw: all of them, unchecked.
function types.by(general, special) return merged(general, { special = special }) end

--- A point or vector with as many coordinates as the argument `key` of a row before.
function types.point_like(key)
  return types.by(types.point, function(_, given)
    return #given[key] == 2 and types.plane_point or types.space_point
  end)
end

return types
