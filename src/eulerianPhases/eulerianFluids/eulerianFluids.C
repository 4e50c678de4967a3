// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "eulerianFluids.H"
#include "dictionaryTools.H"
#include "noTraps.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam::mpm
{

//- no, yes (all words of a switch) or solids
static word lowMachOf(const dictionary& settings)
{
    const Switch value(settings.getOrDefault<word>("lowMach", word::null), true);
    if (value.valid())
    {
        return bool(value) ? "yes" : "no";
    }
    return oneOfOrDefault(settings, "lowMach", "no", wordList({"no", "yes", "solids"}));
}

} // End namespace Foam::mpm

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::eulerianFluids::oneFluid(const label k, const labelUList& cells)
{
    constexpr label room = gasThermo::room;
    scalar rho[room], e[room], p[room], c2[room], strength[room], F[room];
    const bool burns = mixture_.detonates(k);
    const fluidMixture::torn& torn = mixture_.least(k);
    for (label first = 0; first < cells.size(); first += room)
    {
        const label n = min(room, cells.size() - first);
        for (label i = 0; i < n; ++i)
        {
            const label c = cells[first + i];
            const scalar m = mass_[n_ * c + k];
            gasState& w = W_[c];
            w.u = rhoU_[c] / m;
            w.rho = m / theta_[c];
            rho[i] = w.rho;
            e[i] = (rhoE_[c] - 0.5 * (rhoU_[c] & w.u)) / m;
            F[i] = burntOf(c, k);
        }
        mixture_.pressures(k, n, rho, e, p, c2, strength, burns ? F : nullptr);
        for (label i = 0; i < n; ++i)
        {
            const label c = cells[first + i];
            W_[c].p = p[i];
            t_[c].K = rho[i] * c2[i];
            t_[c].rhoE = rho[i] * e[i];
            t_[c].strength = strength[i];
            z_[c] = rho[i] * std::sqrt(max(c2[i], scalar(0)));
            if (torn.is(rho[i], strength[i]))
            {
                torn_.append(c);
            }
        }
    }
}

bool Foam::mpm::eulerianFluids::isTorn(const label c, const label k) const
{
    return interfaces_->single()[c] == k && mixture_.least(k).is(W_[c].rho, t_[c].strength);
}

void Foam::mpm::eulerianFluids::severalFluids(const label c)
{
    const scalar* theta = part_.cdata() + n_ * c;
    const scalar* m = mass_.cdata() + n_ * c;
    scalar total = 0;
    for (label k = 0; k < n_; ++k)
    {
        total += m[k];
    }
    gasState& w = W_[c];
    w.rho = total / theta_[c];
    w.u = rhoU_[c] / total;
    const scalar energy = rhoE_[c] - 0.5 * (rhoU_[c] & w.u);
    const scalar* F = burntOf(c);
    w.p = relaxedP_[c] > 0 ? relaxedP_[c] : mixture_.pressure(theta, m, energy, F);
    const fluidMixture::moduli all(mixture_.at(theta, m, w.p, F));
    t_[c].K = all.wood;
    t_[c].rhoE = energy / theta_[c];
    t_[c].strength = all.strength;
    z_[c] = std::sqrt(max(w.rho * all.frozen, scalar(0)));
}

