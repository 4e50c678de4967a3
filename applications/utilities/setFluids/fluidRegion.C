/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "fluidRegion.H"
#include "dictionaryTools.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

Foam::wordList namesOf(const Foam::mpm::fluidMixture& mixture)
{
    Foam::wordList names(mixture.size());
    forAll(names, k)
    {
        names[k] = mixture.name(k);
    }
    return names;
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::fluidRegion::readDensity()
{
    const bool gas = mixture_.thermo(fluid_).isGammaLaw();
    const wordList valid(gas ? wordList({"T", "rho", "mass"}) : wordList({"rho", "mass"}));
    const word& fluid = mixture_.name(fluid_);
    DynamicList<word> given;
    for (const word key : {"T", "rho", "mass"})
    {
        if (dict_.found(key))
        {
            given.append(key);
        }
    }
    if (!gas && dict_.found("T"))
    {
        FatalIOErrorInFunction(dict_)
            << "Entry T in region " << name_ << ": fluid " << fluid
            << " is not a perfectGas; its density is that of the entry rho (or"
            << " mass), without them rho of constant/phaseProperties."
            << exit(FatalIOError);
    }
    if (given.size() > 1 || (gas && given.empty()))
    {
        FatalIOErrorInFunction(dict_)
            << "Region " << name_ << " of fluid " << fluid << " has "
            << (given.empty() ? "none" : "several") << " of the entries "
            << flatOutput(valid) << "; give one." << exit(FatalIOError);
    }
    const auto read = [&](const word& key)
    {
        return dict_.found(key) ? positive(dict_, key) : scalar(-1);
    };
    T_ = read("T");
    rho_ = read("rho");
    mass_ = read("mass");
    if (mass_ > 0 && !shape_)
    {
        FatalIOErrorInFunction(dict_)
            << "Entry mass is for a region with a shape; the default has "
            << (gas ? "T or rho." : "rho.") << exit(FatalIOError);
    }
    if (given.empty())
    {
        rho_ = mixture_.rho0(fluid_);
    }
}


void Foam::mpm::fluidRegion::readVelocity()
{
    U_ = dict_.getOrDefault<vector>("U", Zero);
    const Vector<label>& computed = grid_.mesh().solutionD();
    for (direction d = 0; d < 3; ++d)
    {
        if (computed[d] < 0 && U_[d] != 0)
        {
            FatalIOErrorInFunction(dict_)
                << "Velocity U " << U_ << " of region " << name_
                << " has a component in a direction that the mesh does not"
                << " compute; it must be 0." << exit(FatalIOError);
        }
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::fluidRegion::fluidRegion
(
    const pointGrid& grid,
    const fluidMixture& mixture,
    const dictionary& dict,
    const bool hasShape
)
:
    grid_(grid),
    mixture_(mixture),
    dict_(dict),
    name_(dict.dictName()),
    shape_(hasShape ? pointRegionShape::New(grid, dict_) : nullptr),
    fluid_(namesOf(mixture).find(oneOf(dict, "fluid", namesOf(mixture)))),
    hasP_(dict.found("p")),
    p_(hasP_ ? dict.get<scalar>("p") : 0)
{
    wordList valid({"fluid", "p", "T", "rho", "mass", "U"});
    if (shape_)
    {
        valid.append("type");
        valid.append(shape_->keywords());
    }
    checkKeywords(dict, valid);
    readDensity();
    readVelocity();
    if (shape_ && hasP_ && mixture_.detonates(fluid_))
    {
        FatalIOErrorInFunction(dict_)
            << "Region " << name_ << " has a pressure p, and its fluid "
            << mixture_.name(fluid_) << " a detonation: what has not burnt has"
            << " the pressure around it, p would add to its chemical energy."
            << nl << "Remove p; or, for products that have burnt, the entry"
            << " detonation in constant/phaseProperties." << exit(FatalIOError);
    }
    if (hasP_ && rho_ > 0)
    {
        checkPressure(p_);
    }
    if (hasP_ && mixture_.thermo(fluid_).isGammaLaw() && !(p_ > 0))
    {
        FatalIOErrorInFunction(dict_)
            << "Pressure p of region " << name_ << " is " << p_ << "; that of"
            << " the perfectGas " << mixture_.name(fluid_)
            << " must be greater than 0." << exit(FatalIOError);
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::fluidRegion::setVolume(const scalar V)
{
    if (mass_ > 0)
    {
        rho_ = mass_/V;
    }
}


Foam::scalar Foam::mpm::fluidRegion::density(const scalar p) const
{
    return rho_ > 0 ? rho_ : mixture_.thermo(fluid_).rho(p, T_);
}


void Foam::mpm::fluidRegion::checkPressure(const scalar p) const
{
    const scalar rho = density(p);
    if
    (
        !(rho > 0)
     || !(fluidMixture::c2(mixture_.at(fluid_, rho), rho, p) > 0)
    )
    {
        FatalIOErrorInFunction(dict_)
            << "Fluid " << mixture_.name(fluid_) << " of region " << name_
            << " has no real speed of sound at p " << p << " and rho " << rho
            << "." << exit(FatalIOError);
    }
}


void Foam::mpm::fluidRegion::warnOfCelsius(const scalar p) const
{
    if (T_ > 10 && T_ < 60 && p > 5e4)
    {
        IOWarningInFunction(dict_)
            << "Entry T of region " << name_ << " is " << T_ << " K: it is in"
            << " K. " << T_ << " degrees Celsius are " << T_ + 273.15 << " K."
            << endl;
    }
}

// ************************************************************************* //
