---@meta _
-- Generated from the help pages by scripts/reference; read by editors, not by the program.
-- Results of a model

---@class sg.model
local model = {}

---@class (exact) sg.model.profile.result
---@field x number[]
---@field y number[]
---@field X number[]
---@field Y number[]
---@field area number[]
---@field inside number[]
---@field pressure number[]
---@field traction number[]
---@field gap number[]
---@field state string[]
---@field z? number[]
---@field Z? number[]
---@field tx? number[]
---@field ty? number[]
---@field tz? number[]
---@field damage? number[]

---Returns lists along the slave face, one entry per contact point: x, y (current), X, Y (reference), area (current, on
---which the traction acts; 0 at an open point; with adhesion the reference area, of bonds also where they are open),
---inside (1 in the contact area, see model:contact_resultant, otherwise 0), pressure, traction (of friction, along the
---chord from slip point to foot point, which is tangential on a straight master; in the plane positive along the slave
---face's xi; on the slave it acts in the opposite direction), gap (beyond an open end of the master the distance),
---state ("open", "stick", also of a closed point without friction, "slip", "adhesion", "bonded": not closed, held by a
---bond). At a slipping point |traction| = mu pressure (mortar: at each multiplier). A cohesive contact also has damage,
---from 0 to 1 (no bond); its pressure, negative in tension, and traction include those of the bonds. Pressure and
---traction are forces per current area, whatever `per` of the contact is; with method = "mortar" and with adhesion
---`area`, pressure and traction refer to the reference area. In 3D also z, Z, and tx, ty, tz, the components of the
---friction traction t_T, whose magnitude is `traction`; -t_T acts on the slave. Reading any other field is an error.
---
---Example:
---```lua
---model:profile("interface").pressure
---```
---@param contact string # contact: name of a contact (a string)
---@return sg.model.profile.result
function model:profile(contact) end

---@alias sg.model.sample.field.choice "ux"|"uy"|"u"|"sxx"|"syy"|"szz"|"sxy"|"von_mises"|"pressure"|"I1"|"F11"|"F12"|"F21"|"F22"|"uz"|"sxz"|"syz"|"F13"|"F23"|"F31"|"F32"|"F33"|"contact_pressure"|"damage"

---Returns a field's value at a parametric point of a body.
---
---Example:
---```lua
---model:sample("slab", "uy", {0.5, 1})
---```
---@param body sg.body|string # body: a body or its name (a body or a string)
---@param field sg.model.sample.field.choice # field: 'ux', 'uy', 'u', 'sxx', 'syy', 'szz', 'sxy', 'von_mises', 'pressure', 'I1', 'F11', 'F12', 'F21', 'F22', 'uz', 'sxz', 'syz', 'F13', 'F23', 'F31', 'F32', 'F33', 'contact_pressure' or 'damage'. As in sg.picture; contact_pressure and damage are interpolated between the contact points of a slave face, on which xi must be
---@param xi [number, number]|[number, number, number] # xi: parametric coordinates (a list of 2 numbers {xi1, xi2}, in 3D of 3)
---@return number
function model:sample(body, field, xi) end

---@class (exact) sg.model.energy.result
---@field stored number
---@field contact number
---@field friction number
---@field work number
---@field area_growth number
---@field debonding number

---Returns { stored, contact, friction, work, area_growth, debonding }: strain energy of the bodies, and that of springs
---of supports; energy of penalty springs and bonds, or of adhesion; and, summed over accepted steps (trapezoidal rule),
---dissipation by friction; work of supports, of loads and of changing offsets and overlaps of contacts; energy of the
---penalty springs times the growth of the area on which they act, zero for contacts with per = "reference"; dissipation
---by bonds. Per unit depth in plane strain. Where nothing changes suddenly, as when a contact is switched off, work +
---area_growth = stored + contact + friction + debonding in the limit of small steps (with friction: and of small
---penetration): see share/doc/theory.md, Output quantities.
---
---Example:
---```lua
---model:energy().stored
---```
---@return sg.model.energy.result
function model:energy() end

---@class (exact) sg.model.reaction.result
---@field fx number
---@field fy number
---@field fz? number
---@field moment? number
---@field [integer] number

---Returns the force {fx, fy} ({fx, fy, fz} in 3D) that a support exerts on its bodies, followed, for a support that
---rotates, by the moment about its center (in 3D about the axis); for a load, its force. Also by name: fx, fy, fz,
---moment.
---
---Example:
---```lua
---model:reaction("grip").fy
---```
---@param name string # name: a support or a load (a string)
---@return sg.model.reaction.result
function model:reaction(name) end

---Returns the motions of an obstacle that are unknowns, by name: ux, uy, uz of its translation as far as its support
---frees them, and its angle if that is free. Empty for other supports.
---
---Example:
---```lua
---model:free_motion("grip")
---```
---@param name string # name: a support (a string)
---@return table
function model:free_motion(name) end

---@class (exact) sg.model.contact_law.result
---@field method string
---@field per string
---@field enforcement? string
---@field multipliers? string
---@field law? string
---@field points integer
---@field bonded? integer
---@field penalty? number
---@field mu? number
---@field friction_penalty? number
---@field hamaker? number
---@field r0? number
---@field strength? number
---@field energy? number
---@field stiffness? number
---@field offset? number
---@field overlap? number
---@field active boolean
---@field default_penalty? boolean

---Returns the constants of a contact: { method, enforcement, per, points, penalty, default_penalty, active, offset },
---as given to sg.model or by default, in the present state; default_penalty is true where the penalty is from material
---and mesh. With friction also mu, friction_penalty; with overlap = "interference" overlap, the fraction of the initial
---overlap that is still allowed; with method = "mortar" multipliers; of a cohesive contact strength, energy, law,
---stiffness, and bonded, the number of points with a bond; with adhesion { method, per, points, active, hamaker, r0 }.
---print(model) shows them.
---
---Example:
---```lua
---model:contact_law("interface").penalty
---```
---@param contact string # contact: name of a contact (a string)
---@return sg.model.contact_law.result
function model:contact_law(contact) end

---@class (exact) sg.model.contact_resultant.result
---@field fx number
---@field fy number
---@field fz? number
---@field area number
---@field max_pressure number
---@field mean_pressure number
---@field max_penetration number
---@field weighted_penetration? number
---@field imbalance? number
---@field debonded? number
---@field active integer
---@field slipping integer
---@field unsettled integer
---@field crossed integer
---@field per string
---@field unsettled_at? [number, number]|[number, number, number]
---@field crossed_at? [number, number]|[number, number, number]

---Returns { fx, fy, fz, area, max_pressure, mean_pressure, max_penetration, active, slipping, per, unsettled, crossed
---}: the force on the slave (fz in 3D); the current area in contact (with method = "mortar" and with adhesion the
---reference area), which is that inside gap = 0, linear between contact points; extremes; the largest mean pressure
---over a slave element (where elements or a high penalty do not resolve the peak, it is closer to the peak than
---max_pressure); the numbers of contact points that touch and slip; and per, "current" or "reference", the area on
---which tractions act; with multipliers also weighted_penetration, the largest of the multipliers; of a cohesive
---contact debonded, the area of new surface: energy dissipated by bonds over energy of separation; with "half_passes"
---also imbalance, |f + f2| / max(|f|, |f2|) with the force f2 of the other pass: by how much action and reaction
---differ, 0 without forces. unsettled: how often, in all accepted states so far, the search for a closest point or slip
---point ended at the limit of iterations; unsettled_at is the reference position of the latest such point. crossed: how
---many points have passed through the master without contact since the accepted state, 0 in accepted states; crossed_at
---is the reference position of the last of them.
---
---Example:
---```lua
---model:contact_resultant("interface").area
---```
---@param contact string # contact: name of a contact (a string)
---@return sg.model.contact_resultant.result
function model:contact_resultant(contact) end

---@class (exact) sg.model.tie_profile.result
---@field x number[]
---@field y number[]
---@field X number[]
---@field Y number[]
---@field area number[]
---@field tx number[]
---@field ty number[]
---@field pressure number[]
---@field traction number[]
---@field jump number[]
---@field z? number[]
---@field Z? number[]
---@field tz? number[]

---Returns lists along the slave face of a tie, one entry per quadrature point opposite the master: x, y (current), X, Y
---(reference), area (reference area with the point's weight), tx, ty (traction of the master on the slave per reference
---area), pressure (its part against the slave's current normal, negative in tension), traction (its tangential part: in
---the plane positive along the slave face's xi, in 3D its magnitude), jump (distance by which the two faces have moved
---apart, which vanishes in the weighted mean only). In 3D also z, Z, tz. Points are ordered by elements of the slave
---face, which are divided at the borders of the master's elements.
---
---Example:
---```lua
---coated:tie_profile("seam").pressure
---```
---@param tie string # tie: name of a tie (a string)
---@return sg.model.tie_profile.result
function model:tie_profile(tie) end

---@class (exact) sg.model.tie_resultant.result
---@field fx number
---@field fy number
---@field fz? number
---@field area number
---@field part number
---@field distance number

---Returns { fx, fy, fz, area, part, distance }: the force of the master on the slave (fz in 3D), the tied reference
---area, its fraction of the slave face, and the largest distance of the two faces in the reference shape (relative to
---the elements there).
---
---Example:
---```lua
---coated:tie_resultant("seam").fy
---```
---@param tie string # tie: name of a tie (a string)
---@return sg.model.tie_resultant.result
function model:tie_resultant(tie) end

---@class sg
local sg = {}

---@class (exact) sg.profile_error.arguments
---profile: the measured profile (a contact profile)
---@field profile table
---reference: another profile, or a function of the coordinate (a contact profile)
---@field reference table|(fun(s: number): number)
---coordinate: the name of a column such as "x", or a function of a point; default "x". A column such as "x" (deformed)
---```text
---            or "X" (reference), or a function of a point { x =, y =, pressure =, … }; it is the s of the integral. It
---            must increase along the contact zone; points beyond, where it decreases, are left out
---```
---@field coordinate? string|(fun(point: table<string, any>): number)
---value: compared quantity ('pressure' or 'traction'; default "pressure")
---@field value? "pressure"|"traction"
---normalize: N; "max": the largest value of the reference (a positive number or "max"; default 1)
---@field normalize? number|"max"
---quadrature: 'profile', 'reference' or 'union'; default "profile". Points of the trapezoidal rule; the other profile
---is
---```text
---            interpolated linearly; "union", the points of both, is exact for two polygons
---```
---@field quadrature? "profile"|"reference"|"union"
---zone: 'either' or 'both'; default "either". "either": where one of the two touches, with p = 0 at open points;
---"both":
---```text
---      only where both touch, from edge point to edge point. If the contact of one ends earlier than that of the other,
---      "both" leaves out the largest differences
---```
---@field zone? "either"|"both"
---edge: 'point' or 'gap'; default "point". How a profile decreases to zero between its last point in contact and the
---```text
---      next one: "point": linearly to that next one; "gap": to where the gap, linear between these two, is zero, which
---      becomes a point of the integral
---```
---@field edge? "point"|"gap"
---@field [string] sg.unknown_argument

---@class (exact) sg.profile_error.result2
---@field from number
---@field to number
---@field points integer
---@field scale number
---@field covered number

---Returns the L2 error sqrt(integral of ((p - p_ref)/N)^2 ds) of a contact profile against a reference, and { from, to,
---points, scale, covered }: the range and the number of points of the integral, N, and the fraction of the zone (where
---either one touches) that the range covers. Ranges that do not overlap are an error.
---
---```text
---sg.profile_error{ profile, reference, coordinate = "x", value = "pressure", normalize = 1, quadrature = "profile",
---  zone = "either", edge = "point" }
---```
---
---Source: V. Agrawal, thesis, IIT Guwahati 2020, eq. (7.2), which leaves the points of the integral open.
---
---Example:
---```lua
---sg.profile_error{ profile = model:profile "interface", reference = finer:profile "interface", normalize = "max" }
---```
---@param arguments sg.profile_error.arguments
---@return number
---@return sg.profile_error.result2
function sg.profile_error(arguments) end

---@class (exact) sg.profile_edges.arguments
---profile: the measured profile (a contact profile)
---@field profile table
---coordinate: the name of a column such as "x", or a function of a point; default "x". A column such as "x" (deformed)
---```text
---            or "X" (reference), or a function of a point { x =, y =, pressure =, … }; it is the s of the integral. It
---            must increase along the contact zone; points beyond, where it decreases, are left out
---```
---@field coordinate? string|(fun(point: table<string, any>): number)
---@field [string] sg.unknown_argument

---@class (exact) sg.profile_edges.result
---@field from number
---@field to number
---@field from_spacing? number
---@field to_spacing? number

---Returns the ends of the contact zone of a profile: { from, to, from_spacing, to_spacing }. An edge is where the gap
---is zero, linear between the last point inside the contact area and the first one outside; the spacing is the distance
---of these two points. Without spacing, contact extends to the profile's end.
---
---```text
---sg.profile_edges{ profile, coordinate = "x" }
---```
---
---Example:
---```lua
---half_width = sg.profile_edges{ profile = model:profile "interface" }.to
---```
---@param arguments sg.profile_edges.arguments
---@return sg.profile_edges.result
function sg.profile_edges(arguments) end
