/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "shapeFormula.H"

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


int Foam::mpm::shapeFormula::evaluate
(
    const label celli,
    const UList<int>& inside
) const
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
                stack[--n - 1] =
                    a == decides || b == decides ? decides
                  : a == 2 || b == 2 ? 2
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


void Foam::mpm::shapeFormula::andLast()
{
    tokens_.append({'&', 0});
}


void Foam::mpm::shapeFormula::orLast()
{
    tokens_.append({'|', 0});
}


void Foam::mpm::shapeFormula::notLast()
{
    tokens_.append({'!', 0});
}


bool Foam::mpm::shapeFormula::contains
(
    const label celli,
    const scalar* x
) const
{
    List<int> inside(surfaces_.size());
    forAll(inside, i)
    {
        inside[i] = surfaces_[i].value(x) <= 0 ? 1 : 0;
    }
    return evaluate(celli, inside) == 1;
}

// ************************************************************************* //
