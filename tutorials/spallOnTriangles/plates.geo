// Two plates in free space: triangles that follow their sides, one layer thick
h = 7.6e-5;         // side of the triangles [m]: 50 over the target
H = 1.9e-3;         // thickness of the flyer
w = 2e-3;           // half the width of the plates
s = 0.5e-3;         // free space around them

Point(1) = {-w - s, -s, 0, h};
Point(2) = {w + s, -s, 0, h};
Point(3) = {w + s, 3*H + s, 0, h};
Point(4) = {-w - s, 3*H + s, 0, h};
Point(5) = {-w, 0, 0, h};
Point(6) = {w, 0, 0, h};
Point(7) = {w, 2*H, 0, h};
Point(8) = {-w, 2*H, 0, h};
Point(9) = {w, 3*H, 0, h};
Point(10) = {-w, 3*H, 0, h};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Line(5) = {5, 6};
Line(6) = {6, 7};
Line(7) = {7, 8};
Line(8) = {8, 5};
Line(9) = {7, 9};
Line(10) = {9, 10};
Line(11) = {10, 8};

Curve Loop(1) = {1, 2, 3, 4};
Curve Loop(2) = {5, 6, 7, 8};
Curve Loop(3) = {-7, 9, 10, 11};
Curve Loop(4) = {5, 6, 9, 10, 11, 8};
Plane Surface(1) = {1, 4};
Plane Surface(2) = {2};
Plane Surface(3) = {3};

space[] = Extrude {0, 0, 1e-3} { Surface{1}; Layers{1}; Recombine; };
target[] = Extrude {0, 0, 1e-3} { Surface{2}; Layers{1}; Recombine; };
flyer[] = Extrude {0, 0, 1e-3} { Surface{3}; Layers{1}; Recombine; };

// Patches and, from volumes, cell zones
Physical Surface("frontAndBack") = {1, 2, 3, space[0], target[0], flyer[0]};
Physical Surface("outside") = {space[2], space[3], space[4], space[5]};
Physical Volume("space") = {space[1]};
Physical Volume("target") = {target[1]};
Physical Volume("flyer") = {flyer[1]};
