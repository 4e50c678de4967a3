// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "carriedShare.H"
#include "noTraps.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::carriedShare::start(
    const label n, const labelList& of, PtrList<volScalarField>& fields, const label nBoundary,
    const char* what)
{
    if (of.empty())
    {
        return;
    }
    n_ = n;
    of_ = of;
    fields_.transfer(fields);
    cells_.setSize(n * fields_[0].size(), default_);
    behind_.setSize(n * nBoundary, default_);
    out_.setSize(of.size());
    forAll(of_, j)
    {
        const volScalarField& field = fields_[j];
        out_[j].setSize(field.size(), 0);
        const noTraps guard;
        forAll(field, c)
        {
            const scalar s = field[c];
            if (!(s >= 0 && s <= 1))
            {
                FatalErrorInFunction << "Field " << field.name() << " in " << field.objectPath()
                                     << " has the value " << s << " in cell " << c << " at "
                                     << field.mesh().cellCentres()[c] << "; a " << what
                                     << " is in [0, 1]." << exit(FatalError);
            }
            set(c, of_[j], s);
        }
    }
}

void Foam::mpm::carriedShare::add(
    const fvMesh& mesh, const label k, const label f, const scalar m, const label c, const label i)
{
    forAll(of_, j)
    {
        if (of_[j] == k)
        {
            const scalar flux = m * (i < 0 ? of(c, k) : behind(i, k));
            out_[j][mesh.faceOwner()[f]] += flux;
            if (f < mesh.nInternalFaces())
            {
                out_[j][mesh.faceNeighbour()[f]] -= flux;
            }
        }
    }
}

void Foam::mpm::carriedShare::gain(const label k, const label c, const scalar m)
{
    forAll(of_, j)
    {
        out_[j][c] -= of_[j] == k ? m * of(c, k) : 0;
    }
}

void Foam::mpm::carriedShare::updateFields()
{
    forAll(of_, j)
    {
        volScalarField& field = fields_[j];
        forAll(field, c)
        {
            field[c] = of(c, of_[j]);
        }
        field.correctBoundaryConditions();
    }
}

void Foam::mpm::carriedShare::updateBehind(const coupledFaces& coupled)
{
    forAll(of_, j)
    {
        const fvMesh& mesh = fields_[j].mesh();
        const label nInternal = mesh.nInternalFaces();
        scalarField s(behind_.size() / n_);
        forAll(s, i)
        {
            s[i] = of(mesh.faceOwner()[nInternal + i], of_[j]);
        }
        for (const fvPatchScalarField& b : fields_[j].boundaryField())
        {
            if (b.fixesValue() && !b.coupled())
            {
                forAll(b, i)
                {
                    s[b.patch().start() - nInternal + i] = b[i];
                }
            }
        }
        if (!coupled.empty())
        {
            coupled.swap(s);
        }
        forAll(s, i)
        {
            behind_[n_ * i + of_[j]] = s[i];
        }
    }
}

Foam::scalarField& Foam::mpm::carriedShare::fill(const scalarList& mass)
{
    filled_ = cells_;
    forAll(filled_, i)
    {
        filled_[i] *= mass[i];
    }
    return filled_;
}

void Foam::mpm::carriedShare::filled(const labelUList& cells, const scalarList& mass)
{
    for (const label k : of_)
    {
        for (const label c : cells)
        {
            const label i = n_ * c + k;
            if (mass[i] > 0)
            {
                cells_[i] = min(max(filled_[i] / mass[i], 0.0), 1.0);
            }
        }
    }
}

Foam::scalar
Foam::mpm::carriedShare::total(const label k, const scalarList& mass, const scalarField& V) const
{
    scalar all = 0, part = 0;
    forAll(V, c)
    {
        const scalar m = V[c] * mass[n_ * c + k];
        all += m;
        part += m * of(c, k);
    }
    reduce(all, sumOp<scalar>());
    reduce(part, sumOp<scalar>());
    return all > 0 ? part / all : 0;
}
