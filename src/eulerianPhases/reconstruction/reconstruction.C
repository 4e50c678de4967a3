// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "reconstruction.H"
#include "boxSides.H"
#include "limitedGradients.H"
#include "dictionaryTools.H"
#include "nearWords.H"
#include "surfaceFields.H"
#include "surfaceInterpolationScheme.H"
#include "StringStream.H"
#include "wedgePolyPatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Tokens of an entry with a space between
string words(const UList<token>& tokens)
{
    string text;
    for (const token& t : tokens)
    {
        OStringStream os;
        os << t;
        text += (text.size() ? " " : "") + os.str();
    }
    return text;
}

//- Fatal for a scheme that there is not, with those that make sense here:
//  limited ones for any range of values
template<class Type>
void checkScheme(const fvMesh& mesh, const word& key, const string& scheme)
{
    const auto& known = *surfaceInterpolationScheme<Type>::MeshFluxConstructorTablePtr_;
    const word name(scheme.substr(0, scheme.find(' ')));
    if (known.found(name))
    {
        return;
    }
    const string V(pTraits<Type>::nComponents > 1 ? "V" : "");
    wordList valid;
    for (const word s : {"upwind", "MLP"})
    {
        valid.append(s);
    }
    for (const word s : {"vanLeer", "vanAlbada", "Minmod", "SuperBee"})
    {
        valid.append(s + V);
    }
    bool tetrahedra = false;
    for (const cell& faces : mesh.cells())
    {
        tetrahedra = tetrahedra || faces.size() < 5;
    }
    if (!tetrahedra)
    {
        for (const word s : {"MUSCL", "UMIST", "OSPRE", "QUICK", "SFCD", "limitedLinear"})
        {
            if (known.found(s + V))
            {
                valid.append(s + V);
            }
        }
    }
    FatalIOErrorInFunction(mesh.schemesDict().subDict("interpolationSchemes"))
        << "Unknown scheme " << name << " of " << key << mpm::meant(name, valid).c_str() << nl << nl
        << "Valid schemes on this mesh are: " << flatOutput(valid) << nl
        << "upwind is of first order; MLP is for all three, on any cells"
        << (tetrahedra ? "." : "; limitedLinear takes a number: 1.") << exit(FatalIOError);
}

}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::reconstruction::readSchemes()
{
    const dictionary& dict = requiredDict(mesh_.schemesDict(), "interpolationSchemes");

    const wordList fields({"rho", "U", "p"});
    forAll(fields, i)
    {
        word key("reconstruct(" + fields[i] + ")");
        if (i == 2 && !dict.found(key) && dict.found("reconstruct(T)"))
        {
            key = "reconstruct(T)";
        }
        if (!dict.found(key))
        {
            FatalIOErrorInFunction(dict)
                << "Entry " << key << " is missing in " << dict.name()
                << ". The gas needs, for example," << nl << "    reconstruct(rho) vanLeer;" << nl
                << "    reconstruct(U)   vanLeerV;" << nl << "    reconstruct(p)   vanLeer;" << nl
                << "or upwind for all three (first order); reconstruct(T) may"
                << " stand for reconstruct(p)." << exit(FatalIOError);
        }

        key_[i] = key;
        scheme_[i] = words(dict.lookupEntry(key, keyType::REGEX).stream());
    }

    upwind_ = scheme_[0] == "upwind" && scheme_[1] == "upwind" && scheme_[2] == "upwind";

    label nMLP = 0;
    for (const string& scheme : scheme_)
    {
        nMLP += scheme == "MLP";
    }
    byCells_ = nMLP == 3;
    if (nMLP && !byCells_)
    {
        FatalIOErrorInFunction(dict)
            << "The scheme MLP is for all three: " << key_[0] << " is " << scheme_[0].c_str()
            << ", " << key_[1] << ' ' << scheme_[1].c_str() << ", " << key_[2] << ' '
            << scheme_[2].c_str() << " in " << dict.name() << "." << exit(FatalIOError);
    }

    const dictionary& grad = requiredDict(mesh_.schemesDict(), "gradSchemes");
    bool gaussLinear = true;
    for (const entry& e : grad)
    {
        if (e.isStream())
        {
            gaussLinear = gaussLinear && words(e.stream()) == "Gauss linear";
        }
    }

    own_.clear();
    for (const word name : {"vanLeer", "vanAlbada", "Minmod", "SuperBee"})
    {
        if (gaussLinear && scheme_[0] == name && scheme_[2] == name && scheme_[1] == name + "V")
        {
            own_ = name;
        }
    }
}

Foam::surfaceScalarField Foam::mpm::reconstruction::direction(const scalar sign) const
{
    return surfaceScalarField(
        IOobject("direction", mesh_.time().timeName(), mesh_), mesh_,
        dimensionedScalar("sign", dimless, sign));
}

template<class Type>
Foam::tmp<Foam::surfaceInterpolationScheme<Type>>
Foam::mpm::reconstruction::scheme(const label i, const surfaceScalarField& direction) const
{
    return surfaceInterpolationScheme<Type>::New(
        mesh_, direction, mesh_.schemesDict().subDict("interpolationSchemes").lookup(key_[i]));
}

