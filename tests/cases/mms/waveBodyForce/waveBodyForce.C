// A body force of a user, in one file and loaded with libs (...): what drives
// the neo-Hookean material P = lambda ln J F^-T + mu (F - F^-T) through
//
//     u_i = G sin(pi X_i) sin(c pi t + phase_i),   c = sqrt(E/rho),
//
// so that rho b = rho d2u/dt2 - Div P. With F diagonal, F_i = 1 + du_i/dX_i
// and J the product of the F_i,
//
//     b_i = pi^2 u_i/rho ((lambda (1 - ln J) + mu)/F_i^2 + mu - E)

#include "bodyForce.H"
#include "dictionaryTools.H"
#include "mathematicalConstants.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam::mpm
{

class waveBodyForce : public pointwiseBodyForce<waveBodyForce>
{
    const scalar G_, rho_, E_, nu_, lambda_, mu_;
    const vector phase_;

    //- Displacement only in these directions
    const vector active_;

public:
    TypeName("wave");

    explicit waveBodyForce(const dictionary& dict) :
        G_(positive(dict, "G")),
        rho_(positive(dict, "rho")),
        E_(positive(dict, "E")),
        nu_(bounded(dict, "nu", -0.999, 0.499)),
        lambda_(E_ * nu_ / ((1 + nu_) * (1 - 2 * nu_))),
        mu_(E_ / (2 * (1 + nu_))),
        phase_(required<vector>(dict, "phase")),
        active_(required<vector>(dict, "active"))
    {
        checkKeywords(dict, {"type", "G", "rho", "E", "nu", "phase", "active"});
    }

    bool needsReference() const override { return true; }

    vector acceleration(const point&, const point& X, const scalar time) const
    {
        const scalar pi = constant::mathematical::pi;
        const scalar omega = pi * std::sqrt(E_ / rho_);

        vector u(Zero), F(vector::one);
        for (int i = 0; i < 3; ++i)
        {
            const scalar a = active_[i] * G_ * std::sin(omega * time + phase_[i]);
            u[i] = a * std::sin(pi * X[i]);
            F[i] = 1 + a * pi * std::cos(pi * X[i]);
        }
        const scalar lnJ = std::log(F[0] * F[1] * F[2]);

        vector b(Zero);
        for (int i = 0; i < 3; ++i)
        {
            b[i] = sqr(pi) * u[i] / rho_ * ((lambda_ * (1 - lnJ) + mu_) / sqr(F[i]) + mu_ - E_);
        }
        return b;
    }
};

defineTypeNameAndDebug(waveBodyForce, 0);
addToRunTimeSelectionTable(bodyForce, waveBodyForce, dictionary);

} // End namespace Foam::mpm
