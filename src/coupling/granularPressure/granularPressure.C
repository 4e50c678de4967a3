/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "granularPressure.H"
#include "dictionaryTools.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::mpm::granularPressure::formula(const scalar a) const
{
    return Fr_*a*std::pow(a - min_, eta_)/std::pow(max_ - a, n_);
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::granularPressure::granularPressure(const dictionary& dict)
:
    min_(bounded(dict, "alphaMin", 0, 0.98)),
    max_(bounded(dict, "alphaMax", min_ + 0.02, 1)),
    Fr_(boundedOrDefault(dict, "Fr", 0.1, VSMALL, GREAT)),
    eta_(boundedOrDefault(dict, "eta", 2, 1, 10)),
    n_(boundedOrDefault(dict, "n", 5, 0, 10)),
    delta_(boundedOrDefault(dict, "delta", 0.01, 1e-6, 0.9*(max_ - min_))),
    linear_(boundedOrDefault(dict, "linear", 1, 0, 2)),
    quadratic_(boundedOrDefault(dict, "quadratic", 4, 0, 10))
{
    oneOf(dict, "type", {"JohnsonJackson"});
    checkKeywords
    (
        dict,
        {
            "type", "alphaMin", "alphaMax", "Fr", "eta", "n", "delta", "linear",
            "quadratic"
        }
    );
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::mpm::granularPressure::p(const scalar a) const
{
    if (a <= min_)
    {
        return 0;
    }
    const scalar last = max_ - delta_;
    return a < last ? formula(a) : formula(last) + slope(last)*(a - last);
}


Foam::scalar Foam::mpm::granularPressure::slope(const scalar a) const
{
    if (a <= min_)
    {
        return 0;
    }
    const scalar b = min(a, max_ - delta_);
    return formula(b)*(1/b + eta_/(b - min_) + n_/(max_ - b));
}


Foam::scalar Foam::mpm::granularPressure::q
(
    const scalar a,
    const scalar rho,
    const scalar jump
) const
{
    return
        jump > 0 && a > min_
      ? rho*a*jump*(linear_*std::sqrt(slope(a)/rho) + quadratic_*jump)
      : 0;
}

// ************************************************************************* //
