// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "fluidStart.H"
#include "dictionaryTools.H"
#include "farFieldFvPatchField.H"
#include "fullPrecision.H"
#include "basicSymmetryFvPatchFields.H"
#include "wallPolyPatch.H"
#include "Time.H"
#include <cstdio>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::fluidStart::readRegions(const dictionary& dict)
{
    // Other words are variables of the user, as in setMaterialPointsDict, if not misspelt
    const wordList own({"default", "regions", "hydrostatic"});
    dictionary read(dict);
    for (const word& key : dict.toc())
    {
        if (!own.found(key) && nearWord(key, own).empty())
        {
            read.remove(key);
        }
    }
    checkKeywords(read, own);
    const dictionary& rest = requiredDict(dict, "default");
    regions_.append(new fluidRegion(grid_, mixture_, rest, false));
    if (dict.found("regions"))
    {
        const dictionary& regions = requiredDict(dict, "regions");
        for (const word& name : regions.toc())
        {
            if (!regions.isDict(name))
            {
                FatalIOErrorInFunction(regions)
                    << "Region " << name << " is not a dictionary; write  " << name
                    << " { type box; ...; fluid ...; }" << exit(FatalIOError);
            }
            regions_.append(new fluidRegion(grid_, mixture_, requiredDict(regions, name), true));
        }
    }
    const bool twice = regions_[0].hasP() && hydrostatic_;
    if (twice || !(regions_[0].hasP() || hydrostatic_))
    {
        FatalIOErrorInFunction(rest)
            << "The pressure is given " << (twice ? "twice" : "nowhere")
            << "; either p in default, or"
            << "  hydrostatic { point (0 0 0); p 1e5; }  beside it." << exit(FatalIOError);
    }
}

Foam::scalarField Foam::mpm::fluidStart::alone(const label r, cellCutter::columns& shared) const
{
    const pointRegionShape& shape = regions_[r].shape();
    shapeFormula formula(true);
    shape.formula(formula);
    const cellCutter cutter(grid_, formula, shared);

    const boundBox around(shape.bounds());
    scalarField s(mesh_.nCells(), Zero);
    forAll(s, celli)
    {
        const boundBox cell(mesh_.points(), mesh_.cellPoints()[celli], false);
        bool apart = false;
        for (int d = 0; d < grid_.nDim(); ++d)
        {
            const int c = grid_.direction(d);
            apart = apart || cell.min()[c] > around.max()[c] || cell.max()[c] < around.min()[c];
        }
        s[celli] = apart ? scalar(0) : cutter.share(celli);
    }
    return s;
}

Foam::boolList Foam::mpm::fluidStart::cover(cellCutter::columns& shared)
{
    const label n = regions_.size();
    boolList lost(n, false);
    for (label r = 1; r < n; ++r)
    {
        shapeFormula formula(true);
        regions_[r].shape().formula(formula);
        for (label q = r + 1; q < n; ++q)
        {
            regions_[q].shape().formula(formula);
            formula.notLast();
            formula.andLast();
        }
        const cellCutter cutter(grid_, formula, shared);
        scalarField& s = share_[r];
        forAll(s, celli)
        {
            scalar later = 0;
            for (label q = r + 1; q < n && s[celli] > 0; ++q)
            {
                later = max(later, share_[q][celli]);
            }
            if (later > 0)
            {
                const scalar before = s[celli];
                s[celli] = later == 1 ? scalar(0) : cutter.share(celli);
                lost[r] = lost[r] || before - s[celli] > 1e-12;
            }
        }
    }
    return lost;
}

Foam::scalar Foam::mpm::fluidStart::volume(const label r) const
{
    return sumProd(share_[r], mesh_.V().field());
}

