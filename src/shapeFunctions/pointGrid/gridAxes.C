// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "gridAxes.H"
#include "wedgePolyPatch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::gridAxes::makeWedge(const polyMesh& mesh)
{
    // Planes n.x = d of the wedge patches of all processors
    DynamicList<vector> normal;
    DynamicList<scalar> distance;
    wordList names;
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (!isA<wedgePolyPatch>(pp))
        {
            continue;
        }
        vector S(Zero);
        scalar d = 0;
        forAll(pp, i)
        {
            const vector& Sf = mesh.faceAreas()[pp.start() + i];
            S += Sf;
            d += Sf & mesh.faceCentres()[pp.start() + i];
        }
        reduce(S, sumOp<vector>());
        reduce(d, sumOp<scalar>());
        if (mag(S) > 0)
        {
            normal.append(S / mag(S));
            distance.append(d / mag(S));
            names.append(pp.name());
        }
    }
    if (normal.empty())
    {
        return;
    }

    const auto refuse = [&](const string& reason)
    {
        FatalErrorInFunction << "The wedge patches " << flatOutput(names) << " of the mesh "
                             << mesh.bounds()
                             << " form no sector for material points: " << reason.c_str() << "."
                             << nl << "Axisymmetric material points need one pair of wedge"
                             << " patches at plus and minus the same angle (up to 20 degrees)"
                             << " from a coordinate plane, which meet in a coordinate axis"
                             << " (x, y or z), and the other coordinate of the plane, the"
                             << " radius, not negative." << exit(FatalError);
    };

    if (normal.size() != 2 || nDim_ != 2)
    {
        refuse(
            "there are " + Foam::name(normal.size()) + " with faces, and " + Foam::name(nDim_)
            + " directions that are neither empty nor that of the wedge");
    }

    // Across the plane is the direction that is not computed; of the others
    // the normals have the radial one
    const int across = 3 - dir_[0] - dir_[1];
    radial_ = mag(normal[0][dir_[0]]) > mag(normal[0][dir_[1]]) ? 0 : 1;
    const int r = dir_[radial_], axial = dir_[1 - radial_];

    scalar lowest = GREAT, highest = -GREAT;
    for (const point& p : mesh.points())
    {
        lowest = min(lowest, p[r]);
        highest = max(highest, p[r]);
    }
    reduce(lowest, minOp<scalar>());
    reduce(highest, maxOp<scalar>());
    const scalar size = max(mag(lowest), mag(highest));

    // blockMesh writes 6 digits: of the sine of an angle 4 are left
    constexpr scalar tol = 1e-3;
    const scalar sine = -0.5 * (normal[0][r] + normal[1][r]);
    const scalar cosine = 0.5 * mag(normal[0][across] - normal[1][across]);

    if (!(cosine > 0.94) || !(mag(sine) > 1e-6)
        || mag(normal[0][across] + normal[1][across]) > tol * mag(sine)
        || mag(normal[0][r] - normal[1][r]) > tol * mag(sine)
        || mag(normal[0][axial]) > tol * mag(sine) || mag(normal[1][axial]) > tol * mag(sine))
    {
        OStringStream s;
        s << "their normals are " << normal[0] << " and " << normal[1];
        refuse(s.str());
    }

    // Where they meet: the sum of the planes is -2 sine r = d0 + d1
    const scalar meet = -0.5 * (distance[0] + distance[1]) / sine;
    const scalar plane =
        0.5 * (distance[0] - distance[1]) / (normal[0][across] > 0 ? cosine : -cosine);
    if (mag(meet) > tol * size || mag(plane) > tol * size * mag(sine) || lowest < -tol * size
        || sine < 0)
    {
        OStringStream s;
        s << "they meet at "
          << "xyz"[r] << " = " << meet << ", "
          << "xyz"[across] << " = " << plane << ", and the mesh reaches from "
          << "xyz"[r] << " = " << lowest << " to " << highest;
        refuse(s.str());
    }
    sector_ = 2 * sine / cosine;
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::gridAxes::gridAxes(const polyMesh& mesh) :
    nDim_(0), dir_{0, 0, 0}, radial_(-1), sector_(0)
{
    if (!returnReduce(mesh.nCells(), sumOp<label>()))
    {
        FatalErrorInFunction << "The mesh " << mesh.bounds() << " has no cells: check"
                             << " system/blockMeshDict." << exit(FatalError);
    }

    // Beside wedges the geometric directions may include empty ones
    for (int d = 0; d < 3; ++d)
    {
        if (mesh.solutionD()[d] > 0 && mesh.geometricD()[d] > 0)
        {
            dir_[nDim_++] = d;
        }
    }

    if (!nDim_)
    {
        FatalErrorInFunction << "All directions of the mesh " << mesh.bounds() << " are empty:"
                             << " check the patches in system/blockMeshDict; faces that none"
                             << " of them names become empty." << exit(FatalError);
    }

    makeWedge(mesh);
}
