# Fig. 8: the saddle vertex graph against K.
list = meshes("neighbours")
set terminal pngcairo size 380 * words(list),620 font "DejaVu Sans,10"
set output out."/fig08_neighbours.png"
set logscale xy
set format "%g"
set xlabel "K"
set key outside top center horizontal
set multiplot layout 2,words(list) \
    title "The saddle vertex graph against K (Fig. 8)"
do for [field in "6 9"] {
  do for [mesh in list] {
    set title mesh noenhanced
    set ylabel field eq "6" ? "ms a vertex to build" : "mean error, %"
    plot for [b in "fwp ich"] rows("neighbours", mesh, 4, b) \
        using 3:(column(int(field))) with linespoints \
        lt (b eq "fwp" ? 6 : 4) title "built by ".b
  }
}
unset multiplot
