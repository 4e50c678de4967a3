/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "cellShapes.H"
#include "dictionaryTools.H"
#include "shapeFormula.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(cellsShape, 0);
    addToRunTimeSelectionTable(pointRegionShape, cellsShape, dictionary);
    defineTypeNameAndDebug(cellZoneShape, 0);
    addToRunTimeSelectionTable(pointRegionShape, cellZoneShape, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::cellsShape::cellsShape(const pointGrid& grid, const dictionary&)
:
    pointRegionShape(grid)
{}


Foam::mpm::cellZoneShape::cellZoneShape
(
    const pointGrid& grid,
    const dictionary& dict
)
:
    cellsShape(grid, dict),
    inZone_(grid.nCells(), false)
{
    const cellZoneMesh& zones = grid.mesh().cellZones();

    for (const label celli : zones[oneOf(dict, "zone", zones.names())])
    {
        inZone_[celli] = true;
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::mpm::cellsShape::keywords() const
{
    return wordList();
}


Foam::boundBox Foam::mpm::cellsShape::bounds() const
{
    return grid_.mesh().bounds();
}


bool Foam::mpm::cellsShape::contains(const label, const point&) const
{
    return true;
}


bool Foam::mpm::cellsShape::formula(shapeFormula& f) const
{
    f.cells([this](const label celli) { return contains(celli, point::zero); });
    return true;
}


Foam::scalar Foam::mpm::cellsShape::volume() const
{
    const scalarField& V = grid_.mesh().cellVolumes();

    scalar sum = 0;
    forAll(V, celli)
    {
        if (contains(celli, grid_.mesh().cellCentres()[celli]))
        {
            sum += V[celli];
        }
    }
    return sum;
}


Foam::wordList Foam::mpm::cellZoneShape::keywords() const
{
    return {"zone"};
}


bool Foam::mpm::cellZoneShape::contains(const label celli, const point&) const
{
    return inZone_[celli];
}

// ************************************************************************* //
