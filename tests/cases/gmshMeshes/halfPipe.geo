// A half-pipe with a block of its own cells in it: triangles, one layer thick
h = 0.05;               // cells [m]
low = 0.7;              // inner radius of the mesh [m]
ri = 0.8;               // of the block
ro = 1.0;               // of the pipe
to = 46.667*Pi/180;     // the block's place, from the lowest point
a = 13.333*Pi/180;      // half of its angle

Point(1) = {0, 0, 0};
t[] = {-Pi/2, 0, to - a, to + a, Pi/2};
For i In {0:4}
    Point(10 + i) = {ro*Sin(t[i]), -ro*Cos(t[i]), 0, h};
    Point(20 + i) = {low*Sin(t[i]), -low*Cos(t[i]), 0, h};
EndFor
For i In {2:3}
    Point(30 + i) = {ri*Sin(t[i]), -ri*Cos(t[i]), 0, h};
EndFor
For i In {0:3}
    Circle(10 + i) = {10 + i, 1, 11 + i};
EndFor
Circle(20) = {20, 1, 21};
Circle(21) = {21, 1, 24};
Circle(32) = {32, 1, 33};
Line(40) = {10, 20};
Line(41) = {14, 24};
Line(42) = {12, 32};
Line(43) = {13, 33};

Curve Loop(1) = {42, 32, -43, -12};
Plane Surface(1) = {1};
Curve Loop(2) = {10, 11, 42, 32, -43, 13, 41, -21, -20, -40};
Plane Surface(2) = {2};
one[] = Extrude {0, 0, h} { Surface{1}; Layers{1}; Recombine; };
two[] = Extrude {0, 0, h} { Surface{2}; Layers{1}; Recombine; };

// The sides of an extrusion follow its curve loop
Physical Surface("frontAndBack") = {1, 2, one[0], two[0]};
Physical Surface("pipe") = {one[5], two[2], two[3], two[7]};
Physical Surface("rest") = {two[8], two[9], two[10], two[11]};
Physical Volume("block") = {one[1]};
Physical Volume("space") = {two[1]};
