# Fig. 11: the spread of the labels on the wavefront over time.
list = meshes("wavefront")
set terminal pngcairo size 380 * words(list),620 font "DejaVu Sans,10"
set output out."/fig11_quality.png"
set xlabel "time (share of the windows propagated)"
set ylabel "standard deviation / h"
set xrange [0:1]
set yrange [0:*]
set key outside top center horizontal
set multiplot layout 2,words(list) \
    title "Standard deviation of the labels on the wavefront (Fig. 11)"
do for [family in "mmp_family ch_family"] {
  do for [mesh in list] {
    set title mesh noenhanced
    plot for [a in value(family)] rows("wavefront", mesh, 3, a) using 4:8 \
        with lines lt style(a) title a
  }
}
unset multiplot
