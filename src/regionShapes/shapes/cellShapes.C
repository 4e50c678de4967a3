/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::mpm::cellsShape
    Foam::mpm::cellZoneShape

Description
    All cells of the mesh, or those of a cell zone.

Usage
    \table
        Property | Description          | Required
        type     | cells or cellZone    | yes
        zone     | name of the cellZone | for cellZone
    \endtable

\*---------------------------------------------------------------------------*/

#include "pointRegionShape.H"
#include "shapeFormula.H"

namespace Foam::mpm
{

class cellsShape : public pointRegionShape
{
public:
    TypeName("cells");

    cellsShape(const pointGrid& grid, const dictionary&) : pointRegionShape(grid) {}

    using pointRegionShape::contains;

    wordList keywords() const override { return {}; }
    boundBox bounds() const override { return grid_.mesh().bounds(); }
    bool contains(const label, const point&) const override { return true; }
    bool insideMesh() const override { return true; }

    bool formula(shapeFormula& f) const override
    {
        f.cells([this](const label celli) { return contains(celli, point::zero); });
        return true;
    }

    scalar volume() const override
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
};

class cellZoneShape : public cellsShape
{
    boolList inZone_;

public:
    TypeName("cellZone");

    cellZoneShape(const pointGrid& grid, const dictionary& dict) :
        cellsShape(grid, dict), inZone_(grid.nCells(), false)
    {
        const cellZoneMesh& zones = grid.mesh().cellZones();

        for (const label celli : zones[oneOf(dict, "zone", zones.names())])
        {
            inZone_[celli] = true;
        }
    }

    using pointRegionShape::contains;

    wordList keywords() const override { return {"zone"}; }

    bool contains(const label celli, const point&) const override { return inZone_[celli]; }
};

defineTypeNameAndDebug(cellsShape, 0);
addToRunTimeSelectionTable(pointRegionShape, cellsShape, dictionary);
defineTypeNameAndDebug(cellZoneShape, 0);
addToRunTimeSelectionTable(pointRegionShape, cellZoneShape, dictionary);

} // End namespace Foam::mpm
