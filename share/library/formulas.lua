---@meta _
-- Generated from the help pages by scripts/reference; read by editors, not by the program.
-- Formulas

---An argument of a function that is called once to read its formula, as in sg.hyperelastic; numbers and symbols combine
---to formulas with + - \* / ^ and the functions below. print(symbol) shows the formula.
---@class sg.symbol
local symbol = {}

---@class sg
local sg = {}

---Returns the natural logarithm of a number, or the formula of it if the argument is a symbol.
---
---Example:
---```lua
---sg.log(1)  --> 0.0
---```
---@param x number|sg.symbol
---@return number|sg.symbol
function sg.log(x) end

---Returns the exponential function of a number, or the formula of it if the argument is a symbol.
---
---Example:
---```lua
---sg.exp(0)  --> 1.0
---```
---@param x number|sg.symbol
---@return number|sg.symbol
function sg.exp(x) end

---Returns the square root of a number, or the formula of it if the argument is a symbol.
---
---Example:
---```lua
---sg.sqrt(4)  --> 2.0
---```
---@param x number|sg.symbol
---@return number|sg.symbol
function sg.sqrt(x) end

---Returns the sine of a number, or the formula of it if the argument is a symbol.
---
---Example:
---```lua
---sg.sin(0)  --> 0.0
---```
---@param x number|sg.symbol
---@return number|sg.symbol
function sg.sin(x) end

---Returns the cosine of a number, or the formula of it if the argument is a symbol.
---
---Example:
---```lua
---sg.cos(0)  --> 1.0
---```
---@param x number|sg.symbol
---@return number|sg.symbol
function sg.cos(x) end

---Returns the tangent of a number, or the formula of it if the argument is a symbol.
---
---Example:
---```lua
---sg.tan(0)  --> 0.0
---```
---@param x number|sg.symbol
---@return number|sg.symbol
function sg.tan(x) end

---Returns the inverse tangent of a number, or the formula of it if the argument is a symbol.
---
---Example:
---```lua
---sg.atan(0)  --> 0.0
---```
---@param x number|sg.symbol
---@return number|sg.symbol
function sg.atan(x) end

---Returns the hyperbolic sine of a number, or the formula of it if the argument is a symbol.
---
---Example:
---```lua
---sg.sinh(0)  --> 0.0
---```
---@param x number|sg.symbol
---@return number|sg.symbol
function sg.sinh(x) end

---Returns the hyperbolic cosine of a number, or the formula of it if the argument is a symbol.
---
---Example:
---```lua
---sg.cosh(0)  --> 1.0
---```
---@param x number|sg.symbol
---@return number|sg.symbol
function sg.cosh(x) end

---Returns the hyperbolic tangent of a number, or the formula of it if the argument is a symbol.
---
---Example:
---```lua
---sg.tanh(0)  --> 0.0
---```
---@param x number|sg.symbol
---@return number|sg.symbol
function sg.tanh(x) end

---Returns the absolute value of a number, or the formula of it if the argument is a symbol.
---
---Example:
---```lua
---sg.abs(-2)  --> 2.0
---```
---@param x number|sg.symbol
---@return number|sg.symbol
function sg.abs(x) end
