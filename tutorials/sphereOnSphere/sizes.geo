// Of both meshes: tetrahedra of h at the origin, where the spheres touch, that grow outwards
R = 0.01;           // radius of the spheres [m]
gap = 4e-5;         // between them at the start
h = 0.3e-3;

Field[1] = Ball;
Field[1].Radius = 0.2*R;
Field[1].Thickness = 2*R;
Field[1].VIn = h;
Field[1].VOut = h + 0.5*R;
Background Field = 1;
Mesh.CharacteristicLengthFromPoints = 0;
Mesh.CharacteristicLengthExtendFromBoundary = 0;
Mesh.CharacteristicLengthMax = 0.2*R;
