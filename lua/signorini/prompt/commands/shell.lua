-- !command: runs a command of the shell. On a terminal it has the terminal, so that editors and pagers work; elsewhere
-- its output goes where print's goes.

local core = require "signorini.core"

--- Runs a command whose output is written as it comes.
local function piped(command)
  local pipe = assert(io.popen(("{ %s\n} 2>&1"):format(command)))
  for line in pipe:lines "L" do io.write(line):flush() end
  return pipe:close()
end

return function(command)
  if command == "" then core.fail "! must be followed by a command of the shell. Hint: !ls" end
  if command:find "^cd%f[%s\0]" then
    core.fail(("!%s changes the folder of a shell that ends with the command. Hint: start signorini in that folder, or "
      .. "write paths from %s"):format(command, core.directory))
  end
  io.stdout:flush()
  local run = core.interactive and os.execute or piped
  local _, how, status = run(command)
  if how == "signal" then print((core.interactive and "\n" or "") .. "ended by signal " .. status) end -- after ^C
  if how == "exit" and status ~= 0 then print("exit status " .. status) end
end
