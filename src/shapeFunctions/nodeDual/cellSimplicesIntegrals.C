// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "cellSimplices.H"
#include "pointGrid.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::cellSimplices::addSides(const label celli, const label i, scalar* SdS) const
{
    const auto has = [](const label* triangle, const label v)
    { return triangle[0] == v || triangle[1] == v || triangle[2] == v; };
    for (label s = 0; sides_.size() && s + 1 < nSimplices(celli); ++s)
    {
        // Two triangles, the second of them with the vertices of the diagonal
        const label facei = faceOf(celli, s);
        const label *a = corners(celli) + 3 * s, *b = a + 3;
        if (facei < 0 || faceOf(celli, s + 1) != facei || !sides_.test(facei)
            || !(has(a, i) || has(b, i)))
        {
            continue;
        }
        for (int d = 0; d < 3; ++d)
        {
            // A twelfth of the area, one quarter of it for this vertex
            scalar part = 0;
            for (int k = 0; k < 6; ++k)
            {
                part += volumes(celli)[s + k / 3] * inverses(celli)[9 * s + 3 * k + d] / 16;
            }
            for (int k = 0; k < 3; ++k)
            {
                SdS[3 * a[k] + d] += has(b, a[k]) ? -part : part;
                SdS[3 * b[k] + d] += has(a, b[k]) ? 0 : part;
            }
        }
    }
}

void Foam::mpm::cellSimplices::sides(const label celli, const label i, scalar* h) const
{
    for (int d = 0; d < nDim_; ++d)
    {
        h[d] = 2 * (origin(celli)[d] - position(celli, i)[d]);
    }
}

Foam::mpm::cellSimplices::regions Foam::mpm::cellSimplices::regionsOf(const label celli) const
{
    const label n = nVertices(celli);
    const auto vertex = [&](const label i)
    {
        const scalar* x = position(celli, i % n);
        return vector2D(x[0], x[1]);
    };
    vector2D mean(Zero);
    for (label i = 0; i < n; ++i)
    {
        mean += vertex(i) / n;
    }

    // Gradients of the two vertices of a side in its triangle with the mean;
    // of S_i there they have their share and 1/n of the mean's
    struct side
    {
        vector2D a, b;
    };
    List<side> sides(n);
    const auto first = [&](const label i, const label k) { return scalar(i == k) - 1.0 / n; };
    const auto second = [&](const label i, const label k)
    { return scalar(i == (k + 1) % n) - 1.0 / n; };

    regions r;
    r.size.setSize(n);
    r.S.setSize(n * n);
    r.dS.setSize(n * n, vector2D(Zero));
    scalarList A(n, Zero);
    List<vector2D> moment(n, vector2D(Zero));
    for (label k = 0; k < n; ++k)
    {
        const vector2D a(vertex(k) - mean), b(vertex(k + 1) - mean);
        const scalar twice = a.x() * b.y() - a.y() * b.x();
        sides[k].a = vector2D(b.y(), -b.x()) / twice;
        sides[k].b = vector2D(-a.y(), a.x()) / twice;
        for (const bool end : {false, true})
        {
            const label at = (k + end) % n;
            const vector2D centre(((end ? b : a) + 0.5 * (a + b)) / 3);
            A[at] += 0.25 * twice;
            moment[at] += 0.25 * twice * (mean + centre);
            for (label i = 0; i < n; ++i)
            {
                r.dS[n * at + i] +=
                    0.25 * twice * (first(i, k) * sides[k].a + second(i, k) * sides[k].b);
            }
        }
    }
    for (label k = 0; k < n; ++k)
    {
        // The centroid is in one of the two triangles at the vertex
        const vector2D x(moment[k] / A[k]);
        const label before = (k + n - 1) % n;
        const auto least = [&](const label s)
        { return min(sides[s].a & (x - mean), sides[s].b & (x - mean)); };
        const label s = least(k) >= least(before) ? k : before;
        r.size[k] = A[k] * x[radial_];
        for (label i = 0; i < n; ++i)
        {
            r.S[n * k + i] = 1.0 / n + first(i, s) * (sides[s].a & (x - mean))
                + second(i, s) * (sides[s].b & (x - mean));
            r.dS[n * k + i] /= A[k];
        }
    }
    return r;
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::mpm::cellSimplices::integral(const label celli, const label i) const
{
    if (box_[celli])
    {
        scalar h[3], volume = 1;
        sides(celli, i, h);
        for (int d = 0; d < nDim_; ++d)
        {
            volume *= mag(h[d]) / 2;
        }
        return volume;
    }
    if (radial_ >= 0)
    {
        const regions r(regionsOf(celli));
        scalar sum = 0;
        forAll(r.size, k)
        {
            sum += r.size[k] * r.S[r.size.size() * k + i];
        }
        return sum;
    }
    const scalar b = originShare(celli, i);
    const label* corner = corners(celli);
    scalar sum = 0;
    for (label s = 0; s < nSimplices(celli); ++s, corner += nDim_)
    {
        scalar share = b;
        for (int k = 0; k < nDim_; ++k)
        {
            share += corner[k] == i;
        }
        sum += share * volumes(celli)[s] / (nDim_ + 1);
    }
    return sum;
}

void Foam::mpm::cellSimplices::integrals(const label celli, const label i, scalar* SdS) const
{
    const label n = nVertices(celli);
    if (box_[celli])
    {
        // int S_i S_j = h/3 or h/6, int S_i dS_j/dx = 1/2 towards j
        scalar hi[3], hj[3];
        sides(celli, i, hi);
        for (label j = 0; j < n; ++j)
        {
            sides(celli, j, hj);
            for (int d = 0; d < nDim_; ++d)
            {
                scalar& sum = SdS[nDim_ * j + d];
                sum = hj[d] > 0 ? -0.5 : 0.5;
                for (int e = 0; e < nDim_; ++e)
                {
                    if (e != d)
                    {
                        sum *= mag(hi[e]) / (hi[e] * hj[e] > 0 ? 3 : 6);
                    }
                }
            }
        }
        return;
    }
    if (radial_ >= 0)
    {
        const regions r(regionsOf(celli));
        std::fill_n(SdS, n * nDim_, 0.0);
        for (label k = 0; k < n; ++k)
        {
            for (label j = 0; j < n; ++j)
            {
                for (int d = 0; d < nDim_; ++d)
                {
                    SdS[nDim_ * j + d] += r.size[k] * r.S[n * k + i] * r.dS[n * k + j][d];
                }
            }
        }
        return;
    }
    const scalar b = originShare(celli, i);
    const label* corner = corners(celli);
    const scalar* I = inverses(celli);
    scalar ofOrigin[3] = {0, 0, 0};
    std::fill_n(SdS, n * nDim_, 0.0);
    for (label s = 0; s < nSimplices(celli); ++s)
    {
        scalar share = b;
        for (int k = 0; k < nDim_; ++k)
        {
            share += corner[k] == i;
        }
        share *= volumes(celli)[s] / (nDim_ + 1);
        for (int k = 0; k < nDim_; ++k)
        {
            for (int d = 0; d < nDim_; ++d)
            {
                SdS[nDim_ * corner[k] + d] += share * I[nDim_ * k + d];
                ofOrigin[d] -= share * I[nDim_ * k + d];
            }
        }
        corner += nDim_;
        I += nDim_ * nDim_;
    }
    for (label j = 0; j < n; ++j)
    {
        for (int d = 0; d < nDim_; ++d)
        {
            SdS[nDim_ * j + d] += originShare(celli, j) * ofOrigin[d];
        }
    }
    addSides(celli, i, SdS);
}
