// A bracket: leg, rounded corner, arm
SetFactory("OpenCASCADE");
t = 0.08;           // thickness [m]
b = 0.04;           // depth
R = 0.12;           // radius of the middle line in the corner
leg = 0.28;         // straight parts
arm = 0.36;
h = 0.016;          // tetrahedra

// Section in the plane x, y; the middle line goes down, round and to the right
Point(1) = {-t/2, 0, 0};
Point(2) = {t/2, 0, 0};
Point(3) = {t/2, -leg, 0};
Point(4) = {R, -leg, 0};
Point(5) = {R, -leg - R + t/2, 0};
Point(6) = {R + arm, -leg - R + t/2, 0};
Point(7) = {R + arm, -leg - R - t/2, 0};
Point(8) = {R, -leg - R - t/2, 0};
Point(9) = {-t/2, -leg, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Circle(3) = {3, 4, 5};
Line(4) = {5, 6};
Line(5) = {6, 7};
Line(6) = {7, 8};
Circle(7) = {8, 4, 9};
Line(8) = {9, 1};
Curve Loop(1) = {1, 2, 3, 4, 5, 6, 7, 8};
Plane Surface(1) = {1};
made[] = Extrude {0, 0, b} { Surface{1}; };

Physical Volume("bracket") = {made[1]};
Mesh.CharacteristicLengthMin = h;
Mesh.CharacteristicLengthMax = h;
