// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "solidOverSteps.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::solidOverSteps::add(const label f, const solidOnFaces& step, const scalar dt)
{
    if (!hasFace_[f])
    {
        hasFace_[f] = true;
        faces_.append(f);
        inertia_[f] = GREAT;
    }
    // Areas remain where thetaS is clipped to 0
    const scalar w = dt * max(step.thetaS[f], SMALL);
    weight_[f] += w;
    thetaS0_[f] += dt * step.thetaS0[f];
    thetaS_[f] += dt * step.thetaS[f];
    phiS_[f] += dt * step.phiS[f];
    uS_[f] += w * step.uS[f];
    rhoS_[f] += w * step.rhoS[f];
    K_[f] = max(K_[f], step.K[f]);
    dragLimit_[f] = max(dragLimit_[f], step.dragLimit[f]);
    if (step.K[f] > 0)
    {
        inertia_[f] = min(inertia_[f], step.inertia[f]);
    }
    if (step.area0)
    {
        area0_[f] += dt * step.area0[f];
        area_[f] += dt * step.area[f];
        U_[f] += w * step.U[f];
    }
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::solidOverSteps::solidOverSteps(const fvMesh& mesh) :
    mesh_(mesh),
    thetaS0_(mesh.nFaces(), 0),
    thetaS_(mesh.nFaces(), 0),
    phiS_(mesh.nFaces(), 0),
    uS_(mesh.nFaces(), 0),
    rhoS_(mesh.nFaces(), 0),
    K_(mesh.nFaces(), 0),
    dragLimit_(mesh.nFaces(), 0),
    inertia_(mesh.nFaces(), 0),
    area0_(mesh.nFaces(), Zero),
    area_(mesh.nFaces(), Zero),
    U_(mesh.nFaces(), Zero),
    weight_(mesh.nFaces(), 0),
    dilation_(mesh.nCells(), 0),
    hasFace_(mesh.nFaces(), false),
    dt_(0)
{
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::solidOverSteps::clear()
{
    for (const label f : faces_)
    {
        hasFace_[f] = false;
        thetaS0_[f] = thetaS_[f] = phiS_[f] = uS_[f] = rhoS_[f] = 0;
        K_[f] = dragLimit_[f] = inertia_[f] = weight_[f] = 0;
        area0_[f] = area_[f] = U_[f] = Zero;
    }
    faces_.clear();
    dilation_ = 0;
    dt_ = 0;
}

void Foam::mpm::solidOverSteps::add(const solidOnFaces& step, const scalar dt)
{
    for (label f = 0; f < mesh_.nFaces(); ++f)
    {
        if (step.at(f))
        {
            add(f, step, dt);
        }
    }
    forAll(dilation_, c)
    {
        dilation_[c] += step.dilation[c];
    }
    dt_ += dt;
}

Foam::mpm::solidOnFaces Foam::mpm::solidOverSteps::mean(const solidOnFaces& last)
{
    for (const label f : faces_)
    {
        const scalar w = 1 / max(weight_[f], VSMALL);
        uS_[f] *= w;
        rhoS_[f] *= w;
        U_[f] *= w;
        thetaS0_[f] /= dt_;
        thetaS_[f] /= dt_;
        phiS_[f] /= dt_;
        area0_[f] /= dt_;
        area_[f] /= dt_;
    }
    solidOnFaces all(last);
    all.faces = nullptr;
    all.thetaS0 = thetaS0_.cdata();
    all.thetaS = thetaS_.cdata();
    all.phiS = phiS_.cdata();
    all.uS = uS_.cdata();
    all.rhoS = rhoS_.cdata();
    all.K = K_.cdata();
    all.dragLimit = dragLimit_.cdata();
    all.inertia = inertia_.cdata();
    all.dilation = dilation_.cdata();
    if (last.area0)
    {
        all.area0 = area0_.cdata();
        all.area = area_.cdata();
        all.U = U_.cdata();
    }
    return all;
}
