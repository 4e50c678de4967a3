// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "rowsRefinement.H"
#include "rowsDistribution.H"
#include "boundBox.H"
#include "fieldTypes.H"
#include "largestOfAll.H"
#include "ListOps.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- The values of an internal field: densities of the state
const word internalValues("value"), conditions("boundaryField");

//- Momentum of the state
const word ofVelocity("thetaRhoU");

//- Shares of a cell: fluids, solid
bool isShare(const word& name)
{
    const word member(IOobject::member(name));
    return member == "alpha" || member == "theta";
}

//- Impulse: a sum over the cell
bool isSum(const dictionary& field)
{
    dimensionSet d(dimless);
    return field.readIfPresent("dimensions", d) && d == dimForce * dimTime;
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::mpm::rowsRefinement::components(const dictionary& dict, const word& key)
{
    const entry* e = dict.findEntry(key, keyType::LITERAL);
    if (!e || !e->isStream() || e->stream().empty() || !e->stream()[0].isWord()
        || e->stream()[0].wordToken() != "nonuniform")
    {
        return 0;
    }
    return rowsDistribution::componentsOf(e->stream());
}

template<class Function>
void Foam::mpm::rowsRefinement::forLists(fieldStates& fields, const Function& f)
{
    for (const word& name : fields.sortedToc())
    {
        dictionary& field = fields[name];
        for (const word& key : {word("internalField"), internalValues})
        {
            // The same on all processors
            switch (returnReduce(components(field, key), maxOp<label>()))
            {
            case 1:
                f(name, field, key, pTraits<scalar>::zero);
                break;
            case 3:
                f(name, field, key, vector::zero);
                break;
            case 6:
                f(name, field, key, symmTensor::zero);
                break;
            case 9:
                f(name, field, key, tensor::zero);
                break;
            default:
                break;
            }
        }
    }
}

template<class Type>
void Foam::mpm::rowsRefinement::addList(
    const word& name, const dictionary& field, const word& key, readLists& lists)
{
    const Field<Type> v(key, field, V_.size());
    Field<Type> behind;
    syncTools::swapBoundaryCellList(mesh_, v, behind);
    const word member(IOobject::member(name));
    if (member == "thetaRho")
    {
        masses_.set(IOobject::group(name), values_.size());
    }
    scalar& scale = lists.scale(member, 0);
    for (const Type& q : v)
    {
        scale = max(scale, mag(q));
    }
    for (direction i = 0; i < pTraits<Type>::nComponents; ++i)
    {
        values_.append(new scalarField(v.component(i)));
        lists.behind.append(new scalarField(behind.component(i)));
        lists.names.append(name);
        lists.state.append(key == internalValues);
    }
}

void Foam::mpm::rowsRefinement::addGradients(const readLists& lists)
{
    HashTable<scalar> scale(lists.scale);
    for (const word& member : scale.sortedToc())
    {
        scale[member] = largestOfAll(scale[member]);
    }
    // Changes up to this part of a density, of the momentum at the speed sqrt(E/m), need no
    // factor: in a lake at rest noise would decide
    constexpr scalar free = 1e-4;
    scalarField mass(V_.size(), Zero), energy(V_.size(), Zero);
    forAll(values_, i)
    {
        const word member(IOobject::member(lists.names[i]));
        if (isShare(lists.names[i]))
        {
            gradients_->separate(values_[i], lists.behind[i]);
        }
        mass += (member == "thetaRho" ? 1 : 0) * values_[i];
        energy += (member == "thetaRhoE" ? 1 : 0) * values_[i];
    }
    const scalarField momentum(sqrt(max(mass * energy, scalar(0))));
    forAll(values_, i)
    {
        const word& name = lists.names[i];
        const word member(IOobject::member(name));
        gradients_->add(
            values_[i], lists.behind[i], scale[member], lists.state[i] || isShare(name),
            free * (member == ofVelocity ? momentum : scalarField(mag(values_[i]))));
    }
}

void Foam::mpm::rowsRefinement::makeGradients(const treeLeaves& to)
{
    // Centres of the children by the corners of the base cell
    const polyMesh& base = to.base().mesh();
    DynamicList<label> cells;
    DynamicList<DynamicList<vector>> children;
    for (label c = 0; c < to.size(); ++c)
    {
        if (!isPart(c))
        {
            continue;
        }
        const label old = from_[c][0];
        if (cells.empty() || cells.last() != old)
        {
            cells.append(old);
            children.append(DynamicList<vector>());
        }
        const baseHexes::hex& h = to.base()[to.cell()[c]];
        point x(Zero);
        for (label i = 0; i < 8; ++i)
        {
            scalar weight = 1;
            for (label a = 0; a < 3; ++a)
            {
                const scalar at = (to.at(c)[a] + 0.5 * to.width(c, a)) / treeLeaves::full;
                weight *= (i >> a) & 1 ? at : 1 - at;
            }
            x += weight * base.points()[h.corners[i]];
        }
        children.last().append(x - mesh_.cellCentres()[old]);
    }
    gradients_.reset(
        new childGradients(mesh_, cells, List<DynamicList<vector>>(std::move(children))));
}

template<class Type>
void Foam::mpm::rowsRefinement::moveList(const word& name, dictionary& field, const word& key)
{
    Field<Type> before(V_.size());
    for (direction i = 0; i < pTraits<Type>::nComponents; ++i)
    {
        before.replace(i, values_[next_ + i]);
    }
    const bool sum = isSum(field), density = key == internalValues && !sum;
    const word group(IOobject::group(name));
    const word member(IOobject::member(name));
    const bool ofMass = (member == "F" || member == "lambda") && masses_.found(group);
    const label mass = ofMass ? masses_[group] : -1;
    const auto weight = [&](const label o) { return ofMass ? V_[o] * values_[mass][o] : V_[o]; };
    const scalarField& V = mesh_.V();
    const vectorField& C = mesh_.cellCentres();
    Field<Type> now(from_.size());
    for (label c = 0; c < from_.size(); ++c)
    {
        const label old = from_[c][0];
        if (from_[c][1] > old + 1)
        {
            // Put together
            Type q(Zero);
            for (label o = old; o < from_[c][1]; ++o)
            {
                q += (sum ? 1 : weight(o)) * before[o];
            }
            scalar all = 0;
            for (label o = old; o < from_[c][1]; ++o)
            {
                all += weight(o);
            }
            now[c] = sum ? q : q / (density ? V[c] : max(all, VSMALL));
            continue;
        }
        label last = c;
        while (last + 1 < from_.size() && from_[last + 1] == from_[c])
        {
            ++last;
        }
        scalar all = 0;
        vector x(Zero);
        for (label n = c; n <= last; ++n)
        {
            all += V[n];
            x += V[n] * C[n];
        }
        x /= all;
        for (label n = c; n <= last; ++n)
        {
            now[n] = before[old];
            for (direction i = 0; !ofMass && last > c && i < pTraits<Type>::nComponents; ++i)
            {
                setComponent(now[n], i) += (*gradients_)(next_ + i, old) & (C[n] - x);
            }
            now[n] *= sum ? V[n] / all : density ? V_[old] / all : 1;
        }
        c = last;
    }
    next_ += pTraits<Type>::nComponents;
    field.merge(writtenDictionary([&](Ostream& os) { now.writeEntry(key, os); }));
}

void Foam::mpm::rowsRefinement::mapFaces()
{
    // A new face and those of before on the same base face, by their cells
    Map<Pair<label>> onBase(2 * baseFace_.size());
    forAll(baseFace_, i)
    {
        Pair<label>& range = onBase(baseFace_[i]);
        range = i > 0 && baseFace_[i - 1] == baseFace_[i] ? Pair<label>(range[0], i + 1)
                                                          : Pair<label>(i, i + 1);
    }
    const labelList& now = adaptive_.baseFace();
    fromFaces_.setSize(now.size());
    forAll(now, i)
    {
        const Pair<label>& cells = from_[mesh_.faceOwner()[mesh_.nInternalFaces() + i]];
        DynamicList<label> from;
        const Pair<label> range(onBase[now[i]]);
        for (label o = range[0]; o < range[1]; ++o)
        {
            if (owner_[o] >= cells[0] && owner_[o] < cells[1])
            {
                from.append(o);
            }
        }
        fromFaces_[i].transfer(from);
    }
}

template<class Type>
void Foam::mpm::rowsRefinement::moveFaces(
    dictionary& patch, const word& key, const label patchi) const
{
    const Field<Type> before(key, patch, size_[patchi]);
    const polyPatch& pp = mesh_.boundaryMesh()[patchi];
    Field<Type> now(pp.size(), Zero);
    forAll(now, i)
    {
        const labelList& from = fromFaces_[pp.start() - mesh_.nInternalFaces() + i];
        for (const label o : from)
        {
            now[i] += before[o - start_[patchi]] / scalar(from.size());
        }
    }
    patch.merge(writtenDictionary([&](Ostream& os) { now.writeEntry(key, os); }));
}

void Foam::mpm::rowsRefinement::moveBoundary(dictionary& field) const
{
    if (!field.found(conditions))
    {
        return;
    }
    dictionary& all = field.subDict(conditions);
    forAll(mesh_.boundaryMesh(), patchi)
    {
        const word& name = mesh_.boundaryMesh()[patchi].name();
        if (!all.found(name))
        {
            continue;
        }
        dictionary& patch = all.subDict(name);
        for (const word& key : patch.toc())
        {
            switch (components(patch, key))
            {
            case 1:
                moveFaces<scalar>(patch, key, patchi);
                break;
            case 3:
                moveFaces<vector>(patch, key, patchi);
                break;
            case 6:
                moveFaces<symmTensor>(patch, key, patchi);
                break;
            case 9:
                moveFaces<tensor>(patch, key, patchi);
                break;
            default:
                break;
            }
        }
    }
}

void Foam::mpm::rowsRefinement::movePoints(pointRows& rows) const
{
    // New cells of each old one
    List<Pair<label>> now(V_.size(), Pair<label>(labelMax, -1));
    forAll(from_, c)
    {
        for (label o = from_[c][0]; o < from_[c][1]; ++o)
        {
            now[o] = Pair<label>(min(now[o][0], c), c);
        }
    }
    const label size = rows.rowSize(), x = rows.place("x");
    forAll(rows.cells, p)
    {
        label& c = rows.cells[p];
        const Pair<label> to(now[c < 0 ? -2 - c : c]);
        if (to[0] == to[1])
        {
            c = c < 0 ? -2 - to[0] : to[0];
            continue;
        }
        // In one of several: -2 - a cell nearby, of boxes the one
        scalar least = VGREAT;
        for (label n = to[0]; n <= to[1]; ++n)
        {
            scalar way = 0;
            label i = 0;
            for (direction d = 0; d < 3; ++d)
            {
                if (mesh_.geometricD()[d] > 0)
                {
                    way += sqr(mesh_.cellCentres()[n][d] - rows.values[size * p + x + i++]);
                }
            }
            c = way < least ? -2 - n : c;
            least = min(least, way);
        }
    }
}

void Foam::mpm::rowsRefinement::splitPoints(pointRows& rows) const
{
    const label size = rows.rowSize();
    const int nDim = mesh_.nGeometricD(), n = 1 << nDim;
    const label x = rows.place("x"), m = rows.place("m"), V = rows.place("V"),
                id = rows.place("id");
    const label half = rows.place("halfSize"), reference = rows.place("X");

    DynamicList<label> which;
    labelList ids;
    scalar next = 0;
    for (label p = 0; p < rows.size(); ++p)
    {
        const scalar* row = &rows.values[size * p];
        next = max(next, row[id] + 1);
        const label c = rows.cells[p];
        const auto iter = boxes_.cfind(c < 0 ? -2 - c : c);
        if (iter.good() && row[V] > 0.5 * V_[iter.key()] / n)
        {
            which.append(p);
            ids.append(label(row[id]));
        }
    }
    List<labelList> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = ids;
    Pstream::gatherList(all);
    Pstream::scatterList(all);
    labelList sorted(ListListOps::combine<labelList>(all, accessOp<labelList>()));
    Foam::sort(sorted);
    reduce(next, maxOp<scalar>());

    DynamicList<scalar> values(std::move(rows.values));
    DynamicList<label> cells(std::move(rows.cells));
    for (const label p : which)
    {
        const label at = cells[p], c = at < 0 ? -2 - at : at;
        const boundBox& box = boxes_[c];
        const List<scalar> parent(SubList<scalar>(values, size, size * p));
        const scalar place =
            std::lower_bound(sorted.begin(), sorted.end(), label(parent[id])) - sorted.begin();
        for (int part = 0; part < n; ++part)
        {
            List<scalar> row(parent);
            row[m] /= n;
            row[V] /= n;
            int i = 0;
            for (direction d = 0; d < 3; ++d)
            {
                if (mesh_.geometricD()[d] < 0)
                {
                    continue;
                }
                // Within the cell, of which the point's is known if it is a box
                const scalar width = half >= 0
                    ? 2 * parent[half + i]
                    : box.span()[d] * std::pow(parent[V] / V_[c], 1.0 / nDim);
                const scalar room =
                    0.9 * min(parent[x + i] - box.min()[d], box.max()[d] - parent[x + i]);
                const scalar way = ((part >> i) & 1 ? 1 : -1)
                    * (room > 0 ? min(0.25 * width, room) : 0.25 * width);
                row[x + i] += way;
                if (reference >= 0)
                {
                    row[reference + i] += way;
                }
                if (half >= 0)
                {
                    row[half + i] /= 2;
                }
                ++i;
            }
            if (part == 0)
            {
                SubList<scalar>(values, size, size * p) = row;
            }
            else
            {
                row[id] = next + (n - 1) * place + part - 1;
                values.append(row);
                cells.append(at);
            }
        }
    }
    rows.values.transfer(values);
    rows.cells.transfer(cells);
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::rowsRefinement::rowsRefinement(
    const fvMesh& mesh, const adaptiveMesh& adaptive, const treeLeaves& to, simulation::rows& rows,
    fieldStates& others, const wordList& split) :
    mesh_(mesh),
    adaptive_(adaptive),
    from_(to.sources(adaptive.leaves())),
    start_(mesh.boundaryMesh().size()),
    size_(start_.size()),
    baseFace_(adaptive.baseFace()),
    owner_(SubList<label>(
        mesh.faceOwner(), mesh.nFaces() - mesh.nInternalFaces(), mesh.nInternalFaces())),
    V_(mesh.V().field()),
    split_(split),
    next_(0)
{
    forAll(start_, patchi)
    {
        start_[patchi] = mesh.boundaryMesh()[patchi].start() - mesh.nInternalFaces();
        size_[patchi] = mesh.boundaryMesh()[patchi].size();
    }
    makeGradients(to);
    for (label c = 0; split.size() && c < from_.size(); ++c)
    {
        if (isPart(c))
        {
            const label old = from_[c][0];
            boxes_.set(old, boundBox(pointField(mesh.points(), mesh.cellPoints()[old]), false));
        }
    }
    readLists lists;
    const auto add = [&](const word& name, const dictionary& field, const word& key, const auto& as)
    { addList<typename std::decay<decltype(as)>::type>(name, field, key, lists); };
    for (fieldStates* fields : {&rows.gas, &rows.points.cellFields, &others})
    {
        forLists(*fields, add);
    }
    addGradients(lists);
    forAllConstIters(rows.points.pointFields, iter)
    {
        for (const entry& e : iter.val().subDict(conditions))
        {
            for (const word& key : e.dict().toc())
            {
                if (components(e.dict(), key))
                {
                    FatalIOErrorInFunction(e.dict())
                        << "Entry " << key << " of " << iter.key() << " on patch " << e.keyword()
                        << " is a list of values at points of the mesh; with an adaptive mesh it"
                        << " must be uniform, or a function of time and place."
                        << exit(FatalIOError);
                }
            }
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::rowsRefinement::move(simulation::rows& rows, fieldStates& others)
{
    mapFaces();
    next_ = 0;
    const auto moveCells = [&](const word& name, dictionary& field, const word& key, const auto& as)
    { moveList<typename std::decay<decltype(as)>::type>(name, field, key); };
    for (fieldStates* fields : {&rows.gas, &rows.points.cellFields, &others})
    {
        forLists(*fields, moveCells);
        forAllIters(*fields, iter) { moveBoundary(iter.val()); }
    }
    for (const word& phase : rows.points.points.sortedToc())
    {
        if (split_.found(phase))
        {
            splitPoints(rows.points.points[phase]);
        }
        movePoints(rows.points.points[phase]);
    }
    forAllIters(rows.points.pointFields, iter)
    {
        iter.val().merge(
            writtenDictionary([](Ostream& os) { os << "internalField uniform (0 0 0);"; }));
    }
    rows.places = meshPlaces(mesh_);
}
