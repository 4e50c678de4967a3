#!/usr/bin/env bash
# Takes the tutorials' pictures into the checkout, from runs that are there: the first one that
# each README names, as <tutorial>.png; animations; then the row at the top of README.md
# (row.py).
# After . etc/bashrc. Optional argument: the folder of the tutorials.
cd "${0%/*}" || exit 1
tutorials=$(cd "${1:-../../tutorials}" && pwd) || exit 1

for pair in spall/plates vibratingBar/vibratingBar twoDisks/disks obliqueTranslation/translation \
    cantilever/cantilever slidingBlock/slidingBlock hertz/hertz sandColumn/sandColumn \
    brazilianDisc/crack halfCylinder/crack taylorBar/strain projectile/materials \
    spallInAir/plates blockInAir/moving freePiston/piston shockOnSlab/cylinder \
    dustyShockTube/dustyShockTube houimOran/dense darcyFlow/darcy fluidisedColumn/fluidised \
    fluidisedBed/fluidisedBed \
    ballThroughPlate/debris blastWall/blast kirsch/kirsch spallOnTriangles/spallOnTriangles \
    bracket/bracket pipeBlast/pipe refinedImpact/impact adaptiveImpact/impact \
    sphereOnSphere/spheres \
    cylinderInChannel/cylinder connectingRod/rod hourglass/hourglass damBreak/damBreak \
    tntInAir/blast fluidShockTubes/tubes underwaterPlate/clamped shockOnHelium/helium \
    wedgeEntry/wedgeEntry damBreakGate/damBreakGate damBreakObstacle/damBreakObstacle \
    submergedSand/submergedSand blastOnWall/wall adaptiveBlast/blast explosiveRing/ring waterFilledTube/tube
do
    [ ! -e "$tutorials/$pair.png" ] || cp "$tutorials/$pair.png" "${pair%/*}.png"
done

# Animations, two at the top of README.md, from Allrun -animate
for pair in ballThroughPlate/debris blastWall/blast adaptiveImpact/impact adaptiveBlast/blast
do
    [ ! -e "$tutorials/$pair.gif" ] || cp "$tutorials/$pair.gif" "${pair%/*}.gif"
done

"${MPM_PYTHON:-python3}" row.py "$tutorials"
