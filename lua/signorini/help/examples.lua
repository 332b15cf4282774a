-- The examples on a help page: what follows "Example: ", with the lines below that are indented as far.

local indent = "         "

--- A page's text without its examples, and the list of their code.
return function(page)
  local texts, codes, inside = {}, {}, false
  for line in (page .. "\n"):gmatch "([^\n]*)\n" do
    local first = line:match "^Example: (.*)$"
    if first then
      codes[#codes + 1], inside = first, true
    elseif inside and line:sub(1, #indent) == indent then
      codes[#codes] = codes[#codes] .. "\n" .. line:sub(#indent + 1)
    else
      texts[#texts + 1], inside = line, false
    end
  end
  return table.concat(texts, "\n"), codes
end
