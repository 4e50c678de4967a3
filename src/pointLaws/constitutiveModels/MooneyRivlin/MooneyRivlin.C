/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::mpm::MooneyRivlin

Description
    Hyperelastic rubber of Mooney and Rivlin, shape and volume apart:

        W = c10 (I1' - 3) + c01 (I2' - 3) + K/2 (ln J)^2               [J/m3]
        sigma = 2/J dev(c10 b' + c01 (I1' b' - b'^2)) + K ln(J)/J I

    of the unstressed volume, with b' = J^(-2/3) b, its invariants I1' and I2',
    the left Cauchy-Green tensor b = F F^T [-] and J = sqrt(det b). The column
    leftStretch holds b - I. Shear modulus 2 (c10 + c01). A rotation turns b
    and so sigma exactly. In 1D and 2D as linearElastic.

    Wave speed: that of the unstressed material.

    Initial stress: b follows from the principal stresses by Newton's method;
    fatal where that finds none.

Usage
    \table
        Property | Description                               | Required | Unit
        type     | MooneyRivlin                              | yes      |
        rho      | density of the unstressed material        | yes      | kg/m3
        c10      | > 0                                       | yes      | Pa
        c01      | >= 0                                      | yes      | Pa
        K        | bulk modulus, > 0                         | yes      | Pa
    \endtable

    Reference: R. S. Rivlin, Phil. Trans. Roy. Soc. A 241 (1948) 379.

\*---------------------------------------------------------------------------*/

#include "isotropicElastic.H"
#include "laneMath.H"
#include "principalAxes.H"
#include "tensor.H"
#include <algorithm>
#include <cmath>

namespace Foam::mpm
{

namespace
{

//- det(I + c) - 1 of a symmetric matrix c, without cancellation
template<class T>
MPM_INLINE T detMinus1(const T xx, const T yy, const T zz, const T xy, const T xz, const T yz)
{
    return xx + yy + zz + (xx * yy - xy * xy) + (xx * zz - xz * xz) + (yy * zz - yz * yz)
        + (xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz));
}

}

class MooneyRivlin : public isotropicElastic<MooneyRivlin>
{
    scalar c10_, c01_, K_;

public:
    TypeName("MooneyRivlin");

    explicit MooneyRivlin(const dictionary& dict) :
        isotropicElastic<MooneyRivlin>(
            dict,
            positive(dict, "K")
                - 4.0 / 3 * (positive(dict, "c10") + bounded(dict, "c01", 0, GREAT)),
            2 * (positive(dict, "c10") + bounded(dict, "c01", 0, GREAT))),
        c10_(positive(dict, "c10")),
        c01_(bounded(dict, "c01", 0, GREAT)),
        K_(positive(dict, "K"))
    {
        checkKeywords(dict, {"type", "rho", "c10", "c01", "K"});
    }

    //- Terms of a block: see isotropicElastic
    template<int DIM>
    class terms
    {
        static constexpr int W = laneWidth<DIM>;
        static constexpr int N = DIM * DIM;
        typedef lanes<W> T;

        const MooneyRivlin& law_;

    public:
        terms(const MooneyRivlin& law, const pointBlock&, const double) : law_(law) {}

        MPM_INLINE void stress(
            const pointBlock& b, const laneGroup<W>& g, const T (&c)[N], T& volumePart, T& factor,
            T (&a)[N], T (&side)[3]) const
        {
            T full[9] = {}, cc[9] = {};
            for (int i = 0; i < DIM; ++i)
            {
                for (int j = 0; j < DIM; ++j)
                {
                    full[3 * i + j] = c[i * DIM + j];
                    for (int k = 0; k < DIM; ++k)
                    {
                        cc[3 * i + j] += c[i * DIM + k] * c[k * DIM + j];
                    }
                }
            }
            for (int i = DIM; i < 3; ++i)
            {
                full[4 * i] = g.get(b.history[i]);
                cc[4 * i] = full[4 * i] * full[4 * i];
            }
            const T tr = full[0] + full[4] + full[8];
            const T lnJ = 0.5
                * laneLog(1.0 + detMinus1(full[0], full[4], full[8], full[1], full[2], full[5]));
            const T rJ = laneExp(-lnJ), r23 = laneExp(-2.0 / 3 * lnJ);
            const T f1 = 2 * law_.c10_ * rJ * r23, f2 = 2 * law_.c01_ * rJ * r23 * r23;
            const T linear = f1 + f2 * (1.0 + tr);
            const T mean = (linear * tr - f2 * (cc[0] + cc[4] + cc[8])) / 3.0;

            volumePart = law_.K_ * lnJ * rJ - mean;
            factor = broadcast<W>(1);
            for (int i = 0; i < DIM; ++i)
            {
                for (int j = 0; j < DIM; ++j)
                {
                    a[i * DIM + j] = linear * full[3 * i + j] - f2 * cc[3 * i + j];
                }
            }
            for (int i = DIM; i < 3; ++i)
            {
                side[i] = linear * full[4 * i] - f2 * cc[4 * i];
            }
        }
    };

