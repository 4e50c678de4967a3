// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "granularForce.H"
#include "dictionaryTools.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::granularForce::read(const label phasei, const dictionary& dict)
{
    laws_.set(phasei, granularPressure::New(requiredDict(dict, "granularPressure")).ptr());
    const scalar c = std::sqrt(laws_[phasei].slope(1) / points_.phases()[phasei].rho());
    const pointGrid& grid = points_.grid();
    scalar rate = 0;
    for (label celli = 0; celli < grid.nCells(); ++celli)
    {
        for (int d = 0; d < grid.nDim(); ++d)
        {
            rate = max(rate, c / grid.width(celli, d));
        }
    }
    waveRate_ = max(waveRate_, returnReduce(rate, maxOp<scalar>()));
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::granularForce::granularForce(
    const materialPointSystem& points, solidFraction& fraction, const dictionary& phaseProperties) :
    points_(points), fraction_(fraction), laws_(points.phases().size()), waveRate_(0)
{
    forAll(points_.phases(), phasei)
    {
        const dictionary& dict = requiredDict(phaseProperties, points_.phases()[phasei].name());
        if (dict.found("granularPressure"))
        {
            read(phasei, dict);
            fraction.keepOwn(phasei);
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::scalarField* Foam::mpm::granularForce::pressure(const label phasei)
{
    if (!acts(phasei))
    {
        return nullptr;
    }
    const granularPressure& law = laws_[phasei];
    const scalarField& a = fraction_.own(phasei);
    p_.setSize(a.size());
    forAll(p_, c)
    {
        p_[c] = law.p(a[c]);
    }

    // Nodes of cells with points have a velocity; h max(-div u, 0) [m/s], h the
    // shortest side; on a wedge div u of the plane
    const scalar rho = points_.phases()[phasei].rho();
    for (const label c : points_.phases()[phasei].cloud().cells())
    {
        if (p_[c] > 0)
        {
            p_[c] += law.q(
                a[c], rho,
                points_.grid().shortestSide(c) * max(-fraction_.divergence(phasei, c), scalar(0)));
        }
    }
    return &p_;
}
