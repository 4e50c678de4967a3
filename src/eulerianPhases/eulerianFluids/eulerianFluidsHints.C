// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "eulerianFluids.H"
#include "dictionaryTools.H"
#include "noTraps.H"
#include "StringStream.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- A number of a message
std::string text(const scalar x)
{
    OStringStream os;
    os.precision(5);
    os << x;
    return os.str();
}

//- Least and largest value
struct range
{
    scalar low = GREAT, high = -GREAT;

    void add(const scalar x)
    {
        low = min(low, x);
        high = max(high, x);
    }

    void gather()
    {
        reduce(low, minOp<scalar>());
        reduce(high, maxOp<scalar>());
    }
};

Ostream& operator<<(Ostream& os, const range& r)
{
    os << text(r.low).c_str();
    if (r.high - r.low > 1e-3 * mag(r.low))
    {
        os << " to " << text(r.high).c_str();
    }
    return os;
}

//- The first stiffness of an equation of state: "pInf 6e8"
std::string stiffness(const dictionary& dict)
{
    const dictionary& equation = dict.subOrEmptyDict("equationOfState");
    for (const word key : {"pInf", "K", "C0", "c0", "A"})
    {
        scalar value;
        if (equation.readIfPresent(key, value))
        {
            return ", " + key + " of its equationOfState " + Foam::name(value);
        }
    }
    return "";
}

//- Neither a gas nor products, nor softened
bool isLiquid(const mpm::equationOfState& equation)
{
    scalar gamma, pInf = 1;
    const bool gas = equation.isStiffened(gamma, pInf) && !(pInf > 0);
    return !gas && !equation.ofReaction() && !(equation.softened() > 0)
        && equation.type() != "vanDerWaals" && equation.type() != "perfectGas";
}

