/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"

#include "MooneyRivlin.H"
#include "dictionaryTools.H"
#include "laneMath.H"
#include "addToRunTimeSelectionTable.H"
#include <Eigen/Dense>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace mpm
{
    defineTypeNameAndDebug(MooneyRivlin, 0);
    addToRunTimeSelectionTable(constitutiveModel, MooneyRivlin, dictionary);
}
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- det(I + c) - 1 of a symmetric matrix c, without cancellation
template<class T>
MPM_INLINE T detMinus1
(
    const T xx,
    const T yy,
    const T zz,
    const T xy,
    const T xz,
    const T yz
)
{
    return
        xx + yy + zz
      + (xx*yy - xy*xy) + (xx*zz - xz*xz) + (yy*zz - yz*yz)
      + (xx*(yy*zz - yz*yz) - xy*(xy*zz - yz*xz) + xz*(xy*yz - yy*xz));
}

}

// * * * * * * * * * * * * * * Member Classes  * * * * * * * * * * * * * * * //

template<int DIM>
class Foam::mpm::MooneyRivlin::terms
{
    static constexpr int W = laneWidth<DIM>;
    static constexpr int N = DIM*DIM;
    typedef lanes<W> T;

    const MooneyRivlin& law_;

public:

    terms(const MooneyRivlin& law, const pointBlock&, const double)
    :
        law_(law)
    {}

