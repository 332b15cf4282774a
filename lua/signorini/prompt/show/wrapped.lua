--- Words in lines of at most `width` characters: `first` precedes the first word, `indent` those of further lines.
return function(words, width, first, indent)
  local lines, line, is_empty = {}, first, true
  for _, word in ipairs(words) do
    local size = utf8.len(word) or #word
    if not is_empty and (utf8.len(line) or #line) + 1 + size > width then
      lines[#lines + 1], line, is_empty = line, indent, true
    end
    line, is_empty = line .. (is_empty and "" or " ") .. word, false
  end
  lines[#lines + 1] = line:match "^(.-)%s*$"
  return lines
end
