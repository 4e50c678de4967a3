// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "regionTable.H"
#include "localIOdictionary.H"
#include "IOmanip.H"
#include "StringStream.H"
#include "failureModel.H"
#include "phaseNames.H"
#include "HashSet.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- A line of the table; a negative volume is not known
void printLine(
    const std::string& region, const word& phase, const label nPoints, const scalar mass,
    const scalar volume, const scalar exactVolume)
{
    const auto padded = [](std::string s)
    {
        s.resize(max(s.size(), std::size_t(15)), ' ');
        return s + ' ';
    };

    OStringStream line;
    line.precision(6);
    line << "    " << padded(region).c_str() << padded(phase).c_str() << setw(10) << nPoints
         << setw(14) << mass << setw(14) << volume;
    if (exactVolume > 0)
    {
        line << setw(14) << exactVolume << setw(14) << (volume - exactVolume) / exactVolume;
    }
    else
    {
        line << setw(14) << "n/a" << setw(14) << "n/a";
    }
    Info << line.str().c_str() << nl;
}

//- Share of a shape that lies beyond the mesh; negative: nothing, or not known
scalar shareOutside(const mpm::pointRegion& r)
{
    if (r.shape().insideMesh() || r.shape().type() == "cells")
    {
        return -1;
    }
    const scalar whole = r.wholeVolume();
    return whole > 0 ? 1 - r.volume() / whole : 0;
}

//- A share in per cent
std::string percent(const scalar part)
{
    return part > 0.9995 ? "more than 99.9" : Foam::name(0.1 * std::round(1000 * part));
}

//- How much of a shape lies outside the mesh
std::string outside(const mpm::pointRegion& r)
{
    const scalar part = shareOutside(r);
    return part < 0 ? std::string()
                    : "; it reaches beyond the mesh"
            + (part > 1e-3 ? ", " + percent(part) + " % of it has no points" : std::string());
}

//- The boxes of the bodies
void printBodies(const PtrList<mpm::pointRegion>& regions)
{
    for (const mpm::pointRegion& r : regions)
    {
        const boundBox bb(r.bounds());
        Info << "    " << r.name() << ": " << r.type() << " of " << bb.span() << " m from "
             << bb.min() << " to " << bb.max() << " m, " << r.pointsPerCell()
             << (r.pointsPerCell() == 1 ? " point per " : " points per ")
             << (r.byElements() ? "element" : "cell")
             << (r.samplesUnused() ? "; samples is not used, parts of sub-cells are exact" : "")
             << outside(r).c_str() << nl;
        const scalar asked = r.askedMass();
        if (asked > 0)
        {
            OStringStream line;
            line.precision(6);
            line << "        mass asked " << asked << " kg, put " << r.mass() << " kg, difference "
                 << 100 * (r.mass() / asked - 1) << " %";
            Info << line.str().c_str() << nl;
        }
        if (r.wholeSubCells())
        {
            const boundBox filled(r.pointBounds());
            Info << "        points (whole sub-cells in a gas) fill " << filled.span() << " m from "
                 << filled.min() << " to " << filled.max() << " m" << nl;
        }
    }
    Info << endl;
}

//- Largest ratio of a body's side to that of the mesh
scalar largestRatio(const mpm::pointGrid& grid, const boundBox& body)
{
    const vector mesh(grid.mesh().bounds().span());
    scalar ratio = 0;
    for (int d = 0; d < grid.nDim(); ++d)
    {
        const int c = grid.direction(d);
        ratio = max(ratio, body.span()[c] / mesh[c]);
    }
    return ratio;
}

//- Warn of a shape of which 1 % or more lies beyond the mesh, unless each side
//  that cuts it does so in the middle: a half or quarter at symmetry planes
void checkOutside(const mpm::pointGrid& grid, const mpm::pointRegion& r)
{
    const scalar part = shareOutside(r);
    if (part < 0.01)
    {
        return;
    }
    const boundBox body(r.shape().bounds());
    const boundBox& mesh = grid.mesh().bounds();
    bool meant = false;
    int across = -1;
    for (int d = 0; d < grid.nDim(); ++d)
    {
        const int c = grid.direction(d);
        const scalar middle = 0.5 * (body.min()[c] + body.max()[c]);
        const scalar tol = 1e-3 * (body.max()[c] - body.min()[c]);
        const bool low = d != grid.radial() && body.min()[c] < mesh.min()[c] - tol;
        const bool high = body.max()[c] > mesh.max()[c] + tol;
        const bool half = low != high && mag(middle - (low ? mesh.min() : mesh.max())[c]) < tol;
        if ((low || high) && !half)
        {
            across = low && high ? c : -1;
            meant = false;
            break;
        }
        meant = meant || half;
    }
    if (!meant)
    {
        Ostream& os = WarningInFunction;
        os << "Region " << r.name() << " reaches beyond the mesh: " << percent(part).c_str()
           << " % of its " << r.shape().type() << " has no points. The shape lies in " << r.bounds()
           << " m, the mesh"
           << " in " << mesh << " m.";
        const scalar ratio = largestRatio(grid, body);
        if (ratio > 100)
        {
            os << " It is " << ratio << " times as large as the mesh: places"
               << " and sizes are in m, a box of 5 mm has 5e-3.";
        }
        else if (across >= 0 && grid.nDim() < 3)
        {
            os << " In a scene of fewer dimensions the sides of the mesh across "
               << "xyz"[across] << " have type empty, of a sector wedge.";
        }
        os << endl;
    }
}

