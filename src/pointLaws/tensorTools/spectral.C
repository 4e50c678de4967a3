// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "spectral.H"
#include "principalAxes.H"
#include <algorithm>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

template<int N>
void Foam::mpm::isotropicFunction(const double (&A)[N * N], double (*f)(double), double (&R)[N * N])
{
    const principalAxes<N> axes(A);
    double values[N];
    std::transform(axes.value, axes.value + N, values, f);
    axes.compose(values, R);
}

double Foam::mpm::largestPrincipal(const double (&A)[9])
{
    return principalAxes<3>(A, false).value[2];
}

double Foam::mpm::largestPrincipal(const double (&A)[9], double (&n)[3])
{
    const principalAxes<3> axes(A);
    std::copy(axes.direction[2], axes.direction[2] + 3, n);
    return axes.value[2];
}

template void
Foam::mpm::isotropicFunction<1>(const double (&)[1], double (*)(double), double (&)[1]);
template void
Foam::mpm::isotropicFunction<2>(const double (&)[4], double (*)(double), double (&)[4]);
template void
Foam::mpm::isotropicFunction<3>(const double (&)[9], double (*)(double), double (&)[9]);
