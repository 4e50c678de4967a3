// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

// The compiler's own AVX-512 headers start a register from itself
// (_mm256_undefined_pd), which it then reports in code that Eigen inlines
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"

#include "principalAxes.H"
#include <Eigen/Eigenvalues>
#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

namespace Foam::mpm
{

template<>
principalAxes<1>::principalAxes(const double* A, const bool) : value{A[0]}, direction{{1}}
{
}

// One rotation of Jacobi: the smaller angle, without cancellation
template<>
principalAxes<2>::principalAxes(const double* A, const bool)
{
    const double half = 0.5 * (A[3] - A[0]), off = A[1];
    const double r = std::hypot(half, off);
    const double t = r > 0 ? off / (std::abs(half) + r) : 0;
    const double c = 1 / std::sqrt(1 + t * t), s = t * c;

    const bool first = half < 0;
    value[0] = (first ? A[3] : A[0]) - t * off;
    value[1] = (first ? A[0] : A[3]) + t * off;
    direction[1][0] = direction[0][1] = first ? c : s;
    direction[1][1] = first ? s : c;
    direction[0][0] = -direction[1][1];
}

template<>
principalAxes<3>::principalAxes(const double* A, const bool directions)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
        Eigen::Map<const Eigen::Matrix3d>(A),
        directions ? Eigen::ComputeEigenvectors : Eigen::EigenvaluesOnly);
    for (int k = 0; k < 3; ++k)
    {
        value[k] = solver.eigenvalues()(k);
        for (int i = 0; directions && i < 3; ++i)
        {
            direction[k][i] = solver.eigenvectors()(i, k);
        }
    }
}

}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int N>
void Foam::mpm::principalAxes<N>::compose(const double* f, double* R) const
{
    for (int i = 0; i < N; ++i)
    {
        for (int j = 0; j < N; ++j)
        {
            double sum = f[0] * direction[0][i] * direction[0][j];
            for (int k = 1; k < N; ++k)
            {
                sum += f[k] * direction[k][i] * direction[k][j];
            }
            R[N * i + j] = sum;
        }
    }
}

template struct Foam::mpm::principalAxes<1>;
template struct Foam::mpm::principalAxes<2>;
template struct Foam::mpm::principalAxes<3>;
