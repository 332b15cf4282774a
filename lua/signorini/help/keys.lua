-- The named arguments of a function, read off the first lines of its help page: name{ key, key = default, … }, or
-- name(first, { key, … }); lists of values are written without blanks, {x, y}.

--- Adds what begins the entries of a table as it is written, "{ a, b = {1, 2}, c or d }".
local function add_keys(keys, text)
  local plain = text:sub(2, -2):gsub('"[^"]*"', ""):gsub("%b{}", ""):gsub("%b()", "")
    :gsub("function.-%f[%w]end%f[%W]", "")
  for entry in (plain .. ","):gmatch "([^,]*)," do
    for _, key in ipairs { entry:match "^%s*([%a_][%w_]*)", entry:match "^%s*[%w_]+ or ([%a_][%w_]*)" } do
      if not keys[key] then keys[key], keys[#keys + 1] = true, key end
    end
  end
end

--- The list of named arguments that a page's head shows, in its order; none when the function takes no table of them.
return function(page)
  local keys = {}
  local call, rest = page:match "^([%w_.:]+)(.*)$"
  local form = call and (rest:match "^%b{}" or (rest:match "^%b()" or ""):match "%b{}")
  if form and form:find "^{ " then add_keys(keys, form) end
  for other in (call and rest:match "^[^\n]*" or ""):gmatch(", in 3D [%w_.:]+(%b{})") do add_keys(keys, other) end
  return keys
end
