/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::functionObjects::materialPointFields

Description
    Fields on the mesh's points for smooth pictures, made of the points of each
    phase with the shape functions S_l of the run:

        f_l     = sum_p w_p S_l(x_p) f_p / sum_p w_p S_l(x_p)
        alpha_l = sum_p V_p S_l(x_p) / V_l                                [-]

    with the volume V_p as weight w_p, for the velocity U the mass m_p, and V_l
    the node's share of the cells around it, sum_c V_c/2^D. Mesh points that no
    material point reaches have 0. Towards a free surface alpha goes to 0 over
    the width of S_l; inside a compact material it is 1, for B-splines beside
    the sides of the mesh only about 1.

    Fields are computed and written only at write times, beside the others, as
    point<Field>.<phase>: pointAlpha.target, pointSigma.target, ...; foamToVTK
    and ParaView show them as point data. Nothing reads them again.

Usage
    \verbatim
    pictures
    {
        type            materialPointFields;
        libs            (mpmFunctionObjects);
        fields          (alpha sigma U sigmaEq);
        phases          (target flyer);
    }
    \endverbatim

    \table
        Property | Description                              | Required | Default
        type     | materialPointFields                      | yes      |
        fields   | alpha, and those of mpm::pointQuantity   | yes      |
        phases   | names of phases                          | no       | all
    \endtable

\*---------------------------------------------------------------------------*/

#include "materialPointOutput.H"
#include "FlatOutput.H"
#include "pointFields.H"
#include "pointMesh.H"
#include "pointQuantity.H"
#include <cctype>

namespace Foam::functionObjects
{

namespace
{

//- Dimensions of a unit of mpm::pointQuantity; none for an unknown one
dimensionSet dimensionsOf(const std::string& unit)
{
    return unit == "[m/s]"  ? dimVelocity
        : unit == "[m]"     ? dimLength
        : unit == "[Pa]"    ? dimPressure
        : unit == "[m3]"    ? dimVolume
        : unit == "[kg]"    ? dimMass
        : unit == "[kg/m3]" ? dimDensity
                            : dimless;
}

//- Call f(point, node, S_l(x_p)) for all points and the nodes they reach
template<class Function>
void forWeights(
    const mpm::pointGridTransfer& passes, const mpm::materialPointCloud& cloud, const Function& f)
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

class materialPointFields : public materialPointOutput
{
    wordList fields_;
    wordList phases_;

    //- Start of each phase: only if something refers to it
    PtrList<mpm::startState> start_;

    wordList keywords() const override { return {"phase", "phases", "fields"}; }

    void prepare(const mpm::materialPointSystem& points) override
    {
        phases_ = selectedPhases(points);
        fields_ = mpm::required<wordList>(dict_, "fields");
        if (fields_.empty())
        {
            FatalIOErrorInFunction(dict_)
                << "The list of fields is empty." << nl << nl << "Valid fields are: alpha "
                << flatOutput(mpm::pointQuantity::names(phase(points, phases_[0]))) << nl
                << exit(FatalIOError);
        }

        start_.clear();
        start_.setSize(phases_.size());
        forAll(phases_, i)
        {
            const mpm::materialPointPhase& material = phase(points, phases_[i]);
            wordList quantities(fields_);
            inplaceSubsetList(quantities, [](const word& field) { return field != "alpha"; });
            start_.set(i, startOf(material, quantities).ptr());
        }
    }

    void sample(const mpm::materialPointSystem& points) override
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

    //- Write a field of a phase
    void
    writeQuantity(const mpm::materialPointSystem& points, const label phasei, const word& field)
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
            forWeights(
                points.gridTransfer(), cloud,
                [&](const label p, const label n, const scalar S)
                { V[n] += cloud.volume()[0][p] * S; });
            shared.sum(V.data(), 1, 1);
            const scalarList all(points.gridTransfer().nodeVolumes(grid, true));
            forAll(V, n)
            {
                V[n] = all[n] > 0 ? V[n] / all[n] : 0;
            }
            writeField<scalar>(grid, name, dimless, V);
            return;
        }

        const mpm::pointQuantity q(
            dict_, material, field, start_.set(phasei) ? &start_[phasei] : nullptr);
        const mpm::column& weight =
            field.substr(0, field.find('_')) == "U" ? cloud.mass() : cloud.volume();

        const int size = q.size();
        scalarField sum(size * grid.nNodes(), Zero), sumW(grid.nNodes(), Zero);
        scalar v[mpm::pointQuantity::maxSize];
        label last = -1;
        forWeights(
            points.gridTransfer(), cloud,
            [&](const label p, const label n, const scalar S)
            {
                if (p != last)
                {
                    q.get(p, v);
                    last = p;
                }
                const scalar w = weight[0][p] * S;
                sumW[n] += w;
                for (int c = 0; c < size; ++c)
                {
                    sum[size * n + c] += w * v[c];
                }
            });
        shared.sum(sum.data(), size, size);
        shared.sum(sumW.data(), 1, 1);
        forAll(sumW, n)
        {
            // Weights are never negative: they are 0 only without points
            for (int c = 0; c < size; ++c)
            {
                sum[size * n + c] = sumW[n] > 0 ? sum[size * n + c] / sumW[n] : 0;
            }
        }

        const dimensionSet dimensions(dimensionsOf(q.unit()));
        switch (size)
        {
        case 1:
            writeField<scalar>(grid, name, dimensions, sum);
            break;
        case 3:
            writeField<vector>(grid, name, dimensions, sum);
            break;
        case 6:
            writeField<symmTensor>(grid, name, dimensions, sum);
            break;
        default:
            writeField<tensor>(grid, name, dimensions, sum);
        }
    }

    //- Write values, one row of components per node
    template<class Type>
    void writeField(
        const mpm::pointGrid& grid, const word& name, const dimensionSet& dimensions,
        const UList<scalar>& values) const;

public:
    TypeName("materialPointFields");

    using materialPointOutput::materialPointOutput;
};

template<class Type>
void materialPointFields::writeField(
    const mpm::pointGrid& grid, const word& name, const dimensionSet& dimensions,
    const UList<scalar>& values) const
{
    GeometricField<Type, pointPatchField, pointMesh> field(
        IOobject(
            name, mesh_.time().timeName(), mesh_, IOobject::NO_READ, IOobject::NO_WRITE, false),
        pointMesh::New(mesh_), dimensioned<Type>(dimensions, Zero));
    const int n = pTraits<Type>::nComponents;
    forAll(field, pointi)
    {
        const label at = n * grid.pointToNode()[pointi];
        for (direction c = 0; c < n; ++c)
        {
            setComponent(field[pointi], c) = values[at + c];
        }
    }
    field.write();
}

defineTypeNameAndDebug(materialPointFields, 0);
addTemplateToRunTimeSelectionTable(functionObject, whenMade, materialPointFields, dictionary);

} // End namespace Foam::functionObjects
