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
    constexpr int W = laneWidth<3>;
    typedef lanes<W> T;
    alignas(64) scalar A[room], B[room], dA[room], dB[room];
    alignas(64) scalar A0[room], B0[room], dA0[room], dB0[room];

    equation_->coefficients(r.n, r.rho, A, B, dA, dB);
    const bool viscous = usesWidth() && b.width;
    const bool dissipates = !e && b.dissipated && usesWidth();
    if (e || dissipates)
    {
        equation_->coefficients(r.n, r.rhoOld, A0, B0, dA0, dB0);
    }
    const scalar* damage = b.damage ? b.damage + first : nullptr;

    // The law of a failed point that has opened goes on with a density that
    // falls, and its speed grows; what the point carries has no such wave
    const scalar unstressed = damage ? (bulkModulus() + 4.0 / 3 * G) / equation_->rho0() : 0;
    const T none = {}, least = none + pMin_;
    const scalar rdt = 1 / r.dt;

    T fastest = {};
    forLaneGroups<W>(
        0, r.n, [&](const laneGroup<W> g) __attribute__((always_inline)) {
            const T rho = g.get(r.rho), dTheta = g.get(r.dTheta);
            const T a = g.get(A), c = g.get(B), da = g.get(dA), dc = g.get(dB);
            const T v = 1.0 / rho;
            T e1 = e ? g.get(e) : none;

            // Bulk viscosity, and the speed that it adds to that of the waves
            T q = {}, more = {};
            if (viscous)
            {
                const T speed = laneSqrt(laneMax(da + e1 * dc + (a + c * e1) * c * v * v, none));
                const T ld = g.get(b.width + first) * laneMax(-dTheta * rdt, none);
                more = linear_ * speed + quadratic_ * ld;
                q = rho * ld * more;
                more = select(ld > none, more, none);
            }

            const T failed = damage ? g.get(damage) : none;
            if (e)
            {
                const T rhoOld = g.get(r.rhoOld), a0 = g.get(A0), c0 = g.get(B0);
                const T lowest = select(failed >= 1.0, laneMax(least, none), least);
                const T dv = v - 1.0 / rhoOld;
                const T p0 = laneMax(a0 + c0 * e1, lowest);
                const T known = e1 - (0.5 * p0 + q) * dv + g.get(r.work);

                e1 = (known - 0.5 * a * dv) / (1.0 + 0.5 * c * dv);
                e1 = select(a + c * e1 >= lowest, e1, known - 0.5 * lowest * dv);
                g.put(e, e1);
                g.put(r.heat, -q * dv);
                g.put(r.isentropic, -2.0 * c / (rho + rhoOld) * dTheta);
            }
            else if (dissipates)
            {
                const T q0 = -g.get(r.meanOld) - laneMax(g.get(A0), least);
                scalar* to = b.dissipated + first;
                g.put(
                    to,
                    g.get(to)
                        + g.get(b.mass + first) * 0.5 * (q0 + q) * (1.0 / g.get(r.rhoOld) - v));
            }

            const T p = laneMax(a + c * e1, least);
            T square = laneMax(da + e1 * dc + p * c * v * v, none) + 4.0 / 3 * G * v;
            g.put(r.p, p + q);
            if (damage)
            {
                square = select(
                    (failed >= 1.0) & (p <= 0.0), laneMin(square, none + unstressed), square);
            }
            fastest = laneMax(fastest, more + laneSqrt(square + more * more));
        });
    return horizontalMax(fastest);
}

void Foam::mpm::pressurePart::stateOf(
    const scalar p, const pointBlock& b, const label point, scalar& theta, scalar& e) const
{
    scalar rho;
    if (!equation_->stateOf(p, rho, e))
    {
        FatalErrorInFunction << "The equation of state " << equation_->type() << " has no state"
                             << " with the pressure " << p << " Pa that " << b.nameOf(point).c_str()
                             << " starts with. Moduli are in Pa (1e6 for 1 MPa, 1e9 for 1 GPa)."
                             << exit(FatalError);
    }
    checkEnergy(p, e, b, point);
    theta = std::log(equation_->rho0() / rho);
}
