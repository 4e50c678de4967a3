// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "bodyVectors.H"
#include "scalarMatrices.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::vector6::vector6(const vector& linear, const vector& angular)
{
    for (int d = 0; d < 3; ++d)
    {
        v_[d] = linear[d];
        v_[3 + d] = angular[d];
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::mpm::vector6 Foam::mpm::matrix6::operator*(const vector6& v) const
{
    vector6 product(Zero);
    for (int i = 0; i < 6; ++i)
    {
        for (int j = 0; j < 6; ++j)
        {
            product[i] += v_[6 * i + j] * v[j];
        }
    }
    return product;
}

Foam::mpm::vector6 Foam::mpm::matrix6::solve(const vector6& b) const
{
    scalarSquareMatrix A(6);
    scalarField x(6);
    for (int i = 0; i < 6; ++i)
    {
        x[i] = b[i];
        for (int j = 0; j < 6; ++j)
        {
            A(i, j) = (*this)(i, j);
        }
    }
    LUsolve(A, x);
    return vector6(vector(x[0], x[1], x[2]), vector(x[3], x[4], x[5]));
}

Foam::vector Foam::mpm::matrix36::operator*(const vector6& V) const
{
    vector sum(Zero);
    for (int i = 0; i < 6; ++i)
    {
        sum += V[i] * (*this)[i];
    }
    return sum;
}

Foam::mpm::vector6 Foam::mpm::matrix36::transposed(const vector& f) const
{
    vector6 product;
    for (int i = 0; i < 6; ++i)
    {
        product[i] = (*this)[i] & f;
    }
    return product;
}
