// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "farLayer.H"
#include "indexedOctree.H"
#include "treeDataPoint.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Twice the integral of sigma/c over the layer
constexpr scalar damping = 8;

//- All processors' panels
List<mpm::farLayer::panel> ofAll(const UList<mpm::farLayer::panel>& here)
{
    List<scalarList> sent(Pstream::nProcs());
    scalarList& mine = sent[Pstream::myProcNo()];
    DynamicList<scalar> numbers;
    for (const mpm::farLayer::panel& a : here)
    {
        for (direction d = 0; d < 3; ++d)
        {
            numbers.append(a.centre[d]);
        }
        for (direction d = 0; d < 3; ++d)
        {
            numbers.append(a.n[d]);
        }
        numbers.append(a.radius);
        numbers.append(a.thickness);
        numbers.append(a.u);
    }
    mine.transfer(numbers);
    Pstream::gatherList(sent);
    Pstream::scatterList(sent);

    DynamicList<mpm::farLayer::panel> all;
    for (const scalarList& s : sent)
    {
        for (label i = 0; i < s.size(); i += 9)
        {
            all.append(
                {{s[i], s[i + 1], s[i + 2]},
                 {s[i + 3], s[i + 4], s[i + 5]},
                 s[i + 6],
                 s[i + 7],
                 s[i + 8]});
        }
    }
    return List<mpm::farLayer::panel>(std::move(all));
}

//- Distance of a place before a panel: of its plane, beside it of its rim
scalar distance(const mpm::farLayer::panel& a, const point& x)
{
    const vector r(a.centre - x);
    const scalar along = r & a.n;
    return std::hypot(along, max(mag(r - along * a.n) - a.radius, scalar(0)));
}

//- The axis that a normal is closest to
direction axisOf(const vector& n)
{
    const vector m(cmptMag(n));
    return m.x() >= m.y() && m.x() >= m.z() ? 0 : m.y() >= m.z() ? 1 : 2;
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::farLayer::addCell(const label c, const List<const panel*>& nearest)
{
    const point& x = mesh_.cellCentres()[c];
    struct one
    {
        const panel* a;
        scalar rate;
    };
    DynamicList<one> found;
    for (const panel* a : nearest)
    {
        const scalar share = a ? 1 - distance(*a, x) / a->thickness : 0;
        if (share > 1e-9 && ((a->centre - x) & a->n) > 0)
        {
            found.append({a, damping / a->thickness * share});
        }
    }
    std::stable_sort(
        found.begin(), found.end(),
        [](const one& a, const one& b) { return a.rate > b.rate * (1 + 1e-9); });

    cell to{c, FixedList<vector, 3>(vector(Zero)), Zero, Zero};
    forAll(found, i)
    {
        const panel& a = *found[i].a;
        bool own = true;
        for (label j = 0; j < i; ++j)
        {
            own = own && (a.n & found[j].a->n) < 0.7;
        }
        const direction k = axisOf(a.n);
        if (own && to.rate[k] == 0)
        {
            to.n[k] = a.n;
            to.rate[k] = found[i].rate;
            to.u[k] = a.u;
        }
    }
    if (found.size())
    {
        cells_.append(to);
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::farLayer::set(const UList<panel>& here)
{
    cells_.clear();
    const List<panel> all(ofAll(here));
    if (all.empty())
    {
        return;
    }
    strain_.setSize(mesh_.nCells(), Zero);

    // By the six directions
    typedef indexedOctree<treeDataPoint> tree;
    List<pointField> centres(6);
    labelListList number(6);
    PtrList<tree> trees(6);
    forAll(centres, k)
    {
        DynamicList<point> points;
        DynamicList<label> numbers;
        forAll(all, i)
        {
            const direction axis = axisOf(all[i].n);
            if (2 * axis + (all[i].n[axis] > 0) == k)
            {
                points.append(all[i].centre);
                numbers.append(i);
            }
        }
        centres[k].transfer(points);
        number[k].transfer(numbers);
        if (centres[k].size())
        {
            const boundBox box(centres[k], false);
            const vector room(vector::uniform(1e-3 * box.mag() + SMALL));
            trees.set(
                k,
                new tree(
                    treeDataPoint(centres[k]), treeBoundBox(box.min() - room, box.max() + room), 8,
                    10, 3.0));
        }
    }

    List<const panel*> nearest(6, nullptr);
    for (label c = 0; c < mesh_.nCells(); ++c)
    {
        forAll(nearest, k)
        {
            nearest[k] = nullptr;
            if (trees.set(k))
            {
                const label i = trees[k].findNearest(mesh_.cellCentres()[c], sqr(GREAT)).index();
                nearest[k] = i < 0 ? nullptr : &all[number[k][i]];
            }
        }
        addCell(c, nearest);
    }
    next_.setSize(cells_.size(), Zero);
}

void Foam::mpm::farLayer::add(
    const label i, const scalar dt, const scalar c, const vector& u, const vector& gradients)
{
    const cell& a = cells_[i];
    source s{a.c, 0, Zero};
    for (direction k = 0; k < 3; ++k)
    {
        if (a.rate[k] > 0)
        {
            const scalar phi = strain_[a.c][k], damped = -std::expm1(-dt * c * a.rate[k]);
            s.strain += damped * phi;
            s.du -= damped * ((u & a.n[k]) - a.u[k]) * a.n[k];
            next_[i][k] = (1 - damped) * phi + dt * gradients[k];
        }
    }
    sources_.append(s);
}

void Foam::mpm::farLayer::keep()
{
    // Those of the step's sources, which are in the order of cells_
    label i = 0;
    for (const source& s : sources_)
    {
        while (cells_[i].c != s.c)
        {
            ++i;
        }
        strain_[s.c] = next_[i];
    }
    sources_.clear();
}
