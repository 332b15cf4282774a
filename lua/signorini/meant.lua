local nearest = require("signorini.core").nearest

--- The end of a message about a name that is none of the known ones: "; did you mean 'refine'?", or nothing.
return function(name, known)
  local meant = type(name) == "string" and nearest(name, known)
  return meant and ("; did you mean '%s'?"):format(meant) or ""
end
