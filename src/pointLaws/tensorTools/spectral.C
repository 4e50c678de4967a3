// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

// The compiler's own AVX-512 headers start a register from itself
// (_mm256_undefined_pd), which it then reports in code that Eigen inlines
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"

#include "spectral.H"
#include <Eigen/Eigenvalues>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

template<int N>
void Foam::mpm::isotropicFunction(const double (&A)[N * N], double (*f)(double), double (&R)[N * N])
{
    typedef Eigen::Matrix<double, N, N> matrix;

    const Eigen::SelfAdjointEigenSolver<matrix> s(Eigen::Map<const matrix>(A, N, N));
    const Eigen::Matrix<double, N, 1> values(s.eigenvalues().unaryExpr(f));

    Eigen::Map<matrix>(R, N, N) =
        s.eigenvectors() * values.asDiagonal() * s.eigenvectors().transpose();
}

double Foam::mpm::largestPrincipal(const double (&A)[9])
{
    typedef Eigen::Matrix3d matrix;

    const Eigen::SelfAdjointEigenSolver<matrix> s(
        Eigen::Map<const matrix>(A, 3, 3), Eigen::EigenvaluesOnly);
    return s.eigenvalues()(2);
}

double Foam::mpm::largestPrincipal(const double (&A)[9], double (&n)[3])
{
    typedef Eigen::Matrix3d matrix;

    const Eigen::SelfAdjointEigenSolver<matrix> s(Eigen::Map<const matrix>(A, 3, 3));
    Eigen::Map<Eigen::Vector3d>(n, 3) = s.eigenvectors().col(2);
    return s.eigenvalues()(2);
}

template void
Foam::mpm::isotropicFunction<1>(const double (&)[1], double (*)(double), double (&)[1]);
template void
Foam::mpm::isotropicFunction<2>(const double (&)[4], double (*)(double), double (&)[4]);
template void
Foam::mpm::isotropicFunction<3>(const double (&)[9], double (*)(double), double (&)[9]);
