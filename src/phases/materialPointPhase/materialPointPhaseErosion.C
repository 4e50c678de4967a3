// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "materialPointPhase.H"
#include "outflowPatches.H"
#include "pointGridTransfer.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::mpm::erodedPoints
Foam::mpm::materialPointPhase::erode(const scalar dt, materialPointCloud* debris)
{
    const int D = cloud_.grid().nDim();
    const pointBlock all(block());
    scalar* failedTime = failedTime_ < 0 ? nullptr : all.history[failedTime_];
    for (label p = 0; failedTime && p < all.n; ++p)
    {
        failedTime[p] += all.damage[p] >= 1 ? dt : 0;
    }

    scalarList speed, width;
    findSpeeds(speed, width);
    erosionBlock b{all,
                   {},
                   failedTime,
                   cloud_.start(),
                   {},
                   {},
                   speed.size() ? speed.cdata() : nullptr,
                   width.cdata()};
    for (int d = 0; d < D; ++d)
    {
        b.U[d] = cloud_.U()[d];
        b.x[d] = cloud_.x()[d];
        b.axis[d] = cloud_.grid().direction(d);
    }
    boolList gone(all.n, false);
    erosion_->mark(b, gone);

    erodedPoints sums;
    if (!gone.found(true))
    {
        return sums;
    }
    DynamicList<label> cells;
    for (label p = 0; debris && p < all.n; ++p)
    {
        if (gone[p])
        {
            cells.append(cloud_.cellOf(p));
        }
    }
    const label n = cloud_.remove(gone);
    sums = sumOf(cloud_.size(), n);
    if (debris)
    {
        debris->take(cloud_, cells);
    }
    return sums;
}

Foam::label Foam::mpm::materialPointPhase::fastestPoint()
{
    if (fastestBlock_ < 0 || motion_)
    {
        return -1;
    }

    // Within the block, unless points have eroded since
    const pointBlock all(block());
    const label last = min(cloud_.size(), fastestBlock_ + label(pointGridTransfer::largestBlock));
    label fastest = -1;
    scalar most = 0;
    for (label p = fastestBlock_; p < last; ++p)
    {
        const scalar h = cloud_.grid().shortestSide(cloud_.cellOf(p));
        const scalar c = law_->waveSpeedOf(all, p, h);
        if (c > most)
        {
            most = c;
            fastest = p;
        }
    }
    return fastest;
}

Foam::scalar Foam::mpm::materialPointPhase::shortestSide() const
{
    const pointGrid& grid = cloud_.grid();
    if (grid.sameWidth() > 0)
    {
        return grid.sameWidth();
    }
    scalar shortest = GREAT;
    for (const label celli : cloud_.cells())
    {
        shortest = min(shortest, grid.shortestSide(celli));
    }
    return shortest;
}

Foam::scalar Foam::mpm::materialPointPhase::waveRate(const vector& g, const scalar h) const
{
    if (!motion_)
    {
        return waveSpeed_ / h;
    }
    return motion()->free() ? std::sqrt(mag(g) / shortestSide()) : 0;
}

Foam::scalar Foam::mpm::materialPointPhase::largestSpeed(const label p) const
{
    scalar largest = 0;
    for (int d = 0; d < cloud_.grid().nDim(); ++d)
    {
        largest = max(largest, mag(cloud_.U()[d][p]));
    }
    return largest;
}

void Foam::mpm::materialPointPhase::findSpeeds(scalarList& speed, scalarList& width)
{
    if (!erosion_->needsSpeeds(0, GREAT))
    {
        return;
    }
    scalar fastest = 0;
    for (label p = 0; p < cloud_.size(); ++p)
    {
        fastest = max(fastest, largestSpeed(p));
    }
    if (!erosion_->needsSpeeds(shortestSide(), fastest + waveSpeed_))
    {
        return;
    }

    const pointBlock all(block());
    speed.setSize(cloud_.size());
    width.setSize(cloud_.size());
    forAll(cloud_.cells(), k)
    {
        const scalar h = cloud_.grid().shortestSide(cloud_.cells()[k]);
        for (label p = cloud_.start()[k]; p < cloud_.start()[k + 1]; ++p)
        {
            speed[p] = largestSpeed(p) + law_->waveSpeedOf(all, p, h);
            width[p] = h;
        }
    }
}

Foam::mpm::erodedPoints
Foam::mpm::materialPointPhase::leave(const UList<materialPointCloud::cellChange>& cellChanges)
{
    erodedPoints sums;
    label p = cloud_.size();
    for (const materialPointCloud::cellChange& mv : cellChanges)
    {
        if (mv.cell == outflowPatches::gone)
        {
            sums += sumOf(p, 1);
        }
        p += mv.cell >= cloud_.grid().nCells();
    }
    return sums;
}

Foam::mpm::erodedPoints Foam::mpm::materialPointPhase::sumOf(const label first, const label n)
{
    erodedPoints sums;
    sums.n = n;
    sums.stored = storedEnergy(cloud_.block(first, n));
    for (label p = first; p < first + n; ++p)
    {
        const scalar m = cloud_.mass()[0][p];
        const vector U(cloud_.velocity(p));
        sums.mass += m;
        sums.momentum += m * U;
        sums.kinetic += 0.5 * m * magSqr(U);
    }
    return sums;
}
