/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "mshReader.H"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::mshReader::fail(const string& problem) const
{
    FatalIOErrorInFunction(dict_)
        << "Cannot read the mesh " << file_ << ": "
        << (section_[0] == '$' ? "section " + section_ + ", " : section_).c_str()
        << problem.c_str() << exit(FatalIOError);

    std::abort();
}


template<class Type>
Type Foam::mpm::mshReader::get()
{
    Type value = 0;
    if (binary_)
    {
        is_.read(reinterpret_cast<char*>(&value), sizeof(Type));
    }
    else
    {
        is_ >> value;
    }
    if (!is_)
    {
        fail("the file ends, or there is no number where one must be.");
    }
    return value;
}


Foam::label Foam::mpm::mshReader::count()
{
    // Each item takes a byte at least
    const int64_t n = get<int64_t>();
    if (n < 0 || n > size_)
    {
        fail("a size of " + std::to_string(n) + " cannot be right.");
    }
    return label(n);
}


Foam::label Foam::mpm::mshReader::tag()
{
    const int64_t n = version_ < 4 ? get<int32_t>() : get<int64_t>();
    if (n < 0 || n > std::numeric_limits<label>::max())
    {
        fail("a number of " + std::to_string(n) + " cannot be right.");
    }
    return label(n);
}


void Foam::mpm::mshReader::skipLine()
{
    is_.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
}


void Foam::mpm::mshReader::skipSection()
{
    const std::string end("$End" + section_.substr(1));
    std::string line;
    while (std::getline(is_, line))
    {
        // Behind binary numbers the word ends a line
        if (line.find(end) != std::string::npos)
        {
            return;
        }
    }
    fail(end + " is missing.");
}


void Foam::mpm::mshReader::readFormat()
{
    binary_ = false;
    version_ = get<scalar>();
    const bool binary = get<int>();
    const int size = get<int>();
    if ((version_ < 2 || version_ >= 3) && mag(version_ - 4.1) > 1e-6)
    {
        fail
        (
            "version " + name(version_) + " is not read, only 2 and 4.1; write"
            " it anew with  gmsh -save -format msh41 " + file_.name() + " -o "
          + file_.lessExt().name() + "41.msh"
        );
    }
    skipLine();
    if (binary)
    {
        int32_t one = 0;
        is_.read(reinterpret_cast<char*>(&one), sizeof(one));
        if (one != 1 || size != 8)
        {
            fail("binary numbers of another kind of machine.");
        }
    }
    binary_ = binary;
}


void Foam::mpm::mshReader::readNames()
{
    const bool binary = binary_;
    binary_ = false;
    const label n = count();
    for (label i = 0; i < n; ++i)
    {
        const label dim = get<label>(), tag = get<label>();
        std::string name;
        std::getline(is_, name);
        const std::size_t first = name.find('"'), last = name.rfind('"');
        if (dim < 0 || dim > 3 || first == last)
        {
            fail("group " + std::to_string(tag) + " has no dimension or name.");
        }
        names_[dim].set
        (
            tag,
            word(name.substr(first + 1, last - first - 1), false)
        );
    }
    binary_ = binary;
}


void Foam::mpm::mshReader::readEntities()
{
    label n[4];
    for (label& m : n)
    {
        m = count();
    }
    for (int dim = 0; dim < 4; ++dim)
    {
        for (label i = 0; i < n[dim]; ++i)
        {
            const label tag = get<int32_t>();
            for (int j = 0; j < (dim ? 6 : 3); ++j)
            {
                get<double>();
            }
            labelList groups(count());
            for (label& g : groups)
            {
                g = get<int32_t>();
            }
            groupsOf_[dim].set(tag, groups);
            for (label left = dim ? count() : 0; left > 0; --left)
            {
                get<int32_t>();
            }
        }
    }
}


void Foam::mpm::mshReader::addPoint(const label number, const point& x)
{
    if (!(mag(x) < GREAT))
    {
        fail("node " + std::to_string(number) + " has no finite place.");
    }
    if (!pointOf_.insert(number, points_.size()))
    {
        fail("node " + std::to_string(number) + " is there twice.");
    }
    points_.append(x);
}


void Foam::mpm::mshReader::readNodes2()
{
    const bool binary = binary_;
    binary_ = false;
    const label n = count();
    binary_ = binary;
    if (binary)
    {
        skipLine();
    }
    for (label i = 0; i < n; ++i)
    {
        const label number = tag();
        const scalar x = get<double>(), y = get<double>(), z = get<double>();
        addPoint(number, point(x, y, z));
    }
}


void Foam::mpm::mshReader::readNodes4()
{
    const label nBlocks = count();
    for (int i = 0; i < 3; ++i)
    {
        get<int64_t>();
    }
    for (label block = 0; block < nBlocks; ++block)
    {
        const int dim = get<int32_t>();
        get<int32_t>();
        const int nParameters = get<int32_t>() ? dim : 0;
        labelList numbers(count());
        for (label& number : numbers)
        {
            number = tag();
        }
        for (const label number : numbers)
        {
            const scalar x = get<double>(), y = get<double>(), z = get<double>();
            for (int i = 0; i < nParameters; ++i)
            {
                get<double>();
            }
            addPoint(number, point(x, y, z));
        }
    }
}


