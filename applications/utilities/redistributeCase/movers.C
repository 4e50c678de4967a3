// materialPointFoam: GPL-3.0-or-later, see LICENSE in the top folder

// As the solver has them: loadBalance
#include "rowsDistribution.C"
