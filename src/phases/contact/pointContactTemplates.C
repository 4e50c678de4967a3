/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Function>
void Foam::mpm::pointContact::forPoints
(
    const label fieldi,
    const Function& f
) const
{
    DynamicList<label> nodes;
    DynamicList<scalar> S, gradS;
    forAll(phases_, phasei)
    {
        if (fieldOf_[phasei] != fieldi)
        {
            continue;
        }
        const materialPointCloud& cloud = phases_[phasei].cloud();
        const column* half = cloud.halfSize();
        gridTransfer_.forStencils
        (
            cloud,
            [&](const label k, const labelUList& stencil)
            {
                bool near = false;
                for (const label node : stencil)
                {
                    near = near || (node >= 0 && placeOf_[node] >= 0);
                }
                if (!near)
                {
                    return;
                }
                const label celli = cloud.cells()[k];
                for (label p = cloud.start()[k]; p < cloud.start()[k + 1]; ++p)
                {
                    scalar x[3], l[3] = {0, 0, 0};
                    for (int d = 0; d < nDim_; ++d)
                    {
                        x[d] = cloud.x()[d][p];
                        l[d] = half ? (*half)[d][p] : 0;
                    }
                    gridTransfer_.weights(celli, x, half ? l : nullptr, nodes, S, gradS);
                    if (!half)
                    {
                        // A box of the cell's shape and the point's volume
                        const scalar part = 0.5*std::pow
                        (
                            cloud.volume()[0][p]/grid_.mesh().cellVolumes()[celli],
                            1.0/nDim_
                        );
                        for (int d = 0; d < nDim_; ++d)
                        {
                            l[d] = part*grid_.width(celli, d);
                        }
                    }
                    f(cloud, p, x, l, nodes, S, gradS);
                }
            }
        );
    }
}


template<class Function>
void Foam::mpm::pointContact::forMeetings
(
    const label fieldi,
    const Function& f
) const
{
    forPoints
    (
        fieldi,
        [&]
        (
            const materialPointCloud&,
            const label,
            const scalar* x,
            const scalar* l,
            const UList<label>& nodes,
            const UList<scalar>& S,
            const UList<scalar>&
        )
        {
            forAll(nodes, i)
            {
                const label place = nodes[i] < 0 ? -1 : placeOf_[nodes[i]];
                if (place >= 0 && S[i] > 0)
                {
                    f(place, x, l, S[i]);
                }
            }
        }
    );
}

// ************************************************************************* //
