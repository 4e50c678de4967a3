/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "fluidStart.H"
#include "fullPrecision.H"
#include "basicSymmetryFvPatchFields.H"
#include "wallPolyPatch.H"
#include "Time.H"
#include <cstdio>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::mpm::fluidStart::elsewhere
(
    const label k,
    const scalar p
) const
{
    const gasThermo& thermo = mixture_.thermo(k);
    for (const fluidRegion& region : regions_)
    {
        if (region.fluid() == k)
        {
            const scalar rho = region.density(region.hasP() ? region.p() : p);
            return
                thermo.isGammaLaw()
              ? (region.hasP() ? region.p() : p)/(thermo.R()*rho)
              : rho;
        }
    }
    return thermo.isGammaLaw() ? scalar(300) : mixture_.rho0(k);
}


template<class Type>
void Foam::mpm::fluidStart::write
(
    const word& name,
    const dimensionSet& dimensions,
    const Field<Type>& values,
    const word& onWalls
) const
{
    typedef GeometricField<Type, fvPatchField, volMesh> fieldType;

    IOobject io
    (
        name,
        mesh_.time().timeName(),
        mesh_,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
    autoPtr<fieldType> field;
    if (io.typeHeaderOk<fieldType>(true))
    {
        // Its conditions
        field.reset(new fieldType(io, mesh_));
    }
    else
    {
        io.readOpt() = IOobject::NO_READ;
        wordList types(mesh_.boundary().size(), "zeroGradient");
        forAll(types, i)
        {
            const polyPatch& patch = mesh_.boundaryMesh()[i];
            if (polyPatch::constraintType(patch.type()))
            {
                types[i] = patch.type();
            }
            else if (isA<wallPolyPatch>(patch))
            {
                types[i] = onWalls;
            }
        }
        field.reset
        (
            new fieldType
            (
                io, mesh_, dimensioned<Type>("zero", dimensions, Zero), types
            )
        );
    }
    field->primitiveFieldRef() = values;
    field->correctBoundaryConditions();
    Info<< "Writing " << field->objectPath() << endl;
    field->write();
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::fluidStart::printTable() const
{
    char line[200];
    const auto number = [&](const scalar x, const int digits = 12)
    {
        char text[40];
        std::snprintf(text, sizeof(text), "%.*g", digits, x);
        return std::string(x < 0 ? "-" : text);
    };
    std::snprintf
    (
        line, sizeof(line), "%-16s %-12s %20s %20s %20s %10s", "region", "fluid",
        "volume [m3]", "of the shape [m3]", "mass [kg]", "corrected"
    );
    Info<< line << nl;
    scalar all = 0;
    forAll(regions_, r)
    {
        scalar mass = 0;
        forAll(share_[r], c)
        {
            if (share_[r][c] > 0)
            {
                mass +=
                    share_[r][c]*mesh_.V()[c]*regions_[r].density(pressure(r, c));
            }
        }
        all += volume(r);
        std::snprintf
        (
            line, sizeof(line), "%-16s %-12s %20s %20s %20s %10s",
            regions_[r].name().c_str(),
            mixture_.name(regions_[r].fluid()).c_str(),
            number(volume(r)).c_str(),
            number(exact_[r]).c_str(),
            number(mass).c_str(),
            number(r == 0 ? -1 : moved_[r], 2).c_str()
        );
        Info<< line << nl;
    }
    Info<< "All regions fill " << number(all).c_str() << " m3, the mesh has "
        << number(gSum(mesh_.V())).c_str() << " m3. corrected: largest change"
        << " of a share" << nl << endl;
}


void Foam::mpm::fluidStart::write() const
{
    const label n = mesh_.nCells(), nFluids = mixture_.size();
    List<scalarField> alpha(nFluids), state(nFluids);
    scalarField p(n, Zero);
    vectorField U(n, Zero);
    for (label k = 0; k < nFluids; ++k)
    {
        alpha[k].setSize(n, Zero);
        state[k].setSize(n, Zero);
    }
    scalarList theta(nFluids), m(nFluids);
    for (label c = 0; c < n; ++c)
    {
        theta = 0;
        m = 0;
        scalar energy = 0, low = VGREAT, high = -VGREAT, mass = 0, shares = 0;
        forAll(regions_, r)
        {
            const scalar s = share_[r][c];
            if (s > 0)
            {
                const label k = regions_[r].fluid();
                const scalar pr = pressure(r, c);
                const scalar rho = regions_[r].density(pr);
                theta[k] += s;
                m[k] += s*rho;
                mass += s*rho;
                shares += s;
                U[c] += s*rho*regions_[r].U();
                energy += s*fluidMixture::energy(mixture_.at(k, rho), rho, pr);
                low = min(low, pr);
                high = max(high, pr);
            }
        }
        U[c] /= mass;
        p[c] =
            low == high
          ? low
          : mixture_.pressure(theta.cdata(), m.cdata(), energy);
        for (label k = 0; k < nFluids; ++k)
        {
            alpha[k][c] = theta[k]/shares;
            const scalar rho = theta[k] > 0 ? m[k]/theta[k] : 0;
            const gasThermo& thermo = mixture_.thermo(k);
            state[k][c] =
                !(theta[k] > 0) ? elsewhere(k, p[c])
              : thermo.isGammaLaw() ? p[c]/(thermo.R()*rho)
              : rho;
        }
    }

    const fullPrecision allDigits;
    write("p", dimPressure, p, "zeroGradient");
    write("U", dimVelocity, U, "slip");
    for (label k = 0; k < nFluids; ++k)
    {
        const word& name = mixture_.name(k);
        const bool gas = mixture_.thermo(k).isGammaLaw();
        write(IOobject::groupName("alpha", name), dimless, alpha[k], "zeroGradient");
        write
        (
            IOobject::groupName(gas ? "T" : "rho", name),
            gas ? dimTemperature : dimDensity,
            state[k],
            "zeroGradient"
        );
    }
}

// ************************************************************************* //
