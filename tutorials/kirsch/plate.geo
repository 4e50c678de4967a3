// A quarter of a plate with a hole: triangles that are small at the hole, one layer thick
a = 0.01;           // radius of the hole [m]
W = 20*a;           // side of the quarter
fine = a/24;        // triangles at the hole
coarse = W/10;      // and far away

Point(1) = {0, 0, 0, fine};
Point(2) = {a, 0, 0, fine};
Point(3) = {W, 0, 0, coarse};
Point(4) = {W, W, 0, coarse};
Point(5) = {0, W, 0, coarse};
Point(6) = {0, a, 0, fine};

Line(1) = {2, 3};
Line(2) = {3, 4};
Line(3) = {4, 5};
Line(4) = {5, 6};
Circle(5) = {6, 1, 2};

Curve Loop(1) = {1, 2, 3, 4, 5};
Plane Surface(1) = {1};
made[] = Extrude {0, 0, a} { Surface{1}; Layers{1}; Recombine; };

// Patches of the mesh: made[2] to made[6] are the sides over the lines 1 to 5
Physical Surface("frontAndBack") = {1, made[0]};
Physical Surface("bottom") = {made[2]};
Physical Surface("far") = {made[3], made[4]};
Physical Surface("left") = {made[5]};
Physical Surface("hole") = {made[6]};
Physical Volume("plate") = {made[1]};
