-- A word of a shell command, in quotes.

return function(word) return "'" .. tostring(word):gsub("'", [['\'']]) .. "'" end
