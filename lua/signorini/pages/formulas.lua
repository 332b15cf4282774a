-- Pages: functions of numbers and symbols.

local t = require "signorini.call.types"

local x = { { "x", t.worded(t.either(t.number, t.object "symbol"), "a number or a symbol"), "" } }

local function page(name, text, example)
  return { "sg." .. name, ("Returns %s of a number, or the formula of it if the argument is a symbol."):format(text),
           arguments = x, returns = t.either(t.number, t.object "symbol"), example = example }
end

local pair = { { "a", x[1][2], "" }, { "b", x[1][2], "" } }

local function extreme(name, text, example)
  return { "sg." .. name, ("Returns the %s of two numbers, or the formula of it if one is a symbol."):format(text),
           arguments = pair, returns = t.either(t.number, t.object "symbol"), example = example }
end

return {
  title = "Formulas", word = "formulas",
  { "symbol", [[An argument of a function that is called once to read its formula, as in sg.hyperelastic; numbers and
symbols combine to formulas with + - * / ^ and the functions below. Functions of contacts, such as friction.mu, receive
their arguments by name: their parameters are those that they need, in any order. Those of sg.hyperelastic and
sg.rigid.level_set receive them by position. print(symbol) shows the formula.]] },
  page("log", "the natural logarithm", "sg.log(1)  --> 0.0"),
  page("exp", "the exponential function", "sg.exp(0)  --> 1.0"),
  page("sqrt", "the square root", "sg.sqrt(4)  --> 2.0"),
  page("sin", "the sine", "sg.sin(0)  --> 0.0"),
  page("cos", "the cosine", "sg.cos(0)  --> 1.0"),
  page("tan", "the tangent", "sg.tan(0)  --> 0.0"),
  page("atan", "the inverse tangent", "sg.atan(0)  --> 0.0"),
  page("sinh", "the hyperbolic sine", "sg.sinh(0)  --> 0.0"),
  page("cosh", "the hyperbolic cosine", "sg.cosh(0)  --> 1.0"),
  page("tanh", "the hyperbolic tangent", "sg.tanh(0)  --> 0.0"),
  page("abs", "the absolute value", "sg.abs(-2)  --> 2.0"),
  extreme("max", "greater one", "sg.max(1, 2)  --> 2.0"),
  extreme("min", "lesser one", "sg.min(1, 2)  --> 1.0"),
}
