-- Checks that no class declares more than 25 data members and functions of its own: larger ones are hard to survey.
-- Nested types, constructors, functions that override those of a base, deleted and defaulted ones, constants and type
-- names do not count.
--   build/signorini tests/architecture/classes.lua [folder of the sources]

local most = 25

--- Source without comments, literals, directives, and parameters of templates.
local function bare(source)
  return (source:gsub("//[^\n]*", ""):gsub("/%*.-%*/", ""):gsub("\\.", ""):gsub('"[^"\n]*"', '""')
    :gsub("'[^'\n]*'", "0"):gsub("\n%s*#[^\n]*", "\n"):gsub("template%s*%b<>", ""))
end

--- A statement of a class without the access specifiers before it.
local function stripped(statement)
  return (statement:gsub("%f[%w]p%l+%s*:%f[^:]", ""):gsub("^%s+", ""))
end

local types = { class = true, struct = true, enum = true, union = true }
local uncounted = { using = true, friend = true, static_assert = true, typedef = true }

--- True for the declaration of a constructor or of a function that overrides another.
local function given(text, class)
  return text:find("^explicit%s") or text:find("^" .. class .. "%s*%(") or text:find "%f[%w_]override%f[^%w_]"
    or text:find "%)%s*final%f[^%w_]" or text:find "%)%s*const%s+final%f[^%w_]"
end

--- The number of members that a statement declares: `int a, b;` are two.
local function declared(statement, class)
  local text = stripped(statement)
  if given(text, class) then return 0 end
  local word = text:match "^[%w_]+"
  if not word or types[word] or uncounted[word] or text:find "=%s*default" or text:find "=%s*delete" then return 0 end
  if text:find "%f[%w_]constexpr%f[^%w_]" and not text:find "%(" then return 0 end
  text = text:gsub("operator[^%w%s(]+", "operator"):gsub("%b<>", ""):gsub("%b<>", ""):gsub("%b()", "()")
  if text:match("^[^=]*"):find "%(" then return 1 end
  return 1 + select(2, text:gsub("%b{}", ""):gsub(",", ","))
end

--- The number of members of the class whose body follows this place.
local function members(source, place, class)
  local count, depth, statement, start = 0, 1, {}, nil
  while depth > 0 and place <= #source do
    local c = source:sub(place, place)
    if c == "{" then
      if depth == 1 then start = table.concat(statement) end
      depth = depth + 1
    elseif c == "}" then
      depth = depth - 1
      if depth == 1 then
        local text, after = stripped(start), source:match("^%s*(.)", place + 1)
        if types[text:match "^%l+"] then
          statement = {} -- a nested type
        elseif text:find "%(" and not text:find "=%s*$" and after ~= "," and after ~= "{" and after ~= ";" then
          count = count + (given(text, class) and 0 or 1) -- a function with its body
          statement = {}
        else
          statement[#statement + 1] = "{}"
        end
      end
    elseif c == ";" and depth == 1 then
      count = count + declared(table.concat(statement), class)
      statement = {}
    elseif depth == 1 then
      statement[#statement + 1] = c
    end
    place = place + 1
  end
  return count
end

--- Complaints about the classes of a source file.
local function check(file, source, wrong)
  source = bare(source)
  for kind, name, place in source:gmatch "%f[%w_](%l+)%s+([%w_]+)[^;{}()]*{()" do
    if kind == "class" or kind == "struct" then
      local count = members(source, place, name)
      if count > most then
        wrong[#wrong + 1] = ("%s: %s has %d members, at most %d are allowed: divide it by subject"):format(file, name,
          count, most)
      end
    end
  end
  return wrong
end

-- Shows that the test can fail, and what it counts.
local example = [[
/// A class; with { in a comment.
template <class T> class Example final : public Base<T> {
public:
  Example() = default;
  explicit Example(int first) : first_(first), list_{1, 2} {}
  Example(int first, int second);
  int area() const override { return 1; }
  void move(double by) final;
  struct Nested { int a, b, c; };
  int size() const { return first_; }
  template <class Visit> void each(const Visit& visit);
  bool operator==(const Example&) const = default;
  using Map = std::map<int, std::vector<int>>;
private:
  static constexpr int limit = 3;
  int first_ = 0, second_ = Base::of(1, 2);
  std::map<int, std::string> names_;
  std::vector<int> list_ = {1, 2};%s
};
]]
local function complaints(members_more)
  return #check("example", example:format(("\n  int more;"):rep(members_more)), {})
end
assert(complaints(most - 6) == 0, "a class with 25 members was rejected")
assert(complaints(most - 5) == 1, "a class with 26 members was accepted")

local wrong = {}
local files = assert(io.popen(("find '%s' -name '*.?pp' | sort"):format(arg and arg[1] or "src")))
for name in files:lines() do
  local file = assert(io.open(name))
  check(name, file:read "a", wrong)
  file:close()
end
files:close()
print(table.concat(wrong, "\n"))
os.exit(#wrong == 0 and 0 or 1)
