/*---------------------------------------------------------------------------*\
    materialPointFoam: material point method on OpenFOAM's mesh
-------------------------------------------------------------------------------
License
    GPL-3.0-or-later, see LICENSE in the project's top folder.

\*---------------------------------------------------------------------------*/

#include "pointContact.H"
#include "ListListOps.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::pointContact::findPressed
(
    const label pairi,
    const pointField& places,
    const labelList& stuck
)
{
    const scalar tol = 1e-8*grid_.mesh().bounds().mag();
    pressed_.setSize(pairs_.size());
    for (const contactNode& m : contactNodes_)
    {
        for (label i = 0; m.pair == pairi && i < places.size(); ++i)
        {
            if (mag(places[i] - position_[m.node]) < tol)
            {
                pressed_[pairi].insert(m.node, i < stuck.size() && stuck[i]);
            }
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dictionary Foam::mpm::pointContact::state() const
{
    dictionary state;
    forAll(pairs_, pairi)
    {
        state.add
        (
            word("pair" + Foam::name(pairi)),
            returnReduce(pairs_[pairi].sum, sumOp<vector>())
        );

        // By place: nodes have other numbers on other processors
        DynamicList<point> places;
        DynamicList<label> stuck;
        for (label i = 0; pressed_.size() && i < contactNodes_.size(); ++i)
        {
            const contactNode& m = contactNodes_[i];
            if (m.pair == pairi && pressed_[pairi].found(m.node))
            {
                places.append(position_[m.node]);
                stuck.append(pressed_[pairi][m.node]);
            }
        }
        List<pointField> allPlaces(Pstream::nProcs());
        List<labelList> allStuck(Pstream::nProcs());
        allPlaces[Pstream::myProcNo()] = pointField(places);
        allStuck[Pstream::myProcNo()] = stuck;
        Pstream::gatherList(allPlaces);
        Pstream::gatherList(allStuck);
        Pstream::scatterList(allPlaces);
        Pstream::scatterList(allStuck);
        const pointField all
        (
            ListListOps::combine<pointField>(allPlaces, accessOp<pointField>())
        );
        if (all.size())
        {
            state.add(word("pressed" + Foam::name(pairi)), all);
            state.add
            (
                word("stuck" + Foam::name(pairi)),
                ListListOps::combine<labelList>(allStuck, accessOp<labelList>())
            );
        }
    }
    return state;
}


void Foam::mpm::pointContact::setState(const dictionary& state)
{
    forAll(pairs_, pairi)
    {
        const vector sum
        (
            state.getOrDefault<vector>
            (
                word("pair" + Foam::name(pairi)),
                vector::zero
            )
        );
        pairs_[pairi].sum = Pstream::master() ? sum : vector(Zero);

        const word n(Foam::name(pairi));
        findPressed
        (
            pairi,
            state.getOrDefault<pointField>("pressed" + n, pointField()),
            state.getOrDefault<labelList>("stuck" + n, labelList())
        );
    }
}

// ************************************************************************* //
