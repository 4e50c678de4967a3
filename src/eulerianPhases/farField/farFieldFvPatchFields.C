/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

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

// ************************************************************************* //
