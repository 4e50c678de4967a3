// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "meshPlaces.H"
#include "fieldDictionary.H"
#include "polyMesh.H"
#include "emptyPolyPatch.H"
#include "matchPoints.H"
#include "fieldTypes.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::mpm;

//- Where the values at some places were before; empty: at the same index
labelList orderOfPlaces(
    const UList<point>& before, const UList<point>& now, const scalar near, const char* what,
    const word& where)
{
    if (before == now)
    {
        return labelList();
    }
    labelList from;
    if (before.size() != now.size()
        || !matchPoints(
            now, before, scalarList(now.size(), near), false, from,
            now.size() ? now[0] : point::zero))
    {
        FatalErrorInFunction << "The " << now.size() << ' ' << what << " of " << where
                             << " are not the " << before.size() << " that the state was taken"
                             << " from: a state can be taken over by a mesh of the same cells"
                             << " and patches." << exit(FatalError);
    }
    return from;
}

template<class Type>
bool permuteList(dictionary& dict, const word& key, const labelUList& from)
{
    ITstream& is = dict.lookup(key);
    if (is.size() != 2 || !is[0].isWord() || is[0].wordToken() != "nonuniform"
        || !is[1].isCompound()
        || is[1].compoundToken().type() != token::Compound<List<Type>>::typeName)
    {
        return false;
    }
    const Field<Type> values(key, dict, from.size());
    const Field<Type> ordered(values, from);
    dict.merge(writtenDictionary([&](Ostream& os) { ordered.writeEntry(key, os); }));
    return true;
}

//- Permute the lists of values in a dictionary
void permuteLists(dictionary& dict, const labelUList& from)
{
    if (from.empty())
    {
        return;
    }
    for (const word& key : dict.toc())
    {
        if (dict.isDict(key))
        {
            continue;
        }
        permuteList<scalar>(dict, key, from) || permuteList<vector>(dict, key, from)
            || permuteList<sphericalTensor>(dict, key, from)
            || permuteList<symmTensor>(dict, key, from) || permuteList<tensor>(dict, key, from);
    }
}

void permutePatches(dictionary& field, const HashTable<labelList>& orders)
{
    if (!field.found("boundaryField"))
    {
        return;
    }
    dictionary& boundary = field.subDict("boundaryField");
    forAllConstIters(orders, iter)
    {
        if (boundary.found(iter.key()))
        {
            permuteLists(boundary.subDict(iter.key()), iter.val());
        }
    }
}

}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::meshPlaces::meshPlaces(const polyMesh& mesh) : cells_(mesh.cellCentres())
{
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        // Empty patches have no values
        if (!isA<emptyPolyPatch>(pp))
        {
            faces_.set(pp.name(), pointField(pp.faceCentres()));
            points_.set(pp.name(), pointField(pp.localPoints()));
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::mpm::meshPlaces::order Foam::mpm::meshPlaces::orderOf(const polyMesh& mesh) const
{
    const meshPlaces now(mesh);
    const scalar near = 1e-9 * mesh.bounds().mag();
    order o;
    o.cells_ = orderOfPlaces(cells_, now.cells_, near, "cells", "the mesh");
    forAllConstIters(now.faces_, iter)
    {
        const word& patch = iter.key();
        o.faces_.set(
            patch,
            orderOfPlaces(
                faces_.lookup(patch, pointField()), iter.val(), near, "faces", "patch " + patch));
        o.points_.set(
            patch,
            orderOfPlaces(
                points_.lookup(patch, pointField()), now.points_[patch], near, "points",
                "patch " + patch));
    }
    return o;
}

void Foam::mpm::meshPlaces::order::ofCells(dictionary& field) const
{
    permuteLists(field, cells_);
    permutePatches(field, faces_);
}

void Foam::mpm::meshPlaces::order::ofPoints(dictionary& field) const
{
    field.remove("internalField");
    field.merge(writtenDictionary([](Ostream& os) { os << "internalField uniform (0 0 0);"; }));
    permutePatches(field, points_);
}
