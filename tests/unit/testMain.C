/*---------------------------------------------------------------------------*\
    materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

Description
    Unit tests against the built libraries (doctest). OpenFOAM's fatal errors
    become exceptions, so that a test can ask for one.

\*---------------------------------------------------------------------------*/

#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>
#include "error.H"

int main(int argc, char* argv[])
{
    Foam::FatalError.throwExceptions();
    Foam::FatalIOError.throwExceptions();

    doctest::Context context(argc, argv);
    return context.run();
}
