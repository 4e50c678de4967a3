// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

#include "loadBalance.H"
#include "rowsDistribution.H"
#include "decompositionMethod.H"
#include "dictionaryTools.H"
#include "fatalMessages.H"
#include "largestOfAll.H"
#include "OSspecific.H"
#include "ownedFields.H"
#include "Time.H"
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::mpm::loadBalance::measure(simulation& of, const label nSteps)
{
    // The least of all that have something to do: the others wait
    const auto least = [&](const scalar seconds, const label n)
    {
        const scalar most = largestOfAll(n);
        const scalar each = n > 0.1 * most ? max(seconds, 0.0) / nSteps / n : GREAT;
        return most > 0 ? returnReduce(each, minOp<scalar>()) : scalar(0);
    };
    scalar seconds = 0;
    label n = 0;
    if (of.points())
    {
        const materialPointSystem::clocks& t = of.points()->clock();
        seconds = t.nodes + t.move + t.sort + t.project + t.stress;
        for (const materialPointPhase& phase : of.points()->phases())
        {
            n += phase.cloud().size();
        }
    }
    ofPoint_ = least(seconds - points_, n);
    points_ = seconds;
    ofCell_ = of.gas() ? least(of.gasSeconds() - gas_, mesh_.nCells()) : scalar(0);
    gas_ = of.gas() ? of.gasSeconds() : scalar(0);
}

Foam::scalarField Foam::mpm::loadBalance::weights(simulation& of) const
{
    scalarField w(mesh_.nCells(), max(ofCell_, 0.01 * ofPoint_));
    for (label i = 0; of.points() && i < of.points()->phases().size(); ++i)
    {
        const materialPointCloud& cloud = of.points()->phases()[i].cloud();
        forAll(cloud.cells(), k)
        {
            w[cloud.cells()[k]] += ofPoint_ * (cloud.start()[k + 1] - cloud.start()[k]);
        }
    }
    return adaptation_.active() ? adaptation_.trees().ofBase(w) : w;
}

Foam::scalarField
Foam::mpm::loadBalance::loads(const scalarField& weights, const labelUList& proc) const
{
    scalarField all(Pstream::nProcs(), 0);
    forAll(weights, c)
    {
        all[proc[c]] += weights[c];
    }
    Pstream::listCombineGather(all, plusEqOp<scalar>());
    Pstream::listCombineScatter(all);
    return all;
}

Foam::labelList Foam::mpm::loadBalance::newProcs(const scalarField& weights) const
{
    autoPtr<decompositionMethod> method(decompositionMethod::New(dict_));
    if (!method->parallelAware())
    {
        FatalIOErrorInFunction(dict_)
            << "method " << method->type() << " does not work while a run goes on; name another"
            << " one in loadBalance, for example  method hierarchical;" << exit(FatalIOError);
    }
    return method->decompose(units(), units().cellCentres(), weights);
}

void Foam::mpm::loadBalance::move(simulation& of, const labelList& to)
{
    before_ = labelList(to.size(), Pstream::myProcNo());
    if (adaptation_.active())
    {
        adaptation_.move(of, to, before_);
        return;
    }
    rowsDistribution rows(mesh_, to);
    simulation::rows state(of.takeDown());
    ownedFields owned(mesh_);
    const meshDistribution::maps maps(distribution_->move(to));
    rows.move(state, maps);
    rows.move(owned.states, maps);
    maps.cells.distribute(before_);
    owned.make(mesh_);
    of = simulation(mesh_, std::move(state));
    maps.change.tellFunctionObjects();
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mpm::loadBalance::loadBalance(fvMesh& mesh, meshAdaptation& adaptation) :
    mesh_(mesh),
    adaptation_(adaptation),
    interval_(0),
    maxImbalance_(GREAT),
    worth_(1),
    points_(0),
    gas_(0),
    look_(mesh.time().timeIndex()),
    moved_(look_),
    cost_(0),
    brought_(0),
    write_(false),
    ofPoint_(0),
    ofCell_(0)
{
    if (!Pstream::parRun())
    {
        return;
    }
    const IOdictionary dict(IOobject(
        "decomposeParDict", mesh.time().system(), mesh.time(), IOobject::READ_IF_PRESENT,
        IOobject::NO_WRITE, false));
    if (!dict.found("loadBalance"))
    {
        return;
    }
    const dictionary& own = requiredDict(dict, "loadBalance");
    wordList keywords({"interval", "maxImbalance", "worth", "method"});
    for (const entry& e : own)
    {
        if (e.isDict())
        {
            keywords.append(e.keyword());
        }
    }
    checkKeywords(own, keywords);
    interval_ = boundedLabelOrDefault(own, "interval", 200, 1, labelMax);
    maxImbalance_ = boundedOrDefault(own, "maxImbalance", 1.2, 1, GREAT);
    worth_ = boundedOrDefault(own, "worth", 1, 0, GREAT);
    dict_ = dict;
    dict_.name() = own.name();
    dict_.merge(own);
    dict_.set("numberOfSubdomains", Pstream::nProcs());
    if (!adaptation.active())
    {
        distribution_.reset(new meshDistribution(mesh));
    }
    Info << "Load balance: a look every " << interval_ << " steps, imbalance up to "
         << maxImbalance_ << " is borne; method " << required<word>(dict_, "method") << nl << endl;
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::mpm::loadBalance::update(simulation& of)
{
    const label now = mesh_.time().timeIndex();
    if (!interval_ || now % interval_ || now == look_)
    {
        return;
    }
    const label nSteps = now - look_;
    measure(of, nSteps);
    look_ = now;
    const scalarField w(weights(of));
    const scalarField before(loads(w, labelList(w.size(), Pstream::myProcNo())));
    if (cost_ > 0)
    {
        brought_ += nSteps * (max(loads(w, before_)) - max(before));
    }
    if (!(sum(before) > 0 && imbalance(before) >= maxImbalance_))
    {
        return;
    }
    const labelList to(newProcs(w));
    const scalarField after(loads(w, to));
    const scalar saved = (max(before) - max(after)) * (now - moved_);
    const bool empty = min(loads(scalarField(to.size(), 1), to)) < 1;
    const scalar least = worth_ * cost_;
    const bool pays = worth_ == 0 || (saved >= least && (brought_ >= least || saved >= 3 * least));
    const auto rounded = [](const scalar x) { return std::round(1000 * x) / 1000; };
    Info << "Load: imbalance " << rounded(imbalance(before)) << ", by "
         << required<word>(dict_, "method") << ' ' << rounded(imbalance(after));
    if (empty || !pays)
    {
        Info << ", left: ";
        if (empty)
        {
            Info << "a processor would have no cells" << nl << endl;
        }
        else
        {
            Info << "it would save " << rounded(saved) << " s, the last move took "
                 << rounded(cost_) << " s and brought " << rounded(brought_) << " s" << nl << endl;
        }
        return;
    }
    Info << nl << endl;

    scalar seconds = 0;
    {
        const timer t(seconds);
        move(of, to);
    }
    cost_ = largestOfAll(seconds);
    brought_ = 0;
    moved_ = now;
    write_ = distribution_.valid();

    // The clocks of the new simulation go on
    measure(of, 1);
}

void Foam::mpm::loadBalance::write()
{
    if (!write_)
    {
        return;
    }
    distribution_->write(mesh_.time().timeName());

    // Where old times are removed each has its mesh
    write_ = mesh_.time().controlDict().getOrDefault<label>("purgeWrite", 0) > 0;
}
