# Fig. 14: the heat method against the time that heat spreads for.
list = meshes("heat-time")
set terminal pngcairo size 700,440 font "DejaVu Sans,10"
set output out."/fig14_heat_time.png"
set logscale xy
set format "%g"
set xlabel "lambda (heat spreads for lambda h^2)"
set ylabel "mean error, %"
set title "The heat method against lambda (Fig. 14)"
plot for [mesh in list] sprintf( \
    "< awk -F'\\t' '$1 == \"%s\"' '%s/heat-time.tsv'", mesh, data) \
    using 4:5 with linespoints lw 2 title mesh noenhanced
