// Draws a connecting rod [mm] and writes it as rod.step, as a program of CAD would:
//     gmsh -0 rod.geo -o rod.step
SetFactory("OpenCASCADE");
Mesh.CharacteristicLengthMax = 6;
between = 110;      // of the two bores

// Ends and shank, the shank with a pocket on both sides
Cylinder(1) = {0, 0, -12, 0, 0, 24, 28};
Cylinder(2) = {between, 0, -10, 0, 0, 20, 16};
Box(3) = {20, -11, -8, between - 30, 22, 16};
Box(4) = {32, -6, 3, between - 52, 12, 5};
Box(5) = {32, -6, -8, between - 52, 12, 5};
BooleanDifference(6) = { Volume{3}; Delete; }{ Volume{4, 5}; Delete; };
BooleanUnion(7) = { Volume{1}; Delete; }{ Volume{2, 6}; Delete; };

// Bores
Cylinder(8) = {0, 0, -20, 0, 0, 40, 19};
Cylinder(9) = {between, 0, -20, 0, 0, 40, 9};
BooleanDifference(10) = { Volume{7}; Delete; }{ Volume{8, 9}; Delete; };
