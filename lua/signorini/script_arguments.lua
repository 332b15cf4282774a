-- sg.arguments: the arguments name=value that stand behind a script's name on the command line.

local core = require "signorini.core"
local arguments = require "signorini.arguments"
local argument_types = require "signorini.argument_types"
local sorted = require("signorini.lists").sorted_names

local where = "sg.arguments"

-- ── Words ────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The words of the script that calls: what its chunk was called with, by the program or by another script as a
--- function; without any, what the program was called with.
local function words_of_script()
  for level = 2, math.huge do
    local frame = debug.getinfo(level, "S")
    if not frame then return arg end
    local caller = debug.getinfo(level + 1, "f")
    if frame.what == "main" and not (caller and caller.func == require) then
      local words = {}
      while debug.getlocal(level, -1 - #words) do
        words[#words + 1] = select(2, debug.getlocal(level, -1 - #words))
      end
      return #words > 0 and words or arg
    end
  end
end

--- Ends the script with words for who typed the command: a message of one line, of which the program shows no
--- traceback (src/repl/interpreter.cpp).
local Refusal = { __name = "refused argument", without_traceback = true }
function Refusal.__tostring(refusal) return refusal.message end
local function refuse(message) error(setmetatable({ message = message }, Refusal), 0) end

-- ── What a script declares ───────────────────────────────────────────────────────────────────────────────────────────

--- The entries of one table and of another one, or of nothing, which come before those of the first.
local function joined(first, second)
  local all = {}
  for _, entries in ipairs { first, second } do
    for name, entry in pairs(entries) do all[name] = entry end
  end
  return all
end

--- The arguments of a table of defaults by name.
local function declare(defaults)
  local known = {}
  for name, given in pairs(defaults) do
    if type(name) ~= "string" or not name:find "^%a[%w_]*$" or name == "help" then
      core.fail(("%s: %s cannot be the name of an argument"):format(where, core.describe(name)))
    end
    known[name] = argument_types.argument(name, given)
  end
  return known
end

--- The argument that chooses a variant; nil when there is none.
local function chooser_of(known)
  local found
  for _, name in ipairs(sorted(known)) do
    if known[name].variants then
      if found then core.fail(("%s: both %s and %s have variants"):format(where, found.name, name)) end
      found = known[name]
    end
  end
  return found
end

--- The further arguments by variant; empty when there is no such choice.
local function declare_variants(chooser)
  local further = {}
  for variant, defaults in pairs(chooser and chooser.variants or {}) do
    if type(defaults) ~= "table" then
      arguments.reject(where, ("%s.variants.%s"):format(chooser.name, variant), "a table of arguments", defaults)
    end
    further[variant] = declare(defaults)
    if further[variant][chooser.name] or chooser_of(further[variant]) then
      core.fail(("%s: the variant %s chooses once more"):format(where, variant))
    end
  end
  return further
end

-- ── Help ─────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- "name=default" of all arguments, sorted.
local function listed(known)
  local texts = {}
  for i, name in ipairs(sorted(known)) do texts[i] = name .. "=" .. argument_types.text(known[name].default) end
  return texts
end

--- One line per argument: its default and what it must be, one below the other unless a default is very long.
local function page(known, lines)
  local most = 54
  local texts, width = listed(known), 0
  for _, text in ipairs(texts) do width = math.max(width, math.min(utf8.len(text), most)) end
  for i, name in ipairs(sorted(known)) do
    local blanks = (" "):rep(width - utf8.len(texts[i]))
    lines[#lines + 1] = ("  %s%s  %s"):format(texts[i], blanks, known[name].words)
  end
end

--- Prints all arguments and ends the program.
local function help(common, chooser, further)
  local script = arg and arg[0] and arg[0] ~= "" and arg[0] or "the script"
  local lines = { ("Arguments of %s, with their defaults:"):format(script) }
  page(common, lines)
  for _, variant in ipairs(chooser and chooser.choices or {}) do
    lines[#lines + 1] = ("with %s=%s also:"):format(chooser.name, variant)
    page(further[variant], lines)
  end
  lines[#lines + 1] = "Several values have commas in between: a,b,c."
  print(table.concat(lines, "\n"))
  os.exit(true, true)
end

-- ── Reading ──────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The texts of words name=value by name, the later of two; and the first word that does not look like this.
local function split(words)
  local texts, odd = {}, nil
  for _, word in ipairs(words) do
    local name, text = word:match "^([%w_]+)=(.*)$"
    if name then texts[name] = text else odd = odd or word end
  end
  return texts, odd
end

local function refuse_value(argument, text, part)
  local meant = argument.choices and argument.type == "text" and core.nearest(part, argument.choices)
  refuse(("%s must be %s, got %s%s"):format(argument.name, argument.words,
    text == "" and "nothing" or part == text and ("'%s'"):format(text) or ("'%s' in '%s'"):format(part, text),
    meant and ("; did you mean '%s'?"):format(meant) or ""))
end

--- An argument's value: the default, or what was given for it.
local function value_of(argument, text)
  if text == nil then
    local default = argument.default
    return argument.list and table.move(default, 1, #default, 1, {}) or default
  end
  local value, wrong = argument_types.read(argument, text)
  if wrong then refuse_value(argument, text, wrong) end
  return value
end

--- Refuses a word whose name is none of the known ones. `scope`: how the known ones came to be known, `also`: which
--- variants know it.
local function refuse_word(word, known, scope, also)
  local name = word:match "^([%w_]+)="
  local meant = name and #also == 0 and core.nearest(name, sorted(known))
  refuse(("unknown argument '%s'%s%s; %sknown%s: %s"):format(word, name and "" or ": arguments look like name=value",
    #also > 0 and (", which belongs to %s"):format(table.concat(also, ", ")) or "",
    meant and ("did you mean '%s'? "):format(meant) or "", scope, table.concat(listed(known), ", ")))
end

--- Refuses words that mean no known argument.
local function check_words(texts, odd, known, chooser, further, variant)
  local scope = chooser and (" with %s=%s"):format(chooser.name, variant) or ""
  if odd then refuse_word(odd, known, scope, {}) end
  for _, name in ipairs(sorted(texts)) do
    local also = {}
    for _, other in ipairs(chooser and chooser.choices or {}) do
      if further[other][name] then also[#also + 1] = ("%s=%s"):format(chooser.name, other) end
    end
    if not known[name] then refuse_word(("%s=%s"):format(name, texts[name]), known, scope, also) end
  end
end

--- Calls the script's own checks of a value, or of each entry of a list, when all values are known.
local function run_check(argument, options, text)
  local value = options[argument.name]
  for _, entry in ipairs(argument.list and value or { value }) do
    if not argument.check(entry, options) then
      local part = argument_types.text(entry)
      refuse_value(argument, text or argument_types.text(value), part)
    end
  end
end

core.docs["sg.arguments"] = [[
sg.arguments{ <name> = default, <name> = { default, <restriction> = … }, … }
The arguments name=value that stand behind a script's name on the command line, as a table of values by name. The
default gives the type: a whole number (10; of at least 1 unless it is told otherwise), a number (2.5, 100.0), a text,
true or false (yes or no on the command line), or a list of numbers or of texts (values with commas in between).
Restrictions, of a list's entries where the default is a list: { {"m1"}, choices = {"m1", "m2"} }
choices:  a list of what it may be
at_least, above, at_most, below: limits of a number
none:     true: the word none stands for the empty list
check:    a function of the value (or entry) and of all values, which returns whether it is good; with
expected: what check asks for, in words that follow "must be"
variants: further arguments by variant: variant = { "plain", variants = { plain = {…}, deep = { depth = 0.5 } } }; those
          of a variant go before those that all have
What cannot be understood ends the script with one line that says what came and what was expected; the word help or
--help prints all arguments with their defaults and ends the program. A script that is called as a function takes the
words of the call; sg.arguments(defaults, words) those of a list.
Example: options = sg.arguments{ labels = {"N2", "N4"}, steps = 10, penalty = { 100.0, above = 0 },
                                  out = "out/study" }]]
return function(defaults, words)
  if type(defaults) ~= "table" then arguments.reject(where, "its argument", "a table of defaults", defaults) end
  if words == nil then words = words_of_script() end
  if type(words) ~= "table" then arguments.reject(where, "words", "a list of words name=value", words) end
  for i, word in ipairs(words) do arguments.string(where, ("words[%d]"):format(i), word) end

  local common = declare(defaults)
  local chooser = chooser_of(common)
  local further = declare_variants(chooser)
  for _, word in ipairs(words) do
    if word == "help" or word == "--help" then help(common, chooser, further) end
  end
  local texts, odd = split(words)
  local variant = chooser and value_of(chooser, texts[chooser.name])
  local known = joined(common, chooser and further[variant])
  check_words(texts, odd, known, chooser, further, variant)
  local options = {}
  for _, name in ipairs(sorted(known)) do options[name] = value_of(known[name], texts[name]) end
  for _, name in ipairs(sorted(known)) do
    if known[name].check then run_check(known[name], options, texts[name]) end
  end
  return options
end
