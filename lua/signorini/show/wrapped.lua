-- Many short texts in lines.

local width = 100 -- characters of a line

--- Texts with commas between them, in lines of at most so many characters that begin with an indentation.
return function(texts, indent)
  local lines, line, length = {}, nil, nil
  for i, text in ipairs(texts) do
    local piece = text .. (i < #texts and "," or "")
    local size = utf8.len(piece) or #piece
    if line and length + 1 + size <= width then
      line, length = line .. " " .. piece, length + 1 + size
    else
      lines[#lines + 1] = line
      line, length = indent .. piece, #indent + size
    end
  end
  lines[#lines + 1] = line
  return table.concat(lines, "\n")
end
