// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "pointContact.H"
#include "largestOfAll.H"
#include "mathematicalConstants.H"

namespace
{

using namespace Foam;

//- Directions about n, nDim each: 3, 6, 9 degrees to both sides; in 3D six at 4.5
//  degrees and six between them at 9
void directionsAbout(const scalar* n, const int nDim, scalar* directions)
{
    constexpr scalar degree = constant::mathematical::pi / 180;
    if (nDim == 2)
    {
        for (int c = 0; c < 6; ++c)
        {
            const scalar angle = (c % 2 ? -3 : 3) * (c / 2 + 1) * degree;
            directions[2 * c] = std::cos(angle) * n[0] - std::sin(angle) * n[1];
            directions[2 * c + 1] = std::sin(angle) * n[0] + std::cos(angle) * n[1];
        }
        return;
    }
    const vector a(n[0], n[1], n[2]);
    const vector across(mag(a.x()) < 0.6 ? vector(1, 0, 0) : vector(0, 1, 0));
    const vector s(normalised(a ^ across)), t(a ^ s);
    for (int c = 0; c < 12; ++c)
    {
        const scalar angle = (c < 6 ? 4.5 : 9) * degree,
                     around = (60 * c + (c < 6 ? 0 : 30)) * degree;
        const vector b(
            std::cos(angle) * a + std::sin(angle) * (std::cos(around) * s + std::sin(around) * t));
        for (int d = 0; d < 3; ++d)
        {
            directions[3 * c + d] = b[d];
        }
    }
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::pointContact::setBalls()
{
    ball_.setSize(nDim_ * grid_.nNodes(), scalar(0));
    const pointField& points = grid_.mesh().points();
    for (const edge& e : grid_.mesh().edges())
    {
        const vector between(e.vec(points));
        for (const label pointi : {e.first(), e.second()})
        {
            const label n = grid_.pointToNode()[pointi];
            for (int d = 0; n >= 0 && d < nDim_; ++d)
            {
                scalar& R = ball_[nDim_ * n + d];
                R = max(R, 1.2 * mag(between[grid_.direction(d)]));
            }
        }
    }
    fields_[0].largestOfShared(ball_.data(), nDim_, nDim_);
}

void Foam::mpm::pointContact::addBall(
    const label node, const scalar* x, const scalar v, scalar* g) const
{
    const scalar* R = ball_.cdata() + nDim_ * node;
    scalar dx[3], w = 1;
    for (int d = 0; d < nDim_; ++d)
    {
        dx[d] = distance(node, x, d) / R[d];
        w -= sqr(dx[d]);
    }
    for (int d = 0; w > 0 && d < nDim_; ++d)
    {
        g[d] -= v * w * dx[d] / R[d];
    }
}

void Foam::mpm::pointContact::chooseNormals(
    const contactPair& pair, const label first, const label last, scalarList& weighted)
{
    const int stride = fields_[pair.a].stride();

    // Of the normals of both bodies the one with the wider gap: along the
    // side of a block it is that of the floor
    for (label i = first; i < last; ++i)
    {
        placeOf_[contactNodes_[i].node] = i;
    }
    for (int side = 0; side < 2; ++side)
    {
        forMeetings(
            side == 0 ? pair.a : pair.b,
            [&](const label place, const scalar* x, const scalar* l, const scalar)
            {
                contactNode m = contactNodes_[place];
                for (int of = 0; of < 2; ++of)
                {
                    const scalar* g =
                        gradient_[of == 0 ? pair.a : pair.b].cdata() + stride * m.node;
                    for (int d = 0; d < nDim_; ++d)
                    {
                        m.n[d] = of == 0 ? g[d] : -g[d];
                    }
                    scalar& e = reach_[nReach_ * m.node + 2 * of + side];
                    e = max(e, reach(m, x, l)[side]);
                }
            });
    }
    fields_[pair.a].largestOfShared(reach_.data(), nReach_, 4);

    for (label i = first; i < last; ++i)
    {
        contactNode& m = contactNodes_[i];
        scalar size[2] = {0, 0};
        for (int d = 0; d < nDim_; ++d)
        {
            size[0] += sqr(gradient_[pair.a][stride * m.node + d]);
            size[1] += sqr(gradient_[pair.b][stride * m.node + d]);
        }
        scalar* e = reach_.data() + nReach_ * m.node;
        size[0] = max(std::sqrt(size[0]), VSMALL);
        size[1] = max(std::sqrt(size[1]), VSMALL);
        const bool ofB = size[0] <= VSMALL
            || (size[1] > VSMALL && (e[2] + e[3]) * size[0] < (e[0] + e[1]) * size[1]);
        const scalar* g = gradient_[ofB ? pair.b : pair.a].cdata() + stride * m.node;
        for (int d = 0; d < nDim_; ++d)
        {
            m.n[d] = (ofB ? -g[d] : g[d]) / size[ofB];
            weighted[stride * m.node + d] = m.n[d] * min(size[0], size[1]);
        }
        e[0] = e[1] = e[2] = e[3] = -GREAT;
    }
}

void Foam::mpm::pointContact::widenGaps(
    const contactPair& pair, const label first, const label last)
{
    if (nDim_ == 1)
    {
        return;
    }

    // Wide ones stay open in this step, and 9 degrees do not open those that are
    // far below 0
    widened_.clear();
    for (label i = first; i < last; ++i)
    {
        const contactNode& m = contactNodes_[i];
        if (mag(m.gap) < 0.4 * ball_[nDim_ * m.node])
        {
            placeOf_[m.node] = widened_.size();
            widened_.append(i);
        }
    }
    if (!onAny(!widened_.empty()))
    {
        return;
    }
    const int count = nDim_ == 3 ? 12 : 6;
    directions_.resize(nDim_ * count * widened_.size());
    extents_.resize(4 * count * widened_.size());
    extents_ = -GREAT;
    forAll(widened_, k)
    {
        directionsAbout(
            contactNodes_[widened_[k]].n, nDim_, directions_.data() + nDim_ * count * k);
    }
    for (int side = 0; side < 2; ++side)
    {
        const scalar sign = side == 0 ? 1 : -1;
        forMeetings(
            side == 0 ? pair.a : pair.b,
            [&](const label k, const scalar* x, const scalar* l, const scalar)
            {
                const label node = contactNodes_[widened_[k]].node;
                const scalar* n = directions_.cdata() + nDim_ * count * k;
                scalar* e = extents_.data() + 4 * count * k + side;
                e += inBall(node, x) ? 0 : 2;
                scalar dx[3] = {0, 0, 0};
                for (int d = 0; d < nDim_; ++d)
                {
                    dx[d] = sign * distance(node, x, d);
                }
                for (int c = 0; c < count; ++c, n += nDim_, e += 4)
                {
                    scalar along = 0, R = 0;
                    for (int d = 0; d < nDim_; ++d)
                    {
                        along += dx[d] * n[d];
                        R += sqr(l[d] * n[d]);
                    }
                    *e = max(*e, along + std::sqrt(R));
                }
            });
    }
    for (const label i : widened_)
    {
        placeOf_[contactNodes_[i].node] = -1;
    }

    // Two directions in a message
    for (int c = 0; c < count; c += 2)
    {
        forAll(widened_, k)
        {
            std::copy_n(
                extents_.cdata() + 4 * (count * k + c), 8,
                reach_.data() + nReach_ * contactNodes_[widened_[k]].node);
        }
        fields_[pair.a].largestOfShared(reach_.data(), nReach_, 8);
        for (const label i : widened_)
        {
            contactNode& m = contactNodes_[i];
            scalar* e = reach_.data() + nReach_ * m.node;
            for (int two = 0; two < 2; ++two, e += 4)
            {
                const scalar sunk =
                    allowed * ball_[nDim_ * m.node] - max(e[0], e[2]) - max(e[1], e[3]);
                const scalar gap = -(e[0] > -GREAT ? e[0] : e[2]) - (e[1] > -GREAT ? e[1] : e[3]);
                m.gap = max(m.gap, min(gap, sunk));
                e[0] = e[1] = e[2] = e[3] = -GREAT;
            }
        }
    }
    if (Pstream::parRun())
    {
        // A node that by rounding another processor alone has widened
        for (const label n : fields_[pair.a].shared().nodes())
        {
            std::fill_n(reach_.data() + nReach_ * n, 8, -GREAT);
        }
    }
}

void Foam::mpm::pointContact::spreadNormals()
{
    label first = 0;
    forAll(pairs_, pairi)
    {
        const contactPair& pair = pairs_[pairi];
        label last = first;
        while (last < contactNodes_.size() && contactNodes_[last].pair == pairi)
        {
            ++last;
        }
        if (pair.b < 0 || mag(pair.how.normal) > 0)
        {
            first = last;
            continue;
        }
        velocityField& A = fields_[pair.a];
        const int stride = A.stride();

        scalarList& from = impulse_[pair.a];
        scalarList& to = impulse_[pair.b];
        chooseNormals(pair, first, last, from);
        for (const label fieldi : {pair.a, pair.b})
        {
            forPoints(
                fieldi,
                [&](const materialPointCloud& cloud, const label p, const scalar*, const scalar*,
                    const UList<label>& nodes, const UList<scalar>& S)
                {
                    scalar g[3] = {0, 0, 0};
                    forAll(nodes, i)
                    {
                        for (int d = 0; d < nDim_; ++d)
                        {
                            g[d] += S[i] * from[stride * nodes[i] + d];
                        }
                    }
                    const scalar v = cloud.volume()[0][p];
                    forAll(nodes, i)
                    {
                        for (int d = 0; d < nDim_; ++d)
                        {
                            to[stride * nodes[i] + d] += v * S[i] * g[d];
                        }
                    }
                });
        }
        A.sumColumn(to.data());
        for (label i = first; i < last; ++i)
        {
            contactNode& m = contactNodes_[i];
            placeOf_[m.node] = -1;
            scalar size = 0;
            for (int d = 0; d < nDim_; ++d)
            {
                size += sqr(to[stride * m.node + d]);
            }
            for (int d = 0; size > 0 && d < nDim_; ++d)
            {
                m.n[d] = to[stride * m.node + d];
            }
        }
        for (const label fieldi : {pair.a, pair.b})
        {
            for (const label n : fields_[fieldi].active())
            {
                for (int d = 0; d < nDim_; ++d)
                {
                    from[stride * n + d] = to[stride * n + d] = 0;
                }
            }
        }
        first = last;
    }
}
