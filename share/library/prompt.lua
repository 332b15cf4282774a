---@meta _
-- Generated from the help pages by scripts/reference; read by editors, not by the program.
-- Globals of the prompt and of code given by -e; scripts begin with: local sg = require "signorini"

sg = require "signorini"



---Shows the page of a function: arguments with units and defaults, and an example; a word finds all pages and scripts
---that contain it, and common terms of other programs. help "scripts" lists the supplied scripts, help "hertz2d.lua"
---shows what one of them solves. At the prompt ?sg.nurbs.arc and ?refine do the same.
---
---```text
---help(), help(sg.nurbs.arc), help "patch:refine", help "orders"
---```
---
---Example:
---```lua
---help(sg.nurbs.arc)
---```
---@param what? any|string # what: function, value or word (any value or a string; optional)
function help(what) end

---Shows the traceback of the last error at the prompt: the functions that were being called.
---
---```text
---traceback()
---```
function traceback() end
