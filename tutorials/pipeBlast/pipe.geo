// A pipe that turns by half a circle: triangles, one layer thick; in parts by the angle
h = 0.01;               // side of the triangles [m]: 5 across
R1 = 0.2933;            // inner and outer wall
R2 = 0.3433;
t = 0.01;               // thickness
angle[] = {0, 0.3*Pi, 0.4*Pi, Pi};      // of the breech, the plug's ends, the muzzle

Point(1) = {0, 0, 0, h};
For i In {0:3}
    Point(10 + i) = {R1*Cos(angle[i]), R1*Sin(angle[i]), 0, h};
    Point(20 + i) = {R2*Cos(angle[i]), R2*Sin(angle[i]), 0, h};
    Line(30 + i) = {10 + i, 20 + i};
EndFor
For i In {0:2}
    Circle(40 + i) = {10 + i, 1, 11 + i};
    Circle(50 + i) = {20 + i, 1, 21 + i};
    Curve Loop(60 + i) = {30 + i, 50 + i, -(31 + i), -(40 + i)};
    Plane Surface(70 + i) = {60 + i};
EndFor

charge[] = Extrude {0, 0, t} { Surface{70}; Layers{1}; Recombine; };
plug[] = Extrude {0, 0, t} { Surface{71}; Layers{1}; Recombine; };
rest[] = Extrude {0, 0, t} { Surface{72}; Layers{1}; Recombine; };

// Patches and, from volumes, cell zones
Physical Surface("frontAndBack") = {70, 71, 72, charge[0], plug[0], rest[0]};
Physical Surface("breech") = {charge[2]};
Physical Surface("muzzle") = {rest[4]};
Physical Surface("walls") = {charge[3], charge[5], plug[3], plug[5], rest[3], rest[5]};
Physical Volume("charge") = {charge[1]};
Physical Volume("plug") = {plug[1]};
Physical Volume("rest") = {rest[1]};
