# Fig. 13: fast marching with a heap and with untidy buckets.
set terminal pngcairo size 900,380 font "DejaVu Sans,10"
set output out."/fig13_marching.png"
set logscale xy
set format "%g"
set xlabel "anisotropy g"
set multiplot layout 1,2 title "Fast marching on tori of 20,000 faces (Fig. 13)"
do for [field in "5 6"] {
  set ylabel field eq "5" ? "seconds a field" : "mean error, %"
  plot for [m in "fmm fmm-untidy"] rows("marching", "torus", 4, m) \
      using 3:(column(int(field))) with linespoints \
      lt (m eq "fmm" ? 1 : 6) title m
}
unset multiplot
