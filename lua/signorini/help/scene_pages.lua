-- Help pages on the parts of a scene and its path, which are plain tables: sg.model and model:run read them.

local thesis = "V. Agrawal, thesis, IIT Guwahati, 2020"

return {
  contact = [[
contacts = { <name> = { slave, master, penalty, friction, points, adhesion, where } }, in sg.model{ … }
slave:    the face that is integrated over, such as die:face "south"; pressures are known at its contact points. Take
          the finer mesh, of equal meshes the softer body. The published ironing studies take the stiff die.
master:   the face of the other body that these points are projected onto, or an obstacle, sg.rigid.plane{ … } and so
          on. Beyond an open end of the master the traction fades over a fifth of its last element.
penalty:  pressure per length of penetration, above 0: p = -penalty g where the gap g is negative. Needed without
          adhesion. 100 E divided by a length of the scene is a usual choice;
          model:contact_resultant(name).max_penetration tells what it leaves, and augmented = true of model:run takes
          that away.
friction: { mu, penalty }: Coulomb's coefficient, a number of at least 0, not an angle, and the tangential penalty,
          pressure per length of elastic slip. By default none.
points:   Gauss points per slave element and direction, 1 to 100; 3 (p + 1) by default, p the higher degree along the
          face.
adhesion: { hamaker, r0 } in place of penalty and friction: van der Waals forces with Hamaker's constant (force times
          length) and the length r0; they vanish at the distance 15^(-1/6) r0.
where:    function(X) that returns true where the contact acts; X = {x, y}, in 3D {x, y, z}, is a reference position
          of the slave face. Called while the model is made. Everywhere by default.
What comes of it: model:profile(name), model:contact_resultant(name), the columns <name>.fx … of a run.
Example: contacts = { interface = { slave = die:face "south", master = slab:face "north", penalty = 100,
                                    friction = { mu = 0.2, penalty = 100 } } }
Source: projection and gap (3.45), (3.46), penalty (3.73), forces (3.83), friction (3.74) to (3.76), adhesion (3.85) to
(3.89), points 7.1.1 of ]] .. thesis .. [[. More in share/doc/theory.md.]],
  support = [[
supports = { <name> = { on, fix, drive, free, rotate, symmetry } }, in sg.model{ … }
on:       a face, a list of faces (their reactions add up), a corner, in 3D an edge, or an obstacle.
fix:      components that stay where they are: "x", "y", "xy", in 3D "z", "xyz" and so on.
drive:    components that stages move, by lengths.
free:     components of neither; only to say so. Unlisted components are free.
rotate:   the face turns as a rigid body about its centroid by an angle in degrees that stages give behind the driven
          components: true in the plane; in 3D the axis, "x", "y", "z" or {ax, ay, az}. By default it does not.
symmetry: true holds the normal component on flat faces in a plane of symmetry x, y or z = c, in an axisymmetric
          model on the axis or y = c: the model is half of the scene, its forces are half of the whole one's.
A support must hold something. model:reaction(name) is the force that it exerts, with the moment last where it
rotates; a run has them as columns <name>.fx, .fy, .fz, .moment, and what is driven as <name>.ux … .angle.
Example: supports = { bed  = { on = slab:face "south", fix = "xy" },
                      grip = { on = { die:face "west", die:face "east" }, drive = "xy" } }]],
  load = [[
loads = { <name> = { on, traction or pressure } }, in sg.model{ … }
on:       a face or a list of faces.
traction: {tx, ty}, in 3D {tx, ty, tz}: force per reference area.
pressure: a number, force per reference area, against the outward normal of the reference shape.
Loads are dead: neither direction nor size follows the deformation. The value given here acts from the first step on;
stages give new ones. model:reaction(name) is the force; a run has columns <name>.fx …, and .tx … or .pressure.
Example: loads = { push = { on = ring:face "east", traction = {0, -1} } }]],
  stage = [[
model:run{ { name, steps, <support or load> = {…} }, … }: the stages of a load path, a list
name:   of the stage, in reports and on_step; "stage 1" and so on by default.
steps:  how many equal steps lead to its end, at least 1.
Any other key is the name of a driven support or a load: the values at the stage's end, in the order of its driven
components (lengths, then the angle in degrees) or of the traction. A single one needs no braces. What a stage does
not name stays where it is. Values count from the reference state, not from the stage before. model:driven(name) lists
the components. Options are the second argument, model:run({ … }, { step = { adaptive = true } }): help "model:run".
Example: model:run{ { name = "press", steps = 46,  grip = {0, -0.23} },
                    { name = "slide", steps = 250, grip = {1.5, -0.23} } }]],
}
