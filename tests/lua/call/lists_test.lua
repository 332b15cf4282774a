-- Common operations on lists.

require "check"
local lists = require "signorini.call.lists"

check.case("questions", function()
  check.equal(lists.holds({ 1, 2 }, 2), true)
  check.equal(lists.holds({}, 2), false)
  check.equal(lists.any({ 1, 2 }, function(value, i) return value == i and i == 2 end), true)
  local function first(entry) return entry[1] end
  check.equal(lists.least({ { 3 }, {}, { 1, "a" }, { 1, "b" } }, first)[2], "a")
  check.equal(lists.least({ {} }, first), nil)
  check.equal(lists.sorted_names { b = 1, a = false }, { "a", "b" })
  check.equal(lists.ranges { { 1, 5 }, { 3, -2 } }, { { 1, 3 }, { -2, 5 } })
end)

check.case("lists of others leave these as they are", function()
  local list = { 3, 1, 3 }
  check.equal(lists.map(list, function(value, i) return value * i end), { 3, 2, 9 })
  check.equal(lists.filter(list, function(value) return value == 3 end), { 3, 3 })
  check.equal(lists.unique(list), { 3, 1 })
  check.equal(lists.joined(list, {}, { 7 }), { 3, 1, 3, 7 })
  check.equal(lists.flat { { 1 }, {}, { 2, 3 } }, { 1, 2, 3 })
  check.equal(lists.joined(list) ~= list, true)
  local groups = lists.grouped(list, function(value) return value end)
  check.equal(groups, { { 3, 3 }, { 1 } })
  check.equal({ groups[1].key, groups[2].key }, { 3, 1 })
  check.equal(list, { 3, 1, 3 })
end)

check.case("tables by key", function()
  local whole = lists.merged({ a = 1, b = 2 }, nil)
  check.equal({ whole.a, whole.b }, { 1, 2 })
  whole = lists.merged({ a = 1, b = 2 }, { b = false, c = 3 })
  check.equal({ whole.a, whole.b, whole.c }, { 1, false, 3 })
end)
