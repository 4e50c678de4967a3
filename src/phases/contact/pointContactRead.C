// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "pointContact.H"
#include "cornerNormal.H"
#include "dictionaryTools.H"
#include "polyMesh.H"
#include "emptyPolyPatch.H"
#include "SubField.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::mpm::pointContact::rule Foam::mpm::pointContact::readRule(const dictionary& dict)
{
    rule r;
    r.name = dict.dictName();
    laws_.append(contactLaw::New(dict).ptr());
    r.law = &laws_[laws_.size() - 1];
    r.normal = dict.getOrDefault<vector>("normal", vector::zero);
    if (dict.found("normal"))
    {
        vector inside(Zero);
        for (int d = 0; d < nDim_; ++d)
        {
            inside[grid_.direction(d)] = r.normal[grid_.direction(d)];
        }
        if (!(mag(inside) > VSMALL) || mag(r.normal - inside) > SMALL * mag(inside))
        {
            FatalIOErrorInFunction(dict)
                << "normal " << r.normal << " must not be zero and have only"
                << " components that are computed." << exit(FatalIOError);
        }
        if (!dict.found("fields") || dict.found("patch"))
        {
            FatalIOErrorInFunction(dict)
                << "normal needs two fields, from the first to the second." << exit(FatalIOError);
        }
        r.normal /= mag(r.normal);
    }
    return r;
}

Foam::label Foam::mpm::pointContact::fieldNamed(const dictionary& dict, const word& name) const
{
    wordList names(fields_.size());
    forAll(fields_, fieldi)
    {
        names[fieldi] = fields_[fieldi].name();
        if (names[fieldi] == name)
        {
            return fieldi;
        }
    }
    FatalIOErrorInFunction(dict) << "There is no velocity field " << name << "." << nl
                                 << "Valid fields: " << names << exit(FatalIOError);
    return -1;
}

Foam::scalarList Foam::mpm::pointContact::wallNormals(const label fieldi, const label patchi) const
{
    const polyPatch& pp = grid_.mesh().boundaryMesh()[patchi];
    const velocityField& field = fields_[fieldi];
    const int stride = field.stride();
    scalarList sum(stride * grid_.nNodes(), scalar(0));
    forAll(pp.meshPoints(), i)
    {
        const label n = grid_.pointToNode()[pp.meshPoints()[i]];
        for (const label facei : pp.pointFaces()[i])
        {
            const vector nf(cornerNormal(pp, facei, pp.meshPoints()[i]));
            for (int d = 0; d < nDim_; ++d)
            {
                sum[stride * n + d] += nf[grid_.direction(d)];
            }
        }
    }
    field.sumColumn(sum.data());

    scalarList normal(nDim_ * grid_.nNodes(), scalar(0));
    for (label n = 0; n < grid_.nNodes(); ++n)
    {
        scalar size = 0;
        for (int d = 0; d < nDim_; ++d)
        {
            size += sqr(sum[stride * n + d]);
        }
        for (int d = 0; size > 0 && d < nDim_; ++d)
        {
            normal[nDim_ * n + d] = sum[stride * n + d] / std::sqrt(size);
        }
    }
    return normal;
}

void Foam::mpm::pointContact::findEdges()
{
    edges_.resize(fields_.size());
    forAll(fields_, fieldi)
    {
        DynamicList<label> patches;
        for (const contactPair& pair : pairs_)
        {
            if (pair.a == fieldi && pair.b < 0)
            {
                patches.append(grid_.mesh().boundaryMesh().findPatchID(pair.patch));
            }
        }
        if (patches.empty())
        {
            continue;
        }
        const wallSurfaces walls(grid_, fields_[fieldi].shared(), patches, false, labelHashSet());
        for (const auto& of : walls.surfaces())
        {
            const std::vector<label> edge(wallSurfaces::edgesOf(of.second));
            for (size_t k = 0; k < edge.size(); ++k)
            {
                if (edge[k] >= 0)
                {
                    edges_[fieldi][of.first].push_back(normalised(of.second[k].second()[0]));
                }
            }
        }
    }
}

