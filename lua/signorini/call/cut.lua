--- Shortens a text to a number of characters, with an ellipsis in place of the rest.
return function(text, most)
  if (utf8.len(text) or #text) <= most then return text end
  return text:sub(1, (utf8.offset(text, most) or most) - 1) .. "…"
end
