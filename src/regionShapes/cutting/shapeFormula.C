// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "shapeFormula.H"
#include "List.H"
#include <cmath>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::mpm::shapeFormula::body(const pointRegionShape& shape)
{
    if (withBodies_)
    {
        tokens_.append({'b', bodies_.size()});
        bodies_.append(&shape);
    }
    return withBodies_;
}

int Foam::mpm::shapeFormula::evaluate(const label celli, const UList<int>& inside) const
{
    int stack[64];
    int n = 0;
    for (const token& t : tokens_)
    {
        switch (t.kind)
        {
        case 's':
            stack[n++] = inside[t.index];
            break;
        case 'b':
            stack[n++] = inside[surfaces_.size() + t.index];
            break;
        case 'c':
            stack[n++] = cells_[t.index](celli) ? 1 : 0;
            break;
        case '!':
            stack[n - 1] = stack[n - 1] == 2 ? 2 : 1 - stack[n - 1];
            break;
        default:
        {
            const int a = stack[n - 2], b = stack[n - 1];
            const int decides = t.kind == '&' ? 0 : 1;
            stack[--n - 1] = a == decides || b == decides ? decides
                : a == 2 || b == 2                        ? 2
                                                          : 1 - decides;
        }
        }
    }
    return stack[0];
}

void Foam::mpm::shapeFormula::surface(const quadratic& f)
{
    tokens_.append({'s', surfaces_.size()});
    surfaces_.append(f);
}

void Foam::mpm::shapeFormula::cells(const std::function<bool(label)>& f)
{
    tokens_.append({'c', cells_.size()});
    cells_.append(f);
}

void Foam::mpm::shapeFormula::andLast() { tokens_.append({'&', 0}); }

void Foam::mpm::shapeFormula::orLast() { tokens_.append({'|', 0}); }

void Foam::mpm::shapeFormula::notLast() { tokens_.append({'!', 0}); }

bool Foam::mpm::shapeFormula::contains(const label celli, const scalar* x) const
{
    List<int> inside(surfaces_.size());
    forAll(inside, i)
    {
        inside[i] = surfaces_[i].value(x) <= 0 ? 1 : 0;
    }
    return evaluate(celli, inside) == 1;
}

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

namespace
{

//- Gauss-Kronrod rule of 15 points, the odd ones that of Gauss of 7
constexpr double node[8] = {
    0.991455371120812639206854697526329, 0.949107912342758524526189684047851,
    0.864864423359769072789712788640926, 0.741531185599394439863864773280788,
    0.586087235467691130294144691693013, 0.405845151377397166906606412076961,
    0.207784955007898467600689403773245, 0};
constexpr double kronrod[8] = {
    0.022935322010529224963732008058970, 0.063092092629978553290700663189204,
    0.104790010322250183839876322541518, 0.140653259715525918745189590510238,
    0.169004726639267902826583426598550, 0.190350578064785409913256402421014,
    0.204432940075298892414161999234649, 0.209482141084727828012999174891714};
constexpr double gauss[4] = {
    0.129484966168869693270611432679082, 0.279705391489276667901467771423780,
    0.381830050505118944950369775488975, 0.417959183673469387755102040816327};

}

struct Foam::mpm::shapeFormula::integral
{
    const shapeFormula& formula;
    const label celli;
    const int nDim;

    //- Direction of the radius and its half-size over the radius at the middle
    const int radial;
    const scalar growth;

    //- Surfaces that cut, and where they stand in the formula
    List<quadratic> cut;
    List<label> place;
    List<int> inside;

    //- Directions from that of the columns on; breaks across them
    int order[3];
    DynamicList<quadratic> breaks[3];

    //- Does a surface turn back along a direction? Roots at the breaks then
    bool turns[3] = {false, false, false};

    integral(const shapeFormula& f, const label c, const int n, const int rad, const scalar g) :
        formula(f), celli(c), nDim(n), radial(rad), growth(g)
    {
    }

    //- Functions whose zeros part the places along directions from level on
    void project(const int level)
    {
        const DynamicList<quadratic>& from = breaks[level - 1];
        DynamicList<quadratic>& to = breaks[level];
        const int d = order[level - 1];

        const auto keep = [&](const quadratic& q)
        {
            if (q.sign() == 0)
            {
                to.append(q);
            }
        };
        forAll(from, i)
        {
            keep(from[i].fixed(d, -1));
            if (!from[i].dependsOn(d))
            {
                continue;
            }
            keep(from[i].fixed(d, 1));
            if (!from[i].linear())
            {
                const label n = to.size();
                keep(from[i].discriminant(d));
                turns[level] = turns[level] || to.size() > n;
            }
            for (label j = 0; j < i; ++j)
            {
                // Both zero: the difference is, too
                const quadratic minus(from[i].minus(from[j]));
                const bool plane = from[j].linear();
                const quadratic& p = plane ? from[j] : from[i].linear() ? from[i] : minus;
                const quadratic& q = plane ? from[i] : from[j];
                if (!p.linear())
                {
                    continue;
                }
                keep(p.dependsOn(d) ? q.resultant(p, d) : p);
            }
        }
    }

