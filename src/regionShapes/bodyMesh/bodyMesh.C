// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "bodyMesh.H"
#include "simplexParts.H"
#include "mshReader.H"
#include "cellModel.H"
#include "IFstream.H"
#include "tetPointRef.H"
#include "vtkUnstructuredReader.H"

#include <algorithm>
#include <map>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::bodyMesh::checkGroups(const wordList& groups, const wordList& valid) const
{
    for (const word& group : groups)
    {
        if (!valid.found(group))
        {
            OStringStream groupNames;
            groupNames << flatOutput(valid);
            FatalIOErrorInFunction(dict_)
                << "Entry group: the mesh " << file_ << " has no elements of a"
                << " physical group " << group << " in " << nDim_ << "D, the"
                << " dimensions of the case."
                << (valid.empty() && nDim_ == 3
                        ? string(" It has no group in 3D at all: if the scene is in 2D,"
                                 " front and back of the case's mesh must be of type"
                                 " empty, or wedge.")
                        : " Valid groups: " + groupNames.str())
                       .c_str()
                << exit(FatalIOError);
        }
    }
}

void Foam::mpm::bodyMesh::readMsh(const wordList& groups)
{
    const mshReader file(file_, dict_);
    points_ = file.points();

    const auto nameOf = [&](const label tag)
    { return file.names(nDim_).lookup(tag, Foam::name(tag)); };

    int highest = 0;
    wordHashSet valid;
    for (const mshReader::element& e : file.elements())
    {
        highest = max(highest, e.dim);
        bool wanted = groups.empty();
        for (const label tag : e.groups)
        {
            if (e.dim == nDim_)
            {
                const word group(nameOf(tag));
                valid.insert(group);
                wanted = wanted || groups.found(group);
            }
        }
        if (wanted && e.dim == nDim_)
        {
            elements_.append(e.nodes);
        }
    }
    checkGroups(groups, valid.sortedToc());
    if (highest > nDim_)
    {
        FatalIOErrorInFunction(dict_)
            << "The mesh " << file_ << " has elements in " << highest << "D; that of the case is "
            << nDim_ << "D." << exit(FatalIOError);
    }
}

void Foam::mpm::bodyMesh::readVtk(const objectRegistry& registry, const wordList& groups)
{
    IFstream is(file_);
    if (!is.good())
    {
        FatalIOErrorInFunction(dict_)
            << "Cannot read the mesh " << file_ << ": there is no such file." << exit(FatalIOError);
    }
    const vtkUnstructuredReader file(registry, is);
    points_ = file.points();
    checkGroups(groups, wordList());
    if (nDim_ == 3)
    {
        for (const cellShape& cell : file.cells())
        {
            elements_.append(cell);
        }
    }
    else
    {
        for (const face& f : file.faces())
        {
            elements_.append(f);
        }
    }
    for (const labelList& e : elements_)
    {
        if (min(e) < 0 || max(e) >= points_.size() || e.size() > 8)
        {
            FatalIOErrorInFunction(dict_)
                << "Cannot read the mesh " << file_ << ": an element has nodes " << e << " of "
                << points_.size() << "." << exit(FatalIOError);
        }
    }
}

Foam::faceList Foam::mpm::bodyMesh::faces(const labelUList& corners) const
{
    faceList result;
    if (nDim_ == 2)
    {
        const label n = corners.size();
        result.setSize(n);
        for (label i = 0; i < n; ++i)
        {
            result[i] = face(labelList({corners[i], corners[(i + 1) % n]}));
        }
        return result;
    }
    static const cellModel* models[9] = {
        nullptr,
        nullptr,
        nullptr,
        nullptr,
        &cellModel::ref(cellModel::TET),
        &cellModel::ref(cellModel::PYR),
        &cellModel::ref(cellModel::PRISM),
        nullptr,
        &cellModel::ref(cellModel::HEX)};
    result = models[corners.size()]->faces(corners);
    return result;
}

Foam::vector Foam::mpm::bodyMesh::normal(const face& f) const
{
    if (f.size() > 2)
    {
        return f.areaNormal(points_);
    }
    vector along(points_[f[1]] - points_[f[0]]), n(Zero);
    const int a = grid_.direction(0), b = grid_.direction(1);
    n[a] = along[b];
    n[b] = -along[a];
    return n;
}

