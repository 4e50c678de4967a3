// A shape function of a user with a number of nodes known at run time: linear on
// boxes, S_i = prod_d (1 - |x - x_i|_d/h_d), node by node in any order.

#include "shapeTransfer.H"
#include "stencilShape.H"

namespace Foam
{
namespace mpm
{

template<int DIM>
struct nodewiseLinear : stencilShape<DIM, 8, nodewiseLinear<DIM>>
{
    typedef stencilShape<DIM, 8, nodewiseLinear<DIM>> base;
    typedef typename base::T T;
    struct stencil : base::baseStencil { double low[DIM], high[DIM], ih[DIM]; };

    const pointGrid& grid;

    explicit nodewiseLinear(const pointGrid& g) : grid(g) {}

    static string refuses(const pointGrid& g) { return g.noLattice(); }

    MPM_INLINE void prepare(const label celli, stencil& s) const
    {
        base::setNodes(grid, celli, s);
        for (int d = 0; d < DIM; ++d)
        {
            s.low[d] = s.high[d] = s.x[0][d];
            for (int i = 1; i < s.n; ++i) s.low[d] = min(s.low[d], s.x[i][d]);
            for (int i = 1; i < s.n; ++i) s.high[d] = max(s.high[d], s.x[i][d]);
            s.ih[d] = 1/(s.high[d] - s.low[d]);
        }
    }

    double inverseWidth(const stencil& s, const int d) const { return s.ih[d]; }

    MPM_INLINE auto left(const stencil& s, const T (&x)[DIM]) const
    {
        auto in = (x[0] >= s.low[0]) & (x[0] < s.high[0]);
        for (int d = 1; d < DIM; ++d) in = in & (x[d] >= s.low[d]) & (x[d] < s.high[d]);
        return ~in;
    }

    template<bool GRADIENT>
    MPM_INLINE void functions(const stencil& s, const T (&x)[DIM], const T*, T* S, T (*dS)[DIM]) const
    {
        for (int i = 0; i < s.n; ++i)
        {
            T w[DIM];
            double slope[DIM];
            S[i] = broadcast<base::W>(1);
            for (int d = 0; d < DIM; ++d)
            {
                slope[d] = 2*s.x[i][d] > s.low[d] + s.high[d] ? s.ih[d] : -s.ih[d];
                w[d] = offSides<base::W>(1.0 + slope[d]*(x[d] - s.x[i][d]));
                S[i] *= w[d];
            }
            for (int d = 0; GRADIENT && d < DIM; ++d)
            {
                dS[i][d] = broadcast<base::W>(slope[d]);
                for (int e = 0; e < DIM; ++e) if (e != d) dS[i][d] *= w[e];
            }
        }
    }
};

typedef shapeFunction<nodewiseLinear> nodewiseLinearPasses;
addNamedToRunTimeSelectionTable
(
    pointGridTransfer, nodewiseLinearPasses, grid, nodewiseLinear
);

} // End namespace mpm
} // End namespace Foam