void Foam::mpm::fluidStart::correct(const label r)
{
    constexpr scalar most = 0.1;

    const scalarField& V = mesh_.V();
    scalarField& s = share_[r];
    const scalarField part(s * (1 - s));
    const scalar cut = sumProd(part, V), missing = exact_[r] - volume(r);
    if (cut > 0 && mag(missing) < most * cut)
    {
        const scalarField before(s);
        s += missing / cut * part;
        moved_[r] = max(mag(s - before));
    }
}

void Foam::mpm::fluidStart::makeShares()
{
    const label n = regions_.size();
    cellCutter::columns shared;
    share_.setSize(n);
    exact_.setSize(n, -1);
    moved_.setSize(n, 0);
    inMesh_.setSize(n, 1);
    for (label r = 1; r < n; ++r)
    {
        const pointRegionShape& shape = regions_[r].shape();
        share_[r] = alone(r, shared);
        if (max(share_[r]) <= 0)
        {
            FatalIOErrorInFunction(regions_[r].dict())
                << "Region " << regions_[r].name() << " fills no part of the"
                << " mesh " << mesh_.bounds() << ": its shape lies in " << shape.bounds() << " [m]."
                << exit(FatalIOError);
        }
        if (shape.insideMesh())
        {
            exact_[r] = shape.volume();
            if (exact_[r] < 0 && shape.facets())
            {
                shapeFormula formula(true);
                shape.formula(formula);
                exact_[r] = cellCutter(grid_, formula, shared).volumeInBounds();
            }
        }
        else if (shape.type() != "box" && shape.volume() > 0)
        {
            // A box is often larger on purpose
            inMesh_[r] = volume(r) / shape.volume();
        }
    }
    const boolList lost(cover(shared));
    share_[0].setSize(mesh_.nCells(), 1);
    for (label r = 1; r < n; ++r)
    {
        if (lost[r])
        {
            exact_[r] = -1;
        }
        if (exact_[r] > 0)
        {
            correct(r);
        }
        const scalar V = volume(r);
        if (!(V > 0))
        {
            FatalIOErrorInFunction(regions_[r].dict())
                << "Region " << regions_[r].name() << " is covered by the"
                << " regions after it; nothing of it is left. Later regions lie"
                << " on top." << exit(FatalIOError);
        }
        regions_[r].setVolume(V);
        share_[0] -= share_[r];
    }
    // What is left of the default is rounding where it is as little
    for (scalar& s : share_[0])
    {
        s = s < 1e-13 ? 0 : s;
    }
}

Foam::scalar Foam::mpm::fluidStart::pressure(const label r, const label celli) const
{
    return regions_[r].hasP() ? regions_[r].p() : hydrostatic_ ? p_[celli] : regions_[0].p();
}

void Foam::mpm::fluidStart::layer()
{
    if (!hydrostatic_->strata().active())
    {
        return;
    }
    const label n = mixture_.size();
    scalarField part(n * mesh_.nCells(), Zero), mass(part);
    DynamicList<label> mixed;
    forAll(p_, c)
    {
        label several = 0;
        forAll(regions_, r)
        {
            const label at = n * c + regions_[r].fluid();
            if (share_[r][c] > 0)
            {
                several += !(part[at] > 0);
                part[at] += share_[r][c];
                mass[at] += share_[r][c] * regions_[r].density(pressure(r, c));
            }
        }
        if (several > 1)
        {
            mixed.append(c);
        }
    }
    hydrostatic_->strata().update(mixed, boolList(p_.size(), true), n, part, mass);
}

