// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "latticeFraction.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam::mpm
{
defineTypeNameAndDebug(latticeFraction, 0);
addToRunTimeSelectionTable(solidFraction, latticeFraction, dictionary);
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::latticeFraction::makeFaces()
{
    const pointGrid& grid = lattice_.grid();
    forAll(faces_, f)
    {
        const int d = lattice_.direction(f);
        if (d < 0)
        {
            continue;
        }
        const label c = mesh_.faceOwner()[f];
        const scalar S = mag(mesh_.faceAreas()[f]);
        faces_[f].at = lattice_.nPlaces() * d + lattice_.facePlace(f);
        faces_[f].sign = lattice_.sign(f);
        faces_[f].S = S;
        faces_[f].V = lattice_.graded(d) ? S * lattice_.width(f)
            : grid.radial() < 0          ? mesh_.V()[c]
                                         : S * grid.width(c, d);
    }
}

template<int n>
void Foam::mpm::latticeFraction::clear(scalarList& sums) const
{
    const label nPlaces = lattice_.nPlaces();
    for (const label place : live_.places())
    {
        for (label at = n * place; at < sums.size(); at += n * nPlaces)
        {
            for (int i = 0; i < n; ++i)
            {
                sums[at + i] = 0;
            }
        }
    }
}

template<int n>
void Foam::mpm::latticeFraction::add(const scalarList& sums, scalarList& to) const
{
    const label nPlaces = lattice_.nPlaces();
    for (const label place : live_.places())
    {
        for (label at = n * place; at < sums.size(); at += n * nPlaces)
        {
            for (int i = 0; i < n; ++i)
            {
                to[at + i] += sums[at + i];
            }
        }
    }
}

void Foam::mpm::latticeFraction::sumPoints(const bool withDilation)
{
    updateVolumes();
    live_.update(withDilation);
    clear<pointKernels::cellStride>(cell_);
    forAll(points_.phases(), phasei)
    {
        const bool own = ownFace_[phasei].size();
        scalarList& face = own ? ownFace_[phasei] : faceNew_;
        scalarList& cell = own ? ownCell_[phasei] : cell_;
        if (own)
        {
            clear<pointKernels::faceStride>(face);
            clear<pointKernels::cellStride>(cell);
        }
        kernels_->arrive(
            points_.phases()[phasei].cloud(), withDilation ? oldVolume_[phasei].cdata() : nullptr,
            face.data(), cell.data());
        if (own)
        {
            add<pointKernels::faceStride>(face, faceNew_);
            add<pointKernels::cellStride>(cell, cell_);
            sumFaces(face);
            lattice_.sum(cell.data(), pointKernels::cellStride, live_.groups());
        }
    }
    sumFaces(faceNew_);
    lattice_.sum(cell_.data(), pointKernels::cellStride, live_.groups());
}

void Foam::mpm::latticeFraction::sumFaces(scalarList& face) const
{
    for (int d = 0; d < lattice_.grid().nDim(); ++d)
    {
        lattice_.sum(
            face.data() + pointKernels::faceStride * lattice_.nPlaces() * d,
            pointKernels::faceStride, live_.groups());
    }

    // The solid is mirrored at walls
    for (const label facei : lattice_.walls())
    {
        scalar* q = face.data() + pointKernels::faceStride * faces_[facei].at;
        q[pointKernels::volume] *= 2;
        q[pointKernels::mass] *= 2;
        q[pointKernels::flux] = 0;
    }
}

void Foam::mpm::latticeFraction::updateFaces(const scalar dt)
{
    // Of a cell's volume: rounding of the sums
    constexpr scalar nothing = 1e-15;

    for (const label f : live_.faces())
    {
        const faceOfPlace& of = faces_[f];
        const scalar* old = at(face_, f);
        const scalar* now = at(faceNew_, f);
        const scalar sumOld = max(old[pointKernels::volume], scalar(0));
        const scalar sumNow = max(now[pointKernels::volume], scalar(0));
        if (sumOld + sumNow <= nothing * of.V)
        {
            thetaS0_[f] = thetaS_[f] = phiS_[f] = uS_[f] = 0;
            dragLimit_[f] = 0;
            continue;
        }

        const scalar part = (1 - eps_) / of.V;
        const scalar mean = 0.5 * part * (sumOld + sumNow);
        thetaS0_[f] = min(part * sumOld, most_);
        thetaS_[f] = min(mean, most_);
        dragLimit_[f] = mean;

        // S/V is 1/h; the lattice's own 1/h differs from it by rounding, which
        // adds up in the gas fraction
        uS_[f] = of.sign * part * now[pointKernels::flux] / (mean * dt);
        phiS_[f] = uS_[f] * thetaS_[f] * of.S;

        const scalar m = old[pointKernels::mass] + now[pointKernels::mass];
        rhoS_[f] = m / (sumOld + sumNow);
    }
}

void Foam::mpm::latticeFraction::updateCells()
{
    for (const label c : live_.cells())
    {
        const scalar* q = cell_.cdata() + pointKernels::cellStride * lattice_.place(c);
        dilation_[c] = (1 - eps_) * q[pointKernels::dilation] / mesh_.V()[c];
        theta_[c] = (1 - eps_) * q[pointKernels::fraction] / mesh_.V()[c];
    }
    forAll(own_, phasei)
    {
        if (own_[phasei].empty())
        {
            continue;
        }
        for (const label c : live_.cells())
        {
            const label i = pointKernels::cellStride * lattice_.place(c);
            own_[phasei][c] = ownCell_[phasei][i + pointKernels::fraction] / mesh_.V()[c];
        }
    }
}

void Foam::mpm::latticeFraction::limitDrag()
{
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    const auto forCells = [&](const auto& f)
    {
        for (const label facei : live_.faces())
        {
            f(facei, own[facei]);
            if (facei < nei.size())
            {
                f(facei, nei[facei]);
            }
        }
    };
    forCells([&](const label, const label c) { largest_[c] = 0; });
    forCells([&](const label f, const label c) { largest_[c] = max(largest_[c], dragLimit_[f]); });
    const scalarList behind(coupled_.behind(largest_));
    for (const label f : live_.faces())
    {
        const label i = f - nei.size();
        const scalar most = max(largest_[own[f]], i < 0 ? largest_[nei[f]] : behind[i]);
        dragLimit_[f] = most > 0 ? thetaS_[f] / most : 0;
    }
}

void Foam::mpm::latticeFraction::findSurface()
{
    surface_.find(
        [&](const label f) -> vector
        {
            if (faces_[f].at < 0)
            {
                return Zero;
            }
            return blocked(f) * mesh_.faceAreas()[f];
        },
        [](const label) { return false; });
}

template<class Jump>
void Foam::mpm::latticeFraction::sumJumps(
    const UList<scalar>& p, const UList<scalar>& pBehind, const Jump& jump, scalarList& G) const
{
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    clear<1>(G);
    const auto set = [&](const label f)
    {
        const label i = f - nei.size();
        G[faces_[f].at] = jump(f, p[own[f]], i < 0 ? p[nei[f]] : pBehind[i]);
    };
    for (const label f : live_.faces())
    {
        if (f < nei.size())
        {
            set(f);
        }
    }
    for (const label f : lattice_.coupled())
    {
        set(f);
    }
    for (int d = 0; d < lattice_.grid().nDim(); ++d)
    {
        lattice_.sum(G.data() + lattice_.nPlaces() * d, 1, live_.groups());
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::latticeFraction::latticeFraction(
    materialPointSystem& points, const dictionary& gasDict) :
    solidFraction(points, gasDict, points.grid().radial() < 0 ? 0.5 : 1),
    lattice_(points.grid()),
    kernels_(pointKernels::New(lattice_)),
    live_(points, lattice_),
    faces_(mesh_.nFaces()),
    face_(pointKernels::faceStride * lattice_.nPlaces() * points.grid().nDim(), scalar(0)),
    faceNew_(face_.size(), scalar(0)),
    cell_(pointKernels::cellStride * lattice_.nPlaces(), scalar(0)),
    ownFace_(points.phases().size()),
    ownCell_(points.phases().size()),
    P_(lattice_.nPlaces(), scalar(0)),
    G_(lattice_.nPlaces() * points.grid().nDim(), scalar(0)),
    largest_(mesh_.nCells(), 0)
{
    makeFaces();
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::latticeFraction::show(solidOnFaces& pores) const
{
    solidFraction::show(pores);
    pores.faces = &live_.faces();
}

void Foam::mpm::latticeFraction::keepOwn(const label phasei)
{
    solidFraction::keepOwn(phasei);
    ownFace_[phasei].setSize(face_.size(), scalar(0));
    ownCell_[phasei].setSize(cell_.size(), scalar(0));
    ownG_.setSize(G_.size());
}

void Foam::mpm::latticeFraction::initialise()
{
    faceNew_ = 0;
    sumPoints(false);
    updateCells();
    face_.swap(faceNew_);
    findSurface();
}

void Foam::mpm::latticeFraction::setPressure(const UList<scalar>& p, const UList<scalar>& pBehind)
{
    clear<1>(P_);
    for (const label c : live_.cells())
    {
        P_[lattice_.place(c)] = p[c];
    }
    lattice_.sum(P_.data(), 1, live_.groups());

    sumJumps(
        p, pBehind,
        [&](const label f, const scalar pO, const scalar pN) -> scalar
        {
            const faceOfPlace& of = faces_[f];
            const scalar theta = (1 - eps_) * at(face_, f)[pointKernels::volume] / of.V;
            if (!(theta > 0))
            {
                return 0;
            }
            const scalar clip = min(scalar(1), most_ / theta);
            return (1 - eps_) * clip * of.sign * (pN - pO) * of.S / of.V;
        },
        G_);
    pushAnew(p, pBehind);
}

void Foam::mpm::latticeFraction::pushAnew(const UList<scalar>& p, const UList<scalar>& pBehind)
{
    // Share of gas in a nearly full cell
    constexpr scalar full = 0.1;

    const vectorField& S = mesh_.faceAreas();
    for (const label c : pushed_)
    {
        gasPush_[c] = Zero;
    }
    pushed_.clear();
    for (const label c : live_.cells())
    {
        if ((*gasTheta_)[c] < full)
        {
            gasPush_[c] =
                pushOn(c, p, pBehind, [&](const label f) { return (1 - blocked(f)) * S[f]; });
            pushed_.append(c);
        }
    }
}

void Foam::mpm::latticeFraction::gather(const label phasei, const scalarField* pOwn)
{
    if (pOwn)
    {
        const scalarList behind(coupled_.behind(*pOwn));
        sumJumps(
            *pOwn, behind,
            [&](const label f, const scalar pO, const scalar pN) -> scalar
            {
                // v/h is the area; v holds V K_f
                const scalar v = at(ownFace_[phasei], f)[pointKernels::volume];
                return v > 0 && pO != pN ? faces_[f].sign * (pN - pO) * faces_[f].S / v : 0;
            },
            ownG_);
        add<1>(G_, ownG_);
    }
    kernels_->gather(
        points_.phases()[phasei].cloud(), P_.cdata(), pOwn ? ownG_.cdata() : G_.cdata());
}

void Foam::mpm::latticeFraction::depart()
{
    clear<pointKernels::faceStride>(faceNew_);
    for (materialPointPhase& phase : points_.phases())
    {
        kernels_->depart(phase.cloud(), faceNew_.data());
    }
}

void Foam::mpm::latticeFraction::arrive(const scalar dt)
{
    sumPoints(true);
    updateFaces(dt);
    updateCells();
    limitDrag();
    face_.swap(faceNew_);
    findSurface();
}

void Foam::mpm::latticeFraction::updateNormals()
{
    // Difference of the fraction over two cells below which it is uniform
    constexpr scalar uniform = 1e-3;

    const pointGrid& grid = lattice_.grid();
    const int D = grid.nDim();
    const labelList& places = lattice_.places();

    smooth_.setSize(lattice_.nPlaces());
    coarse_.setSize(lattice_.nPlaces());
    smooth_ = 0;
    forAll(places, c)
    {
        smooth_[places[c]] = theta_[c];
    }
    lattice_.sum(smooth_.data(), 1);

    for (int pass = 0; pass < 2 * D; ++pass)
    {
        const int d = pass % D;
        coarse_ = 0;
        forAll(places, c)
        {
            const scalar* q = smooth_.cdata() + places[c];
            coarse_[places[c]] =
                0.5 * q[0] + 0.25 * (q[lattice_.below(c, d)] + q[lattice_.above(c, d)]);
        }
        lattice_.sum(coarse_.data(), 1);
        smooth_.swap(coarse_);
    }

    normals_.setSize(mesh_.nCells());
    forAll(places, c)
    {
        const scalar* q = smooth_.cdata() + places[c];
        vector n(Zero);
        scalar most = 0;
        for (int d = 0; d < D; ++d)
        {
            const scalar difference = q[lattice_.above(c, d)] - q[lattice_.below(c, d)];
            const label i = grid.lattice().ijk(c, d);
            const scalarList& x = grid.lattice().planes(d);
            n[grid.direction(d)] = difference / (x[i + 2] + x[i + 1] - x[i] - x[i - 1]);
            most = max(most, mag(difference));
        }
        normals_[c] = most < uniform ? vector(Zero) : n / mag(n);
    }
}
