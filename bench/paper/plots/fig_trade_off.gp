# Error against time: one field of every exact algorithm, tolerance and approximate
# method, on the first mesh of the table; programs of others where `peers` is a
# table of them.
set terminal pngcairo noenhanced size 900,560 font "DejaVu Sans,10"
set output out."/fig_trade_off.png"
set logscale xy
first = word(meshes("trade-off"), 1)
set title "One field on ".first.": error against time"
set xlabel "mean relative error"
set ylabel "processor seconds a field, once the mesh is prepared"
set key outside right top
# Errors of exact algorithms are rounding.
exact = 1e-10
at(mean) = mean < exact ? exact : mean
set format x "%.0e"
set xrange [exact / 20:0.3]
set yrange [0.004:*]
set xtics add ("exact" exact)
set label 1 "certified" at 1e-8, graph 0.04 tc rgb "#08306b"
set label 2 "no bound" at 2e-3, graph 0.04 tc rgb "#777777"
of(method) = rows("trade-off", first, 4, method)
peer(program) = sprintf( \
    "< awk -F'\\t' '$1 == \"%s\" && $3 == \"%s\"' '%s'", first, program, peers)
programs = system(sprintf( \
    "awk -F'\\t' '$1 == \"%s\" && $3 != \"geodesic\" && !s[$3]++ { print $3 }' '%s'", \
    first, peers))
# To be drawn, too; nothing where there are none.
others = words(programs) == 0 ? "" : \
    ', for [p in programs] peer(p) using (at($8)):7 with points pt 2 ps 1.1 lw 2'. \
    ' lc rgb p eq "VSP" ? "#000000" : "#777777" title p,'. \
    ' for [p in programs] peer(p) using (at($8)):7:4 with labels left'. \
    ' offset 0.8,0.3 font ",8" tc rgb "#777777" notitle'
# Labels of algorithms that label correcting orders stand on the left.
is_lc(name) = strstrt(name, "lc-") == 1
plot of("exact") using (at($8)):7 with points pt 7 ps 1.1 lc rgb "#08306b" \
         title "exact algorithms", \
     of("exact") using (at($8)):7:(is_lc(strcol(5)) ? "" : strcol(5)) \
         with labels left offset 0.8,0 font ",8" notitle, \
     of("exact") using (at($8)):7:(is_lc(strcol(5)) ? strcol(5) : "") \
         with labels right offset -0.8,0 font ",8" notitle, \
     of("tolerance") using (at($8)):7 with linespoints lw 2 pt 7 ps 0.9 \
         lc rgb "#4292c6" title "within a tolerance", \
     of("tolerance") using (at($8)):7:(strcol(5) eq "1e-1" ? "" : strcol(5)) \
         with labels offset 0,0.8 font ",8" notitle, \
     for [m in "svg gtu heat fmm fmm-untidy"] of(m) using (at($8)):7 \
         with linespoints lw 1 pt 4 ps 0.9 \
         lc rgb word("#7f2704 #756bb1 #d94801 #31a354 #a1d99b", \
                     m eq "svg" ? 1 : m eq "gtu" ? 2 : m eq "heat" ? 3 : \
                     m eq "fmm" ? 4 : 5) \
         title m.(m eq "svg" ? ", K" : m eq "gtu" ? ", samples" : \
                  m eq "heat" ? ", lambda" : ""), \
     of("svg") using (at($8)):7:5 with labels offset 0,0.8 font ",8" notitle, \
     for [m in "gtu heat"] of(m) using (at($8)):7:5 with labels \
         offset 0,-0.8 font ",8" notitle @others
