/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Class
    Foam::mpm::surfaceShape

Description
    The inside of a closed surface: any searchableSurface of OpenFOAM that
    knows inside from outside, most often an STL or OBJ file of triangles in
    constant/triSurface. In 1D and 2D it is cut at the mid-plane of the mesh.

Usage
    \table
        Property | Description                              | Required
        type     | surface                                  | yes
        surface  | { type triSurfaceMesh; file "body.stl"; } | yes
    \endtable
    A file in mm needs  scale 1e-3;  beside its name.

\*---------------------------------------------------------------------------*/

#include "pointRegionShape.H"
#include "searchableSurface.H"
#include "triSurfaceMesh.H"
#include "volumeType.H"
#include "Time.H"

namespace Foam::mpm
{

class surfaceShape : public pointRegionShape
{
    autoPtr<searchableSurface> surface_;

    //- Negative: not known
    scalar volume_;

    //- Read the surface. OpenFOAM's own message, with file and line of
    //  our dictionary, if that fails
    void read(const word& name, const dictionary& dict)
    {
        const Time& time = grid_.mesh().time();
        const word type(required<word>(dict, "type"));
        string problem;

        const bool throwing = FatalError.throwExceptions();
        const bool throwingIO = FatalIOError.throwExceptions();
        try
        {
            surface_ = searchableSurface::New(
                type,
                IOobject(
                    name, time.constant(), "triSurface", time, IOobject::MUST_READ,
                    IOobject::NO_WRITE, false),
                dict);
        }
        catch (const Foam::error& err)
        {
            problem = err.message();
        }
        FatalError.throwExceptions(throwing);
        FatalIOError.throwExceptions(throwingIO);

        if (problem.find("Cannot find triSurfaceMesh") != std::string::npos
            || problem.find("Cannot find surface") != std::string::npos)
        {
            // OpenFOAM's messages (v1912, v2506) name a file of the region's name, or no folder
            FatalIOErrorInFunction(dict)
                << "Cannot make the surface: there is no file constant/triSurface/"
                << dict.getOrDefault<fileName>("file", name).c_str() << "." << exit(FatalIOError);
        }
        if (problem.size())
        {
            FatalIOErrorInFunction(dict)
                << "Cannot make the surface: " << problem.c_str() << exit(FatalIOError);
        }
    }

public:
    TypeName("surface");

    surfaceShape(const pointGrid& grid, const dictionary& dict) :
        pointRegionShape(grid), volume_(-1)
    {
        requireKeyword(dict, "surface");
        if (!dict.isDict("surface"))
        {
            FatalIOErrorInFunction(dict)
                << "Entry surface is not a dictionary; for a triangle file in"
                << " constant/triSurface write"
                << "  surface { type triSurfaceMesh; file \"body.stl\"; }" << exit(FatalIOError);
        }
        const dictionary& surfaceDict = dict.subDict("surface");
        read(dict.dictName(), surfaceDict);

        if (!surface_->hasVolumeType())
        {
            FatalIOErrorInFunction(surfaceDict)
                << "The surface is not closed: it has no inside. surfaceCheck"
                << " shows where it is open." << exit(FatalIOError);
        }

        if (isA<triSurfaceMesh>(*surface_))
        {
            // Divergence theorem, from the middle of the surface: tetrahedra far
            // from the origin would cancel
            const triSurface& s = refCast<const triSurfaceMesh>(*surface_);
            const point middle(surface_->bounds().midpoint());

            scalar sum = 0;
            for (const labelledTri& t : s)
            {
                const vector a(s.points()[t[0]] - middle);
                const vector b(s.points()[t[1]] - middle);
                const vector c(s.points()[t[2]] - middle);
                sum += ((a ^ b) & c) / 6;
            }
            if (!(sum > 0))
            {
                FatalIOErrorInFunction(surfaceDict)
                    << "The normals of the surface point inwards (its volume is " << sum
                    << "); turn them with surfaceOrient." << exit(FatalIOError);
            }
            if (grid_.nDim() == 3)
            {
                volume_ = sum;
            }
        }
    }

    wordList keywords() const override { return {"surface"}; }
    boundBox bounds() const override { return surface_->bounds(); }

    bool contains(const label celli, const point& x) const override;

    boolList contains(const label celli, const pointField& x) const override;

    const triSurface* facets() const override
    {
        return isA<triSurfaceMesh>(*surface_)
            ? &refCast<const triSurface>(refCast<const triSurfaceMesh>(*surface_))
            : nullptr;
    }

    bool nearest(const point& x, point& foot) const override
    {
        List<pointIndexHit> hit;
        surface_->findNearest(pointField(1, x), scalarField(1, magSqr(bounds().span())), hit);
        foot = hit[0].rawPoint();
        return hit[0].hit();
    }

    scalar volume() const override { return volume_; }
};

bool surfaceShape::contains(const label celli, const point& x) const
{
    return contains(celli, pointField(1, x))[0];
}

boolList surfaceShape::contains(const label, const pointField& x) const
{
    List<volumeType> types;
    surface_->getVolumeType(x, types);

    boolList inside(x.size());
    forAll(x, i)
    {
        inside[i] = types[i] == volumeType::INSIDE;
    }
    return inside;
}

defineTypeNameAndDebug(surfaceShape, 0);
addToRunTimeSelectionTable(pointRegionShape, surfaceShape, dictionary);

} // End namespace Foam::mpm
