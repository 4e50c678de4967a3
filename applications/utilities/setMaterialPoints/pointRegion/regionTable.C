/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "regionTable.H"
#include "localIOdictionary.H"
#include "IOmanip.H"
#include "StringStream.H"
#include "failureModel.H"
#include "phaseNames.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- A line of the table; a negative volume is not known
void printLine
(
    const std::string& region,
    const word& phase,
    const label nPoints,
    const scalar mass,
    const scalar volume,
    const scalar exactVolume
)
{
    const auto padded = [](std::string s)
    {
        s.resize(max(s.size(), std::size_t(15)), ' ');
        return s + ' ';
    };

    OStringStream line;
    line.precision(6);
    line<< "    " << padded(region).c_str() << padded(phase).c_str()
        << setw(10) << nPoints << setw(14) << mass << setw(14) << volume;
    if (exactVolume > 0)
    {
        line<< setw(14) << exactVolume
            << setw(14) << (volume - exactVolume)/exactVolume;
    }
    else
    {
        line<< setw(14) << "n/a" << setw(14) << "n/a";
    }
    Info<< line.str().c_str() << nl;
}


//- How much of a shape lies outside the mesh; may be meant (half a body at a
//  symmetry plane)
std::string outside(const mpm::pointRegion& r)
{
    if (r.shape().insideMesh() || r.shape().type() == "cells")
    {
        return "";
    }
    const scalar whole = r.wholeVolume();
    const scalar part = whole > 0 ? 1 - r.volume()/whole : 0;
    return
        "; it reaches beyond the mesh"
      + (
            part > 1e-3
          ? ", " + Foam::name(0.1*std::round(1000*part))
          + " % of it has no points"
          : std::string()
        );
}


//- The start pressure on the cells, empty without a file of it
scalarField startPressure(const polyMesh& mesh)
{
    const IOobject io
    (
        "p",
        mesh.time().timeName(),
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
    if (!isFile(io.objectPath()) && !isFile(io.objectPath() + ".gz"))
    {
        return scalarField();
    }
    // What is wrong in the file the solver says
    const bool threw = FatalIOError.throwExceptions();
    scalarField p;
    try
    {
        const localIOdictionary file(io, "volScalarField");
        p = scalarField("internalField", file, mesh.nCells());
    }
    catch (const Foam::error&)
    {
        p.clear();
    }
    FatalIOError.throwExceptions(threw);
    return p;
}


//- Warn of points that start with another pressure than the gas around them
void checkAmbient(const mpm::pointRegion& r, const scalarField& p)
{
    const scalar ambient = r.ambientPressure();
    if (ambient < 0 || p.empty())
    {
        return;
    }
    scalar low = GREAT, high = -GREAT;
    for (const label celli : r.cells())
    {
        low = min(low, p[celli]);
        high = max(high, p[celli]);
    }
    if (ambient < 0.9*low || ambient > 1.1*high)
    {
        WarningInFunction
            << "Region " << r.name() << " starts with the pressure " << ambient
            << " Pa; the gas in its cells has " << low << " to " << high
            << " Pa. They are not in equilibrium." << endl;
    }
}


//- Warn of cells in which points of a region cannot soften: their widest bands
//  are those across a diagonal, of the strongest point. firstId: of the region
void checkSoftening
(
    const mpm::materialPointPhase& phase,
    const mpm::pointRegion& r,
    const label firstId
)
{
    const mpm::failureModel* failure = phase.failure();
    if (!failure || !failure->softens())
    {
        return;
    }
    scalar strongest = failure->strength();
    if (failure->scatters())
    {
        strongest = 0;
        forAll(r.points(), i)
        {
            strongest = max
            (
                strongest,
                failure->strength
                (
                    uint64_t(firstId + i),
                    r.points()[i].mass/phase.rho()
                )
            );
        }
    }
    const scalar widest = failure->widestBand(strongest);
    const scalar h = r.widestCell();
    const scalar diagonal = std::sqrt(scalar(phase.cloud().grid().nDim()));
    if (diagonal*h >= widest)
    {
        WarningInFunction
            << "Region " << r.name() << " has cells of " << h
            << " m; softening with the Gf of phase " << phase.name()
            << " needs bands narrower than 2 E Gf/strength^2 = " << widest
            << " m, with " << strongest << " Pa of its strongest point. A band"
            << " is " << h << " m wide along the cells and up to "
            << diagonal*h << " m across them. The run would stop where such a"
            << " point fails"
            << (h < widest ? " obliquely" : "")
            << ". Use smaller cells, or no Gf." << endl;
    }
}

}

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::mpm::printTable
(
    const wordList& phases,
    const PtrList<pointRegion>& regions
)
{
    Info<< "    region          phase               points     mass [kg]"
        << "   volume [m3]    exact [m3]    difference" << nl;

    forAll(regions, i)
    {
        const pointRegion& r = regions[i];
        printLine
        (
            r.name(), r.phase(), r.points().size(), r.mass(), r.volume(),
            r.exactVolume()
        );
    }
    Info<< nl;

    for (const word& phase : phases)
    {
        label n = 0;
        scalar mass = 0, volume = 0, exact = 0;
        forAll(regions, j)
        {
            const pointRegion& r = regions[j];
            if (r.phase() == phase)
            {
                n += r.points().size();
                mass += r.mass();
                volume += r.volume();
                const scalar v = r.exactVolume();
                exact = v < 0 || exact < 0 ? -1 : exact + v;
            }
        }
        printLine("total", phase, n, mass, volume, exact);
    }
    Info<< endl;
}