void Foam::mpm::eulerianFluids::primitives()
{
    scalar rate = 0;
    label bad = -1;
    {
        const noTraps guard;
        torn_.clear();
        List<DynamicList<label>> of(n_);
        forAll(theta_, c)
        {
            const label k = only(c);
            if (k >= 0)
            {
                of[k].append(c);
            }
            else
            {
                severalFluids(c);
            }
        }
        for (label k = 0; k < n_; ++k)
        {
            oneFluid(k, of[k]);
        }
        spreadTears();
        forAll(W_, c)
        {
            const gasState& w = W_[c];
            p_[c] = w.p;
            U_[c] = w.u;
            rho0_[c] = w.rho;
            const scalar r =
                (cmptMag(w.u) & faceRates_.directions[c]) + z_[c] / w.rho * faceRates_.all[c];
            if (!(w.rho > 0 && t_[c].K > 0 && r < GREAT && mag(w.p) < GREAT))
            {
                bad = bad < 0 ? c : bad;
            }
            rate = max(rate, r);
        }
        for (const label c : torn_)
        {
            // What is torn may close
            rate = max(rate, mixture_.least(only(c)).c * faceRates_.all[c]);
        }
        for (const label k : burnt_.of())
        {
            // The step must see a front that has not come yet
            const scalar D = mixture_.detonates(k)->speed();
            forAll(W_, c)
            {
                if (mass_[n_ * c + k] > 0 && burntOf(c, k) < 1)
                {
                    rate = max(rate, D * faceRates_.all[c]);
                }
            }
        }
    }
    if (whyBad_.size() && !canTear())
    {
        whyBad_ += "\n" + aboutNuclei();
    }
    setRate(rate, bad);
}

Foam::mpm::farField::medium::part Foam::mpm::eulerianFluids::partOf(
    const label k, const scalar Y, const scalar rho, const scalar p, const scalar F) const
{
    return farField::medium::isentrope(
        Y, rho, p,
        [&](const scalar rho, const scalar p)
        { return rho * fluidMixture::c2(mixture_.at(k, rho, F), rho, p); });
}

