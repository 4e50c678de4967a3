// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "eulerianGas.H"
#include "dictionaryTools.H"
#include "noTraps.H"
#include "StringStream.H"
#include "HashTable.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Conditions that look fields up by names, which have the gas behind them
template<class Field>
void checkNames(const Field& field, const word& gas)
{
    const HashTable<wordList> asks(
        {{"waveTransmissive", {"phi", "psi"}},
         {"advective", {"phi"}},
         {"inletOutlet", {"phi"}},
         {"outletInlet", {"phi"}},
         {"pressureInletOutletVelocity", {"phi"}},
         {"totalPressure", {"phi", "U"}},
         {"totalTemperature", {"phi", "U"}}});
    for (const auto& pf : field.boundaryField())
    {
        if (!asks.found(pf.type()))
        {
            continue;
        }
        OStringStream os;
        pf.write(os);
        IStringStream is(os.str());
        const dictionary dict(is);
        const bool total = pf.type().compare(0, 5, "total") == 0;
        const bool byRho =
            pf.type() == "totalPressure" && dict.getOrDefault<word>("psi", "none") == "none";

        // The first asks for the density where it has no psi
        wordList keys(asks[pf.type()]);
        if (total)
        {
            keys.append(byRho ? "rho" : "psi");
        }
        for (const word& key : keys)
        {
            const word name(dict.getOrDefault<word>(key, key));
            if (pf.db().template foundObject<regIOobject>(name))
            {
                continue;
            }
            OStringStream names;
            for (const word& k : keys)
            {
                if (!(total && (k == "psi" || k == "rho")))
                {
                    names << ' ' << k << ' ' << IOobject::groupName(k, gas) << ';';
                }
            }
            if (total)
            {
                names << " psi " << IOobject::groupName("psi", gas) << "; gamma <of the gas>;";
            }
            if (pf.type() == "totalPressure")
            {
                names << nl << "or, without compression by its speed, psi none;"
                      << " rho " << IOobject::groupName("rho", gas)
                      << "; in place of psi and gamma.";
            }
            OStringStream fields;
            for (const char* own : {"phi", "U", "psi", "rho", "T"})
            {
                fields << ' ' << IOobject::groupName(own, gas);
            }
            FatalErrorInFunction << "The condition " << pf.type() << " of patch "
                                 << pf.patch().name() << " of " << field.name() << " ("
                                 << field.objectPath() << ") looks for the field " << name
                                 << ", which is called " << IOobject::groupName(key, gas) << "."
                                 << nl << "Add the entries:" << names.str().c_str() << nl
                                 << "Fields of the gas: p" << fields.str().c_str()
                                 << exit(FatalError);
        }
    }
}

//- Warn of a temperature that is probably one in degrees Celsius: below 100 K
//  everywhere, at a pressure of a scene in SI units
void warnOfCelsius(const volScalarField& T, const volScalarField& p)
{
    const scalar low = gMin(T.primitiveField());
    const scalar high = gMax(T.primitiveField());
    if (high < 100 && gMax(p.primitiveField()) > 1e3)
    {
        Ostream& os = WarningInFunction;
        os << T.name() << " starts with " << low;
        if (high > low)
        {
            os << " to " << high;
        }
        os << " K (" << T.objectPath() << "): it is in K. " << high << " degrees Celsius are "
           << high + 273.15 << " K." << endl;
    }
}