//- Warn of a body of another mass than that of its shape in the mesh
void checkMass(const mpm::pointRegion& r)
{
    constexpr scalar most = 1e-3;

    const scalar asked = r.askedMass();
    if (asked > 0 && mag(r.mass() - asked) > most * asked)
    {
        WarningInFunction << "Region " << r.name() << " has the mass " << r.mass()
                          << " kg; that of its shape in the mesh is " << asked << " kg, "
                          << 100 * (r.mass() / asked - 1) << " % off. "
                          << (r.sampled() ? "Remove  parts sampled;  or write  samples 8;"
                                  : r.shape().facets()
                                  ? "Look with surfaceCheck whether the surface is closed and"
                                    " does not cut itself."
                                  : "Use smaller cells or a larger pointsPerCell.")
                          << endl;
    }
}

//- Warn of what is probably a wrong unit: the largest velocity is more than five
//  times the wave speed of a law, also of one that is hit by it. Gas guns and
//  meteorites (8 km/s on plastics, 20 km/s on rock) reach four times, factors of
//  1000 in a unit more; laws without a stress have no waves
void checkSpeed(
    const PtrList<mpm::materialPointPhase>& phases, const PtrList<mpm::pointRegion>& regions)
{
    constexpr scalar fast = 5;
    scalar speed = 0;
    word fastest;
    wordHashSet filled;
    for (const mpm::pointRegion& r : regions)
    {
        filled.insert(r.phase());
        for (const mpm::materialPointCloud::newPoint& p : r.points())
        {
            if (mag(p.U) > speed)
            {
                speed = mag(p.U);
                fastest = r.name();
            }
        }
    }
    for (const mpm::materialPointPhase& phase : phases)
    {
        const scalar c =
            phase.motion() || !filled.found(phase.name()) ? 0 : phase.law().waveSpeed();
        if (c > 0 && speed > fast * c)
        {
            WarningInFunction << "Region " << fastest << " starts with " << speed << " m/s, "
                              << speed / c << " times the wave speed of phase " << phase.name()
                              << " (" << c << " m/s): look for a wrong unit of the velocity"
                              << " (m/s) or of the law (Pa, kg/m3)." << endl;
        }
    }
}

//- Width of a cell along d [m]: of a box its side; of another cell that of the square or cube of
//  its size, of which triangles and tetrahedra are halves and sixths (mpmCheck counts likewise)
scalar cellWidth(const mpm::pointGrid& grid, const label celli, const int d)
{
    const int D = grid.nDim();
    const vector size = grid.mesh().bounds().span();
    scalar volume = grid.mesh().cellVolumes()[celli] / cmptProduct(size), box = 1;
    for (int e = 0; e < D; ++e)
    {
        volume *= size[grid.direction(e)];
        box *= grid.width(celli, e);
    }
    if (grid.radial() >= 0 || mag(box - volume) <= 1e-6 * volume)
    {
        return grid.width(celli, d);
    }
    const bool simplex = grid.nodesOf(celli).size() == D + 1;
    return std::pow((simplex ? (D == 2 ? 2 : 6) : 1) * volume, 1.0 / D);
}

//- Warn of a body that is narrower than two cells: a wrong unit, or too coarse.
//  body: box around the region and those that continue it
void checkWidth(
    const mpm::pointGrid& grid, const mpm::materialPointPhase& phase, const mpm::pointRegion& r,
    const boundBox& body)
{
    if (phase.motion())
    {
        return;
    }
    for (int d = 0; d < grid.nDim(); ++d)
    {
        const int way = grid.direction(d);
        scalar h = GREAT;
        for (const label celli : r.cells())
        {
            h = min(h, cellWidth(grid, celli, d));
        }
        const scalar all = grid.mesh().bounds().span()[way];
        const scalar n = (body.max()[way] - body.min()[way]) / h;
        if (all > 1.5 * h && n < 2 - 1e-6)
        {
            WarningInFunction << "Region " << r.name() << " is " << n << " cells wide in "
                              << vector::componentNames[way] << ", fewer than 2: nothing is"
                              << " resolved across it. Use smaller cells; if that is not"
                              << " meant, look for a wrong unit (m)." << endl;
            break;
        }
    }
}

