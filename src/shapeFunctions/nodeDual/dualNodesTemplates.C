/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Description
    Included by dualNodes.H.

\*---------------------------------------------------------------------------*/

namespace Foam::mpm
{

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Row, class Range>
MPM_INLINE void dualNodes::forRows(const Row& row, const Range& range) const
{
    for (const rowRange& r : ranges_)
    {
        if (r.alike)
        {
            range(r);
        }
        else
        {
            for (label m = r.first; m < r.end; ++m)
            {
                row(m);
            }
        }
    }
}

template<int N, class Function>
MPM_INLINE void dualNodes::unrolled(const Function& f)
{
    if constexpr (N > 0)
    {
        unrolled<N - 1>(f);
        f(std::integral_constant<int, N - 1>());
    }
}

template<int D, int P, int N, class Store>
MPM_INLINE void dualNodes::sumRows(
    const nodeDual& dual, const scalar* weight, const label m, const scalar* u, const Store& to)
{
    // Two nodes side by side, or the only one
    constexpr int V = N == 1 ? P : 2 * P;
    constexpr int R = N == 1 ? 1 : N / 2;
    const label m0 = dual.alike(m);
    const scalar* at = u + P * (m - m0);
    lanes<V> sum[R][D] = {};
    for (label e = dual.begin(m0); e < dual.begin(m0 + 1); ++e)
    {
        const scalar* q = at + P * dual.node(e);
        const scalar* w = weight + D * e;
        unrolled<R>([&](const auto r) __attribute__((always_inline)) {
            const lanes<V> ul = load<V>(q + V * r);
            unrolled<D>([&](const auto j)
                            __attribute__((always_inline)) { sum[r][j] += w[j] * ul; });
        });
    }
    unrolled<R>([&](const auto r) __attribute__((always_inline)) {
        unrolled<V / P>([&](const auto i) __attribute__((always_inline)) {
            unrolled<D>([&](const auto j) __attribute__((always_inline)) {
                // By its elements: what has an address leaves the registers
                const lanes<V> a = sum[r][j];
                if constexpr (P == 2)
                {
                    to(m + (V / P) * r + i, j, lanes<P>{a[P * i], a[P * i + 1]});
                }
                else
                {
                    to(m + (V / P) * r + i, j,
                       lanes<P>{a[P * i], a[P * i + 1], a[P * i + 2], a[P * i + 3]});
                }
            });
        });
    });
}

template<int D, int P, class Store>
MPM_INLINE void dualNodes::sumRange(
    const nodeDual& dual, const scalar* weight, const rowRange& range, const scalar* u,
    const Store& to)
{
    label m = range.first;
    for (; m + 8 <= range.end; m += 8)
    {
        sumRows<D, P, 8>(dual, weight, m, u, to);
    }
    for (; m + 2 <= range.end; m += 2)
    {
        sumRows<D, P, 2>(dual, weight, m, u, to);
    }
    if (m < range.end)
    {
        sumRows<D, P, 1>(dual, weight, m, u, to);
    }
}

template<int D, int P, int K>
MPM_INLINE void
dualNodes::addLine(const scalar* weight, const scalar* const (&column)[D], const int n, scalar* to)
{
    constexpr int V = 2 * P;

    // What is stored may be a weight, as far as the compiler knows
    lanes<V> w[K * D];
    unrolled<K * D>([&](const auto i)
                        __attribute__((always_inline)) { w[i] = broadcast<V>(weight[i]); });
    int k = 0;
    for (; k + 2 < n + K; k += 2)
    {
        lanes<V> sum = load<V>(to + P * k);
        unrolled<K * D>([&](const auto i) __attribute__((always_inline)) {
            sum += w[i] * load<V>(column[i % D] + P * (k - i / D));
        });
        store<V>(to + P * k, sum);
    }
    if (k + 1 < n + K)
    {
        lanes<P> sum = load<P>(to + P * k);
        unrolled<K * D>([&](const auto i) __attribute__((always_inline)) {
            sum += weight[i] * load<P>(column[i % D] + P * (k - i / D));
        });
        store<P>(to + P * k, sum);
    }
}

template<int D, int P>
MPM_INLINE void dualNodes::addLines(
    const nodeDual& dual, const scalar* weight, const scalar* const (&column)[D], const label m,
    const int n, scalar* f)
{
    const label m0 = dual.alike(m), end = dual.begin(m0 + 1);
    for (label e = dual.begin(m0); e < end;)
    {
        label K = 1;
        while (K < 3 && e + K < end && dual.node(e + K) == dual.node(e) + K)
        {
            ++K;
        }
        const scalar* w = weight + D * e;
        scalar* to = f + P * (m - m0 + dual.node(e));
        if (K == 3)
        {
            addLine<D, P, 3>(w, column, n, to);
        }
        else if (K == 2)
        {
            addLine<D, P, 2>(w, column, n, to);
        }
        else
        {
            addLine<D, P, 1>(w, column, n, to);
        }
        e += K;
    }
}

template<int DIM>
MPM_INLINE void dualNodes::columnsOf(const scalar* F, scalar* to, const int apart)
{
    constexpr int P = nodeStride<DIM>;
    unrolled<DIM>([&](const auto j) __attribute__((always_inline)) {
        unrolled<P>([&](const auto i) __attribute__((always_inline)) {
            constexpr int c = i < DIM ? dualColumns<DIM>::slot(i, j) : 0;
            to[P * apart * j + i] = i < DIM ? F[c] : 0;
        });
    });
}

template<int DIM>
void dualNodes::gradientAtWall(const label i, const scalar* u, scalar* L) const
{
    constexpr int P = nodeStride<DIM>;
    const label m = walls_[i];
    alignas(64) scalar U[P];
    dual_.gather<P>(m, u, U);
    lanes<P> sum[DIM] = {};
    const char* mass = hasMass_.cdata() + wallStart_[i];
    for (label e = dual_.begin(m); e < dual_.begin(m + 1); ++e)
    {
        const lanes<P> ul = load<P>(*mass++ ? u + P * dual_.node(e) : U);
        for (int j = 0; j < DIM; ++j)
        {
            sum[j] += dual_.G(e)[j] * ul;
        }
    }
    for (int j = 0; j < DIM; ++j)
    {
        store<P>(L + DIM * j, sum[j]);
    }
}

template<int DIM>
void dualNodes::forceAtWall(const label i, const scalar* column, scalar* f) const
{
    constexpr int P = nodeStride<DIM>;
    const label m = walls_[i];
    lanes<P> rest = {};
    const char* mass = hasMass_.cdata() + wallStart_[i];
    for (label e = dual_.begin(m); e < dual_.begin(m + 1); ++e)
    {
        lanes<P> part = {};
        for (int j = 0; j < DIM; ++j)
        {
            part += dual_.G(e)[j] * load<P>(column + P * j);
        }
        if (*mass++)
        {
            scalar* to = f + P * dual_.node(e);
            store<P>(to, load<P>(to) + part);
        }
        else
        {
            rest += part;
        }
    }
    alignas(64) scalar ofRest[P];
    store<P>(ofRest, rest);
    dual_.spread<P>(m, ofRest, f);
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<int P>
void dualNodes::gather(const scalar* u, scalar* U) const
{
    const auto to = [&](const label m, const int, const lanes<P> sum) { store<P>(U + P * m, sum); };
    forRows(
        [&](const label m) { dual_.gather<P>(m, u, U + P * m); },
        [&](const rowRange& r) { sumRange<1, P>(dual_, dual_.allW(), r, u, to); });
    for (const label m : walls_)
    {
        dual_.gather<P>(m, u, U + P * m);
    }
}

template<int P>
void dualNodes::spread(const scalar* a, const int stride, scalar* q) const
{
    alignas(64) scalar room[(most + 4) * P] = {};
    const scalar* column[1] = {room + 2 * P};
    forRows(
        [&](const label m) { dual_.spread<P>(m, a + stride * m, q); },
        [&](const rowRange& r)
        {
            for (label m = r.first; m < r.end; m += most)
            {
                const int n = min(most, r.end - m);
                for (int i = 0; i < n; ++i)
                {
                    store<P>(room + P * (i + 2), load<P>(a + stride * (m + i)));
                }
                std::fill_n(room + P * (n + 2), 2 * P, 0.0);
                addLines<1, P>(dual_, dual_.allW(), column, m, n, q);
            }
        });
    for (const label m : walls_)
    {
        dual_.spread<P>(m, a + stride * m, q);
    }
}

template<int DIM>
void dualNodes::gradient(const scalar* u, scalar* L) const
{
    typedef dualColumns<DIM> layout;
    constexpr int P = layout::P, C = layout::gradient;
    const auto to = [&](const label m, const int j, const lanes<P> sum)
    {
        // What is too much of a column the next one overwrites
        store<P>(L + C * m + DIM * j, sum);
    };
    forRows(
        [&](const label m) { sumRows<DIM, P, 1>(dual_, dual_.allG(), m, u, to); },
        [&](const rowRange& r) { sumRange<DIM, P>(dual_, dual_.allG(), r, u, to); });
    forAll(walls_, i)
    {
        gradientAtWall<DIM>(i, u, L + C * walls_[i]);
    }
}

template<int DIM>
void dualNodes::force(const scalar* F, const bool beside, scalar* f) const
{
    typedef dualColumns<DIM> layout;
    constexpr int P = layout::P, C = layout::force;
    alignas(64) scalar room[DIM][(most + 4) * P] = {};
    const scalar* column[DIM];
    for (int j = 0; j < DIM; ++j)
    {
        column[j] = room[j] + 2 * P;
    }
    forRows(
        [&](const label m)
        {
            alignas(64) scalar columns[DIM * P];
            columnsOf<DIM>(F + C * m, columns, 1);
            dual_.force<DIM, P>(m, columns, f);
        },
        [&](const rowRange& r)
        {
            for (label m = r.first; m < r.end; m += most)
            {
                const int n = min(most, r.end - m);
                for (int i = 0; i < n; ++i)
                {
                    columnsOf<DIM>(F + C * (m + i), room[0] + P * (i + 2), most + 4);
                }
                for (int j = 0; j < DIM; ++j)
                {
                    std::fill_n(room[j] + P * (n + 2), 2 * P, 0.0);
                }
                addLines<DIM, P>(dual_, dual_.allG(), column, m, n, f);
            }
        });
    forAll(walls_, i)
    {
        alignas(64) scalar columns[DIM * P];
        columnsOf<DIM>(F + C * walls_[i], columns, 1);
        forceAtWall<DIM>(i, columns, f);
    }
    if (beside)
    {
        spread<P>(F + layout::symmetric, C, f);
    }
}

template<int DIM>
void dualNodes::gradientOf(const label m, const scalar* u, scalar* L) const
{
    constexpr int P = nodeStride<DIM>;
    const label i = wall(m);
    if (i >= 0)
    {
        gradientAtWall<DIM>(i, u, L);
        return;
    }
    lanes<P> sum[DIM] = {};
    for (label e = dual_.begin(m); e < dual_.begin(m + 1); ++e)
    {
        const lanes<P> ul = load<P>(u + P * dual_.node(e));
        for (int j = 0; j < DIM; ++j)
        {
            sum[j] += dual_.G(e)[j] * ul;
        }
    }
    for (int j = 0; j < DIM; ++j)
    {
        store<P>(L + DIM * j, sum[j]);
    }
}

template<int DIM>
void dualNodes::forceOf(const label m, const scalar* column, scalar* f) const
{
    const label i = wall(m);
    if (i >= 0)
    {
        forceAtWall<DIM>(i, column, f);
        return;
    }
    dual_.force<DIM, nodeStride<DIM>>(m, column, f);
}

} // End namespace Foam::mpm
