/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "pointRegion.H"
#include "cornerRegions.H"
#include "meshShape.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::mpm::pointRegion::find
(
    const point& at,
    const label near,
    point& moved
) const
{
    scalar x[3] = {0, 0, 0};
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        x[d] = at[grid_.direction(d)];
    }

    // Elements beside each other follow each other in most files
    label celli =
        grid_.locatesAtOnce() ? label(-1) : grid_.locate(max(near, label(0)), x);
    if (celli < 0)
    {
        celli = grid_.find(x);
    }
    for (int d = 0; d < grid_.nDim(); ++d)
    {
        // On a cyclic mesh
        moved[grid_.direction(d)] = x[d];
    }
    return celli;
}


void Foam::mpm::pointRegion::fillElements(const scalar rho)
{
    const bodyMesh& body = refCast<const meshShape>(*shape_).body();
    const int nDim = grid_.nDim();
    const int radial = grid_.radial();

    DynamicList<materialPointCloud::newPoint> points(nSub_*body.size());
    DynamicList<label> cellOf(points.capacity());
    label celli = 0;
    for (label e = 0; e < body.size(); ++e)
    {
        const autoPtr<cellParts> parts(body.parts(e, n_[0]));
        const cellParts& r = *parts;
        const cornerRegions* c = isA<cornerRegions>(r);
        const bool whole = n_[0] == 1;
        for (label i = 0; i < (whole ? 1 : r.size()); ++i)
        {
            const scalar size = whole ? r.whole() : r.volume()[i];
            const point centre(whole ? r.centre() : r.centre(i));
            materialPointCloud::newPoint p;
            p.x = centre;
            p.U = p.halfSize = Zero;
            p.sigma = sigma_;
            p.T = T_;
            p.volume =
                size*volumeFraction_
               *(
                    radial < 0
                  ? shape_->section()
                  : grid_.sector()*centre[grid_.direction(radial)]
                );
            p.mass = rho*p.volume;

            // Those of a cube (square) of its size, up to the outside
            vector l(Zero);
            for (int d = 0; d < nDim; ++d)
            {
                l[grid_.direction(d)] = 0.5*std::pow(size, 1.0/nDim);
            }
            const scalar fit =
                body.fit(e, whole || !c ? -1 : c->corners()[i], centre, l);
            p.halfSize = (bySimplices_ ? min(fit, scalar(1)) : fit)*l;

            celli = find(centre, celli, p.x);
            cellOf.append(celli);
            points.append(p);
        }
    }
    store(points, cellOf);
}

// ************************************************************************* //
