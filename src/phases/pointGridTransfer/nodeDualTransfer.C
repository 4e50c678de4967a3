// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "nodeDualTransfer.H"
#include "dualBoxShape.H"
#include "dualSimplexShape.H"
#include "simplexShape.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{

//- By products on a lattice, linear where all cells are simplices; elsewhere
//  products in boxes, linear in the simplices of other cells
struct nodeDualFunctions
{
    static bool onlySimplices(const pointGrid& grid)
    {
        bool only = true;
        for (label celli = 0; only && celli < grid.nCells(); ++celli)
        {
            only = grid.nodesOf(celli).size() == grid.nDim() + 1;
        }
        return returnReduce(only, andOp<bool>());
    }

    static autoPtr<pointGridTransfer> New(const pointGrid& grid)
    {
        return grid.hasLattice() && grid.radial() < 0
            ? shapeFunction<dualBoxShape, nodeDualTransfer>::New(grid)
            : onlySimplices(grid) ? shapeFunction<dualSimplexShape, nodeDualTransfer>::New(grid)
                                  : shapeFunction<simplexShape, nodeDualTransfer>::New(grid);
    }
};

addNamedToRunTimeSelectionTable(pointGridTransfer, nodeDualFunctions, grid, nodeDual);

}
