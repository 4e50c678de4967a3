// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "meshCheck.H"
#include "polyMesh.H"
#include "emptyPolyPatch.H"
#include "wedgePolyPatch.H"
#include <cstdint>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- A number as good as random of a pair of points (splitmix64)
std::uint64_t mixed(const label a, const label b)
{
    std::uint64_t z = (std::uint64_t(a) << 32 ^ std::uint64_t(b)) + 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
}

//- Cells whose outward faces do not run each edge once to and once fro
DynamicList<label> openCells(const polyMesh& mesh)
{
    List<std::uint64_t> sum(mesh.nCells(), std::uint64_t(0));
    forAll(mesh.faces(), facei)
    {
        const face& f = mesh.faces()[facei];
        std::uint64_t round = 0;
        forAll(f, k)
        {
            const label a = f[k], b = f.nextLabel(k);
            round += a < b ? mixed(a, b) : -mixed(b, a);
        }
        sum[mesh.faceOwner()[facei]] += round;
        if (mesh.isInternalFace(facei))
        {
            sum[mesh.faceNeighbour()[facei]] -= round;
        }
    }
    DynamicList<label> open;
    forAll(sum, celli)
    {
        if (sum[celli])
        {
            open.append(celli);
        }
    }
    return open;
}

DynamicList<label> flatCells(const polyMesh& mesh)
{
    scalarField area(mesh.nCells(), Zero);
    forAll(mesh.faces(), facei)
    {
        const scalar magS = mag(mesh.faceAreas()[facei]);
        area[mesh.faceOwner()[facei]] += magS;
        if (mesh.isInternalFace(facei))
        {
            area[mesh.faceNeighbour()[facei]] += magS;
        }
    }
    DynamicList<label> flat;
    forAll(area, celli)
    {
        const scalar cube = area[celli] * std::sqrt(area[celli]);
        if (!(mesh.cellVolumes()[celli] > 1e-12 * cube))
        {
            flat.append(celli);
        }
    }
    return flat;
}

//- Cells that do not lie between two empty sides; these may differ in size
DynamicList<label> thickCells(const polyMesh& mesh)
{
    vectorField sum(mesh.nCells(), Zero), all(mesh.nCells(), Zero);
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (isA<emptyPolyPatch>(pp))
        {
            forAll(pp, i)
            {
                const vector& S = mesh.faceAreas()[pp.start() + i];
                sum[mesh.faceOwner()[pp.start() + i]] += S;
                all[mesh.faceOwner()[pp.start() + i]] += cmptMag(S);
            }
        }
    }
    DynamicList<label> thick;
    forAll(sum, celli)
    {
        bool one = true;
        for (int d = 0; d < 3; ++d)
        {
            if (mesh.solutionD()[d] < 0)
            {
                const scalar out = mag(sum[celli][d]);
                one = one && all[celli][d] > 0 && out <= 0.5 * all[celli][d];
            }
        }
        if (!one)
        {
            thick.append(celli);
        }
    }
    return thick;
}

//- Directions in which the mesh is one layer of cells between faces that are
//  no plane of symmetry, and the patches of these; none where it is so in all.
//  sector: somewhere both sides make an angle with each other. Collective
std::string oneLayer(const polyMesh& mesh, std::string& patches, bool& sector)
{
    sector = false;
    // Of each direction: sum of the faces of both sides, and of one
    List<FixedList<vector, 2>> sum(3, FixedList<vector, 2>(vector(Zero)));
    List<FixedList<unsigned char, 3>> sides(
        mesh.nCells(), FixedList<unsigned char, 3>(static_cast<unsigned char>(0)));
    const auto across = [&](const label facei, const int d)
    {
        const vector& S = mesh.faceAreas()[facei];
        return mag(S[d]) > 0.9 * mag(S);
    };
    const auto open = [](const polyPatch& pp)
    { return !pp.coupled() && !polyPatch::constraintType(pp.type()); };
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        for (label i = 0; open(pp) && i < pp.size(); ++i)
        {
            const label facei = pp.start() + i;
            for (int d = 0; d < 3; ++d)
            {
                const bool up = mesh.faceAreas()[facei][d] > 0;
                if (across(facei, d))
                {
                    sum[d][0] += mesh.faceAreas()[facei];
                    sum[d][1] += up ? mesh.faceAreas()[facei] : vector(Zero);
                }
                sides[mesh.faceOwner()[facei]][d] |= !across(facei, d) ? 0 : up ? 2 : 1;
            }
        }
    }

    std::string found;
    int nComputed = 0;
    for (int d = 0; d < 3; ++d)
    {
        bool thin = mesh.geometricD()[d] > 0;
        nComputed += thin;
        for (label celli = 0; thin && celli < mesh.nCells(); ++celli)
        {
            thin = sides[celli][d] == 3;
        }
        if (!returnReduce(thin, andOp<bool>()))
        {
            continue;
        }
        // More than 0.06 degrees
        for (vector& S : sum[d])
        {
            reduce(S, sumOp<vector>());
        }
        vector inPlane(sum[d][0]);
        inPlane[d] = 0;
        sector = sector || mag(inPlane) > 1e-3 * mag(sum[d][1]);
        found += found.empty() ? "" : " and ";
        found += "xyz"[d];
        --nComputed;
        for (const polyPatch& pp : mesh.boundaryMesh())
        {
            if (open(pp) && pp.size() && across(pp.start(), d)
                && patches.find(pp.name()) == std::string::npos)
            {
                patches += ' ' + pp.name() + " (" + pp.type() + ')';
            }
        }
    }
    return nComputed ? found : std::string();
}