    //- Left stretch that carries a stress: see isotropicElastic
    std::string leftStretch(const double (&sigma)[9], const scalar J, double (&c)[9]) const;

    scalar strainEnergy(const pointBlock& b) const override
    {
        scalar sum = 0;
        for (label p = 0; p < b.n; ++p)
        {
            double c[9];
            fullTensor(b.history, b.nDim, p, c);
            const double tr = c[0] + c[4] + c[8];
            double cc = 0;
            for (const double x : c)
            {
                cc += x * x;
            }
            const double lnJ =
                0.5 * std::log1p(detMinus1<double>(c[0], c[4], c[8], c[1], c[2], c[5]));
            // I1 - 3 = tr, I2 - 3 = 2 tr + (tr^2 - c:c)/2
            const double m = std::expm1(-2.0 / 3 * lnJ), m2 = std::expm1(-4.0 / 3 * lnJ);
            const double I1 = 3 * m + (1 + m) * tr;
            const double I2 = 3 * m2 + (1 + m2) * (2 * tr + 0.5 * (tr * tr - cc));
            sum += b.mass[p] / rho() * (c10_ * I1 + c01_ * I2 + 0.5 * K_ * sqr(lnJ));
        }
        return sum;
    }
};

std::string MooneyRivlin::leftStretch(const double (&sigma)[9], const scalar, double (&c)[9]) const
{
    const std::string none("no stretch was found that carries it");
    if (!std::all_of(sigma, sigma + 9, [](const double x) { return std::isfinite(x); }))
    {
        return none;
    }
    const principalAxes<3> axes(sigma);
    const vector wanted(axes.value[0], axes.value[1], axes.value[2]);

    // Principal stresses of the principal logarithmic stretches
    const auto stressOf = [&](const vector& h)
    {
        const double lnJ = h[0] + h[1] + h[2], rJ = std::exp(-lnJ);
        vector b, t;
        for (int i = 0; i < 3; ++i)
        {
            b[i] = std::exp(2 * h[i] - 2.0 / 3 * lnJ);
        }
        for (int i = 0; i < 3; ++i)
        {
            t[i] = 2 * rJ * (c10_ * b[i] + c01_ * b[i] * (b[(i + 1) % 3] + b[(i + 2) % 3]));
        }
        const double mean = (t[0] + t[1] + t[2]) / 3;
        return vector(t + (K_ * lnJ * rJ - mean) * vector(1, 1, 1));
    };
    const auto largest = [](const vector& v) { return cmptMax(cmptMag(v)); };

    vector h(Zero);
    const double size = mag(wanted) + 1e-3 * mu();
    for (int iteration = 0; iteration < 60; ++iteration)
    {
        const vector residual(stressOf(h) - wanted);
        if (mag(residual) <= 1e-14 * size)
        {
            break;
        }
        // Row j: change by h_j
        tensor slope;
        for (direction j = 0; j < 3; ++j)
        {
            vector d(Zero);
            d[j] = 1e-6;
            const vector row((stressOf(h + d) - stressOf(h - d)) / 2e-6);
            for (direction i = 0; i < 3; ++i)
            {
                slope(j, i) = row[i];
            }
        }
        const vector change(residual & inv(slope));
        h -= change * std::min(1.0, 0.3 / std::max(largest(change), VSMALL));
        // Also for NaN
        if (!(largest(h) <= 5))
        {
            return none;
        }
    }
    if (!(mag(stressOf(h) - wanted) <= 1e-10 * size))
    {
        return none;
    }
    double stretch[3];
    for (int i = 0; i < 3; ++i)
    {
        stretch[i] = std::expm1(2 * h[i]);
    }
    axes.compose(stretch, c);
    return std::string();
}

defineTypeNameAndDebug(MooneyRivlin, 0);
addToRunTimeSelectionTable(constitutiveModel, MooneyRivlin, dictionary);

} // End namespace Foam::mpm