//- The start pressure on the cells, empty without a file of it
scalarField startPressure(const polyMesh& mesh)
{
    const IOobject io(
        "p", mesh.time().timeName(), mesh, IOobject::MUST_READ, IOobject::NO_WRITE, false);
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

//- Warn of points that start with another pressure than the gas around them;
//  of grains the stress is not that of the gas
void checkAmbient(const mpm::pointRegion& r, const scalarField& p)
{
    const bool given = !r.isAmbient();
    const scalar ambient = -tr(r.stress()) / 3;
    if ((!r.hasStress() && ambient <= 0) || (given && r.granular()) || p.empty())
    {
        return;
    }
    scalar low = GREAT, high = -GREAT;
    for (const label celli : r.cells())
    {
        low = min(low, p[celli]);
        high = max(high, p[celli]);
    }
    if (ambient < 0.9 * low || ambient > 1.1 * high)
    {
        WarningInFunction << "Region " << r.name() << " starts with the pressure " << ambient
                          << (given ? " Pa (minus a third of the trace of its stress, which is"
                                      " negative in compression)"
                                    : " Pa")
                          << "; what flows in its cells has " << low
                          << (high > low ? " to " + Foam::name(high) : std::string()).c_str()
                          << " Pa. They are not in equilibrium." << endl;
    }
}

//- Warn of a law that is far from its unstressed state in the gas
void checkSoft(const mpm::materialPointPhase& phase, const mpm::pointRegion& r)
{
    constexpr scalar most = 0.2;

    const scalar E = phase.law().elasticModulus();
    const scalar above = -tr(r.stress()) / 3 - phase.referencePressure();
    if (r.isAmbient() && phase.law().holdsTogether() && above > most * E)
    {
        WarningInFunction << "Region " << r.name() << " starts " << above << " Pa above the"
                          << " pressure at which phase " << phase.name()
                          << " is unstressed; its modulus is " << E
                          << " Pa (moduli are in Pa, 1e6 for 1 MPa). If that and rho are those of"
                          << " the material in the gas, write"
                          << "  referencePressure " << -tr(r.stress()) / 3 << ";  in the phase."
                          << endl;
    }
}

//- Warn of fluids that are still to be made
void checkFluids(const Time& time, const wordList& fluids, const scalarField& p)
{
    if (fluids.size() && p.empty() && isFile(time.path() / "system/setFluidsDict"))
    {
        WarningInFunction << "The fluids " << flatOutput(fluids) << " have no p at time "
                          << time.timeName() << ": the pressure that points start with cannot be"
                          << " compared with theirs. Run setFluids first, then"
                          << " setMaterialPoints." << endl;
    }
}

//- The law itself has the pressure of the gas or more, like an explosive that
//  is burnt at the start
bool pressesBack(
    const mpm::materialPointPhase& phase, const mpm::pointRegion& r, const scalarField& p)
{
    const scalar own = phase.law().startPressure();
    scalar most = 0;
    for (const label celli : r.cells())
    {
        most = max(most, p.empty() ? scalar(0) : p[celli]);
    }
    return own > 0 && own >= most;
}

//- Warn of cells in which points of a region cannot soften: their widest bands
//  are those across a diagonal, of the strongest point. firstId: of the region
void checkSoftening(
    const mpm::materialPointPhase& phase, const mpm::pointRegion& r, const label firstId)
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
            strongest =
                max(strongest,
                    failure->strength(uint64_t(firstId + i), r.points()[i].mass / phase.rho()));
        }
    }
    const scalar widest = failure->widestBand(strongest);
    const scalar h = r.widestCell();
    const scalar diagonal = std::sqrt(scalar(phase.cloud().grid().nDim()));
    if (diagonal * h >= widest)
    {
        WarningInFunction << "Region " << r.name() << " has cells of " << h
                          << " m; softening with the Gf of phase " << phase.name()
                          << " needs bands narrower than 2 E Gf/strength^2 = " << widest
                          << " m, with " << strongest << " Pa of its strongest point. A band"
                          << " is " << h << " m wide along the cells and up to " << diagonal * h
                          << " m across them. The run would stop where such a"
                          << " point fails" << (h < widest ? " obliquely" : "")
                          << ". Use smaller cells, or no Gf." << endl;
    }
}

}

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::mpm::printTable(const wordList& phases, const PtrList<pointRegion>& regions)
{
    Info << "    region          phase               points     mass [kg]"
         << "   volume [m3]    exact [m3]    difference" << nl;

    forAll(regions, i)
    {
        const pointRegion& r = regions[i];
        printLine(r.name(), r.phase(), r.points().size(), r.mass(), r.volume(), r.askedVolume());
    }
    Info << nl;

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
                const scalar v = r.askedVolume();
                exact = v < 0 || exact < 0 ? -1 : exact + v;
            }
        }
        printLine("total", phase, n, mass, volume, exact);
    }
    Info << endl;
}

