/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

// The compiler's own AVX-512 headers start a register from itself
// (_mm256_undefined_pd), which it then reports in code that Eigen inlines
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"

#include "MohrCoulomb.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"
#include <Eigen/Eigenvalues>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(MohrCoulomb, 0);
    addToRunTimeSelectionTable(constitutiveModel, MohrCoulomb, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::MohrCoulomb::MohrCoulomb(const dictionary& dict)
:
    frictionalLaw<MohrCoulomb>(dict, wordList()),
    sinPhi_(std::sin(phi_)),
    sinPsi_(std::sin(psi_)),
    cCosPhi_(c_*std::cos(phi_))
{}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::mpm::MohrCoulomb::principalReturn(double (&s)[3]) const
{
    // Trial stresses in descending order
    const double t1 = s[2], t2 = s[1], t3 = s[0];
    const auto yield = [&](const double high, const double low)
    {
        return (high - low) + (high + low)*sinPhi_ - 2*cCosPhi_;
    };
    const double f = yield(t1, t3);
    bool changed = f > 0;
    if (changed)
    {
        // Stress that a unit of flow (1 + psi, 0, -1 + psi) takes away
        const double high = 2*G_*(1 + sinPsi_/3) + 2*K_*sinPsi_;
        const double middle = (2*K_ - 4.0/3*G_)*sinPsi_;
        const double low = -2*G_*(1 - sinPsi_/3) + 2*K_*sinPsi_;
        const double both = sinPhi_*sinPsi_;
        const double a = 4*G_*(1 + both/3) + 4*K_*both;

        const double g = f/a;
        double s1 = t1 - high*g, s2 = t2 - middle*g, s3 = t3 - low*g;
        const double slack = 1e-13*(mag(t1) + mag(t3));
        if (s1 < s2 - slack || s2 < s3 - slack)
        {
            // The edge that is nearer: two planes at once
            const bool right =
                (1 - sinPsi_)*t1 - 2*t2 + (1 + sinPsi_)*t3 > 0;
            const double fB = right ? yield(t1, t2) : yield(t2, t3);
            const double sum = right ? sinPhi_ + sinPsi_ : -sinPhi_ - sinPsi_;
            const double b = 2*G_*(1 + sum - both/3) + 4*K_*both;
            const double gA = (a*f - b*fB)/(a*a - b*b);
            const double gB = (a*fB - b*f)/(a*a - b*b);
            if (right)
            {
                s1 = t1 - high*(gA + gB);
                s2 = t2 - middle*gA - low*gB;
                s3 = t3 - low*gA - middle*gB;
            }
            else
            {
                s1 = t1 - high*gA - middle*gB;
                s2 = t2 - middle*gA - high*gB;
                s3 = t3 - low*(gA + gB);
            }
            if (sinPhi_ > 0 && (s1 < s2 - slack || s2 < s3 - slack))
            {
                s1 = s2 = s3 = cCosPhi_/sinPhi_;
            }
        }
        s[2] = s1;
        s[1] = s2;
        s[0] = s3;
    }
    for (double& x : s)
    {
        if (x > tension_)
        {
            x = tension_;
            changed = true;
        }
    }
    return changed;
}


double
Foam::mpm::MohrCoulomb::pointFlow(double (&X)[9], double& theta) const
{
    typedef Eigen::Matrix3d matrix;
    Eigen::Map<matrix> x(X);
    const Eigen::SelfAdjointEigenSolver<matrix> solver(x);
    const Eigen::Vector3d h(solver.eigenvalues());

    double s[3];
    for (int i = 0; i < 3; ++i)
    {
        s[i] = 2*G_*h(i) + K_*theta;
    }
    if (!principalReturn(s))
    {
        return 0;
    }
    const double mean = (s[0] + s[1] + s[2])/3;
    Eigen::Vector3d left;
    double flow = 0;
    for (int i = 0; i < 3; ++i)
    {
        left(i) = (s[i] - mean)/(2*G_);
        flow += sqr(h(i) - left(i));
    }
    theta = mean/K_;
    const matrix result
    (
        solver.eigenvectors()*left.asDiagonal()
       *solver.eigenvectors().transpose()
    );
    x = result;
    return std::sqrt(2.0/3*flow);
}

// ************************************************************************* //
