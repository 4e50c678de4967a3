/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::mpm::MohrCoulomb

Description
    Mohr and Coulomb's pyramid; elasticity: frictionalLaw, entries:
    soilStrength.

        f = (s1 - s3) + (s1 + s3) sin(phi) - 2 c cos(phi) <= 0

    with the principal stresses s1 >= s2 >= s3, tension positive, and the same
    with psi as potential. Return in principal stresses, to the plane, an
    edge or the apex. Then principal stresses above tensionCutoff are cut to it.
    Points that cannot reach a plane of the pyramid skip the principal
    values.

Usage
    \table
        Property      | Description                          | Required | Unit
        type          | MohrCoulomb                          | yes      |
        tensionCutoff | largest principal stress             | no       | none
        rho, E, nu, cohesion, frictionAngle, dilationAngle | see soilStrength | |
    \endtable

    Reference: E. de Souza Neto, D. Peric, D. Owen, Computational methods for
    plasticity, Wiley (2008), chapter 8.

\*---------------------------------------------------------------------------*/

#include "frictionalLaw.H"
#include "soilStrength.H"
#include "principalAxes.H"

namespace Foam::mpm
{

class MohrCoulomb : public frictionalLaw<MohrCoulomb>, soilStrength
{
    scalar sinPhi_, sinPsi_, cCosPhi_;

    //- Principal stresses s, ascending, to the pyramid; false if inside
    bool principalReturn(double (&s)[3]) const;

    //- Deviator and trace of the elastic strain of one point after flow,
    //  in full storage; the equivalent plastic strain
    double pointFlow(double (&X)[9], double& theta) const;

public:
    TypeName("MohrCoulomb");

    explicit MohrCoulomb(const dictionary& dict) :
        frictionalLaw<MohrCoulomb>(dict, keywords()),
        soilStrength(dict),
        sinPhi_(std::sin(phi_)),
        sinPsi_(std::sin(psi_)),
        cCosPhi_(c_ * std::cos(phi_))
    {
    }

    //- See frictionalLaw
    template<int DIM>
    void flow(
        const pointBlock&, const laneGroup<laneWidth<DIM>>& g, elasticStrainStep<DIM>& step,
        lanes<laneWidth<DIM>>& theta, lanes<laneWidth<DIM>>& dEps) const
    {
        constexpr int W = laneWidth<DIM>;
        typedef lanes<W> T;

        // No principal stress is further from the mean than 2 sqrt(J2/3)
        T XX, XU, UU;
        step.products(XX, XU, UU);
        const T r = 2 * G_ * laneSqrt(2.0 / 3 * XX), s = K_ * theta;
        const laneMask<W> near =
            (2.0 * r + 2.0 * s * sinPhi_ - 2 * cCosPhi_ > 0.0) | (s + r > tension_);
        if (!anyOf<W>(near))
        {
            return;
        }
        for (int l = 0; l < g.n; ++l)
        {
            if (!near[l])
            {
                continue;
            }
            double X[9] = {}, trace = theta[l];
            for (int i = 0; i < DIM; ++i)
            {
                for (int j = 0; j < DIM; ++j)
                {
                    X[3 * i + j] = step.X[i * DIM + j][l];
                }
            }
            for (int i = DIM; i < 3; ++i)
            {
                X[4 * i] = step.side[i][l];
            }
            dEps[l] = pointFlow(X, trace);
            theta[l] = trace;
            for (int i = 0; i < DIM; ++i)
            {
                for (int j = 0; j < DIM; ++j)
                {
                    step.X[i * DIM + j][l] = X[3 * i + j];
                }
            }
            for (int i = DIM; i < 3; ++i)
            {
                step.side[i][l] = X[4 * i];
            }
        }
    }
};

bool MohrCoulomb::principalReturn(double (&s)[3]) const
{
    // Trial stresses in descending order
    const double t1 = s[2], t2 = s[1], t3 = s[0];
    const auto yield = [&](const double high, const double low)
    { return (high - low) + (high + low) * sinPhi_ - 2 * cCosPhi_; };
    const double f = yield(t1, t3);
    bool changed = f > 0;
    if (changed)
    {
        // Stress that a unit of flow (1 + psi, 0, -1 + psi) takes away
        const double high = 2 * G_ * (1 + sinPsi_ / 3) + 2 * K_ * sinPsi_;
        const double middle = (2 * K_ - 4.0 / 3 * G_) * sinPsi_;
        const double low = -2 * G_ * (1 - sinPsi_ / 3) + 2 * K_ * sinPsi_;
        const double both = sinPhi_ * sinPsi_;
        const double a = 4 * G_ * (1 + both / 3) + 4 * K_ * both;

        const double g = f / a;
        double s1 = t1 - high * g, s2 = t2 - middle * g, s3 = t3 - low * g;
        const double slack = 1e-13 * (mag(t1) + mag(t3));
        if (s1 < s2 - slack || s2 < s3 - slack)
        {
            // The edge that is nearer: two planes at once
            const bool right = (1 - sinPsi_) * t1 - 2 * t2 + (1 + sinPsi_) * t3 > 0;
            const double fB = right ? yield(t1, t2) : yield(t2, t3);
            const double sum = right ? sinPhi_ + sinPsi_ : -sinPhi_ - sinPsi_;
            const double b = 2 * G_ * (1 + sum - both / 3) + 4 * K_ * both;
            const double gA = (a * f - b * fB) / (a * a - b * b);
            const double gB = (a * fB - b * f) / (a * a - b * b);
            if (right)
            {
                s1 = t1 - high * (gA + gB);
                s2 = t2 - middle * gA - low * gB;
                s3 = t3 - low * gA - middle * gB;
            }
            else
            {
                s1 = t1 - high * gA - middle * gB;
                s2 = t2 - middle * gA - high * gB;
                s3 = t3 - low * (gA + gB);
            }
            if (sinPhi_ > 0 && (s1 < s2 - slack || s2 < s3 - slack))
            {
                s1 = s2 = s3 = cCosPhi_ / sinPhi_;
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

double MohrCoulomb::pointFlow(double (&X)[9], double& theta) const
{
    const principalAxes<3> axes(X);
    const double* h = axes.value;

    double s[3];
    for (int i = 0; i < 3; ++i)
    {
        s[i] = 2 * G_ * h[i] + K_ * theta;
    }
    if (!principalReturn(s))
    {
        return 0;
    }
    const double mean = (s[0] + s[1] + s[2]) / 3;
    double left[3];
    double flow = 0;
    for (int i = 0; i < 3; ++i)
    {
        left[i] = (s[i] - mean) / (2 * G_);
        flow += sqr(h[i] - left[i]);
    }
    theta = mean / K_;
    axes.compose(left, X);
    return std::sqrt(2.0 / 3 * flow);
}

defineTypeNameAndDebug(MohrCoulomb, 0);
addToRunTimeSelectionTable(constitutiveModel, MohrCoulomb, dictionary);

} // End namespace Foam::mpm