void Foam::mpm::bodyMesh::check() const
{
    constexpr scalar tolerance = 1e-9;

    forAll(elements_, e)
    {
        const cornerRegions r(regions(e));
        const scalar whole = r.whole();
        scalar byFaces = 0;
        if (nDim_ == 2)
        {
            byFaces = mag(face(elements_[e]).areaNormal(points_));
        }
        else
        {
            // Triangles about the means of the corners, as in cornerRegions
            const point O(points_[elements_[e][0]]);
            for (const face& f : faces(elements_[e]))
            {
                point F(Zero);
                for (const label i : f)
                {
                    F += points_[i] / f.size();
                }
                forAll(f, i)
                {
                    const edge ab(f.faceEdge(i));
                    byFaces += ((F - O) & ((points_[ab[0]] - O) ^ (points_[ab[1]] - O))) / 6;
                }
            }
            byFaces = mag(byFaces);
        }
        if (!(min(r.volume()) > 0) || !(mag(byFaces - whole) <= tolerance * whole))
        {
            FatalIOErrorInFunction(dict_)
                << "The mesh " << file_ << " has an element of " << elements_[e].size()
                << " nodes at " << r.centre()
                << " that is folded over or has no volume: the sum of its parts"
                << " is " << whole << ", by its sides " << byFaces << "; improve the mesh."
                << exit(FatalIOError);
        }
    }
}

void Foam::mpm::bodyMesh::findOutside()
{
    // Faces by their nodes in order: the element of the first, -1: two have it
    std::map<std::vector<label>, std::pair<label, face>> first;
    forAll(elements_, e)
    {
        const cornerRegions r(regions(e));
        for (face f : faces(elements_[e]))
        {
            std::vector<label> key(f.begin(), f.end());
            std::sort(key.begin(), key.end());
            const point middle(f.average(points_, points_));
            if ((normal(f) & (middle - r.centre())) < 0)
            {
                std::reverse(f.begin(), f.end());
            }
            const auto found = first.emplace(key, std::make_pair(e, f));
            if (!found.second)
            {
                found.first->second.first = -1;
            }
        }
    }
    outside_.setSize(elements_.size());
    for (const auto& item : first)
    {
        if (item.second.first >= 0)
        {
            outside_[item.second.first].append(item.second.second);
        }
    }
}

Foam::label Foam::mpm::bodyMesh::row(const int d, const scalar x) const
{
    const int c = grid_.direction(d);
    const scalar at = (x - bounds_.min()[c]) / bounds_.span()[c] * n_[d];
    return at < 0 ? 0 : at >= n_[d] ? n_[d] - 1 : label(at);
}

void Foam::mpm::bodyMesh::makeBoxes()
{
    // About as many as there are elements, of nearly equal sides
    scalar size = 1;
    for (int d = 0; d < nDim_; ++d)
    {
        size *= bounds_.span()[grid_.direction(d)];
    }
    const scalar side = std::pow(size / elements_.size(), 1.0 / nDim_);
    label nBoxes = 1;
    for (int d = 0; d < 3; ++d)
    {
        n_[d] = 1;
        if (d < nDim_)
        {
            const scalar n = bounds_.span()[grid_.direction(d)] / side;
            n_[d] = label(min(max(n, scalar(1)), scalar(1000)));
        }
        nBoxes *= n_[d];
    }

    inBox_.setSize(nBoxes);
    forAll(elements_, e)
    {
        const boundBox bb(points_, elements_[e], false);
        label low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
        for (int d = 0; d < nDim_; ++d)
        {
            low[d] = row(d, bb.min()[grid_.direction(d)]);
            high[d] = row(d, bb.max()[grid_.direction(d)]);
        }
        for (label k = low[2]; k <= high[2]; ++k)
        {
            for (label j = low[1]; j <= high[1]; ++j)
            {
                for (label i = low[0]; i <= high[0]; ++i)
                {
                    inBox_[i + n_[0] * (j + n_[1] * k)].append(e);
                }
            }
        }
    }
}

