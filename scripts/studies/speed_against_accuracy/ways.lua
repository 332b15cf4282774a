-- Where a discretization has its layer: "N2-N2.2" on whole faces, "N2-N2.2 following" where its problem says.

--- The order label of "N2-N2.2 following", and the value of its word in `ways`; {} without a word.
return function(label, ways)
  local order, word = label:match "^(%S+) ?(%S*)$"
  return order, ways[word] or word == "" and {} or error(("there is no '%s' layer in '%s'"):format(word, label), 0)
end
