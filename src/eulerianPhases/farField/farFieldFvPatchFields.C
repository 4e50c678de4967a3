// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "farFieldFvPatchField.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
typedef farFieldFvPatchField<scalar> farFieldFvPatchScalarField;
typedef farFieldFvPatchField<vector> farFieldFvPatchVectorField;

makeTemplatePatchTypeField(scalar, farField);
makeTemplatePatchTypeField(vector, farField);
}
