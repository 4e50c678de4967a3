/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Application
    renumbered

Description
    Test of a simulation that is taken down and built again on another mesh:
    the same cells in random order, with the faces of patches in random order.
    Makes -steps steps of the case's deltaT twice from its start, the second
    time with another mesh after half of them, and prints for each column and
    each field of the gas the largest difference over the largest value.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "fvMesh.H"
#include "surfaceFields.H"
#include "Time.H"
#include "volFields.H"
// Of the solver, not of a library
#include "propertiesRecord.C"
#include "simulation.C"
#include "fatalMessages.H"
#include <algorithm>
#include <random>

using namespace Foam;

namespace
{

//- The same mesh, cells and faces of patches in random order
autoPtr<fvMesh> renumbered(autoPtr<fvMesh>& old, std::mt19937& random)
{
    const label nInternal = old->nInternalFaces();
    labelList newCell(identity(old->nCells()));
    std::shuffle(newCell.begin(), newCell.end(), random);

    struct side
    {
        label owner, neighbour;
        face f;
    };
    List<side> sides(old->nFaces());
    forAll(sides, i)
    {
        side& s = sides[i];
        s.f = old->faces()[i];
        s.owner = newCell[old->faceOwner()[i]];
        s.neighbour = i < nInternal ? newCell[old->faceNeighbour()[i]] : -1;
        if (i < nInternal && s.owner > s.neighbour)
        {
            std::swap(s.owner, s.neighbour);
            s.f = s.f.reverseFace();
        }
    }
    std::sort(
        sides.begin(), sides.begin() + nInternal,
        [](const side& a, const side& b)
        { return a.owner != b.owner ? a.owner < b.owner : a.neighbour < b.neighbour; });
    List<dictionary> patches;
    wordList names;
    for (const polyPatch& pp : old->boundaryMesh())
    {
        if (!pp.coupled())
        {
            std::shuffle(
                sides.begin() + pp.start(), sides.begin() + pp.start() + pp.size(), random);
        }
        OStringStream os;
        pp.write(os);
        os.writeEntry("nFaces", pp.size());
        os.writeEntry("startFace", pp.start());
        patches.append(dictionary(IStringStream(os.str())()));
        names.append(pp.name());
    }

    pointField points(old->points());
    faceList faces(sides.size());
    labelList owner(sides.size()), neighbour(nInternal);
    forAll(sides, i)
    {
        faces[i] = sides[i].f;
        owner[i] = sides[i].owner;
        if (i < nInternal)
        {
            neighbour[i] = sides[i].neighbour;
        }
    }
    const Time& time = old->time();
    old.clear();

    autoPtr<fvMesh> mesh(new fvMesh(
        // Schemes are read as those of the case, the mesh is not
        IOobject(fvMesh::defaultRegion, "inMemory", time, IOobject::READ_IF_PRESENT),
        std::move(points), std::move(faces), std::move(owner), std::move(neighbour)));
    List<polyPatch*> list(patches.size());
    forAll(list, patchi)
    {
        list[patchi] =
            polyPatch::New(names[patchi], patches[patchi], patchi, mesh->boundaryMesh()).ptr();
    }
    mesh->addFvPatches(list);
    return mesh;
}

void advance(mpm::simulation& simulation, Time& time, const label nSteps)
{
    for (label step = 0; step < nSteps; ++step)
    {
        scalar factor = 1;
        if (!simulation.advancePoints(time.deltaTValue(), factor))
        {
            FatalErrorInFunction << "A step has to be redone: take a smaller deltaT."
                                 << exit(FatalError);
        }
        simulation.advanceGas(time.deltaTValue());
        ++time;
        simulation.correct();
    }
}

//- Rows in the order of their ids
labelList byId(const mpm::pointRows& rows, label& nComponents)
{
    label at = 0;
    nComponents = rows.rowSize();
    for (label c = 0; rows.columns[c] != "id"; ++c)
    {
        at += rows.nComponents[c];
    }
    labelList order(identity(rows.size()));
    std::sort(
        order.begin(), order.end(),
        [&](const label a, const label b)
        { return rows.values[nComponents * a + at] < rows.values[nComponents * b + at]; });
    return order;
}

void comparePoints(const word& phase, const mpm::pointRows& a, const mpm::pointRows& b)
{
    label size = 0, at = 0;
    const labelList orderA(byId(a, size)), orderB(byId(b, size));
    if (a.columns != b.columns || orderA.size() != orderB.size())
    {
        FatalErrorInFunction << "Phase " << phase << " has other columns or points."
                             << exit(FatalError);
    }
    forAll(a.columns, c)
    {
        scalar most = 0, difference = 0;
        for (label i = at; i < at + a.nComponents[c]; ++i)
        {
            forAll(orderA, p)
            {
                const scalar u = a.values[size * orderA[p] + i];
                const scalar v = b.values[size * orderB[p] + i];
                most = max(most, mag(u));
                difference = max(difference, mag(u - v));
            }
        }
        at += a.nComponents[c];
        Info << "Column " << phase << '.' << a.columns[c] << ": " << difference / max(most, VSMALL)
             << nl;
    }
}

template<class Type>
void compareField(
    const word& name, const word& key, const dictionary& a, const dictionary& b, const label nCells)
{
    const Field<Type> u(key, a, nCells), v(key, b, nCells);
    Info << "Field " << name << ": " << max(mag(u - v)) / max(max(mag(u)), VSMALL) << nl;
}

}

int main(int argc, char* argv[])
{
    mpm::exitOnFatal();
    argList::noParallel();
    argList::addOption("steps", "n", "number of steps");
#include "setRootCase.H"
#include "createTime.H"
    autoPtr<fvMesh> mesh(new fvMesh(
        IOobject(fvMesh::defaultRegion, runTime.timeName(), runTime, IOobject::MUST_READ)));
    const label nSteps = args.getOrDefault<label>("steps", 20);

    mpm::simulation::rows a;
    {
        mpm::simulation straight(*mesh);
        advance(straight, runTime, nSteps);
        a = straight.takeDown();
    }

    runTime.setTime(0, 0);
    mpm::simulation simulation(*mesh);
    advance(simulation, runTime, nSteps / 2);
    mpm::simulation::rows middle(simulation.takeDown());
    std::mt19937 random(1);
    mesh = renumbered(mesh, random);
    simulation = mpm::simulation(*mesh, std::move(middle));
    advance(simulation, runTime, nSteps - nSteps / 2);
    const mpm::simulation::rows b(simulation.takeDown());

    Info << nl << "Cells: " << mesh->nCells() << nl;
    forAllConstIters(a.points.points, iter)
    {
        comparePoints(iter.key(), iter.val(), b.points.points[iter.key()]);
    }
    const mpm::meshPlaces::order order(a.places.orderOf(*mesh));
    forAllIters(a.gas, iter)
    {
        dictionary& field = iter.val();
        order.ofCells(field);
        const word key(field.found("value") ? "value" : "internalField");
        const dictionary& other = b.gas[iter.key()];
        if (iter.key().find('U') != std::string::npos)
        {
            compareField<vector>(iter.key(), key, field, other, mesh->nCells());
        }
        else
        {
            compareField<scalar>(iter.key(), key, field, other, mesh->nCells());
        }
    }
    Info << "End" << nl;

    return 0;
}
