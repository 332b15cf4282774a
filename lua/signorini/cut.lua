--- A text with at most so many characters: what is cut off is a sign of omission.
return function(text, most)
  if (utf8.len(text) or #text) <= most then return text end
  return text:sub(1, (utf8.offset(text, most) or most) - 1) .. "…"
end
