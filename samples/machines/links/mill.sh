#!/bin/sh
# Mills the links of ../trunnion.toml, each out of one block: its programs are in the coordinates of
# the machine with all axes at 0, mm. Writes them into the folder that is told.
#
#     samples/machines/links/mill.sh build/ncsim samples/machines/links
set -eu
ncsim=$1
into=$2
here=$(dirname "$0")

link() {
    name=$1
    stock=$2
    shift 2
    "$ncsim" run "$here/$name.nc" --quiet --stock "$stock" "$@" --tool-tolerance 0.5 \
        --tolerance 0.1 --simplify 0.01 --stl "$into/$name.stl"
}

link base -260,-260,-620:260,360,300 --tool T1=flat:D400:L900 --tool T2=flat:D240:L900 \
    --tool T3=flat:D160:L900
link saddle -230,-130,-480:230,130,-270 --tool T1=flat:D160:L500 --tool T2=flat:D40:L300
link cradle -170,-115,-435:170,115,-270 --tool T1=flat:D50:L400 --tool T2=flat:D40:L300
link platter D180x52@0,0,-372 --tool T1=flat:D14:L100 --tool T2=flat:D60:L100
link carriage -130,150,-60:130,188,280 --tool T1=flat:D100:L400
link head -85,-85,60:85,148,330 --tool T1=flat:D100:L400
link spindle D100x60@0,0,0 --tool T1=v:D80:A60:P20 --tool T2=flat:D30:L60
