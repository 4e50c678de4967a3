// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "pointContact.H"
#include "dictionaryTools.H"
#include "ListListOps.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::pointContact::markPressed()
{
    label first = 0;
    forAll(pairs_, pairi)
    {
        label last = first;
        for (; last < contactNodes_.size() && contactNodes_[last].pair == pairi; ++last)
        {
            placeOf_[contactNodes_[last].node] = last;
        }
        for (const label entry : pressed_[pairi])
        {
            const label place = placeOf_[entry / 2];
            if (place >= 0)
            {
                contactNodes_[place].pressed = true;
                contactNodes_[place].held = entry % 2;
            }
        }
        for (; first < last; ++first)
        {
            placeOf_[contactNodes_[first].node] = -1;
        }
    }
}

void Foam::mpm::pointContact::findPressed(
    const label pairi, const pointField& places, const labelList& stuck)
{
    const scalar tol = 1e-8 * grid_.mesh().bounds().mag();
    for (contactNode& m : contactNodes_)
    {
        for (label i = 0; m.pair == pairi && i < places.size(); ++i)
        {
            if (mag(places[i] - position_[m.node]) < tol)
            {
                m.pressed = true;
                m.held = i < stuck.size() && stuck[i];
                pressed_[pairi].append(2 * m.node + m.held);
            }
        }
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::pointContact::addState(dictionary& to) const
{
    dictionary state;
    forAll(pairs_, pairi)
    {
        state.add(
            word("pair" + Foam::name(pairi)), returnReduce(pairs_[pairi].sum, sumOp<vector>()));

        // By place: nodes have other numbers on other processors
        DynamicList<point> places;
        DynamicList<label> stuck;
        for (const contactNode& m : contactNodes_)
        {
            if (m.pair == pairi && m.pressed)
            {
                places.append(position_[m.node]);
                stuck.append(m.held);
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
        const pointField all(ListListOps::combine<pointField>(allPlaces, accessOp<pointField>()));
        if (all.size())
        {
            state.add(word("pressed" + Foam::name(pairi)), all);
            state.add(
                word("stuck" + Foam::name(pairi)),
                ListListOps::combine<labelList>(allStuck, accessOp<labelList>()));
        }
    }
    to.add("contact", state);
}

void Foam::mpm::pointContact::setState(const dictionary& from)
{
    if (!from.found("contact"))
    {
        return;
    }
    const dictionary& state = requiredDict(from, "contact");
    forAll(pairs_, pairi)
    {
        const vector sum(
            state.getOrDefault<vector>(word("pair" + Foam::name(pairi)), vector::zero));
        pairs_[pairi].sum = Pstream::master() ? sum : vector(Zero);

        const word n(Foam::name(pairi));
        findPressed(
            pairi, state.getOrDefault<pointField>("pressed" + n, pointField()),
            state.getOrDefault<labelList>("stuck" + n, labelList()));
    }
}