void Foam::mpm::pointContact::addPair(
    const rule& how, const label a, const label b, const label patchi)
{
    contactPair pair;
    pair.how = how;
    pair.a = a;
    pair.b = b;
    pair.step = pair.sum = Zero;
    pair.nClosed = pair.pushedGap = pair.push = 0;
    if (b < 0)
    {
        pair.patch = grid_.mesh().boundaryMesh()[patchi].name();
        pair.wall = wallNormals(a, patchi);
    }
    else
    {
        has_[b] = true;
    }
    has_[a] = true;
    pairs_.append(pair);
}

void Foam::mpm::pointContact::addWalls(
    const dictionary& dict, const rule& how, const wordList& names, DynamicList<labelPair>& walls)
{
    const word name(dict.get<word>("patch"));
    const polyBoundaryMesh& patches = grid_.mesh().boundaryMesh();
    const label patchi = patches.findPatchID(name);
    if (patchi < 0 || patches[patchi].coupled() || isA<emptyPolyPatch>(patches[patchi]))
    {
        const string what(
            patchi < 0 ? "the mesh has no patch " + name
                       : "patch " + name + " is of type " + patches[patchi].type()
                    + ", which no point touches");
        FatalIOErrorInFunction(dict) << "Contact " << dict.dictName() << ": " << what.c_str() << "."
                                     << nl << "Patches: " << patches.names() << exit(FatalIOError);
    }
    if (names.empty())
    {
        FatalIOErrorInFunction(dict) << "fields must name the velocity fields that touch patch "
                                     << name << "; it has none." << exit(FatalIOError);
    }
    for (const word& field : names)
    {
        const label a = fieldNamed(dict, field);
        if (fields_[a].holds(patchi))
        {
            FatalIOErrorInFunction(dict)
                << "U." << field << " has a condition on patch " << name
                << " that holds the points already; make it calculated for contact."
                << exit(FatalIOError);
        }
        if (walls.found(labelPair(a, patchi)))
        {
            FatalIOErrorInFunction(dict)
                << "field " << field << ", patch " << name << ": this pair has a contact already."
                << exit(FatalIOError);
        }
        walls.append(labelPair(a, patchi));
        addPair(how, a, -1, patchi);
    }
}

void Foam::mpm::pointContact::read(const dictionary& dict)
{
    const dictionary* others = nullptr;
    DynamicList<labelPair> walls;
    for (const entry& e : dict)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(dict) << "The entry " << e.keyword() << " of contact must be a"
                                         << " dictionary { type ...; }." << exit(FatalIOError);
        }
        const dictionary& sub = e.dict();
        const rule how(readRule(sub));
        const bool patch = sub.found("patch");
        if (!sub.found("fields") && !patch)
        {
            if (others)
            {
                FatalIOErrorInFunction(sub)
                    << "Both " << others->dictName() << " and " << e.keyword()
                    << " are for all other pairs; name the fields (a b) of"
                    << " one of them." << exit(FatalIOError);
            }
            others = &sub;
            continue;
        }
        const wordList names(required<wordList>(sub, "fields"));
        if (patch)
        {
            addWalls(sub, how, names, walls);
            continue;
        }
        if (names.size() != 2)
        {
            FatalIOErrorInFunction(sub)
                << "fields must name two velocity fields, or with a patch those which touch it;"
                << " it has " << names << "." << exit(FatalIOError);
        }
        const label a = fieldNamed(sub, names[0]);
        const label b = fieldNamed(sub, names[1]);
        if (a == b || between(a, b))
        {
            FatalIOErrorInFunction(sub) << "fields " << names << ": "
                                        << (a == b ? "a field has no contact with itself"
                                                   : "this pair has a contact already")
                                        << "." << exit(FatalIOError);
        }
        addPair(how, a, b, -1);
    }
    if (others)
    {
        const label nNamed = pairs_.size();
        const rule how(readRule(*others));
        for (label a = 0; a < fields_.size(); ++a)
        {
            for (label b = a + 1; b < fields_.size(); ++b)
            {
                if (!between(a, b))
                {
                    addPair(how, a, b, -1);
                }
            }
        }
        if (pairs_.size() == nNamed)
        {
            WarningInFunction << "Contact " << others->dictName() << " is for all pairs of"
                              << " velocity fields that are not named, and there is none: it"
                              << " does nothing. A wall is a patch that is named:  floor {"
                              << " fields (" << fields_[0].name() << "); patch floor; type "
                              << how.law->type() << "; }" << endl;
        }
    }
}