//- Warn of a pressure that is probably one in bar: below 100 Pa everywhere, at
//  the temperature of a scene in SI units
void warnOfBar(const volScalarField& T, const volScalarField& p)
{
    const scalar high = gMax(p.primitiveField());
    const scalar low = gMin(T.primitiveField());
    if (high < 100 && low > 200)
    {
        WarningInFunction << "The gas starts with a pressure of " << high << " Pa ("
                          << p.objectPath() << ") at " << low << " K: that is a vacuum."
                          << " 1 bar is 1e5 Pa." << endl;
    }
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::eulerianGas::checkConditions() const
{
    checkNames(p_, name_);
    checkNames(U_, name_);
    if (T_)
    {
        checkNames(*T_, name_);
    }
    if (readsRho())
    {
        checkNames(rho0_, name_);
    }
}

void Foam::mpm::eulerianGas::conserve()
{
    const noTraps guard;
    closure_.conserve(
        conserved(), p_.primitiveField(), U_.primitiveField(),
        T_ && thermo_.isGammaLaw() ? T_->primitiveField().cdata() : nullptr,
        rho0_.primitiveField());
}

void Foam::mpm::eulerianGas::primitives()
{
    ownPressure::found found;
    {
        const noTraps guard;
        const bool hasT = T_ && thermo_.isGammaLaw();
        found = closure_.correct(
            conserved(), faceRates_,
            {W_, t_, p_.primitiveFieldRef(), U_.primitiveFieldRef(), rho0_.primitiveFieldRef(),
             hasT ? T_->primitiveFieldRef().data() : nullptr},
            region_);
        region_.join();
    }
    setRate(found.rate, found.bad);
}

void Foam::mpm::eulerianGas::readViscosity(const dictionary& dict)
{
    if (!dict.getOrDefault<bool>("viscous", false))
    {
        if (dict.found("kappa"))
        {
            FatalIOErrorInFunction(dict) << "Entry kappa of " << name_ << " conducts heat only with"
                                         << "  viscous yes;" << exit(FatalIOError);
        }
        return;
    }
    mu_ = bounded(dict, "mu", 0, GREAT);
    kappa_ = boundedOrDefault(dict, "kappa", 0, 0, GREAT);
    if (kappa_ > 0 && !thermo_.hasTemperature())
    {
        FatalIOErrorInFunction(dict)
            << "Entry kappa of " << name_ << " (" << thermo_.description().c_str()
            << ") needs a temperature: thermo"
            << " perfectGas, or Cv beside an equationOfState that has one." << exit(FatalIOError);
    }
    viscous_.reset(new viscousFlux(mesh_, faces_, coupled_));
    viscous_->mu = mu_;
    viscous_->kappa = kappa_;
}

bool Foam::mpm::eulerianGas::canGet(const label c, const scalar heat) const
{
    return !thermo_.isGammaLaw() || keepsEnergy(rhoE_[c] - 0.5 * magSqr(rhoU_[c]) / rho_[c], heat);
}

void Foam::mpm::eulerianGas::readRegion(const dictionary& dict)
{
    if (!dict.getOrDefault<bool>("activeRegion", false))
    {
        return;
    }
    const char* why = mag(g_) > 0 ? "gravity acts on it"
        : viscous_                ? "it is viscous"
        : t_.size()               ? "it has an equationOfState"
                                  : nullptr;
    if (why)
    {
        FatalIOErrorInFunction(dict)
            << "activeRegion of " << name_ << ": " << why
            << ", and no cell is left alone. Remove activeRegion." << exit(FatalIOError);
    }
    region_.use(reconstruction_.rings(), !reconstruction_.upwind() && reconstruction_.byCells());
}

const Foam::volScalarField* Foam::mpm::eulerianGas::transport(scalarField& rhoCv)
{
    if (!(kappa_ > 0))
    {
        return nullptr;
    }
    if (!thermo_.isGammaLaw())
    {
        updateTemperature();
    }
    rhoCv = thermo_.Cv() * rho_;
    return &T_();
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::eulerianGas::eulerianGas(
    const fvMesh& mesh, const word& name, const dictionary& dict, const vector& g,
    const fieldStates* states) :
    eulerianFlow(mesh, name, name, g, states),
    thermoPtr_(gasThermo::New(dict)),
    thermo_(*thermoPtr_),
    faceFlux_(mpm::faceFlux::New(dict, faces_)),
    closure_(thermo_),
    T_(!thermo_.hasTemperature() ? nullptr
           : thermo_.isGammaLaw()
           ? new volScalarField(startField<volScalarField>("T", states, name))
           : new volScalarField(computed("T"))),
    mu_(0),
    kappa_(0),
    rho0_(readsRho() ? startField<volScalarField>("rho", states, name) : computed("rho"))
{
    wordList valid(thermo_.keywords());
    valid.append(wordList(
        {"type", "mu", "Pr", "kappa", "viscous", "poreFloor", "faceDrag", "faceFlux",
         "solidFraction", "activeRegion"}));
    valid.append(faceFlux_->keywords());
    checkKeywords(dict, valid);

    if (!thermo_.isGammaLaw())
    {
        t_.setSize(W_.size());
        tb_.setSize(Wb_.size());
    }
    setEnergy(thermo_.hasEnergy());
    checkConditions();
    readViscosity(dict);
    readRegion(dict);
    start(states);
    if (T_ && !restarted_ && thermo_.isGammaLaw())
    {
        warnOfCelsius(*T_, p_);
        warnOfBar(*T_, p_);
    }

    Info << "Gas " << name_ << ": " << thermo_.description().c_str();
    Info << ", " << returnReduce(mesh.nCells(), sumOp<label>()) << " cells" << nl
         << "    reconstruction: " << reconstruction_.description().c_str() << nl << endl;
}

void Foam::mpm::eulerianGas::start(const fieldStates* states)
{
    restarted_ = states || isThere(header("thetaRho", IOobject::MUST_READ, name_));
    if (!restarted_)
    {
        begin();
        return;
    }
    readState(states);
    typedef volScalarField::Internal scalars;
    rho_ = startField<scalars>("thetaRho", states, name_).field();
    const scalarField p(p_.primitiveField());
    primitives();
    const noTraps guard;
    scalar change = 0;
    forAll(p, c)
    {
        const scalar size = t_.empty() ? p_[c] : t_[c].K;
        const scalar d = mag(p[c] - p_[c]) / size;
        change = d < GREAT ? max(change, d) : GREAT;
    }
    reduce(change, maxOp<scalar>());
    if (!states && !(change < 1e-6))
    {
        FatalErrorInFunction << "Field p of time " << mesh_.time().timeName()
                             << " differs by up to " << change << " of its value from the"
                             << " pressure of the state thetaRho." << name_ << ", thetaRhoU."
                             << name_ << ", thetaRhoE." << name_ << " of that time." << nl
                             << "If p was changed on purpose, remove these three files and the"
                             << " run starts from p, T." << name_ << ", U." << name_ << "."
                             << exit(FatalError);
    }
    far_->setValues(W_, g_, U_, p_);
    updateBoundaryStates();
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::mpm::eulerianGas::setTheta(const UList<scalar>& theta)
{
    porous_ = true;
    if (restarted_)
    {
        return true;
    }
    theta_ = theta;
    conserve();
    primitives();
    updateBoundaryStates();
    return false;
}