Foam::mpm::farField::state
Foam::mpm::eulerianFluids::farState(const label i, const gasState& L, const scalar z)
{
    const farField::face& a = far_->faces()[i];
    const label c = mesh_.faceOwner()[a.f], b = a.f - mesh_.nInternalFaces();
    const scalar pFar = far_->p(i);
    const bool ofCell = alphaB_[n_ * b] < 0;
    farField::medium of;
    of.outside = !ofCell && farField::fixes(alpha_[0].boundaryField()[a.patch]);

    // The shares of the conditions at the pressure far away
    const auto given = [&]
    {
        of.size = 0;
        of.p = pFar;
        FixedList<scalar, fluidMixture::most> rho;
        scalar all = 0;
        for (label k = 0; k < n_; ++k)
        {
            rho[k] = density(k, state_[k].boundaryField()[a.patch][a.i], pFar);
            all += alphaB_[n_ * b + k] * rho[k];
        }
        for (label k = 0; k < n_; ++k)
        {
            const scalar m = alphaB_[n_ * b + k] * rho[k];
            if (m > 0)
            {
                of.add(partOf(k, m / all, rho[k], pFar, burntBehind(b, k)));
            }
        }
    };
    if (of.outside)
    {
        given();
    }
    else
    {
        of.p = W_[c].p;
        for (label k = 0; k < n_; ++k)
        {
            const scalar m = mass_[n_ * c + k];
            if (m > 0)
            {
                const scalar rho = m / part_[n_ * c + k];
                of.add(partOf(k, m / rho_[c], rho, of.p, burntOf(c, k)));
            }
        }
    }
    farField::state s(far_->at(i, L, z, of));
    if (ofCell)
    {
        return s;
    }
    if (s.u < 0 && !of.outside)
    {
        given();
    }
    if (s.u < 0)
    {
        // Densities at p*, shares as given
        s.behind.rho = 0;
        for (label k = 0, j = 0; k < n_; ++k)
        {
            if (alphaB_[n_ * b + k] > 0)
            {
                rhoB_[n_ * b + k] = of.rho(j++, s.p);
                s.behind.rho += alphaB_[n_ * b + k] * rhoB_[n_ * b + k];
            }
        }
    }
    return s;
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::eulerianFluids::eulerianFluids(
    const fvMesh& mesh, const dictionary& properties, const wordList& names, const vector& g,
    const fieldStates* states) :
    eulerianFlow(mesh, "fluids", word::null, g, states),
    mixture_(properties, names),
    n_(names.size()),
    lowMachSolids_(lowMachOf(settings(properties)) == "solids"),
    lowMach_(lowMachOf(settings(properties)) != "no"),
    given_(isGiven(properties)),
    chi_(boundedOrDefault(settings(properties), "drainage", 0.1, 0, 1)),
    porousFlux_(settings(properties), faces_),
    part_(n_ * mesh.nCells(), Zero),
    mass_(n_ * mesh.nCells(), Zero),
    relaxedP_(mesh.nCells(), -1),
    z_(W_.size()),
    zB_(Wb_.size(), 1),
    soft_(W_.size() + Wb_.size(), 1),
    alphaB_(n_ * Wb_.size(), Zero),
    rhoB_(n_ * Wb_.size(), Zero),
    rho0_(computed("rho")),
    first_(W_.size() + Wb_.size(), false),
    dropped_(0),
    relaxed_(0),
    voids_(0),
    faceMass_(n_, Zero),
    wet_(false),
    beside_(false),
    bounds_(false),
    firstTry_(true),
    lastTry_(false),
    anyTorn_(false),
    warned_(n_, false),
    tension_(false),
    nuclei_(n_, Zero)
{
    for (const word& name : names)
    {
        const dictionary& dict = requiredDict(properties, name);
        wordList valid(gasThermo::New(dict)->keywords());
        valid.append(wordList({"type", "detonation", "afterburn", "nuclei", "mu", "kappa"}));
        checkKeywords(dict, valid);
    }
    checkKeywords(
        settings(properties),
        {"lowMach", "drainage", "mu", "Pr", "poreFloor", "faceDrag", "solidFraction", "viscous",
         "velocity"});
    setEnergy(true);
    t_.setSize(W_.size());
    tb_.setSize(Wb_.size(), stateTerms{1, 0, 1});
    makeFields(states);
    forAll(nuclei_, k)
    {
        nuclei_[k] = boundedOrDefault(requiredDict(properties, names[k]), "nuclei", 0, 0, 0.01);
        wet_ = wet_ || !(isGas(k) || mixture_.detonates(k));
    }
    makeBurnt(states);
    readViscosity(properties);
    interfaces_.reset(new fluidInterfaces(faces_, coupled_, n_));
    if (mag(g_) > 0)
    {
        jump_.setSize(mesh.nFaces(), 0);
        weight_.setSize(mesh.nFaces(), 0);
        reconstruction_.checkWeight();
        strata_.reset(new fluidStrata(mesh, g_));
        if (!returnReduce(strata_->active(), orOp<bool>()))
        {
            strata_.clear();
        }
    }
    start(states);
    checkTorn();
    startBurning();

    Info << "Fluids with one velocity and one pressure, "
         << returnReduce(mesh.nCells(), sumOp<label>()) << " cells:" << nl;
    Info << "    reconstruction: " << reconstruction_.description().c_str() << nl;
    tellStart(properties);
    Info << (given_ ? "    velocity and pressure: given, they stay\n" : "") << endl;
}

bool Foam::mpm::eulerianFluids::setTheta(const UList<scalar>& theta)
{
    porous_ = true;
    if (restarted_)
    {
        return true;
    }

    const List<fluidSums> before(fluidContents());

    // The fields have shares of the cell
    forAll(theta_, c)
    {
        for (label k = 0; k < n_; ++k)
        {
            alpha_[k][c] /= theta_[c];
        }
        theta_[c] = theta[c];
    }
    conserve();
    primitives();
    updateFields();
    updateBoundaryStates();
    tellDisplaced(before);
    return false;
}

void Foam::mpm::eulerianFluids::velocityChanged()
{
    if (coupled_.empty())
    {
        return;
    }
    const label nInternal = mesh_.nInternalFaces();
    for (const label f : faces_.coupled)
    {
        Wb_[f - nInternal] = W_[mesh_.faceOwner()[f]];
    }
    coupled_.swap(Wb_);
}
