// The bodies: quarters of two spheres, x and y > 0, each a group
SetFactory("OpenCASCADE");
Include "sizes.geo";

Sphere(1) = {0, 0, R + gap/2, R, -Pi/2, Pi/2, Pi/2};
Sphere(2) = {0, 0, -R - gap/2, R, -Pi/2, Pi/2, Pi/2};
Physical Volume("upper") = {1};
Physical Volume("lower") = {2};
