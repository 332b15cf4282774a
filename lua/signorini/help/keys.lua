-- The named arguments of a function, read off the first lines of its help page: name{ key, key = default, … }, or
-- name(first, { key, … }); lists of values are written without blanks, {x, y}.

local keys = {}

--- Adds to a list what begins the entries of a table as it is written, "{ a, b = {1, 2}, c or d }".
function keys.add(list, text)
  local plain = text:sub(2, -2):gsub('"[^"]*"', ""):gsub("%b{}", ""):gsub("%b()", "")
    :gsub("function.-%f[%w]end%f[%W]", "")
  for entry in (plain .. ","):gmatch "([^,]*)," do
    for _, key in ipairs { entry:match "^%s*([%a_][%w_]*)", entry:match "^%s*[%w_]+ or ([%a_][%w_]*)" } do
      if not list[key] then list[key], list[#list + 1] = true, key end
    end
  end
end

--- The list of named arguments that a page's head shows, in its order; none when the function takes no table of them.
function keys.of_page(page)
  local list = {}
  local call, rest = page:match "^([%w_.:]+)(.*)$"
  local form = call and (rest:match "^%b{}" or (rest:match "^%b()" or ""):match "%b{}")
  if form and form:find "^{ " then keys.add(list, form) end
  for other in (call and rest:match "^[^\n]*" or ""):gmatch(", in 3D [%w_.:]+(%b{})") do keys.add(list, other) end
  return list
end

return keys