void Foam::mpm::printStart
(
    const dictionary& phaseProperties,
    const PtrList<materialPointPhase>& phases,
    const PtrList<pointRegion>& regions
)
{
    const wordList gases(phaseNames(phaseProperties, {"gas"}));
    const bool contact = phaseProperties.found("contact");

    wordList names(phases.size());
    forAll(phases, i)
    {
        names[i] = phases[i].name();
    }
    const auto phaseOf = [&](const pointRegion& r) -> const materialPointPhase&
    {
        return phases[names.find(r.phase())];
    };

    for (const pointRegion& r : regions)
    {
        const boundBox bb(r.bounds());
        Info<< "    " << r.name() << ": " << r.type() << " of "
            << bb.span() << " m from " << bb.min() << " to " << bb.max()
            << " m, " << r.pointsPerCell()
            << (r.byElements() ? " points per element" : " points per cell")
            << (r.samplesUnused()
              ? "; samples is not used, parts of sub-cells are exact"
              : "")
            << outside(r).c_str() << nl;
        if (r.wholeSubCells())
        {
            const boundBox filled(r.pointBounds());
            Info<< "        points (whole sub-cells in a gas) fill "
                << filled.span() << " m from " << filled.min() << " to "
                << filled.max() << " m" << nl;
        }
    }
    Info<< endl;

    const scalarField p
    (
        gases.size() ? startPressure(phases[0].cloud().grid().mesh())
      : scalarField()
    );
    for (const materialPointPhase& phase : phases)
    {
        if
        (
            gases.size() && phase.failure()
         && phase.failure()->ambient() <= 0
        )
        {
            WarningInFunction
                << "Phase " << phase.name() << " may fail in the gas "
                << gases[0] << " and its failureModel has no ambientPressure:"
                << " the gas would not enter the cracks. Write"
                << "  ambientPressure <of the gas>;" << endl;
        }
    }

    forAll(regions, i)
    {
        const pointRegion& r = regions[i];
        const materialPointPhase& phase = phaseOf(r);
        checkAmbient(r, p);
        const string hint(r.sizeHint());
        if (hint.size())
        {
            WarningInFunction
                << "Region " << r.name() << ":" << hint.c_str() << endl;
        }
        if
        (
            gases.size() && !phase.motion() && !r.hasStress()
         && !r.granular()
        )
        {
            WarningInFunction
                << "Region " << r.name() << " lies in the gas " << gases[0]
                << " and starts without stress: the gas will press it"
                << " together at once. For equilibrium write"
                << "  stress ambient; pressure <of the gas>;" << endl;
        }
        label firstId = 0;
        for (label j = 0; j < i; ++j)
        {
            firstId +=
                regions[j].phase() == r.phase() ? regions[j].points().size() : 0;
        }
        checkSoftening(phase, r, firstId);
        for (label j = 0; j < i; ++j)
        {
            point where;
            if
            (
                phaseOf(regions[j]).velocityField() != phase.velocityField()
             && regions[j].overlap(r, where) >= 0
            )
            {
                WarningInFunction
                    << "Regions " << regions[j].name() << " and " << r.name()
                    << " overlap at " << where << ": "
                    << (contact
                      ? "contact stops them there but does not part them."
                      : "they have different velocity fields, and nothing"
                        " keeps them apart.")
                    << " Change a shape, or write  overlap allow;  in one of"
                    << " the regions if that is meant." << endl;
            }
        }
    }
}

// ************************************************************************* //
