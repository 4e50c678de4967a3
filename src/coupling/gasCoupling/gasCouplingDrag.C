/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "gasCoupling.H"
#include "noTraps.H"
#include "dictionaryTools.H"
#include "FlatOutput.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::mpm::solidOnFaces::faceDrag Foam::mpm::gasCoupling::readFaceDrag
(
    const dictionary& dict
) const
{
    const wordList words({"none", "velocity", "impedance"});
    const solidOnFaces::faceDrag forms[] =
    {
        solidOnFaces::none,
        solidOnFaces::velocity,
        solidOnFaces::impedance
    };

    // Cases of older versions have numbers
    const entry* given = dict.findEntry("faceDrag", keyType::LITERAL);
    if (given && given->isStream())
    {
        const token first(given->stream());
        if (first.isNumber())
        {
            forAll(words, i)
            {
                if (first.number() == forms[i])
                {
                    Info<< "Phase " << gas_.name() << ": faceDrag "
                        << first.number() << " is the older word for "
                        << words[i] << nl << endl;
                    return forms[i];
                }
            }
            FatalIOErrorInFunction(dict)
                << "Unknown faceDrag " << first.number() << nl << nl
                << "Valid choices are: " << flatOutput(words)
                << exit(FatalIOError);
        }
    }

    const word form
    (
        oneOfOrDefault
        (
            dict,
            "faceDrag",
            normalOnly_ ? "none" : "impedance",
            words
        )
    );
    return forms[words.find(form)];
}


Foam::vector Foam::mpm::gasCoupling::dragImpulse
(
    const label phasei,
    const label celli,
    const scalar M,
    const vector& Us,
    const scalar thetaS,
    const scalar dt
)
{
    const dragModel& model = drag_[phasei];
    const scalar rho = gas_.rho()[celli], theta = gas_.theta()[celli];
    const vector ug((gas_.rhoU()[celli] + J_[celli])/rho);
    vector relative(Us - ug);

    if (model.normalOnly())
    {
        vector n;
        if (normal(celli, n))
        {
            relative = n*(n & relative);
        }
    }

    // The pores of a full cell are there for the gas' equations alone
    const bool full = model.none() && solidFraction(celli) > fullOfSolid;
    const scalar K =
        full
      ? dragModel::sticking
      : model.K
        (
            dragModel::state{thetaS, theta, rho/theta, mu_, mag(relative)}
        );
    if (!(K > 0))
    {
        return Zero;
    }
    Kc_[celli] += K;

    // Harmonic masses; a rigid phase has no end of it: a free body takes
    // the impulse at the end of the step
    const scalar shared = M < GREAT ? rho*M/(rho + M) : rho;
    const scalar a = dt*K/shared;
    const vector J(a/(1 + a)*shared*relative);
    held_[celli] += rho*M*a/(rho*(1 + a) + M);

    if (magSqr(J_[celli]) <= 0 && mag(Q_[celli]) <= 0)
    {
        dragged_.append(celli);
    }
    J_[celli] += J;
    Q_[celli] += J & (M < GREAT ? Us - 0.5*J/M : Us);

    return J;
}


void Foam::mpm::gasCoupling::dragPhase(const label phasei, const scalar dt)
{
    materialPointPhase& phase = points_.phases()[phasei];
    materialPointCloud& cloud = phase.cloud();
    const pointGridTransfer& passes = points_.gridTransfer();
    const label fieldi = points_.fieldOf(phasei);
    velocityField& field = points_.fields()[fieldi];
    const int D = sums_.grid().nDim(), stride = field.stride();
    const label n = passes.nStencil();

    share_.setSize(max(share_.size(), n*cloud.cells().size()));
    passes.massShares(cloud, share_.data());

    impulse_.setSize(stride*sums_.grid().nNodes());
    for (const label node : field.active())
    {
        for (int d = 0; d < D; ++d)
        {
            impulse_[stride*node + d] = 0;
        }
    }

    const scalar* UL = field.UL();
    passes.forStencils
    (
        cloud,
        [&](const label k, const labelUList& nodes)
        {
            const label celli = cloud.cells()[k];
            const scalar* share = share_.cdata() + n*k;
            scalar M = 0, v = 0;
            vector mU(Zero);
            forAll(nodes, i)
            {
                M += share[i];
                for (int d = 0; d < D; ++d)
                {
                    mU[sums_.grid().direction(d)] +=
                        share[i]*UL[stride*nodes[i] + d];
                }
            }
            for (label p = cloud.start()[k]; p < cloud.start()[k + 1]; ++p)
            {
                v += (*cloud.gasVolume())[0][p];
            }
            const scalar V = mesh_.V()[celli];
            const vector J
            (
                dragImpulse
                (
                    phasei,
                    celli,
                    M/V,
                    mU/M,
                    min((1 - eps_)*v/V, 1 - eps_),
                    dt
                )
            );
            forAll(nodes, i)
            {
                const scalar part = share[i]*V/M;
                for (int d = 0; d < D; ++d)
                {
                    impulse_[stride*nodes[i] + d] -=
                        part*J[sums_.grid().direction(d)];
                }
            }
        }
    );
    points_.addImpulse(fieldi, impulse_.data());
}


void Foam::mpm::gasCoupling::dragRigid(const label phasei, const scalar dt)
{
    materialPointCloud& cloud = points_.phases()[phasei].cloud();
    rigidNodes& rigid = points_.fields()[points_.fieldOf(phasei)].rigid();
    freeBody* body = points_.phases()[phasei].motion()->free();
    forAll(cloud.cells(), k)
    {
        scalar m = 0, v = 0;
        vector mU(Zero), mx(Zero);
        for (label p = cloud.start()[k]; p < cloud.start()[k + 1]; ++p)
        {
            m += cloud.mass()[0][p];
            mx += cloud.mass()[0][p]*cloud.position(p, cloud.cells()[k]);
            mU += cloud.mass()[0][p]*cloud.velocity(p);
            v += (*cloud.gasVolume())[0][p];
        }
        const label celli = cloud.cells()[k];
        const vector J
        (
            mesh_.V()[celli]
           *dragImpulse
            (
                phasei,
                celli,
                GREAT,
                mU/m,
                min((1 - eps_)*v/mesh_.V()[celli], 1 - eps_),
                dt
            )
        );
        rigid.addLoad(phasei, -J);
        if (body)
        {
            body->addLoad(-J, mx/m);
        }
        else
        {
            rigidWork_ += J & mU/m;
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::gasCoupling::exchange(const scalar dt)
{
    const noTraps guard;

    for (const label c : dragged_)
    {
        J_[c] = Zero;
        Q_[c] = 0;
    }
    dragged_.clear();
    Kc_ = 0;
    held_ = 0;
    rigidWork_ = 0;
    loadRigid(dt);
    if (normalOnly_)
    {
        updateNormals();
    }

    forAll(points_.phases(), phasei)
    {
        if (drag_[phasei].none() && points_.phases()[phasei].grains())
        {
            continue;
        }
        if (points_.phases()[phasei].motion())
        {
            dragRigid(phasei, dt);
        }
        else
        {
            dragPhase(phasei, dt);
        }
    }
}

// ************************************************************************* //
