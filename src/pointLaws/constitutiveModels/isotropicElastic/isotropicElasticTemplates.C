/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

Description
    Included by isotropicElastic.H.

\*---------------------------------------------------------------------------*/

#include "dictionaryTools.H"

namespace Foam
{
namespace mpm
{

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class Law>
isotropicElastic<Law>::isotropicElastic
(
    const dictionary& dict,
    const wordList& keywords
)
:
    constitutiveModel(dict)
{
    wordList valid({"type", "rho", "E", "nu"});
    valid.append(keywords);
    checkKeywords(dict, valid);

    const scalar E = positive(dict, "E");
    const scalar nu = bounded(dict, "nu", -0.999, 0.499999);

    lambda_ = E*nu/((1 + nu)*(1 - 2*nu));
    mu_ = E/(2*(1 + nu));
}


template<class Law>
isotropicElastic<Law>::isotropicElastic
(
    const dictionary& dict,
    const scalar lambda,
    const scalar mu
)
:
    constitutiveModel(dict),
    lambda_(lambda),
    mu_(mu)
{}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Law>
template<int DIM>
void isotropicElastic<Law>::update(pointBlock& b) const
{
    constexpr int W = laneWidth<DIM>;
    constexpr int N = DIM*DIM;
    typedef lanes<W> T;

    if (DIM == 2 && b.hoop)
    {
        updateHoopStretch<DIM>(b);
    }

    // Largest velocity gradient of the block chooses the number of terms for
    // all its points
    const double dLMag = largestIncrement<DIM>(b);
    const int nExp = expTerms(dLMag);
    const typename Law::template terms<DIM> terms
    (
        static_cast<const Law&>(*this),
        b,
        dLMag
    );

    for (label p = 0; p < b.n; p += W)
    {
        const laneGroup<W> g(p, b.n);
        T c[N], a[N], side[3], volumePart, factor;
        updateLeftStretch<DIM>(b, g, nExp, c);
        terms.stress(b, g, c, volumePart, factor, a, side);

        for (int i = 0; i < 3; ++i)
        {
            g.put
            (
                b.stress[i],
                volumePart + factor*(i < DIM ? a[(i % DIM)*(DIM + 1)] : side[i])
            );
        }
        for (int i = 0; i < DIM; ++i)
        {
            for (int j = i + 1; j < DIM; ++j)
            {
                g.put(b.stress[symmSlot(i, j)], factor*a[i*DIM + j]);
            }
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Law>
List<historyColumn> isotropicElastic<Law>::history() const
{
    return List<historyColumn>
    (
        1,
        historyColumn{"leftStretch", historyColumn::stresses}
    );
}


template<class Law>
void isotropicElastic<Law>::correct(pointBlock& block) const
{
    switch (block.nDim)
    {
        case 1: update<1>(block); break;
        case 2: update<2>(block); break;
        default: update<3>(block);
    }
}


template<class Law>
void isotropicElastic<Law>::initialise(pointBlock& b) const
{
    for (label p = 0; p < b.n; ++p)
    {
        double sigma[9], c[9];
        fullStress(b, p, sigma);
        const scalar J = rho()*b.volume[p]/b.mass[p];

        const std::string reason
        (
            static_cast<const Law&>(*this).leftStretch(sigma, J, c)
        );
        if (!reason.empty())
        {
            FatalErrorInFunction
                << "The law " << type() << " cannot start with the stress"
                << " (xx yy zz xy xz yz) = (" << sigma[0] << ' ' << sigma[4]
                << ' ' << sigma[8] << ' ' << sigma[1] << ' ' << sigma[2]
                << ' ' << sigma[5] << ") Pa of " << b.nameOf(p).c_str()
                << " at J = " << J << ": " << reason.c_str() << "." << exit(FatalError);
        }

        for (int i = 0; i < 3; ++i)
        {
            b.history[i][p] = c[4*i];
        }
        for (int i = 0; i < b.nDim; ++i)
        {
            for (int j = i + 1; j < b.nDim; ++j)
            {
                b.history[symmSlot(i, j)][p] = c[3*i + j];
            }
        }
    }
}


template<class Law>
scalar isotropicElastic<Law>::waveSpeed() const
{
    return std::sqrt((lambda_ + 2*mu_)/rho());
}

} // End namespace mpm
} // End namespace Foam

// ************************************************************************* //
