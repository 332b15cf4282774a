-- CSV files: what is written is read back, files are written atomically, invalid input is reported.

require "check"

local folder = check.folder()
local file = folder .. "/a.csv"

local function write_text(text) core.write_file(file, text) end

check.case("rows, comments and special values are preserved", function()
  local rows = { { 1, 0.1, "N2" }, { 2, nil, 'a,"b"\nc' }, { 3, 1 / 3, "2" }, { -4, 1e300, " edges " },
                 { 5, 2 ^ -1074, "#5" }, { 6, true, "true" }, { math.maxinteger, false, "ξ" } }
  sg.csv.write(file, { columns = { "step", "fx", "label" }, rows = rows, comments = { "source: a test", "one\ntwo" } })
  local read = sg.csv.read(file)
  check.equal(read.columns, { "step", "fx", "label" })
  check.equal(read.comments, { "source: a test", "one two" })
  check.equal(#read.rows, #rows)
  for i, row in ipairs(rows) do
    for j = 1, 3 do
      check.equal(read.rows[i][j], row[j])
      check.equal(math.type(read.rows[i][j]), math.type(row[j]))
    end
  end
  check.equal(read:column "step", { 1, 2, 3, -4, 5, 6, math.maxinteger })
  check.equal(read:by("label")["2"].fx, 1 / 3)
end)

check.case("texts that spreadsheets would read as formulas are texts there and read back", function()
  local names = { "=1+2", "+mu", "-end", "@SUM(A1)", "'=quoted", "''@", "=a,\"b\"", "-5", "-", "'plain'", "\t=1" }
  local columns = { "=name", "value" }
  sg.csv.write(file, { columns = columns, rows = require("signorini.call.lists").map(names, function(name, i)
    return { name, -(i or 1) }
  end) })
  local read = sg.csv.read(file)
  check.equal(read:column "=name", names)
  check.equal(read.columns, columns)
  local text = core.read_file(file)
  for line in text:gmatch "[^\n]+" do
    local cell = line:gsub('^"', "")
    check.equal({ line, cell:find "^[=@]", cell:find "^[+-][^,]" }, { line })
  end
  check.holds(text, '\n"\'=1+2",-1\n') -- and numbers stay numbers
end)

check.case("random numbers are preserved to the last bit", function()
  math.randomseed(7)
  local numbers = {}
  for i = 1, 200 do numbers[i] = (math.random() - 0.5) * 10 ^ math.random(-200, 200) end
  sg.csv.write(file, { columns = { "x" }, x = numbers })
  check.equal(sg.csv.read(file):column "x", numbers)
end)

check.case("named lists are columns, in the order asked for or of their names", function()
  sg.csv.write(file, { b = { 1, 2 }, a = { 3, 4.5 }, columns = { "b", "a" } })
  check.equal(core.read_file(file), "b,a\n1,3\n2,4.5\n")
  sg.csv.write(file, { b = { 1 }, a = { "x" } })
  check.equal(core.read_file(file), "a,b\nx,1\n")
end)

check.case("columns need names, rows no more values than there are columns", function()
  check.fails(function() sg.csv.write(file, { columns = { "" }, rows = { { 1 } } }) end, "csv_test.lua",
    "columns[1] must be a name")
  check.fails(function() sg.csv.write(file, { columns = { "a" }, rows = { { 1 }, { 1, 2 } } }) end,
    "rows[2] has an entry '2', but there is 1 column")
  sg.csv.write(file, { columns = { "a", "b" }, rows = { { 1, "" }, { 2 } } })
  check.equal(core.read_file(file), "a,b\n1,\"\"\n2,\n")
  check.equal(sg.csv.read(file):column "b", { nil, nil })
end)

check.case("aligned tables show all kinds of cells, and no more than there are columns", function()
  check.equal(sg.table{ columns = { "a" }, rows = { { 1 }, {}, { "x" }, { true } } }, "   a\n   1\n   –\n   x\ntrue")
  check.fails(function() sg.table{ columns = { "a" }, rows = { { {} } } } end, "csv_test.lua",
    "sg.table: rows[1][1] must be a number, a string, true or false, got an empty table")
  check.fails(function() sg.table{ columns = { "a" }, rows = { { 2, 3 } } } end,
    "rows[1] has an entry '2', but there is 1 column")
end)

check.case("an unknown published table: the message lists the known ones", function()
  check.fails(function() sg.reference "rings2d_error_table" end, "csv_test.lua",
    "sg.reference: there is no table 'rings2d_error_table'",
    "did you mean 'rings2d_error_table7_5'?", "hertz2d_dofs_table7_4, ironing2d_dofs_table7_2, ")
end)

check.case("files from elsewhere: byte-order mark, carriage returns, blanks, blank lines, no last line break",
  function()
  write_text "\xEF\xBB\xBF# from a spreadsheet\r\nname , value\r\n\r\n\"x, y\" , 2\r\nz,"
  local ok, message = pcall(sg.csv.read, file)
  check.equal(ok, false)
  check.holds(message, "a.csv:4: a comma must follow a quoted field, got ' '")
  write_text "\xEF\xBB\xBF# from a spreadsheet\r\nname , value\r\n\r\n\"x, y\",2\r\nz,"
  local read = sg.csv.read(file)
  check.equal(read.columns, { "name", "value" })
  check.equal(read.rows[1], { "x, y", 2 })
  check.equal(read.rows[2][1], "z")
  check.equal(read.rows[2][2], nil)
end)

check.case("invalid tables are not written, and the old file remains", function()
  sg.csv.write(file, { a = { 1 } })
  local wrong = {
    { { columns = { "a" }, rows = { { 0 / 0 } } }, "row 1, column 'a'", "nan", "use nil for a value that" },
    { { columns = { "a" }, rows = { { math.huge } } }, "infinity" },
    { { columns = { "a" }, rows = { { 1, 2 } } }, "rows[1] has an entry '2', but there is 1 column" },
    { { columns = { "a" }, rows = { { a = 1 } } }, "an entry 'a'" },
    { { columns = { "a" }, rows = { { {} } } }, "must be a number, a string" },
    { { columns = { "a", "a" }, rows = {} }, "the column 'a' occurs twice" },
    { { rows = { { 1 } } }, "columns is missing" },
    { { a = { 1 }, b = { 1, 2 }, columns = { "a", "b" } }, "'b' has 2 values, the column 'a' has 1" },
    { { a = { 1 }, columns = { "a", "c" } }, "'c' has no list of values" },
  }
  for _, case in ipairs(wrong) do
    check.fails(function() sg.csv.write(file, case[1]) end, "csv_test.lua:", "sg.csv.write: ", table.unpack(case, 2))
  end
  check.equal(core.read_file(file), "a\n1\n")
  check.fails(function() sg.csv.write(folder .. "/none/a.csv", { a = { 1 } }) end, "csv_test.lua:",
    "sg.csv.write: cannot write '" .. folder .. "/none/a.csv'",
    'Hint: create it first, sg.mkdir "' .. folder .. '/none"')
  check.fails(function() sg.csv.write(folder, { a = { 1 } }) end, "cannot write")
  check.equal(io.open(folder .. ".part"), nil)
end)

check.case("invalid files are rejected with file and line", function()
  local broken = {
    { "a,b\n1,2\n3\n", "a.csv:3: 1 field, but there are 2 columns" },
    { "a\n\"1\n", "a.csv:2: a quoted field is not closed" },
    { "a,a\n", "a.csv:1: the column 'a' occurs twice" },
    { "a,,b\n", "a.csv:1: column 2 has no name" },
    { "# only a comment\n", "does not contain a table" },
  }
  for _, case in ipairs(broken) do
    write_text(case[1])
    check.fails(function() sg.csv.read(file) end, "csv_test.lua:", "sg.csv.read: ", case[2])
  end
  check.fails(function() sg.csv.read(folder .. "/none.csv") end, "cannot read", "none.csv")
  check.fails(function() sg.csv.read(folder) end, "sg.csv.read")
  write_text "a,force\n1,2\n"
  check.fails(function() sg.csv.read(file):column "b" end, "no column 'b'; known: a, force")
  check.fails(function() sg.csv.read(file):column "forse" end,
    "no column 'forse'; did you mean 'force'? known: a, force")
end)

check.case("published tables name their source", function()
  local sizes = { ironing2d_dofs_table7_2 = 8, ironing2d_oscillation_table7_3 = 8, hertz2d_dofs_table7_4 = 21,
                  rings2d_error_table7_5 = 8, rings2d_time_table7_6 = 8, peeling2d_table7_8_and_B2 = 39,
                  ironing3d_oscillation_table7_10 = 8, ironing3d_dofs_table7_11 = 8 }
  for name, rows in pairs(sizes) do
    local published = sg.reference(name)
    check.equal(#published.rows, rows)
    check.holds(published.comments[1], "source: V. Agrawal", "Table")
  end
  local dofs = sg.reference "ironing2d_dofs_table7_2":by "discretization"
  check.equal(dofs["N2-N6"].die_interface, 34)
  for _, row in pairs(dofs) do check.equal(row.die_total + row.slab_total, row.total) end
  check.fails(function() sg.reference "table9" end, "table9")
end)

check.case("text tables: numbers right-aligned, words left-aligned, a dash for missing values", function()
  check.equal(sg.table{
    columns = { "label", "Δ", "n" }, units = { "", "%" }, formats = { ["Δ"] = "%.1f" },
    rows = { { "N2", 100, 7 }, { "N2-N4", nil, 12 } },
  }, "label      Δ   n\n           %\nN2     100.0   7\nN2-N4      –  12")
end)
