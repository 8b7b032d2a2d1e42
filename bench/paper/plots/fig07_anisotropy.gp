# Fig. 7: time and windows against anisotropy.
set terminal pngcairo size 1100,430 font "DejaVu Sans,10"
set output out."/fig07_anisotropy.png"
set logscale xy
set xlabel "anisotropy g"
set format x "%g"
set key outside right top
set multiplot layout 1,2 \
    title "Time and windows against anisotropy, torus of 20,000 faces (Fig. 7)"
set ylabel "seconds"
set format y "%g"
plot for [a in mmp_family." ".ch_family] rows("anisotropy", "torus", 4, a) using 3:5 \
    with linespoints lt style(a) title a
set ylabel "windows per face"
plot for [a in mmp_family." ".ch_family] rows("anisotropy", "torus", 4, a) using 3:7 \
    with linespoints lt style(a) title a
unset multiplot
