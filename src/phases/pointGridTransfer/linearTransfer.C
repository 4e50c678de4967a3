// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "shapeTransfer.H"
#include "linearShape.H"
#include "hexShape.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{

//- By products of 1D functions on a lattice, through the cells' own coordinates
//  elsewhere
struct linear
{
    static autoPtr<pointGridTransfer> New(const pointGrid& grid)
    {
        return grid.hasLattice() ? shapeFunction<linearShape>::New(grid)
                                 : shapeFunction<hexShape>::New(grid);
    }
};

addNamedToRunTimeSelectionTable(pointGridTransfer, linear, grid, linear);

}
