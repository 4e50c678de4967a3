// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "farFieldFvPatchField.H"
#include "dictionaryTools.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class Type>
Foam::farFieldFvPatchField<Type>::farFieldFvPatchField(
    const fvPatch& p, const DimensionedField<Type, volMesh>& iF) :
    fvPatchField<Type>(p, iF), hasSource_(false), source_(Zero), layer_(0)
{
}

template<class Type>
Foam::farFieldFvPatchField<Type>::farFieldFvPatchField(
    const fvPatch& p, const DimensionedField<Type, volMesh>& iF, const dictionary& dict) :
    fvPatchField<Type>(p, iF, dict, false),
    hasSource_(dict.found("source")),
    source_(dict.getOrDefault<point>("source", Zero)),
    layer_(dict.found("layer") ? mpm::positive(dict, "layer") : 0)
{
    const bool ofP = pTraits<Type>::rank == 0;
    const word member(IOobject::member(iF.name()));
    if (member != "p" && member != "U")
    {
        FatalIOErrorInFunction(dict)
            << "The condition farField of patch " << p.name() << " of " << iF.name()
            << " is for p and U only; T, rho and alpha of what"
            << " comes in: inletOutlet or fixedValue." << exit(FatalIOError);
    }
    mpm::checkKeywords(
        dict,
        ofP ? wordList({"type", "farValue", "source", "layer", "value"})
            : wordList({"type", "farValue", "value"}));
    if (dict.found("farValue"))
    {
        far_ = Field<Type>("farValue", dict, p.size());
    }
    if (dict.found("value"))
    {
        fvPatchField<Type>::operator=(Field<Type>("value", dict, p.size()));
    }
    else
    {
        fvPatchField<Type>::operator=(this->patchInternalField());
    }
}

template<class Type>
Foam::farFieldFvPatchField<Type>::farFieldFvPatchField(
    const farFieldFvPatchField<Type>& of, const fvPatch& p,
    const DimensionedField<Type, volMesh>& iF, const fvPatchFieldMapper& mapper) :
    fvPatchField<Type>(of, p, iF, mapper),
    far_(of.far_.empty() ? Field<Type>() : Field<Type>(of.far_, mapper)),
    hasSource_(of.hasSource_),
    source_(of.source_),
    layer_(of.layer_)
{
}

template<class Type>
Foam::farFieldFvPatchField<Type>::farFieldFvPatchField(const farFieldFvPatchField<Type>& of) :
    fvPatchField<Type>(of),
    far_(of.far_),
    hasSource_(of.hasSource_),
    source_(of.source_),
    layer_(of.layer_)
{
}

template<class Type>
Foam::farFieldFvPatchField<Type>::farFieldFvPatchField(
    const farFieldFvPatchField<Type>& of, const DimensionedField<Type, volMesh>& iF) :
    fvPatchField<Type>(of, iF),
    far_(of.far_),
    hasSource_(of.hasSource_),
    source_(of.source_),
    layer_(of.layer_)
{
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
void Foam::farFieldFvPatchField<Type>::autoMap(const fvPatchFieldMapper& mapper)
{
    fvPatchField<Type>::autoMap(mapper);
    if (far_.size())
    {
        far_.autoMap(mapper);
    }
}

template<class Type>
void Foam::farFieldFvPatchField<Type>::rmap(
    const fvPatchField<Type>& from, const labelList& addressing)
{
    fvPatchField<Type>::rmap(from, addressing);
    const Field<Type>& far = refCast<const farFieldFvPatchField<Type>>(from).far_;
    if (far.size())
    {
        far_.setSize(this->size(), far[0]);
        far_.rmap(far, addressing);
    }
}

template<class Type>
void Foam::farFieldFvPatchField<Type>::write(Ostream& os) const
{
    fvPatchField<Type>::write(os);
    if (far_.size())
    {
        far_.writeEntry("farValue", os);
    }
    if (hasSource_)
    {
        os.writeEntry("source", source_);
    }
    if (layer_ > 0)
    {
        os.writeEntry("layer", layer_);
    }
    this->writeEntry("value", os);
}
