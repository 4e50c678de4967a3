/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::functionObjects::fluidBalance

Description
    Sums over the cells of a gas, or of each of several fluids and of all
    together, on all processors, with u of the cell for all of its fluids:

        m_k = sum_c V theta_k rho_k                                      [kg]
        P_k = sum_c V theta_k rho_k u                                [kg m/s]
        I_k = sum_c V theta_k rho_k e_k      at the common pressure       [J]
        K_k = sum_c V theta_k rho_k u.u/2                                 [J]

    and what has come through the boundaries since the first row: of each the
    mass, of all also impulse and energy, with those of gravity and the energy
    of fix-ups and of products that burn on. massRest, restx..., energyRest: sum less
    that, less the first row's. Without points they are rounding (of the energy: no
    gravity, whose work in fluids is that of the faces); beside points momentum and
    energy have what the points took. A gas without energy equation has neither I nor energyRest.

Usage
    \verbatim
    balance
    {
        type            fluidBalance;
        libs            (mpmFunctionObjects);
        writeControl    timeStep;
        writeInterval   10;
    }
    \endverbatim

    Files: <fluid>.dat, of several fluids also total.dat (of one gas its file
    has the columns of both).

\*---------------------------------------------------------------------------*/

#include "flowOutput.H"
#include "eulerianFlow.H"

namespace Foam::functionObjects
{

class fluidBalance : public flowOutput
{

    //- Mass of each fluid, momentum and energy of the first row; what came in
    //  before a restart: mass of each, impulse, energy
    scalarList first_, before_;

    const mpm::eulerianFlow& flow() const
    {
        return mesh_.lookupObject<mpm::eulerianFlow::handle>("eulerianFlow").flow();
    }

    wordList keywords() const override { return {}; }

    void prepare(const scalarList& kept) override
    {
        if (!mesh_.foundObject<mpm::eulerianFlow::handle>("eulerianFlow"))
        {
            FatalIOErrorInFunction(dict_)
                << type() << " " << name() << ": there is no gas and no fluid." << nl
                << "It works with materialPointFoam." << exit(FatalIOError);
        }
        mpm::eulerianFlow& flow = const_cast<mpm::eulerianFlow&>(this->flow());
        if (!flow.hasBudget())
        {
            flow.startBudget();
        }
        const wordList names(flow.fluidNames());
        const label n = names.size();
        if (first_.empty() && kept.size() == 2 * (n + 4))
        {
            first_ = SubList<scalar>(kept, n + 4);
            before_ = SubList<scalar>(kept, n + 4, n + 4);
        }

        const string part("Time[s]\tmass[kg]\tPx[kg.m/s]\tPy[kg.m/s]\tPz[kg.m/s]\tinternal[J]"
                          "\tkinetic[J]\tvolume[m3]\tmassIn[kg]\tmassRest[kg]");
        const string all("\tJx[N.s]\tJy[N.s]\tJz[N.s]\tenergyIn[J]\trestx[kg.m/s]"
                         "\tresty[kg.m/s]\trestz[kg.m/s]\tenergyRest[J]");
        wordList files(names);
        List<string> headers(n, "Sums of a fluid\n" + part);
        if (n == 1)
        {
            headers[0] = "Sums of " + names[0] + "\n" + part + all;
        }
        else
        {
            files.append(word("total"));
            headers.append("Sums of all fluids\n" + part + all);
        }
        setFiles(files, headers);
    }

    void see() override {}

    void writeRows() override
    {
        typedef mpm::eulerianFlow::fluidSums sums;
        const List<sums> mine(flow().fluidContents());
        const label n = mine.size();
        constexpr label width = 7;
        scalarField s(width * (n + 1), Zero);
        forAll(mine, k)
        {
            const sums& a = mine[k];
            const scalar row[width] = {a.mass,     a.momentum.x(), a.momentum.y(), a.momentum.z(),
                                       a.internal, a.kinetic,      a.volume};
            for (label j = 0; j < width; ++j)
            {
                s[width * k + j] = row[j];
                s[width * n + j] += row[j];
            }
        }
        Pstream::listCombineGather(s, plusEqOp<scalar>());
        Pstream::listCombineScatter(s);
        const scalarList in(gained());
        const scalar* total = s.cdata() + width * n;
        if (first_.empty())
        {
            first_.setSize(n + 4);
            for (label k = 0; k < n; ++k)
            {
                first_[k] = s[width * k] - in[k];
            }
            for (label d = 0; d < 3; ++d)
            {
                first_[n + d] = total[1 + d] - in[n + d];
            }
            first_[n + 3] = total[4] + total[5] - in[n + 3];
        }
        if (!writeToFile())
        {
            return;
        }
        scalar massIn = 0, massRest = 0;
        for (label k = 0; k <= n; ++k)
        {
            const bool whole = k == n || n == 1;
            if (k == n && n == 1)
            {
                break;
            }
            Ostream& os = row(k);
            for (label j = 0; j < width; ++j)
            {
                os << tab << s[width * k + j];
            }
            const scalar rest = k < n ? s[width * k] - in[k] - first_[k] : massRest;
            os << tab << (k < n ? in[k] : massIn) << tab << rest;
            massIn += k < n ? in[k] : 0;
            massRest += rest;
            if (whole)
            {
                for (label d = 0; d < 4; ++d)
                {
                    os << tab << in[n + d];
                }
                for (label d = 0; d < 3; ++d)
                {
                    os << tab << total[1 + d] - in[n + d] - first_[n + d];
                }
                os << tab << total[4] + total[5] - in[n + 3] - first_[n + 3];
            }
            os << endl;
        }
    }

    scalarList kept() const override
    {
        scalarList all(first_);
        all.append(gained());
        return all;
    }

    //- What came in since the first row: mass of each, impulse, energy. Not
    //  collective: of this processor, unless reduced
    scalarList gained() const
    {
        const mpm::eulerianFlow::flows in(flow().allGained());
        const label n = flow().fluidNames().size();
        scalarField s(n + 4, Zero);
        for (label k = 0; k < n; ++k)
        {
            s[k] = n == 1 ? in.mass : in.fluids.size() ? in.fluids[k] : 0;
        }
        const vector J(in.impulse + in.gravityImpulse);
        for (direction d = 0; d < 3; ++d)
        {
            s[n + d] = J[d];
        }
        s[n + 3] = in.energy + in.gravityWork + in.fixups + in.afterburn;
        Pstream::listCombineGather(s, plusEqOp<scalar>());
        Pstream::listCombineScatter(s);
        if (before_.size())
        {
            s += before_;
        }
        return s;
    }

public:
    TypeName("fluidBalance");

    using flowOutput::flowOutput;
};

defineTypeNameAndDebug(fluidBalance, 0);
addTemplateToRunTimeSelectionTable(functionObject, whenMade, fluidBalance, dictionary);

} // End namespace Foam::functionObjects
