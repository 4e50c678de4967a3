// A face flux of a user: that of the impedances with the pressure of von
// Neumann and Richtmyer where gas runs together,
//
//     p* += C rho (u_L - u_R)^2

#include "impedanceFlux.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam::mpm
{

class quadraticViscosity
:
    public impedanceFlux
{
    const scalar C_;

    template<bool General>
    void withViscosity(const gasStates<General>& s, const result& to) const
    {
        impedanceFlux::flux(s, to);
        const fvMesh& mesh = faces_.mesh;
        for (label f = 0; f < mesh.nInternalFaces(); ++f)
        {
            const gasState& L = s.cell(mesh.faceOwner()[f]).w;
            const gasState& R = s.cell(mesh.faceNeighbour()[f]).w;
            const scalar du = (L.u - R.u) & mesh.faceAreas()[f]/faces_.magS[f];
            to.pStar[f] += C_*max(L.rho, R.rho)*sqr(max(du, scalar(0)));
        }
    }

public:

    TypeName("quadraticViscosity");

    quadraticViscosity(const dictionary& dict, const gasFaces& faces)
    :
        impedanceFlux(dict, faces),
        C_(bounded(dict, "C", 0, 4))
    {}

    wordList keywords() const override { return {"C"}; }

    void flux(const gasStates<false>& s, const result& to) const override
    {
        withViscosity(s, to);
    }

    void flux(const gasStates<true>& s, const result& to) const override
    {
        withViscosity(s, to);
    }
};

defineTypeNameAndDebug(quadraticViscosity, 0);
addToRunTimeSelectionTable(faceFlux, quadraticViscosity, dictionary);

} // End namespace Foam::mpm
