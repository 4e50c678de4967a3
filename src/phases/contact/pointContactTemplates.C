// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Function>
void Foam::mpm::pointContact::forPoints(const label fieldi, const Function& f) const
{
    forAll(phases_, phasei)
    {
        if (fieldOf_[phasei] != fieldi)
        {
            continue;
        }
        const materialPointCloud& cloud = phases_[phasei].cloud();
        const nearPoints& near = near_[phasei];
        label n = 0, begin = 0;
        for (const label k : near.cells)
        {
            for (label p = cloud.start()[k]; p < cloud.start()[k + 1]; ++p)
            {
                scalar x[3], l[3];
                placeAndHalfSize(cloud, cloud.cells()[k], p, x, l);
                const label size = near.end[n] - begin;
                f(cloud, p, x, l, SubList<label>(near.nodes, size, begin),
                  SubList<scalar>(near.S, size, begin));
                begin = near.end[n++];
            }
        }
    }
}

template<class Function>
void Foam::mpm::pointContact::forMeetings(const label fieldi, const Function& f) const
{
    forPoints(
        fieldi,
        [&](const materialPointCloud&, const label, const scalar* x, const scalar* l,
            const UList<label>& nodes, const UList<scalar>& S)
        {
            forAll(nodes, i)
            {
                const label place = placeOf_[nodes[i]];
                if (place >= 0 && S[i] > 0)
                {
                    f(place, x, l, S[i]);
                }
            }
        });
}
