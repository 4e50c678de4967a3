/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "transfer.H"
#include "dictionaryTools.H"
#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::transfer::transfer(const dictionary& dict)
{
    const wordList names({"FLIP", "FMPM", "XPIC", "APIC"});
    kind = kinds(names.find(oneOf(dict, "transfer", names)));

    // An entry that the chosen transfer does not read is a mistake
    const auto belongsTo = [&](const word& key, const bool here, const char* to)
    {
        if (dict.found(key) && !here)
        {
            FatalIOErrorInFunction(dict)
                << "Entry " << key << " belongs to transfer " << to
                << ", not to " << names[kind] << "; remove it, or choose that"
                << " transfer." << exit(FatalIOError);
        }
    };
    const bool series = kind == FMPM || kind == XPIC;
    belongsTo("PICfraction", kind == FLIP, "FLIP");
    belongsTo("order", series, "FMPM or XPIC");
    belongsTo("strainFilter", series, "FMPM or XPIC");
    belongsTo("affineMatrix", kind == APIC, "APIC");

    if (kind == FLIP)
    {
        PICfraction = boundedOrDefault(dict, "PICfraction", 0, 0, 1);
        PICgrains = boundedOrDefault(dict, "PICfraction", 0.1, 0, 1);
    }
    else if (series)
    {
        order = boundedLabelOrDefault(dict, "order", 2, 1, 100);

        // Points without an extent take the whole filter: see
        // materialPointSystem
        const word shape(dict.getOrDefault<word>("shapeFunction", ""));
        const bool spline =
            shape == "quadraticBSpline" || shape == "cubicBSpline";
        strainFilter = boundedOrDefault
        (
            dict,
            "strainFilter",
            kind == XPIC ? 0 : spline ? 1 : 0.75,
            0,
            1
        );
        if (kind == FMPM && order > 4)
        {
            WarningInFunction
                << "FMPM of order " << order << " rings at shocks: in plate"
                << " impacts with strainFilter 1 order 8 grew without bound."
                << " Order 2 is what to use." << endl;
        }
    }
    else
    {
        moment =
            oneOfOrDefault
            (
                dict,
                "affineMatrix",
                "gradient",
                {"gradient", "moment"}
            ) == "moment";
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::mpm::transfer::keywords()
{
    return {"transfer", "PICfraction", "order", "strainFilter", "affineMatrix"};
}


Foam::scalar Foam::mpm::transfer::fraction
(
    const scalar Co,
    const bool grains
) const
{
    const scalar a = grains ? PICgrains : PICfraction;
    return a < 1 ? -std::expm1(std::log1p(-a)*Co/0.4) : 1;
}


void Foam::mpm::transfer::write(Ostream& os) const
{
    switch (kind)
    {
        case FLIP:
            os  << "transfer FLIP with PIC fraction " << PICfraction;
            if (PICgrains > PICfraction)
            {
                os  << " (of grains " << PICgrains << ")";
            }
            os  << ": x moves with u^L";
            break;

        case FMPM:
            os  << "transfer FMPM of order " << order
                << ": x moves with the new velocity of the point";
            break;

        case XPIC:
            os  << "transfer XPIC of order " << order
                << ": x moves with the new velocity of the point";
            break;

        case APIC:
            os  << "transfer APIC, affine matrix from the "
                << (moment ? "moments of u^L" : "gradient of u^n")
                << ": x moves with u^L";
    }
    os  << nl;
    if (order > 1)
    {
        os  << "    increments of the filters meet the homogeneous boundary"
            << " conditions; strainFilter " << strainFilter << nl;
    }
}

// ************************************************************************* //
