/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "starFraction.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::starFraction::updateGasPush
(
    const UList<scalar>& p,
    const UList<scalar>& pBehind,
    const vectorField& area
)
{
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    for (const label c : around_)
    {
        const scalar theta = (*gasTheta_)[c];
        vector sum(Zero);
        for (const label f : mesh_.cells()[c])
        {
            if (!isBetween_[f])
            {
                continue;
            }
            const label i = f - nei.size();
            const label other = i >= 0 ? -1 : own[f] == c ? nei[f] : own[f];
            const scalar beside =
                other < 0 ? (*gasThetaBehind_)[i] : (*gasTheta_)[other];
            const scalar jump =
                theta/(theta + beside)
               *((other < 0 ? pBehind[i] : p[other]) - p[c]);
            const vector S(mesh_.faceAreas()[f] - area[f]);
            sum += own[f] == c ? jump*S : -jump*S;
        }
        gasPush_[c] = -sum/mesh_.V()[c];
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::starFraction::pushAnew
(
    const UList<scalar>& p,
    const UList<scalar>& pBehind
)
{
    updateGasPush(p, pBehind, area0_);
}

// ************************************************************************* //
