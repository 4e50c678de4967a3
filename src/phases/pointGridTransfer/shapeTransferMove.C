/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Description
    Included by shapeTransfer.H.

\*---------------------------------------------------------------------------*/

namespace Foam::mpm
{

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<template<int> class Shape, int DIM, bool HOOP>
MPM_INLINE void shapeTransfer<Shape, DIM, HOOP>::workSums::add(
    const scalar* mass, const column* bodyForce, const label p, const int n, const T (&v)[DIM],
    const T (&du)[DIM])
{
    // Lanes beyond n may hold anything
    const auto own = firstLanes<W>(n);
    const T none = {};
    const T m = select(own, load<W>(mass + p), none);
    for (int d = 0; d < DIM; ++d)
    {
        const T w = m * select(own, v[d] + 0.5 * du[d], none);
        work += w * select(own, du[d], none);
        momentum[d] += w;
        if (bodyForce)
        {
            body += w * select(own, load<W>((*bodyForce)[d] + p), none);
        }
    }
}

template<template<int> class Shape, int DIM, bool HOOP>
MPM_INLINE void
shapeTransfer<Shape, DIM, HOOP>::workSums::write(const pointGrid& grid, moveResult& result) const
{
    for (int l = 0; l < W; ++l)
    {
        result.work += work[l];
        result.bodyWork += body[l];
        for (int d = 0; d < DIM; ++d)
        {
            result.momentum[grid.direction(d)] += momentum[d][l];
        }
    }
}

template<template<int> class Shape, int DIM, bool HOOP>
MPM_INLINE void shapeTransfer<Shape, DIM, HOOP>::leave(
    const label celli, const label point, const int lane, const T (&X)[DIM], const T& way,
    movedPoints& to, leavers& all) const
{
    leaver& of = all.of[all.n++];
    bool finite = true;
    for (int d = 0; d < 3; ++d)
    {
        of.x[d] = d < DIM ? X[d < DIM ? d : 0][lane] : 0;
        finite = finite && std::isfinite(of.x[d]);
    }
    if (HOOP && of.x[radial_] < 0)
    {
        of.x[radial_] = -of.x[radial_];
        to.U[radial_][point] = -to.U[radial_][point];
        if (to.displacement[radial_])
        {
            to.displacement[radial_][point] += 2 * of.x[radial_];
        }
    }
    of.cell = celli;
    of.point = point;
    of.finite = finite;
    of.near = finite && way[lane] <= 2;
}

template<template<int> class Shape, int DIM, bool HOOP>
MPM_INLINE auto shapeTransfer<Shape, DIM, HOOP>::outside(
    const geometry& geo, const stencil& s, const label p, const int n, const T (&X)[DIM],
    T (&L)[DIM]) const -> laneMask<W>
{
    if constexpr (rememberedBy<shapeType>)
    {
        const laneMask<W> out = shape_.left(s, X, L[0]);
        geo.keep(p, n, L);
        return out;
    }
    else
    {
        return shape_.left(s, X);
    }
}

template<template<int> class Shape, int DIM, bool HOOP>
void shapeTransfer<Shape, DIM, HOOP>::changeCell(
    const moveRule& rule, const leaver& of, label cell, scalar* x, movedPoints& to,
    moveResult& result, DynamicList<materialPointCloud::cellChange>& cellChanges) const
{
    if (cell < 0 && of.finite && rule.outflow && rule.outflow->through(of.cell, of.x))
    {
        cell = outflowPatches::gone;
    }
    scalar back[3] = {of.x[0], of.x[1], of.x[2]}, shift[3] = {0, 0, 0};
    if (cell < 0 && of.finite && rule.walls)
    {
        cell = rule.walls->putBack(of.cell, back, shift);
        for (int d = 0; cell >= 0 && d < DIM; ++d)
        {
            x[d] = back[d];
            if (to.displacement[d])
            {
                to.displacement[d][of.point] += shift[d];
            }
        }
    }
    if (cell < 0)
    {
        result.badPoint = of.point;
        result.left = of.finite;
        return;
    }
    for (int d = 0; d < DIM; ++d)
    {
        to.x[d][of.point] = x[d];
    }
    if (cell != of.cell)
    {
        cellChanges.append(materialPointCloud::cellChange{of.point, cell});
    }
}

template<template<int> class Shape, int DIM, bool HOOP>
void shapeTransfer<Shape, DIM, HOOP>::changeCells(
    const pointGrid& grid, const moveRule& rule, leavers& all, movedPoints& to, moveResult& result,
    DynamicList<materialPointCloud::cellChange>& cellChanges) const
{
    const leaver* of = all.of;
    const label n = all.n;
    all.n = 0;

    // A point that moves too far is not located: the step will be redone
    label cells[together] = {}, nNear = 0;
    scalar x[3 * together];
    for (label i = 0; i < n; ++i)
    {
        if (of[i].near)
        {
            cells[nNear] = of[i].cell;
            std::copy_n(of[i].x, 3, x + 3 * nNear);
            ++nNear;
        }
    }
    if constexpr (together > 1)
    {
        grid.locateAll(nNear, cells, x);
    }
    else if (nNear)
    {
        cells[0] = grid.locate(cells[0], x);
    }

    nNear = 0;
    for (label i = 0; i < n; ++i)
    {
        scalar far[3] = {of[i].x[0], of[i].x[1], of[i].x[2]};
        const bool near = of[i].near;
        changeCell(
            rule, of[i],
            near               ? cells[nNear]
                : of[i].finite ? of[i].cell
                               : -1,
            near ? x + 3 * nNear : far, to, result, cellChanges);
        nNear += near;
    }
}

template<template<int> class Shape, int DIM, bool HOOP>
pointGridTransfer::moveResult shapeTransfer<Shape, DIM, HOOP>::move(
    materialPointCloud& cloud, const moveRule& rule, const nodeVelocities& u,
    DynamicList<materialPointCloud::cellChange>& cellChanges) const
{
    geometry geo(cloud, false);
    const pointGrid& grid = cloud.grid();
    movedPoints to(cloud);
    const scalar* mass = cloud.mass()[0];
    for (const column* used :
         {&cloud.U(), &cloud.xNew(), &cloud.UNew(), &cloud.mass(), cloud.displacement()})
    {
        geo.fetch(used);
    }

    // Only what the coefficients need is gathered
    const moveCoefficients c(rule.take);
    const bool energy = rule.energy;
    const bool needsU = c.needsU(), needsUL = c.needsUL();
    const bool needsDU = c.needsDU() || energy;
    const double dt = rule.dt;

    moveResult result{0, 0, -1, false, 0, Zero, 0};
    T travel = {}, rate = {};
    workSums sums;
    leavers left;
    cellChanges.clear();

    forGroups(
        cloud, [&](const stencil&) {},
        [&](const stencil& s, const label celli, const label p, const int n)
        {
            T X[DIM], L[DIM], v[DIM], V[DIM], dX[DIM];
            geo.load(p, n, X, L);
            weightsType S;
            shape_.evaluate(s, X, L, S);

            T uL[DIM] = {}, du[DIM] = {}, uN[DIM];
            if (needsUL)
            {
                shapeType::template gather<DIM, P>(S, s.nodes, u.UL, uL);
            }
            if (needsDU)
            {
                shapeType::template gather<DIM, P>(S, s.nodes, u.dU, du);
            }
            for (int d = 0; d < DIM; ++d)
            {
                // (7) and (8)
                v[d] = load<W>(to.v[d] + p);
                V[d] = c.a0 * (v[d] + c.a1 * du[d]) + c.a2 * uL[d];
                dX[d] = dt * (c.b0 * v[d] + c.b1 * du[d] + c.b2 * uL[d]);
            }
            if (needsU)
            {
                shapeType::template gather<DIM, P>(S, s.nodes, u.U, uN);
                for (int d = 0; d < DIM; ++d)
                {
                    dX[d] += dt * c.b3 * uN[d];
                }
            }
            if (energy)
            {
                sums.add(mass, rule.bodyForce, p, n, v, du);
            }

            // Lanes beyond n belong to another cell: they do not count
            T way = {}, fast = {};
            for (int d = 0; d < DIM; ++d)
            {
                X[d] += dX[d];
                if (to.displacement[d])
                {
                    storePart<W>(to.displacement[d] + p, dX[d], n);
                }
                const double ih = shape_.inverseWidth(s, d);
                way = laneMax(way, laneAbs(dX[d]) * ih);
                fast = laneMax(fast, laneAbs(V[d]) * ih);
                store<W>(to.x[d] + p, X[d]);
                store<W>(to.U[d] + p, V[d]);
            }
            if (n < W)
            {
                const auto own = firstLanes<W>(n);
                way = select(own, way, T{});
                fast = select(own, fast, T{});
            }
            travel = laneMax(travel, way);
            rate = laneMax(rate, fast);

            const laneMask<W> out = outside(geo, s, p, n, X, L);
            if (anyOf<W>(out))
            {
                for (int l = 0; l < n; ++l)
                {
                    if (out[l])
                    {
                        leave(celli, p + l, l, X, way, to, left);
                        if (left.n == together)
                        {
                            changeCells(grid, rule, left, to, result, cellChanges);
                        }
                    }
                }
            }
        },
        [&](const stencil&) {});
    changeCells(grid, rule, left, to, result, cellChanges);

    result.travel = horizontalMax(travel);
    result.rate = horizontalMax(rate);
    sums.write(grid, result);
    return result;
}

} // End namespace Foam::mpm
