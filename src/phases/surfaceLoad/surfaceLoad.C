/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "surfaceLoad.H"
#include "selector.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::surfaceLoad::surfaceLoad
(
    const dictionary& dict,
    const hexGrid& grid
)
:
    normal_(Zero),
    node_(grid.nNodes(), false)
{
    checkKeywords
    (
        dict,
        {
            "pressure", "pressureCoeffs", "traction", "tractionCoeffs",
            "normal", "min", "max"
        }
    );
    if (dict.found("pressure") == dict.found("traction"))
    {
        FatalIOErrorInFunction(dict)
            << "A surface load has either pressure [Pa] or traction (a vector"
            << " [Pa])." << exit(FatalIOError);
    }
    if (dict.found("pressure"))
    {
        pressure_ = Function1<scalar>::New("pressure", dict);
        if (dict.found("normal"))
        {
            FatalIOErrorInFunction(dict)
                << "normal only goes with traction: a pressure follows the"
                << " surface." << exit(FatalIOError);
        }
    }
    else
    {
        traction_ = Function1<vector>::New("traction", dict);
        normal_ = required<vector>(dict, "normal");
        if (!(mag(normal_) > 0))
        {
            FatalIOErrorInFunction(dict)
                << "normal " << normal_ << " has no direction: it is the"
                << " outward normal of the loaded side." << exit(FatalIOError);
        }
        normal_ /= mag(normal_);
    }

    // Where corners are typed as nodes are computed
    const vector low(dict.getOrDefault<vector>("min", -GREAT*vector::one));
    const vector high(dict.getOrDefault<vector>("max", GREAT*vector::one));
    const scalar margin = 1e-9*grid.mesh().bounds().mag();
    const pointField x(grid.nodePositions());
    label n = 0;
    forAll(x, nodei)
    {
        bool in = true;
        for (int d = 0; d < grid.nDim(); ++d)
        {
            const int c = grid.direction(d);
            in = in
             && x[nodei][c] > low[c] - margin && x[nodei][c] < high[c] + margin;
        }
        node_[nodei] = in;
        n += in;
    }
    if (!returnReduce(n, sumOp<label>()))
    {
        FatalIOErrorInFunction(dict)
            << "No node of the mesh lies in the box from min " << low
            << " to max " << high << "; the mesh is in "
            << grid.mesh().bounds() << '.' << exit(FatalIOError);
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::surfaceLoad::addForce
(
    const pointPasses& passes,
    const materialPointCloud& cloud,
    const scalar time,
    scalar* f,
    const int stride
) const
{
    const hexGrid& grid = cloud.grid();
    const int D = grid.nDim();
    const scalar p = pressure_ ? pressure_->value(time) : 0;
    const vector t(traction_ ? traction_->value(time) : Zero);
    const column* half = cloud.halfSize();
    DynamicList<label> nodes;
    DynamicList<scalar> S, gradS;
    passes.forStencils
    (
        cloud,
        [&](const label k, const label* stencil)
        {
            bool near = false;
            for (label i = 0; i < passes.nStencil(); ++i)
            {
                near = near || (stencil[i] >= 0 && node_[stencil[i]]);
            }
            for
            (
                label q = cloud.start()[k];
                near && q < cloud.start()[k + 1];
                ++q
            )
            {
                scalar x[3], l[3] = {0, 0, 0};
                for (int d = 0; d < D; ++d)
                {
                    x[d] = cloud.x()[d][q];
                    l[d] = half ? (*half)[d][q] : 0;
                }
                passes.weights
                (
                    cloud.cells()[k],
                    x,
                    half ? l : nullptr,
                    nodes,
                    S,
                    gradS
                );
                const scalar v = cloud.volume()[0][q];
                forAll(nodes, i)
                {
                    if (nodes[i] < 0 || !node_[nodes[i]])
                    {
                        continue;
                    }
                    scalar* fl = f + stride*nodes[i];
                    scalar along = 0;
                    for (int d = 0; d < D; ++d)
                    {
                        scalar A = v*gradS[D*i + d];
                        if (d == grid.radial())
                        {
                            A += v*S[i]/x[d];
                        }
                        fl[d] -= p*A;
                        along += A*normal_[grid.direction(d)];
                    }
                    for (int d = 0; traction_ && d < D; ++d)
                    {
                        fl[d] += along*t[grid.direction(d)];
                    }
                }
            }
        }
    );
}

// ************************************************************************* //
