/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::mpm::noStress

Description
    Points without a stress of their own: sigma = 0, and the volume stays
    that of the mass, v = m/rho. For grains in a gas (volumeModel grains).

Usage
    \table
        Property | Description                          | Required | Unit
        type     | noStress                             | yes      |
        rho      | density of the grains' material      | yes      | kg/m3
    \endtable

\*---------------------------------------------------------------------------*/

#include "constitutiveModel.H"

namespace Foam::mpm
{

class noStress : public constitutiveModel
{
public:
    TypeName("noStress");

    explicit noStress(const dictionary& dict) : constitutiveModel(dict)
    {
        checkKeywords(dict, {"type", "rho"});
    }

    bool hasStress() const override { return false; }

    void correct(pointBlock&) const override {}

    scalar waveSpeed() const override { return 0; }
    scalar strainEnergy(const pointBlock&) const override { return 0; }
};

defineTypeNameAndDebug(noStress, 0);
addToRunTimeSelectionTable(constitutiveModel, noStress, dictionary);

} // End namespace Foam::mpm