    //- Along the column through x
    cutMoments column(scalar* x)
    {
        const int d = order[0];
        scalar ends[66];
        int n = 0;
        ends[n++] = -1;
        for (const quadratic& q : cut)
        {
            scalar t[2];
            const int nRoots = q.roots(d, x, t);
            for (int i = 0; i < nRoots && n < 64; ++i)
            {
                if (t[i] > -1 && t[i] < 1)
                {
                    ends[n++] = t[i];
                }
            }
        }
        ends[n++] = 1;
        std::sort(ends, ends + n);

        cutMoments m;
        for (int i = 0; i < n - 1; ++i)
        {
            const scalar a = ends[i], b = ends[i + 1];
            if (!(b > a))
            {
                continue;
            }
            x[d] = 0.5 * (a + b);
            forAll(cut, j)
            {
                inside[place[j]] = cut[j].value(x) <= 0 ? 1 : 0;
            }
            if (formula.evaluate(celli, inside) != 1)
            {
                continue;
            }
            const scalar length = b - a, first = 0.5 * (b * b - a * a);
            m.value[1] += length;
            m.value[0] += radial < 0 ? length
                : radial == d        ? length + growth * first
                                     : length * (1 + growth * x[radial]);
            for (int e = 0; e < nDim; ++e)
            {
                m.value[2 + e] += e == d ? first : length * x[e];
                m.value[5 + e] += e == d ? (b * b * b - a * a * a) / 3 : length * x[e] * x[e];
            }
        }
        return m;
    }

    //- From a to b of a level. Where surfaces turn, positions
    //  a + (b - a)(2 - u)(1 + u)^2/4 make roots at the ends smooth
    cutMoments panel(const int level, const scalar a, const scalar b, scalar* x, const int depth)
    {
        cutMoments fine, coarse;
        const scalar half = 0.5 * (b - a), middle = 0.5 * (a + b);
        for (int i = 0; i < 15; ++i)
        {
            const int k = i < 8 ? i : 14 - i;
            const scalar u = i < 8 ? -node[k] : node[k];
            const bool dense = turns[level];
            x[order[level]] = middle + half * u * (dense ? 1.5 - 0.5 * u * u : 1);
            const cutMoments m(over(level - 1, x));
            const scalar w = half * (dense ? 1.5 * (1 - u * u) : 1);
            fine.add(w * kronrod[k], m);
            if (k % 2)
            {
                coarse.add(w * gauss[k / 2], m);
            }
        }
        // The finer one is good to about (200 difference)^1.5
        const scalar tol = level == 1 ? 1e-10 : 1e-9;
        if (fine.difference(coarse) < tol || depth > 30 || half < 1e-12)
        {
            return fine;
        }
        cutMoments sum(panel(level, a, middle, x, depth + 1));
        sum.add(1, panel(level, middle, b, x, depth + 1));
        return sum;
    }

    //- Over the directions up to a level, those above given in x
    cutMoments over(const int level, scalar* x)
    {
        if (level == 0)
        {
            return column(x);
        }
        constexpr int most = 256;
        scalar ends[most];
        int nEnds = 0;
        ends[nEnds++] = -1;
        ends[nEnds++] = 1;
        for (const quadratic& q : breaks[level])
        {
            scalar t[2];
            const int n = q.roots(order[level], x, t);
            for (int i = 0; i < n && nEnds < most; ++i)
            {
                if (t[i] > -1 && t[i] < 1)
                {
                    ends[nEnds++] = t[i];
                }
            }
        }
        std::sort(ends, ends + nEnds);

        cutMoments sum;
        for (int i = 0; i + 1 < nEnds; ++i)
        {
            if (ends[i + 1] - ends[i] > 1e-14)
            {
                sum.add(1, panel(level, ends[i], ends[i + 1], x, 0));
            }
        }
        return sum;
    }
};

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

int Foam::mpm::shapeFormula::integrate(
    const label celli, const int nDim, const int radial, const scalar* centre, const scalar* half,
    cutMoments& m, DynamicList<label>& cutting) const
{
    cutting.clear();
    scalar c[3] = {0, 0, 0}, h[3] = {0, 0, 0};
    for (int d = 0; d < nDim; ++d)
    {
        c[d] = centre[d];
        h[d] = half[d];
    }

    integral whole(*this, celli, nDim, radial, radial < 0 ? 0 : half[radial] / centre[radial]);
    whole.inside.setSize(surfaces_.size());
    DynamicList<quadratic> cut;
    forAll(surfaces_, i)
    {
        const quadratic q(surfaces_[i].local(c, h));
        const int sign = q.sign();
        whole.inside[i] = sign < 0 ? 1 : sign > 0 ? 0 : 2;
        if (sign == 0)
        {
            cut.append(q);
            cutting.append(i);
        }
    }
    const int known = evaluate(celli, whole.inside);
    if (known < 2)
    {
        cutting.clear();
        return known;
    }
    whole.cut = cut;
    whole.place = cutting;
    whole.breaks[0] = cut;

    // Columns along the largest change of the surfaces over the box
    scalar steep[3] = {0, 0, 0};
    for (const quadratic& q : cut)
    {
        const scalar origin[3] = {0, 0, 0};
        scalar g[3];
        q.gradient(origin, g);
        const scalar size = std::sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
        for (int d = 0; d < nDim && size > 0; ++d)
        {
            steep[d] += std::abs(g[d]) / size;
        }
    }
    for (int d = 0; d < nDim; ++d)
    {
        whole.order[d] = d;
    }
    std::sort(
        whole.order, whole.order + nDim,
        [&](const int a, const int b) { return steep[a] > steep[b]; });
    for (int level = 1; level < nDim; ++level)
    {
        whole.project(level);
    }

    scalar x[3] = {0, 0, 0};
    m = whole.over(nDim - 1, x);
    return 2;
}
