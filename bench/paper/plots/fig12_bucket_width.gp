# Fig. 12: bucket widths.
list = meshes("bucket-width")
set terminal pngcairo size 380 * words(list),620 font "DejaVu Sans,10"
set output out."/fig12_bucket_width.png"
set logscale x 2
set format x "%g"
set xtics (0.0625, 0.25, 1, 4, 16, 64, 256)
set xlabel "bucket width / l"
set yrange [0:*]
set key outside top center horizontal
set multiplot layout 2,words(list) \
    title "Bucket widths, in units of l = h / sqrt(n) (Fig. 12)"
do for [field in "6 7"] {
  do for [mesh in list] {
    set title mesh noenhanced
    set ylabel field eq "6" ? "seconds" : "windows"
    set format y field eq "6" ? "%g" : "%.1s%c"
    plot for [a in "fwp-mmp fwp-ch"] rows("bucket-width", mesh, 3, a) \
        using 5:(column(int(field))) with linespoints lt style(a) title a
  }
}
unset multiplot
