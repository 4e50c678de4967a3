// A square tube that turns by half a circle: tetrahedra; in parts by the angle
SetFactory("OpenCASCADE");
h = 0.0167;             // side of the tetrahedra [m]: 3 across
R1 = 0.2933;            // inner and outer wall
R2 = 0.3433;
b = 0.05;               // depth

// The section at the breech, turned about z: charge, plug, rest
Rectangle(1) = {R1, 0, 0, R2 - R1, b};
Rotate {{1, 0, 0}, {0, 0, 0}, Pi/2} { Surface{1}; }
charge[] = Extrude {{0, 0, 1}, {0, 0, 0}, 0.3*Pi} { Surface{1}; };
plug[] = Extrude {{0, 0, 1}, {0, 0, 0}, 0.1*Pi} { Surface{charge[0]}; };
rest[] = Extrude {{0, 0, 1}, {0, 0, 0}, 0.6*Pi} { Surface{plug[0]}; };

// Patches and, from volumes, cell zones
Physical Surface("breech") = {1};
Physical Surface("muzzle") = {rest[0]};
Physical Surface("walls") = {charge[{2:5}], plug[{2:5}], rest[{2:5}]};
Physical Volume("charge") = {charge[1]};
Physical Volume("plug") = {plug[1]};
Physical Volume("rest") = {rest[1]};
Mesh.CharacteristicLengthMin = h;
Mesh.CharacteristicLengthMax = h;
