// A drag of a user: K = theta_s C |u_g - u_s|

#include "dragModel.H"
#include "dictionaryTools.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam::mpm
{

class quadraticDrag
:
    public dragModel
{
    const scalar C_;

public:

    TypeName("quadratic");

    explicit quadraticDrag(const dictionary& dict)
    :
        dragModel(dict, {"C"}),
        C_(positive(dict, "C"))
    {}

    scalar K(const state& s) const override
    {
        return s.thetaS*C_*s.U;
    }

    bool needsViscosity() const override
    {
        return false;
    }
};

defineTypeNameAndDebug(quadraticDrag, 0);
addToRunTimeSelectionTable(dragModel, quadraticDrag, dictionary);

} // End namespace Foam::mpm
