// The space in which they move: a box
SetFactory("OpenCASCADE");
Include "sizes.geo";

Box(1) = {0, 0, -2.2*R, 1.2*R, 1.2*R, 4.4*R};
Physical Surface("planes") = {1, 3};            // of symmetry: x = 0, y = 0
Physical Surface("outside") = {2, 4, 5, 6};
Physical Volume("space") = {1};
