// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "rowsDistribution.H"
#include "fieldTypes.H"
#include "processorPolyPatch.H"
#include "PstreamBuffers.H"
#include "Tuple2.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::HashTable<Foam::label> Foam::mpm::rowsDistribution::lists(const dictionary& dict)
{
    HashTable<label> found;
    for (const entry& e : dict)
    {
        if (e.isStream())
        {
            const label n = componentsOf(e.stream());
            if (n == 1 || n == 3 || n == 6 || n == 9)
            {
                found.insert(e.keyword(), n);
            }
        }
    }
    Pstream::mapCombineGather(found, maxEqOp<label>());
    Pstream::mapCombineScatter(found);
    return found;
}

template<class Type>
void Foam::mpm::rowsDistribution::moveList(
    dictionary& dict, const word& key, const place of, const label patchi) const
{
    const label n = of == cells ? nCells_
        : of == nodes           ? nPoints_
        : of == faces           ? size_[patchi]
                                : points_[patchi].size();
    Field<Type> v(n, Zero);
    if (n || dict.found(key))
    {
        v = Field<Type>(key, dict, n);
    }
    if (of == cells)
    {
        map_->cells.distribute(v);
    }
    else if (of == nodes)
    {
        map_->points.distribute(v);
    }
    else if (of == faces)
    {
        Field<Type> all(nFaces_, Zero);
        SubField<Type>(all, n, start_[patchi]) = v;
        map_->faces.distribute(all);
        const polyPatch& pp = mesh_.boundaryMesh()[patchi];
        v = SubField<Type>(all, pp.size(), pp.start());
    }
    else
    {
        Field<Type> all(nPoints_, Zero);
        forAll(v, i)
        {
            all[points_[patchi][i]] = v[i];
        }
        map_->points.distribute(all);
        v = Field<Type>(all, mesh_.boundaryMesh()[patchi].meshPoints());
    }
    dict.merge(writtenDictionary([&](Ostream& os) { v.writeEntry(key, os); }));
}

void Foam::mpm::rowsDistribution::moveLists(
    dictionary& dict, const place of, const label patchi) const
{
    const HashTable<label> all(lists(dict));
    for (const word& key : all.sortedToc())
    {
        switch (all[key])
        {
        case 1:
            moveList<scalar>(dict, key, of, patchi);
            break;
        case 3:
            moveList<vector>(dict, key, of, patchi);
            break;
        case 6:
            moveList<symmTensor>(dict, key, of, patchi);
            break;
        default:
            moveList<tensor>(dict, key, of, patchi);
        }
    }
}

void Foam::mpm::rowsDistribution::moveField(dictionary& field, const place boundary) const
{
    moveLists(field, boundary == faces ? cells : nodes, -1);
    const word boundaryField("boundaryField");
    if (!field.found(boundaryField))
    {
        return;
    }

    // Patches between processors have no state
    dictionary& all = field.subDict(boundaryField);
    const dictionary before(all);
    all.clear();
    forAll(mesh_.boundaryMesh(), patchi)
    {
        const polyPatch& pp = mesh_.boundaryMesh()[patchi];
        dictionary of(before.subOrEmptyDict(pp.name()));
        if (patchi < start_.size())
        {
            moveLists(of, boundary, patchi);
        }
        else
        {
            of = writtenDictionary([&](Ostream& os) { os.writeEntry("type", pp.type()); });
        }
        all.add(pp.name(), of);
    }
}

void Foam::mpm::rowsDistribution::moveFields(fieldStates& fields, const place boundary) const
{
    for (const word& name : fields.sortedToc())
    {
        moveField(fields[name], boundary);
    }
}

void Foam::mpm::rowsDistribution::movePoints(pointRows& rows, const labelUList& newCells) const
{
    // A processor without points may not have all columns
    List<Tuple2<wordList, labelList>> columns(Pstream::nProcs());
    columns[Pstream::myProcNo()] =
        Tuple2<wordList, labelList>(rows.size() ? rows.columns : wordList(), rows.nComponents);
    Pstream::gatherList(columns);
    Pstream::scatterList(columns);
    for (const Tuple2<wordList, labelList>& of : columns)
    {
        if (of.first().size())
        {
            rows.columns = of.first();
            rows.nComponents = of.second();
        }
    }

    const label size = rows.rowSize();
    List<DynamicList<scalar>> values(Pstream::nProcs());
    List<DynamicList<label>> cells(Pstream::nProcs());
    forAll(rows.cells, p)
    {
        const label c = rows.cells[p];
        values[toProc_[c]].append(SubList<scalar>(rows.values, size, size * p));
        cells[toProc_[c]].append(newCells[c]);
    }
    rows.values.clear();
    DynamicList<label> now;
    PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);
    forAll(values, proci)
    {
        UOPstream os(proci, buffers);
        os << static_cast<const UList<scalar>&>(values[proci])
           << static_cast<const UList<label>&>(cells[proci]);
        values[proci].clearStorage();
    }
    buffers.finishedSends();
    forAll(values, proci)
    {
        UIPstream is(proci, buffers);
        rows.values.append(List<scalar>(is));
        now.append(labelList(is));
    }
    rows.cells.transfer(now);
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::rowsDistribution::rowsDistribution(const fvMesh& mesh, const labelList& toProc) :
    mesh_(mesh),
    toProc_(toProc),
    nPoints_(mesh.nPoints()),
    nFaces_(mesh.nFaces()),
    nCells_(mesh.nCells()),
    map_(nullptr)
{
    const label n = mesh.boundaryMesh().nNonProcessor();
    start_.setSize(n);
    size_.setSize(n);
    points_.setSize(n);
    forAll(start_, patchi)
    {
        const polyPatch& pp = mesh.boundaryMesh()[patchi];
        start_[patchi] = pp.start();
        size_[patchi] = pp.size();
        points_[patchi] = pp.meshPoints();
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::mpm::rowsDistribution::componentsOf(ITstream& is)
{
    if (is.size() < 2 || !is[0].isWord())
    {
        return 0;
    }
    if (is[0].wordToken() == "uniform")
    {
        return is[1].isPunctuation() ? is.size() - 3 : label(1);
    }
    if (is[0].wordToken() != "nonuniform" || !is[1].isCompound())
    {
        return 0;
    }
    const word& type = is[1].compoundToken().type();
    return type == token::Compound<List<scalar>>::typeName    ? 1
        : type == token::Compound<List<vector>>::typeName     ? 3
        : type == token::Compound<List<symmTensor>>::typeName ? 6
        : type == token::Compound<List<tensor>>::typeName     ? 9
                                                              : 0;
}

void Foam::mpm::rowsDistribution::move(simulation::rows& rows, const meshDistribution::maps& map)
{
    map_ = &map;
    moveFields(rows.gas, faces);
    moveFields(rows.points.cellFields, faces);
    moveFields(rows.points.pointFields, points);
    labelList newCells(identity(mesh_.nCells()));
    map.cells.reverseDistribute(nCells_, newCells);
    for (const word& phase : rows.points.points.sortedToc())
    {
        movePoints(rows.points.points[phase], newCells);
    }
    rows.places = meshPlaces(mesh_);
}