//- Number and places of bad cells of this processor
string
listed(const polyMesh& mesh, const labelUList& bad, const char* what, const bool volumes = true)
{
    if (bad.empty())
    {
        return string();
    }
    OStringStream os;
    if (Pstream::parRun())
    {
        os << "Processor " << Pstream::myProcNo() << ": ";
    }
    os << bad.size() << (bad.size() == 1 ? " cell is " : " cells are ") << what;
    for (label i = 0; i < min(bad.size(), label(5)); ++i)
    {
        // The centre of a cell without volume may be anywhere
        const labelList& points = mesh.cellPoints()[bad[i]];
        os << (i ? "; " : ": ") << "cell " << bad[i] << " at "
           << average(pointField(mesh.points(), points));
        if (volumes)
        {
            os << ", volume " << mesh.cellVolumes()[bad[i]];
        }
    }
    return os.str();
}

template<class Zones>
string problemOfZones(const Zones& zones, const label size, const char* of)
{
    OStringStream os;
    for (const auto& zone : zones)
    {
        for (const label i : static_cast<const labelList&>(zone))
        {
            if (i < 0 || i >= size)
            {
                os << "File " << zones.objectPath() << ": zone " << zone.name() << " has " << of
                   << ' ' << i << "; the mesh has " << size;
                return os.str();
            }
        }
    }
    return string();
}

}

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::mpm::checkMesh(const polyMesh& mesh)
{
    refuseMesh(problemOfZones(mesh.cellZones(), mesh.nCells(), "cell"));
    refuseMesh(problemOfZones(mesh.faceZones(), mesh.nFaces(), "face"));
    refuseMesh(problemOfZones(mesh.pointZones(), mesh.nPoints(), "point"));
    refuseMesh(listed(
        mesh, openCells(mesh),
        "open: a face is missing, the wrong way round, has a wrong point or"
        " another cell",
        false));
    refuseMesh(listed(mesh, flatCells(mesh), "without volume, or turned inside out"));

    // Empty in every direction, or wedges too: the axes of the points have
    // their own message
    bool wedges = false;
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        wedges = wedges || isA<wedgePolyPatch>(pp);
    }
    if (!wedges && mesh.nSolutionD() > 0 && mesh.nSolutionD() < 3)
    {
        refuseMesh(listed(
            mesh, thickCells(mesh),
            "not between two faces of empty patches, but the direction"
            " across is not computed",
            false));
    }

    std::string patches;
    bool sector;
    const std::string thin(oneLayer(mesh, patches, sector));
    if (thin.size())
    {
        WarningInFunction << "The mesh is one layer of cells thick in " << thin.c_str()
                          << ", and its faces there have other types than empty," << patches.c_str()
                          << ": the scene is computed in " << mesh.nGeometricD()
                          << "D with open sides." << nl
                          << (sector ? "    They make an angle with each other: for a sector"
                                       " of a scene with an axis give them  type wedge;  in"
                                     : "    For fewer dimensions give them  type empty;  in")
                          << " constant/polyMesh/boundary (with blockMesh in its dictionary, and"
                          << " run it again) and in the files of time 0." << endl;
    }
}