void Foam::mpm::reconstruction::interpolated(
    const volScalarField& rho, const volVectorField& U, const volScalarField& p)
{
    for (const bool owner : {true, false})
    {
        const surfaceScalarField to(direction(owner ? 1 : -1));
        const auto rho_f = scheme<scalar>(0, to)->interpolate(rho);
        const auto U_f = scheme<vector>(1, to)->interpolate(U);
        const auto p_f = scheme<scalar>(2, to)->interpolate(p);

        const auto set = [&](const label f, const gasState& s)
        { (owner ? faces_[f].own : faces_[f].nei) = s; };
        for (label f = 0; f < mesh_.nInternalFaces(); ++f)
        {
            set(f, {rho_f()[f], U_f()[f], p_f()[f]});
        }
        for (const label f : coupledList_)
        {
            const label patchi = mesh_.boundaryMesh().whichPatch(f);
            const label i = f - mesh_.boundaryMesh()[patchi].start();
            set(f,
                {rho_f().boundaryField()[patchi][i], U_f().boundaryField()[patchi][i],
                 p_f().boundaryField()[patchi][i]});
        }
    }
}

void Foam::mpm::reconstruction::refuseTetrahedra() const
{
    label tet = -1;
    forAll(mesh_.cells(), c)
    {
        if (mesh_.cells()[c].size() < 5)
        {
            tet = c;
            break;
        }
    }
    if (tet < 0)
    {
        return;
    }
    FatalIOErrorInFunction(mesh_.schemesDict())
        << "Cell " << tet << " at " << mesh_.cellCentres()[tet] << " is a tetrahedron, where "
        << key_[0] << ' ' << scheme_[0].c_str() << ", " << key_[1] << ' ' << scheme_[1].c_str()
        << ", " << key_[2] << ' ' << scheme_[2].c_str() << " grow without bound." << nl
        << "Valid there are MLP or upwind for"
        << " all three; vanLeer, vanAlbada, Minmod and SuperBee (of U with V"
        << " behind the name) become MLP." << exit(FatalIOError);
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::reconstruction::reconstruction(
    const fvMesh& mesh, const activeRegion& region, const coupledFaces& coupled,
    const labelList& boundaryFaces, const labelList& coupledFaceList) :
    mesh_(mesh),
    region_(region),
    coupled_(coupled),
    boundary_(boundaryFaces),
    coupledList_(coupledFaceList)
{
    readSchemes();

    DynamicList<label> wedge;
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        for (label i = 0; isA<wedgePolyPatch>(pp) && i < pp.size(); ++i)
        {
            wedge.append(pp.start() + i);
        }
    }
    wedge_.transfer(wedge);

    if (!upwind_)
    {
        faces_.setSize(mesh.nFaces());
        if (!byCells_)
        {
            measureSkew();
        }
        if (own_.size() && !byCells_)
        {
            boxes_ = boxSides::New(mesh, region, coupled);
            byCells_ = !boxes_;
            skew_.clear();
        }
        grad_.setSize(skew_.size() ? mesh.nCells() : 0);
        rates_.setSize(boxes_ ? 0 : mesh.nCells());
        swap_.setSize(mesh.nFaces() - mesh.nInternalFaces());
    }
    if (!upwind_ && !byCells_ && own_.empty())
    {
        // A wrong name is fatal now, not in the first step
        checkScheme<scalar>(mesh, key_[0], scheme_[0]);
        checkScheme<vector>(mesh, key_[1], scheme_[1]);
        checkScheme<scalar>(mesh, key_[2], scheme_[2]);
        refuseTetrahedra();
        const surfaceScalarField to(direction(1));
        scheme<scalar>(0, to);
        scheme<vector>(1, to);
        scheme<scalar>(2, to);
    }
}

Foam::mpm::reconstruction::~reconstruction() = default;

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::reconstruction::leaveAlone()
{
    forAll(rates_, c)
    {
        if (!region_.has(c))
        {
            rates_[c] = rates{0, 0, 0, Zero, Zero};
        }
    }
    forAll(grad_, c)
    {
        if (!region_.has(c))
        {
            grad_[c] = gradients{Zero, Zero, Zero};
        }
    }
}

Foam::label Foam::mpm::reconstruction::rings() const
{
    return upwind_ ? 1 : boxes_ ? boxes_->rings() : 2;
}

Foam::string Foam::mpm::reconstruction::description() const
{
    return "rho " + scheme_[0] + ", U " + scheme_[1] + ", p " + scheme_[2]
        + (byCells_ && own_.size() ? ", on these cells: MLP" : "")
        + (upwind_ || byCells_ || own_.size() ? "" : " (by OpenFOAM's general schemes)")
        + (skew_.size() ? ", corrected on skewed faces" : "");
}

void Foam::mpm::reconstruction::checkWeight() const
{
    if (!upwind_ && !byCells_ && own_.empty())
    {
        FatalIOErrorInFunction(mesh_.schemesDict())
            << "Several fluids under gravity need upwind, MLP, or vanLeer,"
            << " vanAlbada, Minmod or SuperBee for " << key_[0] << ", " << key_[1]
            << " (with V behind the name) and " << key_[2]
            << " and gradients by Gauss linear; here these are " << description().c_str()
            << exit(FatalIOError);
    }
}

void Foam::mpm::reconstruction::update(
    const scalar dt, const phase& of, const volScalarField& rho, const volVectorField& U,
    const volScalarField& p, const boolUList* nearSolid)
{
    const UList<gasState>& W = of.W;
    const UList<gasState>& Wb = of.Wb;
    if (byCells_)
    {
        if (!slopes_)
        {
            slopes_.reset(new limitedGradients(mesh_, boundary_, coupledList_));
        }
        if (of.jump)
        {
            slopesAboveRest(of);
        }
        else
        {
            slopes_->update(W, Wb);
        }
        fromSlopes();
        halfStep(dt, of, nearSolid);
        return;
    }
    if (boxes_)
    {
        halfStep(dt, of, nearSolid);
        return;
    }
    if (skew_.size())
    {
        leastSquares(W, Wb);
    }
    interpolated(rho, U, p);
    if (skew_.size())
    {
        addSkew(W, Wb);
    }
    halfStep(dt, of, nearSolid);
}
