/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "filteredScheme.H"
#include "dictionaryTools.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::filteredScheme::filteredScheme
(
    const dictionary& dict,
    const scalar strainFilter
)
:
    order_(boundedLabelOrDefault(dict, "order", 2, 1, 100)),
    strainFilter_(boundedOrDefault(dict, "strainFilter", strainFilter, 0, 1))
{}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::mpm::moveCoefficients
Foam::mpm::filteredScheme::coefficients(const step& s) const
{
    if (s.mean)
    {
        return {0, 0, 1, 0.5, 0, 0.5, 0};
    }
    return {0, 0, 1, 0, 0, 1, 0};
}


void Foam::mpm::filteredScheme::write(Ostream& os, const bool) const
{
    os  << "transfer " << type() << " of order " << order_
        << ": x moves with the new velocity of the point" << nl;
    if (order_ > 1)
    {
        os  << "    increments of the filters meet the homogeneous boundary"
            << " conditions; strainFilter " << strainFilter_ << nl;
    }
}

// ************************************************************************* //
