/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::functionObjects::materialPointVTK

Description
    Files for ParaView: the points of each phase with columns that are chosen
    (.vtp), and the mesh with the fields of the time folder (.vtu), in double
    precision. On several processors each writes its piece.

    Written are the start and, without writeControl, the times that the run
    writes. With it, points follow it, and the mesh comes at those of its times
    that the run writes, since fields are taken from the files: those of cells
    and of mesh points, as foamToVTK takes them, without what restarts alone
    need. The mesh is written with each time, so that it may change. A name of
    fields that the first written time does not have ends the run there.

    A restart drops the times after its start from the series; -postProcess
    replaces those that it writes.

Usage
    \verbatim
    paraView
    {
        type            materialPointVTK;
        libs            (mpmFunctionObjects);
        columns         (U sigma damage);
        fields          (p "alpha.*");
    }
    \endverbatim

    \table
        Property | Description                          | Required | Default
        type     | materialPointVTK                     | yes      |
        phases   | names of phases                      | no       | all
        columns  | quantities, see pointQuantity.H      | no       | U m sigma, damage, T
                 | (those that a phase has)             |          |
        fields   | names, expressions; (): no mesh      | no       | all
    \endtable

    Files in postProcessing/<name>: points.<phase>.pvd, mesh.pvd, and folders
    points.<phase> and mesh with the files of the times. Points have their id
    and are vertices, so that ParaView shows them without a filter. Symmetric
    tensors are in VTK's order, xx yy zz xy yz xz.

\*---------------------------------------------------------------------------*/

#include "materialPointOutput.H"
#include "foamVtuCells.H"
#include "IOobjectList.H"
#include "localIOdictionary.H"
#include "pointFields.H"
#include "pointQuantity.H"
#include "volFields.H"
#include "vtkFile.H"
#include "wordRes.H"
#include <algorithm>

namespace Foam::functionObjects
{

namespace
{

//- Component of OpenFOAM at place i of VTK
int vtkComponent(const int size, const int i)
{
    static const int symmetric[] = {0, 3, 5, 1, 4, 2};
    return size == 6 ? symmetric[i] : i;
}

//- Name of the class of a field's file
template<class Type>
const word& classOf(const bool onCells)
{
    return onCells ? GeometricField<Type, fvPatchField, volMesh>::typeName
                   : GeometricField<Type, pointPatchField, pointMesh>::typeName;
}

//- Declare n values of a file, read when they are written
template<class Type>
void declareField(mpm::vtkFile& file, const IOobject& io, const label n)
{
    const int size = pTraits<Type>::nComponents;
    const word type(io.headerClassName());
    const IOobject source(
        io.name(), io.instance(), io.local(), io.db(), IOobject::MUST_READ, IOobject::NO_WRITE,
        false);
    file.array<double>(
        io.name(), size, n,
        [=](std::ostream& os)
        {
            const localIOdictionary dict(source, type);
            const Field<Type> values("internalField", dict, n);
            mpm::vtkFile::stream<double>(
                os, size, n,
                [&](const label i, double* v)
                {
                    for (int c = 0; c < size; ++c)
                    {
                        v[c] = component(values[i], vtkComponent(size, c));
                    }
                });
        });
}

//- Files of fields of these types, on cells or on mesh points
template<class... Types>
struct filesOf
{
    static bool has(const IOobject& io, const bool onCells)
    {
        return (... || (io.headerClassName() == classOf<Types>(onCells)));
    }

    static void declare(mpm::vtkFile& file, const IOobject& io, const bool onCells, const label n)
    {
        const auto one = [&](auto zero)
        {
            typedef decltype(zero) Type;
            if (io.headerClassName() == classOf<Type>(onCells))
            {
                declareField<Type>(file, io, n);
            }
        };
        (one(Types(Zero)), ...);
    }
};

typedef filesOf<scalar, vector, sphericalTensor, symmTensor, tensor> fieldFiles;

}

class materialPointVTK : public materialPointOutput
{
    wordList phases_;

    //- Of each phase
    List<wordList> columns_;
    PtrList<mpm::startState> start_;

