# Fig. 6: time and windows against resolution.
set terminal pngcairo size 1200,760 font "DejaVu Sans,10"
set output out."/fig06_resolution.png"
set logscale xy
set format y "10^{%T}"
set format x "%.0s%c"
set xlabel "faces"
set key outside right top
set multiplot layout 2,2 columnsfirst \
    title "Time and windows against resolution (Fig. 6)"
do for [mesh in "sphere terrain"] {
  set title mesh noenhanced
  set ylabel "seconds"
  plot for [a in all] rows("resolution", mesh, 4, a) using 2:5 \
      with linespoints lt style(a) title a
  set title mesh noenhanced
  set ylabel "windows per face"
  set format y "%g"
  plot for [a in all] rows("resolution", mesh, 4, a) using 2:7 \
      with linespoints lt style(a) title a
  set format y "10^{%T}"
}
unset multiplot
