// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "wallPatches.H"
#include "StringStream.H"
#include <algorithm>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::wallPatches::wallPatches(const pointGrid& grid, const boolList& holds) :
    grid_(grid), holds_(holds), n_(0), deepest_(0)
{
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::mpm::wallPatches::putBack(const label from, scalar* x, scalar* shift) const
{
    const int D = grid_.nDim();
    scalar way[3] = {0, 0, 0}, at[3] = {0, 0, 0}, depth = 0;
    std::copy_n(x, D, at);
    label celli = from;

    // In a corner one wall after the other
    for (int i = 0; i < 2 * D; ++i)
    {
        cellLocator::wayOut out;
        if (!grid_.locator().leaves(celli, at, out)
            || !holds_[grid_.mesh().boundaryMesh().whichPatch(out.face)])
        {
            return -1;
        }
        depth += out.beyond / grid_.shortestSide(out.cell);
        if (!(depth <= farthest))
        {
            return -1;
        }
        for (int d = 0; d < D; ++d)
        {
            at[d] -= out.beyond * out.normal[d];
            way[d] -= out.beyond * out.normal[d];
        }
        scalar found[3] = {0, 0, 0};
        std::copy_n(at, D, found);
        celli = out.cell;
        const label cell = grid_.locate(celli, found);
        if (cell >= 0)
        {
            std::copy_n(found, D, x);
            std::copy_n(way, D, shift);
            ++n_;
            deepest_ = max(deepest_, depth);
            return cell;
        }
    }
    return -1;
}

Foam::string Foam::mpm::wallPatches::words(const label from, const scalar* x) const
{
    scalar at[3] = {0, 0, 0};
    std::copy_n(x, grid_.nDim(), at);
    cellLocator::wayOut out;
    if (!grid_.locator().leaves(from, at, out))
    {
        return "";
    }
    const label patchi = grid_.mesh().boundaryMesh().whichPatch(out.face);
    OStringStream os;
    os.precision(3);
    os << "It is " << out.beyond / grid_.shortestSide(out.cell) << " of its cell beyond patch "
       << grid_.mesh().boundaryMesh()[patchi].name();
    if (holds_[patchi])
    {
        os << ", from which points are put back up to " << farthest;
    }
    os << ".\n";
    return os.str();
}

Foam::label Foam::mpm::wallPatches::count(scalar& deepest) const
{
    const label n = returnReduce(n_, sumOp<label>());
    deepest = returnReduce(deepest_, maxOp<scalar>());
    n_ = 0;
    deepest_ = 0;
    return n;
}