    MPM_INLINE void stress
    (
        const pointBlock& b,
        const laneGroup<W>& g,
        const T (&c)[N],
        T& volumePart,
        T& factor,
        T (&a)[N],
        T (&side)[3]
    ) const
    {
        T full[9] = {}, cc[9] = {};
        for (int i = 0; i < DIM; ++i)
        {
            for (int j = 0; j < DIM; ++j)
            {
                full[3*i + j] = c[i*DIM + j];
                for (int k = 0; k < DIM; ++k)
                {
                    cc[3*i + j] += c[i*DIM + k]*c[k*DIM + j];
                }
            }
        }
        for (int i = DIM; i < 3; ++i)
        {
            full[4*i] = g.get(b.history[i]);
            cc[4*i] = full[4*i]*full[4*i];
        }
        const T tr = full[0] + full[4] + full[8];
        const T lnJ = 0.5*laneLog
        (
            1.0 + detMinus1
            (
                full[0], full[4], full[8], full[1], full[2], full[5]
            )
        );
        const T rJ = laneExp(-lnJ), r23 = laneExp(-2.0/3*lnJ);
        const T f1 = 2*law_.c10_*rJ*r23, f2 = 2*law_.c01_*rJ*r23*r23;
        const T linear = f1 + f2*(1.0 + tr);
        const T mean = (linear*tr - f2*(cc[0] + cc[4] + cc[8]))/3.0;

        volumePart = law_.K_*lnJ*rJ - mean;
        factor = broadcast<W>(1);
        for (int i = 0; i < DIM; ++i)
        {
            for (int j = 0; j < DIM; ++j)
            {
                a[i*DIM + j] = linear*full[3*i + j] - f2*cc[3*i + j];
            }
        }
        for (int i = DIM; i < 3; ++i)
        {
            side[i] = linear*full[4*i] - f2*cc[4*i];
        }
    }
};

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::MooneyRivlin::MooneyRivlin(const dictionary& dict)
:
    isotropicElastic<MooneyRivlin>
    (
        dict,
        positive(dict, "K")
      - 4.0/3*(positive(dict, "c10") + bounded(dict, "c01", 0, GREAT)),
        2*(positive(dict, "c10") + bounded(dict, "c01", 0, GREAT))
    ),
    c10_(positive(dict, "c10")),
    c01_(bounded(dict, "c01", 0, GREAT)),
    K_(positive(dict, "K"))
{
    checkKeywords(dict, {"type", "rho", "c10", "c01", "K"});
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::string Foam::mpm::MooneyRivlin::leftStretch
(
    const double (&sigma)[9],
    const scalar,
    double (&c)[9]
) const
{
    const std::string none("no stretch was found that carries it");
    typedef Eigen::Matrix3d matrix;
    typedef Eigen::Vector3d vector3;

    matrix s(Eigen::Map<const matrix>(sigma, 3, 3));
    if (!s.allFinite())
    {
        return none;
    }
    const Eigen::SelfAdjointEigenSolver<matrix> solver(s);
    const vector3 wanted(solver.eigenvalues());

    // Principal stresses of the principal logarithmic stretches
    const auto stressOf = [&](const vector3& h)
    {
        const double lnJ = h.sum(), rJ = std::exp(-lnJ);
        vector3 b, t;
        for (int i = 0; i < 3; ++i)
        {
            b(i) = std::exp(2*h(i) - 2.0/3*lnJ);
        }
        for (int i = 0; i < 3; ++i)
        {
            t(i) = 2*rJ*(c10_*b(i) + c01_*b(i)*(b.sum() - b(i)));
        }
        const double mean = t.mean();
        for (int i = 0; i < 3; ++i)
        {
            t(i) += K_*lnJ*rJ - mean;
        }
        return t;
    };

    vector3 h(vector3::Zero());
    const double size = wanted.norm() + 1e-3*mu();
    for (int iteration = 0; iteration < 60; ++iteration)
    {
        const vector3 residual(stressOf(h) - wanted);
        if (residual.norm() <= 1e-14*size)
        {
            break;
        }
        matrix slope;
        for (int i = 0; i < 3; ++i)
        {
            const double d = 1e-6;
            vector3 up(h), down(h);
            up(i) += d;
            down(i) -= d;
            slope.col(i) = (stressOf(up) - stressOf(down))/(2*d);
        }
        vector3 change(slope.partialPivLu().solve(-residual));
        const double largest = change.cwiseAbs().maxCoeff();
        h += change*(largest > 0.3 ? 0.3/largest : 1.0);
        if (!h.allFinite() || h.cwiseAbs().maxCoeff() > 5)
        {
            return none;
        }
    }
    if (!((stressOf(h) - wanted).norm() <= 1e-10*size))
    {
        return none;
    }
    vector3 stretch;
    for (int i = 0; i < 3; ++i)
    {
        stretch(i) = std::expm1(2*h(i));
    }
    Eigen::Map<matrix>(c, 3, 3) =
        solver.eigenvectors()*stretch.asDiagonal()
       *solver.eigenvectors().transpose();
    return std::string();
}


Foam::scalar Foam::mpm::MooneyRivlin::strainEnergy(const pointBlock& b) const
{
    scalar sum = 0;
    for (label p = 0; p < b.n; ++p)
    {
        double c[9] = {};
        for (int i = 0; i < 9; ++i)
        {
            const int r = i/3, k = i % 3;
            const bool stored = r == k || (r < b.nDim && k < b.nDim);
            c[i] = stored ? b.history[symmSlot(r, k)][p] : 0;
        }
        const double tr = c[0] + c[4] + c[8];
        double cc = 0;
        for (const double x : c)
        {
            cc += x*x;
        }
        const double lnJ = 0.5*std::log1p
        (
            detMinus1<double>(c[0], c[4], c[8], c[1], c[2], c[5])
        );
        // I1 - 3 = tr, I2 - 3 = 2 tr + (tr^2 - c:c)/2
        const double m = std::expm1(-2.0/3*lnJ), m2 = std::expm1(-4.0/3*lnJ);
        const double I1 = 3*m + (1 + m)*tr;
        const double I2 = 3*m2 + (1 + m2)*(2*tr + 0.5*(tr*tr - cc));
        sum +=
            b.mass[p]/rho()
           *(c10_*I1 + c01_*I2 + 0.5*K_*sqr(lnJ));
    }
    return sum;
}

// ************************************************************************* //
