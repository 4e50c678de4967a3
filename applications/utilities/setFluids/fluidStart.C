/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "fluidStart.H"
#include "dictionaryTools.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::fluidStart::readRegions(const dictionary& dict)
{
    checkKeywords(dict, {"default", "regions", "hydrostatic"});
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
                    << "Region " << name << " is not a dictionary; write  "
                    << name << " { type box; ...; fluid ...; }"
                    << exit(FatalIOError);
            }
            regions_.append
            (
                new fluidRegion(grid_, mixture_, requiredDict(regions, name), true)
            );
        }
    }
    const bool twice = regions_[0].hasP() && hydrostatic_;
    if (twice || !(regions_[0].hasP() || hydrostatic_))
    {
        FatalIOErrorInFunction(rest)
            << "The pressure is given " << (twice ? "twice" : "nowhere")
            << "; either p in default, or"
            << "  hydrostatic { point (0 0 0); p 1e5; }  beside it."
            << exit(FatalIOError);
    }
}


Foam::scalarField Foam::mpm::fluidStart::alone
(
    const label r,
    cellCutter::columns& shared
) const
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
            apart =
                apart
             || cell.min()[c] > around.max()[c]
             || cell.max()[c] < around.min()[c];
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
    const scalarField part(s*(1 - s));
    const scalar cut = sumProd(part, V), missing = exact_[r] - volume(r);
    if (cut > 0 && mag(missing) < most*cut)
    {
        const scalarField before(s);
        s += missing/cut*part;
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
    for (label r = 1; r < n; ++r)
    {
        const pointRegionShape& shape = regions_[r].shape();
        share_[r] = alone(r, shared);
        if (max(share_[r]) <= 0)
        {
            FatalIOErrorInFunction(regions_[r].dict())
                << "Region " << regions_[r].name() << " fills no part of the"
                << " mesh " << mesh_.bounds() << ": its shape lies in "
                << shape.bounds() << " [m]." << exit(FatalIOError);
        }
        if (shape.insideMesh())
        {
            exact_[r] = shape.volume();
            if (exact_[r] < 0 && shape.facets())
            {
                shapeFormula formula(true);
                shape.formula(formula);
                exact_[r] =
                    cellCutter(grid_, formula, shared).volumeInBounds();
            }
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


Foam::scalar Foam::mpm::fluidStart::pressure
(
    const label r,
    const label celli
) const
{
    return
        regions_[r].hasP() ? regions_[r].p()
      : hydrostatic_ ? p_[celli]
      : regions_[0].p();
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
                        rho[c] += share_[r][c]*regions_[r].density(pressure(r, c));
                    }
                }
            }
            const scalarField before(p_);
            hydrostatic_->solve(rho, p_);
            if (!follows || max(mag(p_ - before)) < 1e-13*max(mag(p_)))
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

Foam::mpm::fluidStart::fluidStart
(
    const fvMesh& mesh,
    const dictionary& phaseProperties,
    const wordList& names,
    const dictionary& dict,
    const vector& g
)
:
    mesh_(mesh),
    grid_(pointGrid::New(mesh)),
    mixture_(phaseProperties, names)
{
    if (dict.found("hydrostatic"))
    {
        hydrostatic_.reset
        (
            new hydrostatic(mesh, requiredDict(dict, "hydrostatic"), g)
        );
    }
    readRegions(dict);
    makeShares();
    makePressure();
}

// ************************************************************************* //