    wordList keywords() const override { return {"phase", "phases", "columns", "fields"}; }

    //- A phase has a quantity, or that of a component
    static bool has(const mpm::materialPointPhase& material, const word& name)
    {
        const wordList all(mpm::pointQuantity::names(material));
        return all.found(name) || all.found(name.substr(0, name.rfind('_')));
    }

    void prepare(const mpm::materialPointSystem& points) override
    {
        phases_ = selectedPhases(points);
        columns_.setSize(phases_.size());
        start_.clear();
        start_.setSize(phases_.size());
        forAll(phases_, i)
        {
            const mpm::materialPointPhase& material = phase(points, phases_[i]);
            const wordList all(mpm::pointQuantity::names(material));
            columns_[i] = wordList({"U", "m", "sigma", "damage", "T"});
            inplaceSubsetList(columns_[i], [&](const word& name) { return all.found(name); });
            if (dict_.readIfPresent("columns", columns_[i]))
            {
                // What another phase has and this one has not is left out
                inplaceSubsetList(
                    columns_[i],
                    [&](const word& name)
                    {
                        return has(material, name)
                            || std::none_of(
                                   phases_.begin(), phases_.end(),
                                   [&](const word& other)
                                   { return has(phase(points, other), name); });
                    });
            }
            start_.set(i, startOf(material, columns_[i]).ptr());
        }
    }

    //- The points of each phase
    void sample(const mpm::materialPointSystem& points) override
    {
        forAll(phases_, i)
        {
            writePoints(
                phase(points, phases_[i]), columns_[i], start_.set(i) ? &start_[i] : nullptr);
        }
    }

    //- A file and its entry in the series
    void save(mpm::vtkFile& file, const word& name) const
    {
        const fileName folder(baseFileDir() / prefix_);
        const fileName written(file.write(folder, name / mesh_.time().timeName()));
        if (Pstream::master())
        {
            mpm::addToSeries(
                folder / name + ".pvd", mesh_.time(), written, functionObject::postProcess);
        }
    }

    void writePoints(
        const mpm::materialPointPhase& material, const wordList& columns,
        const mpm::startState* start) const;

    //- The mesh with the fields of the time folder
    void writeMesh(const bool starts) const;

public:
    TypeName("materialPointVTK");

    using materialPointOutput::materialPointOutput;

    bool read(const dictionary& dict) override;
    bool write() override { return write(false); }

