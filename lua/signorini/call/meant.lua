local nearest = require("signorini.core").nearest

--- The end of a message about an unknown name: "; did you mean 'refine'?", or an empty string.
return function(name, known)
  local meant = type(name) == "string" and nearest(name, known)
  return meant and ("; did you mean '%s'?"):format(meant) or ""
end
