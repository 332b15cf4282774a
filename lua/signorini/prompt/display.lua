-- Shows pictures: in the terminal, or where a front end such as a notebook wants them.

local core = require "signorini.core"
local merged = require("signorini.call.lists").merged
local on_behalf_of = require "signorini.call.on_behalf_of"

local display = {}

--- A front end sets this to a function that shows a picture; nil: pictures go to the terminal.
display.screen = nil

local obstacles = {
  no_terminal = "the output is not a terminal",
  turned_off = "--pictures=none turns pictures in the terminal off",
  dumb = "a terminal with TERM = dumb, or without TERM, shows no pictures",
  no_library = "this terminal shows pictures by signorini_terminal.so, which is missing (install libchafa-dev and "
    .. "libsixel-dev, then configure and build again)",
}

--- Shows a picture and returns true, or returns false and the reason. Errors name the function `name`, if given.
function display.show(picture, name)
  if display.screen then
    display.screen(picture)
    return true
  end
  local obstacle = core.screen_obstacle()
  if obstacle then return false, obstacles[obstacle] end
  on_behalf_of(name or "picture", "core.show_picture", core.show_picture, picture)
  return true
end

--- Shows a picture for the user's call of a function; an error unless it can be shown or is in a file.
local function show_or_fail(name, picture, hint)
  local shown, reason = display.show(picture, name)
  if not shown and not core.picture_file(picture) then
    core.fail(("%s: file is needed, because %s. Hint: %s"):format(name, reason, hint))
  end
end

--- picture:show().
function display.show_picture(picture)
  show_or_fail("picture:show", picture, 'write picture:write "x.png", or make the picture with file = "x.png"')
end

--- The method `show` of a model, a state or a patch: sg.picture of it, with options, shown.
function display.show_object(kind, object, options)
  local name = kind .. ":show"
  local picture = on_behalf_of(name, "sg.picture", core.sg.picture, merged(options, { [kind] = object }))
  show_or_fail(name, picture, ('write %s{ file = "%s.png" }'):format(name, kind))
end

return display