    //- starts: the state of the start, before the first step
    bool write(const bool starts);
};

void materialPointVTK::writePoints(
    const mpm::materialPointPhase& material, const wordList& columns,
    const mpm::startState* start) const
{
    const mpm::materialPointCloud& cloud = material.cloud();
    const label n = cloud.size();
    const std::string count('"' + std::to_string(n) + '"');
    mpm::vtkFile file("PolyData", "NumberOfPoints=" + count + " NumberOfVerts=" + count);

    file.section("PointData");
    file.array<label>(
        "id", 1, n,
        [&](std::ostream& os)
        {
            mpm::vtkFile::stream<label>(
                os, 1, n, [&](const label p, label* v) { *v = label(cloud.id()[0][p]); });
        });
    for (const word& name : columns)
    {
        const mpm::pointQuantity q(dict_, material, name, start);
        file.array<double>(
            name, q.size(), n,
            [=](std::ostream& os)
            {
                const int size = q.size();
                scalar values[mpm::pointQuantity::maxSize] = {};
                mpm::vtkFile::stream<double>(
                    os, size, n,
                    [&](const label p, double* v)
                    {
                        q.get(p, values);
                        for (int c = 0; c < size; ++c)
                        {
                            v[c] = values[vtkComponent(size, c)];
                        }
                    });
            });
    }

    file.section("Points");
    file.array<double>(
        "Points", 3, n,
        [&](std::ostream& os)
        {
            label k = 0;
            mpm::vtkFile::stream<double>(
                os, 3, n,
                [&](const label p, double* v)
                {
                    while (p >= cloud.start()[k + 1])
                    {
                        ++k;
                    }
                    const point x(cloud.position(p, cloud.cells()[k]));
                    std::copy(x.begin(), x.end(), v);
                });
        });

    // A vertex of each point
    file.section("Verts");
    for (const label first : {0, 1})
    {
        file.array<label>(
            first ? "offsets" : "connectivity", 1, n,
            [=](std::ostream& os) {
                mpm::vtkFile::stream<label>(
                    os, 1, n, [&](const label p, label* v) { *v = p + first; });
            });
    }
    save(file, "points." + material.name());
}

void materialPointVTK::writeMesh(const bool starts) const
{
    wordRes fields(1, wordRe(".*", wordRe::REGEX));
    dict_.readIfPresent("fields", fields);
    if (fields.empty())
    {
        return;
    }

    const IOobjectList objects(mesh_, mesh_.time().timeName());
    wordList names(objects.sortedNames());
    inplaceSubsetList(
        names,
        [&](const word& name)
        {
            const IOobject& io = *objects[name];
            return fieldFiles::has(io, true) || fieldFiles::has(io, false);
        });
    Pstream::scatter(names);
    for (const wordRe& field : fields)
    {
        const auto matches = [&](const word& name) { return field.match(name); };
        if (!starts && dict_.found("fields") && std::none_of(names.begin(), names.end(), matches))
        {
            FatalIOErrorInFunction(dict_)
                << "No field " << field << " in the time folder " << mesh_.time().timeName() << nl
                << nl << "Valid fields are: " << flatOutput(names) << nl << exit(FatalIOError);
        }
    }
    inplaceSubsetList(names, [&](const word& name) { return fields.match(name); });

    const vtk::vtuCells cells(mesh_);
    mpm::vtkFile file(
        "UnstructuredGrid",
        "NumberOfPoints=\"" + std::to_string(mesh_.nPoints()) + "\" NumberOfCells=\""
            + std::to_string(mesh_.nCells()) + '"');
    for (const bool onCells : {true, false})
    {
        file.section(onCells ? "CellData" : "PointData");
        for (const word& name : names)
        {
            fieldFiles::declare(
                file, *objects[name], onCells, onCells ? mesh_.nCells() : mesh_.nPoints());
        }
    }
    file.section("Points");
    file.array<scalar>(
        "Points", 3, mesh_.nPoints(),
        [&](std::ostream& os)
        {
            os.write(
                reinterpret_cast<const char*>(mesh_.points().cdata()),
                mesh_.nPoints() * sizeof(point));
        });
    file.section("Cells");
    file.list<label>("connectivity", cells.vertLabels());
    file.list<label>("offsets", cells.vertOffsets());
    file.list<uint8_t>("types", cells.cellTypes());
    if (cells.faceLabels().size())
    {
        file.list<label>("faces", cells.faceLabels());
        file.list<label>("faceoffsets", cells.faceOffsets());
    }
    save(file, "mesh");
}

bool materialPointVTK::read(const dictionary& dict)
{
    materialPointOutput::read(dict);

    // With -postProcess they come later
    const bool points = findPoints() || functionObject::postProcess;
    if (!points && (dict.found("phases") || dict.found("phase") || dict.found("columns")))
    {
        FatalIOErrorInFunction(dict)
            << "There are no material points: leave out phases and columns." << exit(FatalIOError);
    }

    // Not where controlDict is read again
    const bool starts =
        !functionObject::postProcess && mesh_.time().timeIndex() == mesh_.time().startTimeIndex();
    return starts ? write(true) : true;
}

bool materialPointVTK::write(const bool starts)
{
    const bool written = starts || functionObject::postProcess || mesh_.time().writeTime();
    const bool given = dict_.found("writeControl") || dict_.found("outputControl");
    if (!sampled_ || !(written || given))
    {
        return true;
    }
    if (findPoints())
    {
        sample(system());
    }
    if (written)
    {
        writeMesh(starts);
    }
    return true;
}

defineTypeNameAndDebug(materialPointVTK, 0);
addTemplateToRunTimeSelectionTable(functionObject, whenMade, materialPointVTK, dictionary);

} // End namespace Foam::functionObjects
