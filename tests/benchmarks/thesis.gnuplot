# The three diagrams of thesis figures 7.1, 7.2 and 7.6 for one sample: csv, svg, name are given.
set terminal svg size 1200,400 font "sans,11" background "white"
set output svg
set datafile separator ","
set datafile missing ""
set key top left
set multiplot layout 1,3 title name
set xlabel "negative cells"
set title "time spent (ms)"
set logscale y
plot csv using 1:($2+1e-3) every ::1 with lines title "linear programs, negative", \
     csv using 1:($3+1e-3) every ::1 with lines title "hulls, negative", \
     csv using 1:($4+1e-3) every ::1 with lines title "linear programs, zero", \
     csv using 1:($5+1e-3) every ::1 with lines title "hulls, zero", \
     csv using 1:6 every ::1 with points pt 7 ps 0.4 title "rendering"
unset logscale y
set title "facets"
plot csv using 1:7 every ::1 with lines title "stencilled negative", \
     csv using 1:8 every ::1 with lines title "visible negative", \
     csv using 1:9 every ::1 with lines title "zero"
set title "new zero cells per negative cell"
plot csv using 1:10 every ::1 with lines notitle
unset multiplot
