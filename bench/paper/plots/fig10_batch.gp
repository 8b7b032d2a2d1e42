# Fig. 10: fixed against adaptive K.
list = meshes("batch")
set terminal pngcairo size 380 * words(list),620 font "DejaVu Sans,10"
set output out."/fig10_batch.png"
set logscale x
set format x "10^{%T}"
set xlabel "fixed K"
set yrange [0:*]
set key outside top center horizontal
set multiplot layout 2,words(list) \
    title "Fixed K; dashed: adaptive K with K_{max} = 20000 (Fig. 10)"
adaptive(mesh, a, field) = real(system(sprintf( \
    "awk -F'\\t' '$1 == \"%s\" && $3 == \"%s\" && $4 == \"adaptive\" && ".\
    "$5 == 20000 { print $%d }' '%s/batch.tsv'", mesh, a, field, data)))
fixed(mesh, a) = sprintf( \
    "< awk -F'\\t' '$1 == \"%s\" && $3 == \"%s\" && $4 == \"fixed\"' ".\
    "'%s/batch.tsv'", mesh, a, data)
do for [field in "6 7"] {
  do for [mesh in list] {
    set title mesh noenhanced
    set ylabel field eq "6" ? "seconds" : "windows"
    set format y field eq "6" ? "%g" : "%.1s%c"
    plot for [a in "fwp-mmp fwp-ch"] fixed(mesh, a) \
             using 5:(column(int(field))) \
             with linespoints lt style(a) title a, \
         for [a in "fwp-mmp fwp-ch"] adaptive(mesh, a, int(field)) \
             with lines lt style(a) dt 2 notitle
  }
}
unset multiplot
