// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "outflowPatches.H"
#include "dictionaryTools.H"
#include "ListOps.H"
#include "HashSet.H"
#include "syncTools.H"
#include "wordRes.H"
#include "stringListOps.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::outflowPatches::outflowPatches(const dictionary& dict, const pointGrid& grid) :
    grid_(grid), sides_(grid.nCells(), static_cast<unsigned char>(0)), nodes_(grid.nNodes(), false)
{
    checkKeywords(dict, {"patches"});
    requireKeyword(dict, "patches");
    const wordRes patches(dict.get<wordRes>("patches"));

    const polyMesh& mesh = grid.mesh();
    DynamicList<word> open;
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (!polyPatch::constraintType(patch.type()))
        {
            open.append(patch.name());
        }
    }
    for (const wordRe& name : patches)
    {
        if (findStrings(name, open).empty())
        {
            FatalIOErrorInFunction(dict)
                << "Entry patches of outflow names " << name << ", not a"
                << " patch that points can leave through." << nl << nl
                << "Valid choices are: " << flatOutput(open) << exit(FatalIOError);
        }
    }

    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        open_.append(open.found(patch.name()) && patches.match(patch.name()));
    }
    if (grid.locator().knowsPatches())
    {
        return;
    }

    boolList onPatch(mesh.nPoints(), false);
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (!open_[patch.index()])
        {
            continue;
        }
        forAll(patch, i)
        {
            labelHashSet nodes;
            for (const label p : patch[i])
            {
                nodes.insert(grid.pointToNode()[p]);
                onPatch[p] = true;
            }
            const label celli = patch.faceCells()[i];
            const label* corners = grid.hexes().corners(celli);
            for (int side = 0; side < 2 * grid.nDim(); ++side)
            {
                bool all = grid.hexes().walls(celli) & (1u << side);
                for (label n = 0; n < label(1) << grid.nDim(); ++n)
                {
                    const bool beside = ((n >> side / 2) & 1) == side % 2;
                    all = all && (!beside || nodes.found(corners[n]));
                }
                if (all)
                {
                    sides_[celli] |= 1u << side;
                }
            }
        }
    }
    syncTools::syncPointList(mesh, onPatch, orEqOp<bool>(), false);
    forAll(onPatch, p)
    {
        if (onPatch[p])
        {
            nodes_[grid.pointToNode()[p]] = true;
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::mpm::outflowPatches::through(const label celli, const scalar* x) const
{
    if (grid_.locator().knowsPatches())
    {
        const label patchi = grid_.locator().patchOut(celli, x);
        return patchi >= 0 && open_[patchi];
    }

    const int D = grid_.nDim();
    scalar xi[3];
    grid_.localCoordinates(celli, x, xi);

    // Sides that x is beyond
    unsigned beyond = 0;
    for (int d = 0; d < D; ++d)
    {
        beyond |= xi[d] < 0 ? 1u << 2 * d : xi[d] >= 1 ? 2u << 2 * d : 0;
    }
    if (beyond & grid_.hexes().walls(celli))
    {
        return beyond & sides_[celli];
    }

    // The corners that lie on all of these sides
    bool open = beyond;
    for (label n = 0; n < label(1) << D; ++n)
    {
        bool common = true;
        for (int d = 0; d < D; ++d)
        {
            const unsigned at = (beyond >> 2 * d) & 3u;
            common = common && (at == 0 || at == ((n >> d) & 1 ? 2u : 1u));
        }
        open = open && (!common || nodes_[grid_.hexes().corners(celli)[n]]);
    }
    return open;
}
