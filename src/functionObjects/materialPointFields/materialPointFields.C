/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "materialPointFields.H"
#include "addToRunTimeSelectionTable.H"
#include "FlatOutput.H"
#include "pointFields.H"
#include "pointMesh.H"
#include "pointQuantity.H"
#include "dictionaryTools.H"
#include <cctype>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(materialPointFields, 0);
    addToRunTimeSelectionTable
    (
        functionObject,
        materialPointFields,
        dictionary
    );
}
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Dimensions of a unit of mpm::pointQuantity; none for an unknown one
dimensionSet dimensionsOf(const std::string& unit)
{
    return
        unit == "[m/s]" ? dimVelocity
      : unit == "[m]" ? dimLength
      : unit == "[Pa]" ? dimPressure
      : unit == "[m3]" ? dimVolume
      : unit == "[kg]" ? dimMass
      : unit == "[kg/m3]" ? dimDensity
      : dimless;
}


//- Call f(point, node, S_l(x_p)) for all points and the nodes they reach
template<class Function>
void forWeights
(
    const mpm::pointGridTransfer& passes,
    const mpm::materialPointCloud& cloud,
    const Function& f
)
{
    DynamicList<label> nodes;
    DynamicList<scalar> S, gradS;

    forAll(cloud.cells(), k)
    {
        for (label p = cloud.start()[k]; p < cloud.start()[k + 1]; ++p)
        {
            scalar x[3], l[3];
            for (int d = 0; d < cloud.grid().nDim(); ++d)
            {
                x[d] = cloud.x()[d][p];
                l[d] = cloud.halfSize() ? (*cloud.halfSize())[d][p] : 0;
            }
            passes.weights(cloud.cells()[k], x, l, nodes, S, gradS);
            forAll(nodes, i)
            {
                if (nodes[i] >= 0 && S[i] != 0)
                {
                    f(p, nodes[i], S[i]);
                }
            }
        }
    }
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::wordList Foam::functionObjects::materialPointFields::keywords() const
{
    return {"phase", "phases", "fields"};
}


void Foam::functionObjects::materialPointFields::prepare
(
    const mpm::materialPointSystem& points
)
{
    phases_ = selectedPhases(points);
    fields_ = mpm::required<wordList>(dict_, "fields");
    if (fields_.empty())
    {
        FatalIOErrorInFunction(dict_)
            << "The list of fields is empty." << nl << nl
            << "Valid fields are: alpha "
            << flatOutput
               (
                   mpm::pointQuantity::names(phase(points, phases_[0]))
               ) << nl
            << exit(FatalIOError);
    }

    start_.clear();
    start_.setSize(phases_.size());
    forAll(phases_, i)
    {
        const mpm::materialPointPhase& material = phase(points, phases_[i]);
        bool needsStart = false;
        for (const word& field : fields_)
        {
            if (field != "alpha")
            {
                // Unknown names end here
                mpm::pointQuantity(dict_, material, field, nullptr);
                needsStart =
                    needsStart || mpm::pointQuantity::needsStart(field);
            }
        }
        if (needsStart)
        {
            start_.set(i, new mpm::startState(dict_, material));
            start_[i].share(boolList(start_[i].id().size(), true));
        }
    }
}


template<class Type>
void Foam::functionObjects::materialPointFields::writeField
(
    const mpm::pointGrid& grid,
    const word& name,
    const dimensionSet& dimensions,
    const UList<scalar>& values
) const
{
    GeometricField<Type, pointPatchField, pointMesh> field
    (
        IOobject
        (
            name,
            mesh_.time().timeName(),
            mesh_,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        pointMesh::New(mesh_),
        dimensioned<Type>(dimensions, Zero)
    );
    const int n = pTraits<Type>::nComponents;
    forAll(field, pointi)
    {
        const label at = n*grid.pointToNode()[pointi];
        for (direction c = 0; c < n; ++c)
        {
            setComponent(field[pointi], c) = values[at + c];
        }
    }
    field.write();
}


void Foam::functionObjects::materialPointFields::writeQuantity
(
    const mpm::materialPointSystem& points,
    const label phasei,
    const word& field
)
{
    const mpm::materialPointPhase& material = phase(points, phases_[phasei]);
    const mpm::materialPointCloud& cloud = material.cloud();
    const mpm::pointGrid& grid = points.grid();
    const mpm::sharedNodes& shared = grid.shared(points.gridTransfer().reach());

    word name(field);
    name[0] = char(std::toupper(name[0]));
    name = IOobject::groupName("point" + name, material.name());

    if (field == "alpha")
    {
        scalarField V(grid.nNodes(), Zero);
        forWeights
        (
            points.gridTransfer(),
            cloud,
            [&](const label p, const label n, const scalar S)
            {
                V[n] += cloud.volume()[0][p]*S;
            }
        );
        shared.sum(V.data(), 1, 1);
        const scalarList all
        (
            points.gridTransfer().nodeVolumes(grid, true)
        );
        forAll(V, n)
        {
            V[n] = all[n] > 0 ? V[n]/all[n] : 0;
        }
        writeField<scalar>(grid, name, dimless, V);
        return;
    }

    const mpm::pointQuantity q
    (
        dict_,
        material,
        field,
        start_.set(phasei) ? &start_[phasei] : nullptr
    );
    const mpm::column& weight =
        field.substr(0, field.find('_')) == "U" ? cloud.mass() : cloud.volume();

    const int size = q.size();
    scalarField sum(size*grid.nNodes(), Zero), sumW(grid.nNodes(), Zero);
    scalar v[mpm::pointQuantity::maxSize];
    label last = -1;
    forWeights
    (
        points.gridTransfer(),
        cloud,
        [&](const label p, const label n, const scalar S)
        {
            if (p != last)
            {
                q.get(p, v);
                last = p;
            }
            const scalar w = weight[0][p]*S;
            sumW[n] += w;
            for (int c = 0; c < size; ++c)
            {
                sum[size*n + c] += w*v[c];
            }
        }
    );
    shared.sum(sum.data(), size, size);
    shared.sum(sumW.data(), 1, 1);
    forAll(sumW, n)
    {
        // Weights are never negative: they are 0 only without points
        for (int c = 0; c < size; ++c)
        {
            sum[size*n + c] = sumW[n] > 0 ? sum[size*n + c]/sumW[n] : 0;
        }
    }

    const dimensionSet dimensions(dimensionsOf(q.unit()));
    switch (size)
    {
        case 1: writeField<scalar>(grid, name, dimensions, sum); break;
        case 3: writeField<vector>(grid, name, dimensions, sum); break;
        case 6: writeField<symmTensor>(grid, name, dimensions, sum); break;
        default: writeField<tensor>(grid, name, dimensions, sum);
    }
}


void Foam::functionObjects::materialPointFields::sample
(
    const mpm::materialPointSystem& points
)
{
    if (!functionObject::postProcess && !mesh_.time().writeTime())
    {
        return;
    }
    forAll(phases_, phasei)
    {
        for (const word& field : fields_)
        {
            writeQuantity(points, phasei, field);
        }
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::materialPointFields::materialPointFields
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    materialPointOutput(name, runTime, dict)
{
    read(dict);
}

// ************************************************************************* //
