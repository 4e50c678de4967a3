// A node constraint of a user, joined by a part of the step: the nodes in a box
// have one velocity.

#include "materialPointSystem.H"
#include "dictionaryTools.H"
#include "boundBox.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam::mpm
{

struct heldNodes
:
    public stepPart,
    public nodeConstraint
{
    const vector velocity_;
    const labelList direction_;
    DynamicList<label> nodes_;

    TypeName("heldNodes");

    heldNodes(const word& name, const dictionary& d, materialPointSystem& p)
    :
        stepPart(name),
        velocity_(required<vector>(d, "velocity")),
        direction_(directions(p))
    {
        checkKeywords(d, {"type", "field", "min", "max", "velocity"});
        const boundBox box(required<vector>(d, "min"), required<vector>(d, "max"));
        const pointField x(p.grid().nodePositions());
        forAll(x, node)
        {
            if (box.contains(x[node]))
            {
                nodes_.append(node);
            }
        }
        for (velocityField& field : p.fields())
        {
            if (field.name() == required<word>(d, "field"))
            {
                field.addConstraint(*this);
            }
        }
    }

    static labelList directions(const materialPointSystem& p)
    {
        labelList all(p.grid().nDim());
        forAll(all, d)
        {
            all[d] = p.grid().direction(d);
        }
        return all;
    }

    void impose(scalar* u, const int stride, const bool zero, const bool) const override
    {
        for (const label node : nodes_)
        {
            forAll(direction_, d)
            {
                u[stride*node + d] = zero ? 0 : velocity_[direction_[d]];
            }
        }
    }

    void mark(labelHashSet& constrained) const override
    {
        constrained.insert(nodes_);
    }
};

defineTypeNameAndDebug(heldNodes, 0);
addToRunTimeSelectionTable(stepPart, heldNodes, dictionary);

} // End namespace Foam::mpm