void Foam::mpm::fluidStart::makePressure()
{
    if (hydrostatic_)
    {
        constexpr label most = 50;

        p_.setSize(mesh_.nCells(), hydrostatic_->p());
        for (label i = 0; i < most; ++i)
        {
            // Gases are denser below
            scalarField rho(p_.size(), Zero);
            bool follows = false;
            forAll(regions_, r)
            {
                follows = follows || (regions_[r].ofPressure() && !regions_[r].hasP());
                forAll(rho, c)
                {
                    if (share_[r][c] > 0)
                    {
                        rho[c] += share_[r][c] * regions_[r].density(pressure(r, c));
                    }
                }
            }
            const scalarField before(p_);
            layer();
            hydrostatic_->solve(rho, p_);
            if (!follows || max(mag(p_ - before)) < 1e-13 * max(mag(p_)))
            {
                break;
            }
        }
    }
    forAll(regions_, r)
    {
        scalar low = VGREAT, high = -VGREAT;
        forAll(share_[r], c)
        {
            if (share_[r][c] > 0)
            {
                low = min(low, pressure(r, c));
                high = max(high, pressure(r, c));
            }
        }
        if (low <= high)
        {
            regions_[r].checkPressure(low);
            regions_[r].checkPressure(high);
            regions_[r].warnOfCelsius(low);
        }
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::fluidStart::fluidStart(
    const fvMesh& mesh, const dictionary& phaseProperties, const wordList& names,
    const dictionary& dict, const vector& g) :
    mesh_(mesh), grid_(pointGrid::New(mesh)), mixture_(phaseProperties, names)
{
    if (dict.found("hydrostatic"))
    {
        hydrostatic_.reset(new hydrostatic(mesh, requiredDict(dict, "hydrostatic"), g));
    }
    readRegions(dict);
    makeShares();
    makePressure();
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::mpm::fluidStart::elsewhere(const label k, const scalar p) const
{
    const gasThermo& thermo = mixture_.thermo(k);
    for (const fluidRegion& region : regions_)
    {
        if (region.fluid() == k)
        {
            const scalar rho = region.density(region.hasP() ? region.p() : p);
            return thermo.isGammaLaw() ? (region.hasP() ? region.p() : p) / (thermo.R() * rho)
                                       : rho;
        }
    }
    return thermo.isGammaLaw() ? scalar(300) : mixture_.rho0(k);
}

template<class Type>
Foam::boolList Foam::mpm::fluidStart::farPatches(const word& name) const
{
    typedef GeometricField<Type, fvPatchField, volMesh> fieldType;
    boolList far(mesh_.boundary().size(), false);
    IOobject io(
        name, mesh_.time().timeName(), mesh_, IOobject::MUST_READ, IOobject::NO_WRITE, false);
    if (io.typeHeaderOk<fieldType>(true))
    {
        const fieldType field(io, mesh_);
        forAll(far, i)
        {
            far[i] = isA<farFieldFvPatchField<Type>>(field.boundaryField()[i]);
        }
    }
    return far;
}

template<class Type>
void Foam::mpm::fluidStart::write(
    const word& name, const dimensionSet& dimensions, const Field<Type>& values,
    const word& onWalls, const boolList& far) const
{
    typedef GeometricField<Type, fvPatchField, volMesh> fieldType;

    IOobject io(
        name, mesh_.time().timeName(), mesh_, IOobject::MUST_READ, IOobject::NO_WRITE, false);
    autoPtr<fieldType> field;
    if (io.typeHeaderOk<fieldType>(true))
    {
        // Its conditions
        field.reset(new fieldType(io, mesh_));
    }
    else
    {
        io.readOpt() = IOobject::NO_READ;
        wordList types(mesh_.boundary().size(), "zeroGradient");
        forAll(types, i)
        {
            const polyPatch& patch = mesh_.boundaryMesh()[i];
            if (polyPatch::constraintType(patch.type()))
            {
                types[i] = patch.type();
            }
            else if (far.size() && far[i])
            {
                types[i] = "farField";
            }
            else if (isA<wallPolyPatch>(patch))
            {
                types[i] = onWalls;
            }
        }
        field.reset(new fieldType(io, mesh_, dimensioned<Type>("zero", dimensions, Zero), types));
    }
    field->primitiveFieldRef() = values;
    field->correctBoundaryConditions();
    Info << "Writing " << field->objectPath() << endl;
    field->write();
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::fluidStart::printTable() const
{
    char line[200];
    const auto number = [&](const scalar x, const int digits = 12)
    {
        char text[40];
        std::snprintf(text, sizeof(text), "%.*g", digits, x);
        return std::string(x < 0 ? "-" : text);
    };
    std::snprintf(
        line, sizeof(line), "%-16s %-12s %20s %20s %20s %10s", "region", "fluid", "volume [m3]",
        "of the shape [m3]", "mass [kg]", "corrected");
    Info << line << nl;
    scalar all = 0;
    forAll(regions_, r)
    {
        scalar mass = 0;
        forAll(share_[r], c)
        {
            if (share_[r][c] > 0)
            {
                mass += share_[r][c] * mesh_.V()[c] * regions_[r].density(pressure(r, c));
            }
        }
        all += volume(r);
        std::snprintf(
            line, sizeof(line), "%-16s %-12s %20s %20s %20s %10s", regions_[r].name().c_str(),
            mixture_.name(regions_[r].fluid()).c_str(), number(volume(r)).c_str(),
            number(exact_[r]).c_str(), number(mass).c_str(),
            number(r == 0 ? -1 : moved_[r], 2).c_str());
        Info << line << nl;
        if (inMesh_[r] < 0.999)
        {
            Info << "    of the " << regions_[r].shape().type() << " "
                 << number(100 * inMesh_[r], 3).c_str() << " % lie in the mesh" << nl;
        }
    }
    Info << "All regions fill " << number(all).c_str() << " m3, the mesh has "
         << number(gSum(mesh_.V())).c_str() << " m3. corrected: largest change"
         << " of a share" << nl << endl;
}

void Foam::mpm::fluidStart::write() const
{
    const label n = mesh_.nCells(), nFluids = mixture_.size();
    List<scalarField> alpha(nFluids), state(nFluids);
    scalarField p(n, Zero);
    vectorField U(n, Zero);
    for (label k = 0; k < nFluids; ++k)
    {
        alpha[k].setSize(n, Zero);
        state[k].setSize(n, Zero);
    }
    scalarList theta(nFluids), m(nFluids);
    for (label c = 0; c < n; ++c)
    {
        theta = 0;
        m = 0;
        scalar energy = 0, low = VGREAT, high = -VGREAT, mass = 0, shares = 0;
        forAll(regions_, r)
        {
            const scalar s = share_[r][c];
            if (s > 0)
            {
                const label k = regions_[r].fluid();
                const scalar pr = pressure(r, c);
                const scalar rho = regions_[r].density(pr);
                theta[k] += s;
                m[k] += s * rho;
                mass += s * rho;
                shares += s;
                U[c] += s * rho * regions_[r].U();
                energy += s * fluidMixture::energy(mixture_.at(k, rho), rho, pr);
                low = min(low, pr);
                high = max(high, pr);
            }
        }
        U[c] /= mass;
        p[c] = low == high ? low : mixture_.pressure(theta.cdata(), m.cdata(), energy);
        for (label k = 0; k < nFluids; ++k)
        {
            alpha[k][c] = theta[k] / shares;
            const scalar rho = theta[k] > 0 ? m[k] / theta[k] : 0;
            const gasThermo& thermo = mixture_.thermo(k);
            state[k][c] = !(theta[k] > 0) ? elsewhere(k, p[c])
                : thermo.isGammaLaw()     ? p[c] / (thermo.R() * rho)
                                          : rho;
        }
    }

    const fullPrecision allDigits;
    write("p", dimPressure, p, "zeroGradient", farPatches<vector>("U"));
    write("U", dimVelocity, U, "slip", farPatches<scalar>("p"));
    for (label k = 0; k < nFluids; ++k)
    {
        const word& name = mixture_.name(k);
        const bool gas = mixture_.thermo(k).isGammaLaw();
        write(IOobject::groupName("alpha", name), dimless, alpha[k], "zeroGradient");
        write(
            IOobject::groupName(gas ? "T" : "rho", name), gas ? dimTemperature : dimDensity,
            state[k], "zeroGradient");
    }
}
