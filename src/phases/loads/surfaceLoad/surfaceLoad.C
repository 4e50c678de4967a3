// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "surfaceLoad.H"
#include "dictionaryTools.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::surfaceLoad::surfaceLoad(const dictionary& dict, const pointGrid& grid) :
    normal_(Zero), node_(grid.nNodes(), false)
{
    checkKeywords(
        dict, {"pressure", "pressureCoeffs", "traction", "tractionCoeffs", "normal", "min", "max"});
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
            FatalIOErrorInFunction(dict) << "normal only goes with traction: a pressure follows the"
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

    // min and max as typed may miss nodes by rounding: margin
    const vector low(dict.getOrDefault<vector>("min", -GREAT * vector::one));
    const vector high(dict.getOrDefault<vector>("max", GREAT * vector::one));
    const scalar margin = 1e-9 * grid.mesh().bounds().mag();
    const pointField x(grid.nodePositions());
    label n = 0;
    forAll(x, nodei)
    {
        bool in = true;
        for (int d = 0; d < grid.nDim(); ++d)
        {
            const int c = grid.direction(d);
            in = in && x[nodei][c] > low[c] - margin && x[nodei][c] < high[c] + margin;
        }
        node_[nodei] = in;
        n += in;
    }
    if (!returnReduce(n, sumOp<label>()))
    {
        FatalIOErrorInFunction(dict)
            << "No node of the mesh lies in the box from min " << low << " to max " << high
            << "; the mesh is in " << grid.mesh().bounds() << '.' << exit(FatalIOError);
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::surfaceLoad::addForce(
    const pointGridTransfer& passes, const materialPointCloud& cloud, const scalar time, scalar* f,
    const int stride) const
{
    const pointGrid& grid = cloud.grid();
    const int D = grid.nDim();
    const scalar p = pressure_ ? pressure_->value(time) : 0;
    const vector t(traction_ ? traction_->value(time) : Zero);
    passes.forNodesOf(
        cloud, node_,
        [&](const label, const label node, const scalar, const scalar* A)
        {
            scalar* fl = f + stride * node;
            scalar along = 0;
            for (int d = 0; d < D; ++d)
            {
                fl[d] -= p * A[d];
                along += A[d] * normal_[grid.direction(d)];
            }
            for (int d = 0; traction_ && d < D; ++d)
            {
                fl[d] += along * t[grid.direction(d)];
            }
        });
}
