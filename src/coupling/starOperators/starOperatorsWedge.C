// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "starOperators.H"
#include "pointGrid.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::mpm::starOperators::radius(const label celli, const label s) const
{
    const int radial = grid_.radial();
    if (radial < 0)
    {
        return 1;
    }
    scalar sum = cells_.origin(celli)[radial];
    for (int k = 0; k < 2; ++k)
    {
        const label i = cells_.corners(celli)[2 * s + k];
        sum += cells_.position(celli, i)[radial];
    }
    return sum / 3;
}

Foam::scalar Foam::mpm::starOperators::sectionOf(const label celli, const label i) const
{
    const scalar b = cells_.originShare(celli, i);
    const label* corner = cells_.corners(celli);
    scalar sum = 0;
    for (label s = 0; s < cells_.nSimplices(celli); ++s, corner += 2)
    {
        const scalar here = scalar(corner[0] == i || corner[1] == i);
        sum += (b + here) * cells_.volumes(celli)[s] / 3;
    }
    return sum;
}

Foam::scalar Foam::mpm::starOperators::wedgeShare(const face& f, const label pointi) const
{
    // int r S_a = (2 r_a + r_b)/6 of the length, int r = (r_a + r_b)/2. A node
    // has two points, of which each has half; on the axis one
    const int radial = grid_.direction(grid_.radial());
    const pointField& x = mesh_.points();
    scalar low = GREAT, high = -GREAT;
    for (const label p : f)
    {
        low = min(low, x[p][radial]);
        high = max(high, x[p][radial]);
    }
    return f.size() == 3 ? 1.0 / 3 : (x[pointi][radial] + low + high) / (6 * (low + high));
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::mpm::starOperators::surfaceSum(const label celli, const label i) const
{
    vector sum(sideSum(celli, i));
    if (grid_.radial() >= 0)
    {
        sum[grid_.direction(grid_.radial())] += thickness(celli) * sectionOf(celli, i);
    }
    return sum;
}