//- What is wrong with density, speed of sound and p over the strength (p +
//  pInf) of the start; empty: nothing
std::string
doubts(const range& rho, const range& c, const range& ofStrength, const bool gas, const bool liquid)
{
    OStringStream os;
    if (!gas && (c.high > 2e4 || (liquid && rho.high < 23 && c.low > 300)))
    {
        os << "No matter is that light and fast: " << text(rho.low).c_str() << " g/cm3 are "
           << text(1000 * rho.low).c_str() << " kg/m3.";
    }
    else if (rho.high > 25000)
    {
        os << "No matter is that dense (osmium 22600 kg/m3).";
    }
    else if (gas && rho.high > 500)
    {
        os << "No gas is that dense: p is in Pa, T in K, molWeight in kg/kmol.";
    }
    else if (liquid && rho.high > 100 && c.high < 300 && ofStrength.low > 0.5)
    {
        os << "No liquid is that slow: pressures are in Pa, 6e8 for 0.6 GPa,"
           << " 600 MPa or 6000 bar. A liquid that is soft on purpose has"
           << " soundSpeed in place of pInf.";
    }
    return os.str();
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::mpm::eulerianFluids::traceOf(const label k) const
{
    scalar largest = 0;
    forAll(theta_, i)
    {
        largest = max(largest, part_[n_ * i + k] / theta_[i]);
    }
    return min(0.01, 0.5 * returnReduce(largest, maxOp<scalar>()));
}

void Foam::mpm::eulerianFluids::tellStart(const dictionary& properties) const
{
    const noTraps guard;
    for (label k = 0; k < n_; ++k)
    {
        const gasThermo& thermo = mixture_.thermo(k);
        range rho, c, T, ofStrength, pOf;
        const scalar trace = traceOf(k);
        forAll(theta_, i)
        {
            const scalar m = mass_[n_ * i + k];
            if (m > 0 && part_[n_ * i + k] > trace * theta_[i])
            {
                pOf.add(W_[i].p);
                const scalar r = m / part_[n_ * i + k];
                const fluidMixture::terms t(mixture_.at(k, r, burntOf(i, k)));
                const scalar p = W_[i].p;
                const scalar c2 = max(fluidMixture::c2(t, r, p), VSMALL);
                rho.add(r);
                c.add(std::sqrt(c2));
                ofStrength.add(p * (1 + t.B / r) / (r * c2));
                T.add(thermo.hasTemperature() ? thermo.T(r, p) : scalar(0));
            }
        }
        rho.gather();
        c.gather();
        T.gather();
        ofStrength.gather();
        pOf.gather();
        Info << "    " << mixture_.name(k) << ": " << mixture_.description(k).c_str() << nl;
        if (rho.high < 0)
        {
            continue;
        }
        Info << "        starts with rho " << rho << " kg/m3, ";
        if (thermo.hasTemperature())
        {
            Info << "T " << T << " K, ";
        }
        Info << "speed of sound " << c << " m/s" << nl;
        if (restarted_)
        {
            continue;
        }
        if (!thermo.isGammaLaw() && thermo.equation().ofReaction() && !mixture_.detonates(k)
            && pOf.high < 1e7)
        {
            WarningInFunction << "Fluid " << mixture_.name(k) << " has the equation of state"
                              << " of reaction products, no detonation, and starts with "
                              << text(pOf.high).c_str() << " Pa: it will not explode." << nl
                              << "    Give its region of setFluidsDict the pressure of the"
                              << " products (p 8.4e9 for TNT), or the fluid a detonation in"
                              << " constant/phaseProperties." << nl << endl;
        }
        const scalar rho0 = mixture_.rho0(k);
        if (mixture_.detonates(k) && (rho.high < 0.999 * rho0 || rho.low > 1.001 * rho0))
        {
            IOWarningInFunction(requiredDict(properties, mixture_.name(k)))
                << "The charge of " << mixture_.name(k) << " starts with rho " << rho
                << " kg/m3 (setFluidsDict: rho, or mass and shape), but its entry rho is " << rho0
                << ": constants of products, the velocity of detonation and E0 are of one density"
                << " (TNT of 0.4 % less starts with 1.8 % more energy)." << nl
                << "    Give it that density, or constants of the charge's own." << nl << endl;
        }
        const bool liquid = !isGas(k) && isLiquid(thermo.equation());
        const std::string wrong(doubts(rho, c, ofStrength, isGas(k), liquid));
        if (wrong.size())
        {
            const dictionary& dict = requiredDict(properties, mixture_.name(k));
            IOWarningInFunction(dict)
                << "Fluid " << mixture_.name(k) << " starts with rho " << rho << " kg/m3 ("
                << state_[k].name() << " of the start" << (isGas(k) ? "" : ", or the entry rho")
                << stiffness(dict).c_str() << ") and a speed of sound of " << c << " m/s. "
                << wrong.c_str() << endl;
        }
        warnOfTemperature(k);
    }
}

void Foam::mpm::eulerianFluids::warnOfTemperature(const label k) const
{
    if (!isGas(k))
    {
        return;
    }
    range T, p;
    label cold = 0;
    scalar most = 0;
    forAll(theta_, c)
    {
        most = max(most, part_[n_ * c + k] / max(theta_[c], VSMALL));
    }
    reduce(most, maxOp<scalar>());
    forAll(theta_, c)
    {
        // Not what setFluids has mixed with a liquid: that has another T
        if (mass_[n_ * c + k] > 0 && part_[n_ * c + k] > 0.999 * most * theta_[c])
        {
            const scalar T0 = state_[k][c];
            T.add(T0);
            p.add(p_[c]);
            cold += T0 > 10 && T0 < 60 && p_[c] > 5e4;
        }
    }
    T.gather();
    p.gather();
    reduce(cold, sumOp<label>());
    if (T.high < T.low)
    {
        return;
    }
    if (cold)
    {
        WarningInFunction << state_[k].name() << " starts with " << text(T.low).c_str() << " K; "
                          << cold << " cells have 10 to 60 K (" << state_[k].objectPath()
                          << "): it is in K. " << text(T.low).c_str() << " degrees Celsius are "
                          << text(T.low + 273.15).c_str() << " K." << endl;
    }
    if (p.high < 5 && T.low > 200)
    {
        WarningInFunction << "The fluids start with a pressure of " << p.high << " Pa ("
                          << p_.objectPath() << ") where " << mixture_.name(k) << " has " << T.low
                          << " K: that is a vacuum. 1 bar is 1e5 Pa." << endl;
    }
}

bool Foam::mpm::eulerianFluids::canTear() const
{
    bool liquid = false, nuclei = false;
    for (label k = 0; k < n_; ++k)
    {
        liquid = liquid || !isGas(k);
        nuclei = nuclei || nuclei_[k] > 0;
    }
    return !liquid || nuclei;
}

Foam::string Foam::mpm::eulerianFluids::aboutNuclei() const
{
    OStringStream os;
    word gas;
    for (label k = n_ - 1; k >= 0; --k)
    {
        gas = isGas(k) ? mixture_.name(k) : gas;
    }
    os << "A liquid that shall tear needs a trace of gas in its cells:"
       << "  nuclei 1e-6;  (where jumps of velocity tear it 1e-4) in ";
    if (gas.empty())
    {
        os << "a perfectGas beside it, which has to be added to";
    }
    else
    {
        os << gas << " of";
    }
    os << " constant/phaseProperties.";
    return os.str();
}

void Foam::mpm::eulerianFluids::checkTorn()
{
    if (restarted_ || !anyTorn_)
    {
        return;
    }
    if (torn_.size())
    {
        const label c = torn_[0], k = only(c);
        OStringStream os;
        os << "Fluid " << mixture_.name(k) << " starts torn in cell " << c << " at "
           << mesh_.cellCentres()[c] << ": with the density " << W_[c].rho
           << " kg/m3 and the pressure of 0/p"
           << " it has no speed of sound; rho c^2 must be positive." << nl
           << "Look into 0/p, 0/rho." << mixture_.name(k) << " and constant/phaseProperties.";
        if (!canTear())
        {
            os << nl << aboutNuclei().c_str();
        }
        whyBad_ = os.str();
    }
    stop(torn_.size() ? torn_[0] : -1);
}

void Foam::mpm::eulerianFluids::checkTension() const
{
    if (tension_ || canTear())
    {
        return;
    }
    constexpr scalar bar = 1e5;
    scalar least = 0;
    for (const gasState& w : W_)
    {
        least = min(least, w.p);
    }
    reduce(least, minOp<scalar>());
    if (least > -bar)
    {
        return;
    }
    tension_ = true;
    WarningInFunction << "The pressure of the fluids is down to " << text(least).c_str()
                      << " Pa at time " << mesh_.time().timeName()
                      << ": a liquid is in tension, as a solid." << nl << "    "
                      << aboutNuclei().c_str() << nl << endl;
}

void Foam::mpm::eulerianFluids::tellDisplaced(const List<fluidSums>& before) const
{
    const List<fluidSums> now(fluidContents());
    scalarField had(n_, Zero), share(n_, Zero);
    scalar most = 0;
    for (label k = 0; k < n_; ++k)
    {
        had[k] = returnReduce(before[k].mass, sumOp<scalar>());
        const scalar has = returnReduce(now[k].mass, sumOp<scalar>());
        share[k] = had[k] > 0 ? 1 - has / had[k] : 0;
        most = max(most, share[k]);
    }
    if (!(most > 1e-12))
    {
        return;
    }
    Info << "Points displace";
    for (label k = 0; k < n_; ++k)
    {
        Info << (k ? ", " : " ") << mixture_.name(k) << ' ' << text(had[k] * share[k]).c_str()
             << " of " << text(had[k]).c_str() << " kg (" << text(100 * share[k]).c_str() << " %)";
    }
    Info << nl << endl;
    for (label k = 0; k < n_; ++k)
    {
        const bool charge = !isGas(k) && mixture_.thermo(k).equation().ofReaction();
        if (charge && share[k] > 0.01)
        {
            WarningInFunction << "Points lie where " << mixture_.name(k) << " is: they"
                              << " displace " << text(100 * share[k]).c_str() << " % of its"
                              << " mass, " << text((1 - share[k]) * had[k]).c_str() << " of "
                              << text(had[k]).c_str() << " kg are left (alpha and rho of the"
                              << " start)." << nl
                              << "    Move the charge (setFluidsDict) or the points"
                              << " (setMaterialPointsDict), or give the charge as much more"
                              << " mass." << endl;
        }
    }
}
