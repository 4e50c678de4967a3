/*--------------------------------*- C++ -*----------------------------------*\
|  materialPointFoam: material point method on OpenFOAM's mesh                |
\*---------------------------------------------------------------------------*/
FoamFile
{
    version     2.0;
    format      ascii;
    class       pointVectorField;
    object      U.ring;
}
// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

dimensions      [0 1 -1 0 0 0 0];

internalField   uniform (0 0 0);

boundaryField
{
    outside
    {
        type        calculated;
    }

    frontAndBack
    {
        type        empty;
    }
}

// ************************************************************************* //
