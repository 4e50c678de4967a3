// The space in which the bracket moves: tetrahedra that know nothing of it
SetFactory("OpenCASCADE");
h = 0.02;
Box(1) = {-0.15, -0.75, 0, 0.8, 0.75, 0.04};
Physical Surface("wall") = {4};         // y = 0: holds the leg
Physical Surface("sides") = {5, 6};     // smooth plates in front and behind
Physical Surface("outside") = {1, 2, 3};
Physical Volume("space") = {1};
Mesh.CharacteristicLengthMin = h;
Mesh.CharacteristicLengthMax = h;
