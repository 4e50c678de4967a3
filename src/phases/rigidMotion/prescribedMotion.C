/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "prescribedMotion.H"
#include "dictionaryTools.H"
#include "ListOps.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::prescribedMotion::start
(
    const scalar time,
    const materialPointCloud&
)
{
    path_ = pathNew_ = Zero;
    placement_ = place(path_, rate(time));
    checkDirection(placement_.velocity, "velocity");
}


Foam::dictionary Foam::mpm::prescribedMotion::state() const
{
    dictionary state;
    state.add("path", path_);
    return state;
}


void Foam::mpm::prescribedMotion::setState
(
    const scalar time,
    const dictionary& state
)
{
    path_ = pathNew_ = required<vector>(state, "path");
    placement_ = place(path_, rate(time));
}


void Foam::mpm::prescribedMotion::advance(const scalar t0, const scalar t1)
{
    // Gauss' points and weights on [-1, 1]
    static const scalar at[5] =
    {
        0, 0.538469310105683091, -0.538469310105683091,
        0.906179845938663993, -0.906179845938663993
    };
    static const scalar weight[5] =
    {
        0.568888888888888889, 0.478628670499366468, 0.478628670499366468,
        0.236926885056189088, 0.236926885056189088
    };

    DynamicList<scalar> ends;
    addKinks(t0, t1, ends);
    Foam::sort(ends);
    ends.append(t1);

    vector sum(Zero);
    scalar from = t0;
    for (const scalar to : ends)
    {
        const scalar half = 0.5*(to - from), middle = 0.5*(from + to);
        for (int i = 0; i < 5; ++i)
        {
            sum += half*weight[i]*rate(middle + half*at[i]);
        }
        from = to;
    }
    pathNew_ = path_ + sum;
    placement_ = place(pathNew_, rate(t1));
    checkDirection(placement_.velocity, "velocity");
}

// ************************************************************************* //