void Foam::mpm::printStart(
    const dictionary& phaseProperties, const PtrList<materialPointPhase>& phases,
    const PtrList<pointRegion>& regions)
{
    const wordList gases(phaseNames(phaseProperties, {"gas", "fluid"}));
    const bool contact = phaseProperties.found("contact");
    string around(gases.size() > 1 ? "fluids" : "gas");
    for (const word& gas : gases)
    {
        around += " " + gas;
    }

    wordList names(phases.size());
    forAll(phases, i)
    {
        names[i] = phases[i].name();
    }
    const auto phaseOf = [&](const pointRegion& r) -> const materialPointPhase&
    { return phases[names.find(r.phase())]; };

    printBodies(regions);
    const scalarField p(
        gases.size() ? startPressure(phases[0].cloud().grid().mesh()) : scalarField());
    checkFluids(phases[0].cloud().time(), phaseNames(phaseProperties, {"fluid"}), p);
    for (const materialPointPhase& phase : phases)
    {
        if (phase.referencePressure() > 0 && gases.empty() && phase.surfaceLoads().empty())
        {
            WarningInFunction << "Phase " << phase.name() << " has the referencePressure "
                              << phase.referencePressure() << " Pa, and there is neither gas nor"
                              << " surface load: it expands as in a vacuum." << endl;
        }
        if (gases.size() && phase.failure() && phase.failure()->ambient() <= 0
            && phase.referencePressure() <= 0)
        {
            WarningInFunction << "Phase " << phase.name() << " may fail in the gas " << gases[0]
                              << " and its failureModel has no ambientPressure:"
                              << " the gas would not enter the cracks. Write"
                              << "  ambientPressure <of the gas>;" << endl;
        }
    }

    checkSpeed(phases, regions);
    forAll(regions, i)
    {
        const pointRegion& r = regions[i];
        const materialPointPhase& phase = phaseOf(r);
        if (!phase.motion())
        {
            checkAmbient(r, p);
            checkSoft(phase, r);
        }
        checkOutside(phase.cloud().grid(), r);
        checkMass(r);
        boundBox body(r.bounds());
        for (const pointRegion& other : regions)
        {
            boundBox near(other.bounds());
            near.inflate(1e-6);
            if (phaseOf(other).velocityField() == phase.velocityField() && !phaseOf(other).motion()
                && near.overlaps(r.bounds()))
            {
                body.add(other.bounds());
            }
        }
        checkWidth(phase.cloud().grid(), phase, r, body);
        const string hint(r.sizeHint());
        if (hint.size())
        {
            WarningInFunction << "Region " << r.name() << ":" << hint.c_str() << endl;
        }
        if (gases.size() && !phase.motion() && !r.hasStress() && !r.granular()
            && phase.referencePressure() <= 0 && !pressesBack(phase, r, p))
        {
            WarningInFunction << "Region " << r.name() << " lies in the " << around.c_str()
                              << " and starts without stress: its pressure will press it"
                              << " together at once. For equilibrium write"
                              << "  stress ambient; pressure <that of its place>;" << endl;
        }
        label firstId = 0;
        for (label j = 0; j < i; ++j)
        {
            firstId += regions[j].phase() == r.phase() ? regions[j].points().size() : 0;
        }
        checkSoftening(phase, r, firstId);
        for (label j = 0; j < i; ++j)
        {
            point where;
            if (phaseOf(regions[j]).velocityField() != phase.velocityField()
                && regions[j].overlap(r, where) >= 0)
            {
                WarningInFunction << "Regions " << regions[j].name() << " and " << r.name()
                                  << " overlap at " << where << ": "
                                  << (contact ? "contact stops them there but does not part them."
                                              : "they have different velocity fields, and nothing"
                                                " keeps them apart.")
                                  << " Change a shape, or write  overlap allow;  in one of"
                                  << " the regions if that is meant." << endl;
            }
        }
    }
}
