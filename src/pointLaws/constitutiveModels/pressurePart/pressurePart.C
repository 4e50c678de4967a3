// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "pressurePart.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::wordList Foam::mpm::pressurePart::keywords({"K", "equationOfState", "bulkViscosity"});

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::mpm;

//- The equation linear of a bulk modulus that a dictionary gives
autoPtr<equationOfState> linearOf(const dictionary& dict, const scalar K, const scalar rho0)
{
    dictionary d;
    d.name() = dict.name();
    d.add("type", "linear");
    d.add("K", K);
    return equationOfState::New(d, rho0);
}

autoPtr<equationOfState> readEquation(const dictionary& dict, const scalar rho0)
{
    if (dict.found("K") == dict.found("equationOfState"))
    {
        FatalIOErrorInFunction(dict)
            << "One of the entries K and equationOfState is needed in " << dict.name()
            << (dict.found("K") ? ", not both." : ".") << exit(FatalIOError);
    }
    return dict.found("K") ? linearOf(dict, positive(dict, "K"), rho0)
                           : equationOfState::New(requiredDict(dict, "equationOfState"), rho0);
}

}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::pressurePart::pressurePart(
    const dictionary& dict, const scalar rho0, const scalar K, const scalar pMin) :
    equation_(K > 0 ? linearOf(dict, K, rho0) : readEquation(dict, rho0)),
    linear_(0),
    quadratic_(0),
    pMin_(pMin),
    rhoMin_(0),
    energyMin_(0)
{
    scalar e;
    if (pMin > -GREAT && !usesEnergy())
    {
        if (equation_->stateOf(pMin, rhoMin_, e))
        {
            energyMin_ = equation_->storedEnergy(rhoMin_);
        }
        else
        {
            rhoMin_ = 0;
        }
    }
    if (dict.found("bulkViscosity"))
    {
        const dictionary& q = requiredDict(dict, "bulkViscosity");
        checkKeywords(q, {"linear", "quadratic"});
        linear_ = bounded(q, "linear", 0, 10);
        quadratic_ = bounded(q, "quadratic", 0, 100);
    }
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::pressurePart::checkEnergy(
    const scalar p, const scalar e, const pointBlock& b, const label point) const
{
    const scalar e0 = equation_->e0();
    if (!equation_->ofReaction() || mag(e - e0) <= 0.01 * e0)
    {
        return;
    }
    OStringStream os;
    os << "The stress that " << b.nameOf(point).c_str() << " starts with, a"
       << " pressure of " << p << " Pa, gives it the energy e " << e
       << " J/kg; that of the equation of state " << equation_->type() << ", E0/rho, is " << e0
       << " J/kg with a pressure of " << startPressure()
       << " Pa. Points with an own energy need no stress:"
       << " leave  stress  (and pressure) out of their region.";
    if (!(e > 0))
    {
        FatalErrorInFunction << os.str().c_str() << exit(FatalError);
    }
    if (!warned_)
    {
        warned_ = true;
        WarningInFunction << os.str().c_str() << endl;
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::mpm::pressurePart::startPressure() const
{
    return max(equation_->p(equation_->rho0(), equation_->e0()), pMin_);
}

Foam::scalar Foam::mpm::pressurePart::bulkModulus() const
{
    const scalar rho0 = equation_->rho0();
    return rho0 * sqr(equation_->c(rho0, equation_->e0()));
}

Foam::scalar Foam::mpm::pressurePart::energy(const scalar rho, const scalar* e) const
{
    return e             ? *e - equation_->e0()
        : rho >= rhoMin_ ? equation_->storedEnergy(rho)
                         : energyMin_ - pMin_ * (1 / rho - 1 / rhoMin_);
}

Foam::scalar Foam::mpm::pressurePart::advance(
    run& r, const pointBlock& b, const label first, scalar* e, const scalar G) const
{
    alignas(64) scalar A[room], B[room], dA[room], dB[room], q[room], viscous[room];
    const label n = r.n;

    equation_->coefficients(n, r.rho, A, B, dA, dB);

    // Bulk viscosity, and the speed that it adds to that of the waves
    scalar fastest = 0;
    for (label i = 0; i < n; ++i)
    {
        q[i] = 0;
        viscous[i] = 0;
    }
    if (usesWidth() && b.width)
    {
        const scalar rdt = 1 / r.dt;
        for (label i = 0; i < n; ++i)
        {
            const scalar e0 = e ? e[i] : 0;
            const scalar c = std::sqrt(max(
                dA[i] + e0 * dB[i] + (A[i] + B[i] * e0) * B[i] / (r.rho[i] * r.rho[i]), scalar(0)));
            const scalar ld = b.width[first + i] * max(-r.dTheta[i] * rdt, scalar(0));
            q[i] = r.rho[i] * ld * (linear_ * c + quadratic_ * ld);
            viscous[i] = ld > 0 ? linear_ * c + quadratic_ * ld : 0;
        }
    }

    if (e)
    {
        alignas(64) scalar A0[room], B0[room], dA0[room], dB0[room];
        equation_->coefficients(n, r.rhoOld, A0, B0, dA0, dB0);
        const scalar* damage = b.damage ? b.damage + first : nullptr;
        for (label i = 0; i < n; ++i)
        {
            const scalar least = damage && damage[i] >= 1 ? max(pMin_, scalar(0)) : pMin_;
            const scalar dv = 1 / r.rho[i] - 1 / r.rhoOld[i];
            const scalar p0 = max(A0[i] + B0[i] * e[i], least);
            const scalar known = e[i] - (0.5 * p0 + q[i]) * dv + r.work[i];

            const scalar e1 = (known - 0.5 * A[i] * dv) / (1 + 0.5 * B[i] * dv);
            e[i] = A[i] + B[i] * e1 >= least ? e1 : known - 0.5 * least * dv;
            r.heat[i] = -q[i] * dv;
            r.isentropic[i] = -2 * B[i] / (r.rho[i] + r.rhoOld[i]) * r.dTheta[i];
        }
    }
    else if (b.dissipated && usesWidth())
    {
        alignas(64) scalar A0[room], B0[room], dA0[room], dB0[room];
        equation_->coefficients(n, r.rhoOld, A0, B0, dA0, dB0);
        for (label i = 0; i < n; ++i)
        {
            const scalar q0 = -r.meanOld[i] - max(A0[i], pMin_);
            b.dissipated[first + i] +=
                b.mass[first + i] * 0.5 * (q0 + q[i]) * (1 / r.rhoOld[i] - 1 / r.rho[i]);
        }
    }

    // The law of a failed point that has opened goes on with a density that
    // falls, and its speed grows; what the point carries has no such wave
    const scalar* failed = b.damage ? b.damage + first : nullptr;
    const scalar unstressed = failed ? (bulkModulus() + 4.0 / 3 * G) / equation_->rho0() : 0;
    for (label i = 0; i < n; ++i)
    {
        const scalar e1 = e ? e[i] : 0;
        const scalar p = max(A[i] + B[i] * e1, pMin_);
        const scalar square = max(dA[i] + e1 * dB[i] + p * B[i] / (r.rho[i] * r.rho[i]), scalar(0))
            + 4.0 / 3 * G / r.rho[i];
        r.p[i] = p + q[i];
        const bool open = failed && failed[i] >= 1 && p <= 0;
        fastest = max(
            fastest,
            viscous[i]
                + std::sqrt((open ? min(square, unstressed) : square) + viscous[i] * viscous[i]));
    }
    return fastest;
}

void Foam::mpm::pressurePart::stateOf(
    const scalar p, const pointBlock& b, const label point, scalar& theta, scalar& e) const
{
    scalar rho;
    if (!equation_->stateOf(p, rho, e))
    {
        FatalErrorInFunction << "The equation of state " << equation_->type() << " has no state"
                             << " with the pressure " << p << " Pa that " << b.nameOf(point).c_str()
                             << " starts with." << exit(FatalError);
    }
    checkEnergy(p, e, b, point);
    theta = std::log(equation_->rho0() / rho);
}
