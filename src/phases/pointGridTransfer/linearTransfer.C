/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "shapeTransfer.H"
#include "linearShape.H"
#include "hexShape.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::mpm;

//- linear: by products of 1D functions on a lattice, by the cells' own
//  coordinates elsewhere
autoPtr<pointGridTransfer> newLinearPasses(const hexGrid& grid)
{
    return
        grid.hasLattice()
      ? newShapePasses<linearShape>(grid)
      : newShapePasses<hexShape>(grid);
}

const addShapeTransfer addLinearPasses("linear", newLinearPasses);

}

// ************************************************************************* //