int Foam::mpm::mshReader::nodesOfType(const label type, int& dim) const
{
    static const struct { int dim, nNodes; } types[] =
        {{1, 2}, {2, 3}, {2, 4}, {3, 4}, {3, 8}, {3, 6}, {3, 5}};

    if (type == 15)
    {
        dim = 0;
        return 1;
    }
    if (type < 1 || type > 7)
    {
        fail
        (
            "elements of gmsh's type " + std::to_string(type) + "; only those of"
            " the first order with straight sides are read (gmsh -order 1)."
        );
    }
    dim = types[type - 1].dim;
    return types[type - 1].nNodes;
}


void Foam::mpm::mshReader::addElement
(
    const int dim,
    const int nNodes,
    const label number,
    const labelUList& groups
)
{
    element e;
    e.dim = dim;
    e.nodes.setSize(nNodes);
    for (label& node : e.nodes)
    {
        const label at = tag();
        const auto iter = pointOf_.cfind(at);
        if (!iter.good())
        {
            fail
            (
                "element " + std::to_string(number) + " has node "
              + std::to_string(at) + ", which is not there."
            );
        }
        node = *iter;
    }
    if (dim < 2)
    {
        return;
    }
    if (version_ < 4)
    {
        std::vector<label> key(e.nodes.begin(), e.nodes.end());
        std::sort(key.begin(), key.end());
        const auto found = known_.emplace(key, elements_.size());
        if (!found.second)
        {
            elements_[found.first->second].groups.append(groups);
            return;
        }
    }
    e.groups.append(groups);
    elements_.append(e);
}


void Foam::mpm::mshReader::readElements2()
{
    const bool binary = binary_;
    binary_ = false;
    const label n = count();
    binary_ = binary;
    if (binary)
    {
        skipLine();
    }
    for (label i = 0; i < n;)
    {
        label number = binary ? 0 : get<int32_t>();
        const label type = get<int32_t>();
        const label nBlock = binary ? get<int32_t>() : 1;
        const label nTags = get<int32_t>();
        int dim;
        const int nNodes = nodesOfType(type, dim);
        if (nBlock < 1 || nBlock > n - i || nTags < 0 || nTags > size_)
        {
            fail("a size that cannot be right.");
        }
        for (label j = 0; j < nBlock; ++j)
        {
            number = binary ? get<int32_t>() : number;
            labelList groups;
            for (label tag = 0; tag < nTags; ++tag)
            {
                const label group = get<int32_t>();
                if (tag == 0 && group != 0)
                {
                    groups.append(group);
                }
            }
            addElement(dim, nNodes, number, groups);
        }
        i += nBlock;
    }
}


void Foam::mpm::mshReader::readElements4()
{
    const label nBlocks = count();
    for (int i = 0; i < 3; ++i)
    {
        get<int64_t>();
    }
    for (label block = 0; block < nBlocks; ++block)
    {
        get<int32_t>();
        const label entity = get<int32_t>();
        const label type = get<int32_t>();
        const label n = count();
        int dim;
        const int nNodes = nodesOfType(type, dim);
        const labelList groups(groupsOf_[dim].lookup(entity, labelList()));
        for (label i = 0; i < n; ++i)
        {
            const label number = tag();
            addElement(dim, nNodes, number, groups);
        }
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::mshReader::mshReader(const fileName& file, const dictionary& dict)
:
    file_(file),
    dict_(dict),
    is_(file, std::ios::binary),
    size_(0),
    version_(0),
    binary_(false)
{
    if (!is_)
    {
        fail("there is no such file.");
    }
    is_.seekg(0, std::ios::end);
    size_ = is_.tellg();
    is_.seekg(0);

    std::string word;
    while (is_ >> word)
    {
        section_ = word;
        if (word == "$MeshFormat")
        {
            readFormat();
        }
        else if (version_ == 0)
        {
            fail("it is no mesh of gmsh: it does not begin with $MeshFormat.");
        }
        else if (word == "$PhysicalNames")
        {
            readNames();
        }
        else if (word == "$Entities")
        {
            skipLine();
            readEntities();
        }
        else if (word == "$Nodes")
        {
            skipLine();
            version_ < 4 ? readNodes2() : readNodes4();
        }
        else if (word == "$Elements")
        {
            skipLine();
            version_ < 4 ? readElements2() : readElements4();
        }
        else if (word[0] == '$')
        {
            skipSection();
            section_.clear();
            continue;
        }
        else
        {
            fail("'" + word.substr(0, 20) + "' where a section must begin.");
        }
        is_ >> word;
        if (!is_ || word != "$End" + section_.substr(1))
        {
            fail("it does not end where it must.");
        }
        section_.clear();
    }
}

// ************************************************************************* //
