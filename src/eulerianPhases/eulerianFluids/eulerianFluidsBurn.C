/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/


#include "eulerianFluids.H"
#include "noTraps.H"
#include "startFields.H"
#include "zeroGradientFvPatchFields.H"
#include "Time.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::eulerianFluids::makeBurnt(const fieldStates* states)
{
    DynamicList<label> burning;
    for (label k = 0; k < n_; ++k)
    {
        if (mixture_.detonates(k))
        {
            burning.append(k);
        }
    }
    burning_.transfer(burning);
    if (burning_.empty())
    {
        return;
    }
    burnt_.setSize(n_*mesh_.nCells(), 1);
    burntB_.setSize(n_*Wb_.size(), 1);
    burntOut_.setSize(burning_.size());
    F_.setSize(burning_.size());
    forAll(burning_, j)
    {
        const label k = burning_[j];
        burntOut_[j].setSize(mesh_.nCells(), 0);
        const bool there =
            states || isThere(header("F", IOobject::MUST_READ, k));
        F_.set
        (
            j,
            there
          ? new volScalarField(startField<volScalarField>("F", states, k))
          : new volScalarField
            (
                header("F", IOobject::NO_READ, k), mesh_,
                dimensionedScalar("F", dimless, 0), "zeroGradient"
            )
        );
        const noTraps guard;
        forAll(F_[j], c)
        {
            const scalar F = F_[j][c];
            if (!(F >= 0 && F <= 1))
            {
                FatalErrorInFunction
                    << "Field " << F_[j].name() << " in " << F_[j].objectPath()
                    << " has the value " << F << " in cell " << c << " at "
                    << mesh_.cellCentres()[c]
                    << "; a burn fraction is in [0, 1]." << exit(FatalError);
            }
            burnt_[n_*c + k] = F;
        }
    }
}


void Foam::mpm::eulerianFluids::startBurning()
{
    boolList charge(mesh_.nCells());
    for (const label k : burning_)
    {
        forAll(charge, c)
        {
            charge[c] = mass_[n_*c + k] > 0;
        }
        mixture_.detonates(k)->start(mesh_, charge, !restarted_);
    }
}


void Foam::mpm::eulerianFluids::updateBurntFields()
{
    forAll(burning_, j)
    {
        volScalarField& F = F_[j];
        forAll(F, c)
        {
            F[c] = burnt_[n_*c + burning_[j]];
        }
        F.correctBoundaryConditions();
    }
}


void Foam::mpm::eulerianFluids::updateBurntBehind()
{
    scalarField F(burning_.size() ? Wb_.size() : 0);
    const label nInternal = mesh_.nInternalFaces();
    forAll(burning_, j)
    {
        forAll(F, i)
        {
            const label P = mesh_.faceOwner()[nInternal + i];
            F[i] = burnt_[n_*P + burning_[j]];
        }
        for (const fvPatchScalarField& b : F_[j].boundaryField())
        {
            const label start = b.patch().start() - nInternal;
            if (b.fixesValue() && !b.coupled())
            {
                forAll(b, i)
                {
                    F[start + i] = b[i];
                }
            }
        }
        if (!coupled_.empty())
        {
            coupled_.swap(F);
        }
        forAll(F, i)
        {
            burntB_[n_*i + burning_[j]] = F[i];
        }
    }
}


void Foam::mpm::eulerianFluids::addBurnt
(
    const label k,
    const label f,
    const scalar flux
)
{
    forAll(burning_, j)
    {
        if (burning_[j] == k)
        {
            burntOut_[j][mesh_.faceOwner()[f]] += flux;
            if (f < mesh_.nInternalFaces())
            {
                burntOut_[j][mesh_.faceNeighbour()[f]] -= flux;
            }
        }
    }
}


void Foam::mpm::eulerianFluids::burn(const scalar dt)
{
    const labelList& slot = interfaces_->slot();
    const labelList& single = interfaces_->single();
    DynamicList<label> cells;
    DynamicList<scalar> p, F;
    forAll(burning_, j)
    {
        const label k = burning_[j];
        cells.clear();
        p.clear();
        F.clear();
        forAll(slot, c)
        {
            const label s = slot[c];
            if (s < 0 && single[c] != k)
            {
                continue;
            }
            const scalar h = dt/mesh_.V()[c];
            const scalar m =
                s < 0 ? rho_[c] - h*sums_[c].rho : shares_[n_*s + k].m;
            const scalar was = burnt_[n_*c + k];
            const scalar mF = mass_[n_*c + k]*was - h*burntOut_[j][c];
            if (m > 0)
            {
                cells.append(c);
                p.append(W_[c].p);
                F.append(mF < (1 - 1e-9)*m ? max(mF/m, scalar(0)) : 1);
            }
        }
        mixture_.detonates(k)->burn(cells, p, mesh_.time().value(), dt, F);
        forAll(cells, i)
        {
            const label c = cells[i];
            burnt_[n_*c + k] = F[i];
            if (slot[c] >= 0)
            {
                shares_[n_*slot[c] + k].F = F[i];
            }
        }
        burntOut_[j] = 0;
    }
}


void Foam::mpm::eulerianFluids::columnsFilled(const labelUList& cells)
{
    for (const label c : cells)
    {
        relaxedP_[c] = -1;
    }
    for (const label k : burning_)
    {
        for (const label c : cells)
        {
            const label i = n_*c + k;
            if (mass_[i] > 0)
            {
                burnt_[i] = min(max(burntMass_[i]/mass_[i], 0.0), 1.0);
            }
        }
    }
}


Foam::scalar Foam::mpm::eulerianFluids::burntShare(const label k) const
{
    scalar all = 0, burnt = 0;
    forAll(W_, c)
    {
        const scalar m = mesh_.V()[c]*mass_[n_*c + k];
        all += m;
        burnt += m*burnt_[n_*c + k];
    }
    reduce(all, sumOp<scalar>());
    reduce(burnt, sumOp<scalar>());
    return all > 0 ? burnt/all : 0;
}

// ************************************************************************* //
