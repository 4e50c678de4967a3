// A shape function of a user in 2D: the products of tents

#include "shapeTransfer.H"
#include "linearShape.H"

namespace Foam
{
namespace mpm
{

template<int DIM>
struct tentShape
:
    public linearShape<DIM>
{
    using linearShape<DIM>::linearShape;

    static string refuses(const hexGrid& grid)
    {
        return
            grid.nDim() == 2 && grid.radial() < 0
          ? linearShape<DIM>::refuses(grid)
          : string("tent is one of a plane");
    }
};

struct tent
{
    static autoPtr<pointGridTransfer> New(const hexGrid& grid)
    {
        return autoPtr<pointGridTransfer>
        (
            new shapeTransfer<tentShape, 2>(grid)
        );
    }
};

addNamedToRunTimeSelectionTable(pointGridTransfer, tent, grid, tent);

} // End namespace mpm
} // End namespace Foam
