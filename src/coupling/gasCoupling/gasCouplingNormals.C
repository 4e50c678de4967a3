/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "gasCoupling.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::gasCoupling::updateNormals()
{
    const int D = sums_.grid().nDim();
    const labelList& places = sums_.places();

    smooth_.setSize(sums_.nPlaces());
    smooth_ = 0;
    forAll(places, c)
    {
        smooth_[places[c]] = solidFraction(c);
    }
    sums_.sum(smooth_.data(), 1);

    scalarList coarse(smooth_.size());
    for (int pass = 0; pass < 2; ++pass)
    {
        for (int d = 0; d < D; ++d)
        {
            coarse = 0;
            forAll(places, c)
            {
                const label at = places[c];
                coarse[at] =
                    0.5*smooth_[at]
                  + 0.25
                   *(smooth_[at + sums_.below(c, d)] + smooth_[at + sums_.above(c, d)]);
            }
            sums_.sum(coarse.data(), 1);
            smooth_.swap(coarse);
        }
    }
}


bool Foam::mpm::gasCoupling::normal(const label celli, vector& n) const
{
    // Difference of the fraction over two cells below which it is uniform
    constexpr scalar uniform = 1e-3;

    const label at = sums_.place(celli);
    n = Zero;
    scalar most = 0;
    for (int d = 0; d < sums_.grid().nDim(); ++d)
    {
        const scalar difference =
            smooth_[at + sums_.above(celli, d)]
          - smooth_[at + sums_.below(celli, d)];
        n[sums_.grid().direction(d)] = difference*sums_.grid().lattice().invWidth(d)[1];
        most = max(most, mag(difference));
    }
    if (most < uniform)
    {
        return false;
    }
    n /= mag(n);
    return true;
}

// ************************************************************************* //
