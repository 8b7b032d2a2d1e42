# Fig. 9: K and the size of the wavefront over time.
list = meshes("wavefront")
set terminal pngcairo size 380 * words(list),620 font "DejaVu Sans,10"
set output out."/fig09_wavefront.png"
set xlabel "time (share of the windows propagated)"
set format y "%.1s%c"
set xrange [0:1]
set yrange [0:*]
set key outside top center horizontal
set multiplot layout 2,words(list) \
    title "K and the size of the wavefront over time (Fig. 9)"
do for [a in "fwp-mmp fwp-ch"] {
  do for [mesh in list] {
    set title mesh.", ".a noenhanced
    plot rows("wavefront", mesh, 3, a) using 4:5 \
           with lines lw 2 lc rgb "#08306b" title "|W|", \
         rows("wavefront", mesh, 3, a) using 4:6 \
           with lines lw 2 lc rgb "#f16913" title "K"
  }
}
unset multiplot