bool Foam::mpm::bodyMesh::contains(const labelUList& corners, const point& x) const
{
    // Beyond no side, by as much as rounding
    constexpr scalar tolerance = 1e-12;

    if (nDim_ == 2)
    {
        // Corners go round: beyond no edge, or beyond all
        label n = 0;
        for (const face& f : faces(corners))
        {
            n += (normal(f) & (x - points_[f[0]])) > 0;
        }
        return n == 0 || n == corners.size();
    }

    point O(Zero);
    for (const label i : corners)
    {
        O += points_[i] / corners.size();
    }
    for (const face& f : faces(corners))
    {
        point F(Zero);
        for (const label i : f)
        {
            F += points_[i] / f.size();
        }
        forAll(f, i)
        {
            const edge e(f.faceEdge(i));
            const tetPointRef tet(O, F, points_[e[0]], points_[e[1]]);
            const barycentric b(tet.pointToBarycentric(x));
            if (cmptMin(b) > -tolerance)
            {
                return true;
            }
        }
    }
    return false;
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::bodyMesh::bodyMesh(
    const fileName& file, const dictionary& dict, const pointGrid& grid, const wordList& groups,
    const scalar scale) :
    file_(file), dict_(dict), grid_(grid), nDim_(grid.nDim()), volume_(0)
{
    const word ext(file.ext());
    if (nDim_ < 2)
    {
        FatalIOErrorInFunction(dict_)
            << "A region of type mesh needs a case in 2D or 3D; for 1D take a"
            << " box." << exit(FatalIOError);
    }
    if (ext == "msh")
    {
        readMsh(groups);
    }
    else if (ext == "vtk")
    {
        readVtk(grid.mesh(), groups);
    }
    else
    {
        FatalIOErrorInFunction(dict_)
            << "Entry file: a mesh is a .msh of gmsh or a .vtk, not " << file
            << ". A closed surface (.stl, .obj) is a region of type surface." << exit(FatalIOError);
    }
    if (elements_.empty())
    {
        FatalIOErrorInFunction(dict_) << "The mesh " << file_ << " has no elements in " << nDim_
                                      << "D." << exit(FatalIOError);
    }

    bool computed[3] = {false, false, false};
    for (int d = 0; d < nDim_; ++d)
    {
        computed[grid.direction(d)] = true;
    }
    for (point& x : points_)
    {
        for (int c = 0; c < 3; ++c)
        {
            x[c] = computed[c] ? scale * x[c] : 0;
        }
    }
    for (const labelList& e : elements_)
    {
        bounds_.add(points_, e);
    }
    check();
    forAll(elements_, e)
    {
        const cornerRegions r(regions(e));
        volume_ += r.whole() * (grid.radial() < 0 ? 1 : r.centre()[grid.direction(grid.radial())]);
    }
    findOutside();
    makeBoxes();
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::mpm::bodyMesh::mostParts(const label pointsPerCell) const
{
    label most = 0;
    forAll(elements_, e)
    {
        most = max(most, parts(e, pointsPerCell)->size());
    }
    return most;
}

Foam::mpm::cornerRegions Foam::mpm::bodyMesh::regions(const label e) const
{
    return nDim_ == 2 ? cornerRegions(face(elements_[e]), points_)
                      : cornerRegions(elements_[e], faces(elements_[e]), points_);
}

Foam::autoPtr<Foam::mpm::cellParts>
Foam::mpm::bodyMesh::parts(const label e, const label pointsPerCell) const
{
    const labelList& corners = elements_[e];
    if (pointsPerCell < 3)
    {
        return autoPtr<cellParts>(new cornerRegions(regions(e)));
    }
    return autoPtr<cellParts>(
        nDim_ == 2 ? new simplexParts(face(corners), points_, pointsPerCell)
                   : new simplexParts(corners, faces(corners), points_, pointsPerCell));
}

Foam::scalar
Foam::mpm::bodyMesh::fit(const label e, const label corner, const point& x, const vector& l) const
{
    scalar factor = GREAT;
    for (const face& f : outside_[e])
    {
        if (corner < 0 || f.found(corner))
        {
            const vector n(normalised(normal(f)));
            const scalar s = n & (points_[f[0]] - x);
            factor = min(factor, max(s, scalar(0)) / mag(cmptMultiply(l, n)));
        }
    }
    return factor < GREAT ? factor : 1;
}

bool Foam::mpm::bodyMesh::contains(const point& x) const
{
    point at(Zero);
    label box = 0, stride = 1;
    for (int d = 0; d < nDim_; ++d)
    {
        const int c = grid_.direction(d);
        at[c] = x[c];
        if (at[c] < bounds_.min()[c] || at[c] > bounds_.max()[c])
        {
            return false;
        }
        box += stride * row(d, at[c]);
        stride *= n_[d];
    }
    for (const label e : inBox_[box])
    {
        if (contains(elements_[e], at))
        {
            return true;
        }
    }
    return false;
}
