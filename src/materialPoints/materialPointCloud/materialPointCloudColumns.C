// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "materialPointCloud.H"
#include "pointBlock.H"
#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::mpm::cloudColumn& Foam::mpm::materialPointCloud::declare(
    const word& name, const column::kinds kind, const columnRules& rules)
{
    autoPtr<cloudColumn> c(new cloudColumn(name, kind, grid_.nDim(), rules));
    if (columns_.size() && columns_.first()[0])
    {
        c->grow(columns_.first().capacity(), 0);
        c->fill(0, n_);
    }
    columns_.append(c.ptr());
    return columns_.last();
}

void Foam::mpm::materialPointCloud::reserve(label n)
{
    if (n > x_.capacity() || x_.capacity() == 0)
    {
        // Grow by a tenth at least: a full cloud is likely to grow again
        n = max(n, label(1.1 * x_.capacity()));
        const label nOld = n_ + nArrived_;
        for (cloudColumn& c : columns_)
        {
            c.grow(n, nOld);
        }
        scratch_ = alignedArray(n + column::padding);
    }
}

template<class Column, class Function>
void Foam::mpm::materialPointCloud::forComponents(
    Column& c, const label pointi, const Function& f) const
{
    // Computed directions first, the others after them
    const int D = grid_.nDim();
    int dir[3];
    bool used[3] = {false, false, false};
    for (int d = 0; d < D; ++d)
    {
        dir[d] = grid_.direction(d);
        used[dir[d]] = true;
    }
    for (int d = D, e = 0; d < 3; ++d)
    {
        while (used[e])
            ++e;
        dir[d] = e;
        used[e] = true;
    }

    const column::kinds kind = c.kind();
    for (int i = 0; i < 3; ++i)
    {
        for (int j = 0; j < 3; ++j)
        {
            const bool inside = i < D && j < D;
            if (inside || (kind == column::stresses && i == j))
            {
                const int slot = kind == column::stresses ? symmSlot(i, j)
                    : kind == column::strains             ? strainSlot(D, i, j)
                                                          : i * D + j;
                f(c[slot][pointi], 3 * dir[i] + dir[j]);
            }
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::mpm::cloudColumn& Foam::mpm::materialPointCloud::need(
    const word& name, const column::kinds kind, const columnRules& rules)
{
    cloudColumn* c = findColumn(name);
    if (c && c->kind() != kind)
    {
        FatalErrorInFunction << "Column " << name << " of phase " << this->name()
                             << " is asked for with " << column::nComponents(kind, grid_.nDim())
                             << " components, but it is there with " << c->nComponents()
                             << "; give one of both another name." << exit(FatalError);
    }
    return c ? *c : declare(name, kind, rules);
}

Foam::wordList Foam::mpm::materialPointCloud::columnNames() const
{
    wordList names;
    for (const cloudColumn& c : columns_)
    {
        names.append(c.name());
    }
    return names;
}

Foam::mpm::cloudColumn* Foam::mpm::materialPointCloud::findColumn(const word& name)
{
    for (cloudColumn& c : columns_)
    {
        if (c.name() == name)
        {
            return &c;
        }
    }
    return nullptr;
}

void Foam::mpm::materialPointCloud::needHalfSize()
{
    halfSize_ = &need(
        "halfSize", column::vectors,
        columnRules(columnRules::required)
            .positive(VGREAT, "greater than 0 in the computed directions"));
}

void Foam::mpm::materialPointCloud::needDamage()
{
    damage_ = &need(
        "damage", column::scalars,
        columnRules(columnRules::sinceRun).fraction().changesWithStress());
}

void Foam::mpm::materialPointCloud::needStrength()
{
    strength_ = &need("strength", column::scalars, columnRules());
}

void Foam::mpm::materialPointCloud::needReference()
{
    // Absent if another tool made the points: they start where they are
    reference_ = &need(
        "X", column::vectors,
        columnRules(columnRules::sinceRun, "reference position").position().orElse("x"));
}

void Foam::mpm::materialPointCloud::needTemperature()
{
    temperature_ = &need(
        "T", column::scalars,
        columnRules(columnRules::required, "temperature")
            .positive(1e9, "greater than 0 and less than 1e9 K")
            .remedy(
                "heatTransfer",
                "Run setMaterialPoints, with the entry temperature in its regions."));
}

void Foam::mpm::materialPointCloud::needAffine()
{
    // Absent if the time was written with another transfer
    affine_ = &need("C", column::tensors, columnRules(columnRules::optional).withTentative());
}

void Foam::mpm::materialPointCloud::needHistory(const word& name, const column::kinds kind)
{
    if (findColumn(name))
    {
        FatalErrorInFunction << "Column " << name << " of phase " << this->name()
                             << " is asked for twice: the law, the failure model and what else"
                             << " the phase has (heatTransfer: T) do not go together."
                             << exit(FatalError);
    }
    history_.append(&need(name, kind, columnRules(columnRules::sinceRun).changesWithStress()));
}

void Foam::mpm::materialPointCloud::needHint()
{
    hint_ = &need("hint", column::scalars, columnRules());
}

void Foam::mpm::materialPointCloud::needGas()
{
    const columnRules buffer(columnRules().buffer());
    gasVolume_ = &need("gasVolume", column::scalars, columnRules());
    displacement_ = &need("displacement", column::vectors, columnRules());
    gasPressure_ = &need("gasPressure", column::scalars, buffer);
    gasForce_ = &need("gasForce", column::vectors, buffer);
}

Foam::mpm::pointBlock Foam::mpm::materialPointCloud::block(const label first, const label n)
{
    pointBlock b;
    b.nDim = grid_.nDim();
    b.n = n;
    b.dt = 0;
    for (const scalar*& l : b.dL)
    {
        l = nullptr;
    }
    b.mass = mass_[0] + first;
    b.volume = volume_[0] + first;
    b.id = id_[0] + first;
    b.phase = name().c_str();
    for (int i = 0; i < nStress(b.nDim); ++i)
    {
        b.stress[i] = stress_[i] + first;
    }
    int h = 0;
    for (column& c : history_)
    {
        for (int i = 0; i < c.nComponents(); ++i)
        {
            b.history[h++] = c[i] + first;
        }
    }
    b.damage = damage_ ? (*damage_)[0] + first : nullptr;
    b.strength = strength_ ? (*strength_)[0] + first : nullptr;

    return b;
}

Foam::scalar Foam::mpm::materialPointCloud::bytesPerPoint() const
{
    // The columns and scratch
    label nDoubles = 1;
    for (const cloudColumn& c : columns_)
    {
        nDoubles += c.nDoubles();
    }
    return (scalar(sizeof(scalar)) * nDoubles * (x_.capacity() + column::padding)
            + sizeof(label)
                * scalar(
                    from_.size() + cells_.size() + start_.size() + oldCells_.size()
                    + oldStart_.size() + count_.size() + first_.size()))
        / max(n_, label(1));
}

Foam::tensor Foam::mpm::materialPointCloud::tensorOf(const column& c, const label pointi) const
{
    tensor t(Zero);
    forComponents(c, pointi, [&](const scalar& a, const int i) { t[i] = a; });
    return t;
}

void Foam::mpm::materialPointCloud::setTensor(column& c, const label pointi, const tensor& t) const
{
    forComponents(c, pointi, [&](scalar& a, const int i) { a = t[i]; });
}

void Foam::mpm::materialPointCloud::setSigma(const label pointi, const symmTensor& sigma)
{
    setTensor(stress_, pointi, tensor(sigma));
}

Foam::vector Foam::mpm::materialPointCloud::vectorOf(const column& c, const label pointi) const
{
    vector v(Zero);
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        v[grid_.direction(d)] = c[d][pointi];
    }
    return v;
}

Foam::vector Foam::mpm::materialPointCloud::velocity(const label pointi) const
{
    return vectorOf(U_, pointi);
}

Foam::symmTensor Foam::mpm::materialPointCloud::sigma(const label pointi) const
{
    return symm(tensorOf(stress_, pointi));
}

void Foam::mpm::materialPointCloud::keepStress()
{
    for (cloudColumn& c : columns_)
    {
        c.keep(n_);
    }
}

void Foam::mpm::materialPointCloud::restoreStress()
{
    for (cloudColumn& c : columns_)
    {
        c.restore(n_);
    }
}
