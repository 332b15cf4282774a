-- The scripts that come along, as help finds and lists them: by the first sentence of their headers.

local core = require "signorini.core"

local scripts = {}

--- The comment at the beginning of a script, without its dashes.
local function header(text)
  local lines = {}
  for line in text:gmatch "([^\n]*)\n" do
    if not line:find "^%-%-" then break end
    lines[#lines + 1] = line:gsub("^%-%- ?", "", 1)
  end
  return table.concat(lines, "\n")
end

--- All that can be run, in order: { name, path, header, title }.
function scripts.all()
  local list = {}
  if not core.exists(core.home .. "/scripts") then return list end
  for _, folder in ipairs { "", "stability/" } do
    for _, file in ipairs(core.list_folder(core.home .. "/scripts/" .. folder)) do
      local path = ("%s/scripts/%s%s"):format(core.home, folder, file)
      local page = file:find "%.lua$" and header(core.read_file(path)) or ""
      if page:find "\nRun: " then
        list[#list + 1] = { name = folder .. file, path = path, header = page, title = page:match "^[^\n]*" }
      end
    end
  end
  return list
end

--- The script of a name, with or without its folder and ending; or nothing.
function scripts.of(name)
  for _, script in ipairs(scripts.all()) do
    local short = script.name:match "([^/]*)%.lua$"
    if name == script.name or name == "scripts/" .. script.name or name == short or name == short .. ".lua" then
      return script
    end
  end
end

--- Those whose headers have a word.
function scripts.with(word)
  local found = {}
  for _, script in ipairs(scripts.all()) do
    if (script.name .. "\n" .. script.header):lower():find(word:lower(), 1, true) then found[#found + 1] = script end
  end
  return found
end

return scripts
