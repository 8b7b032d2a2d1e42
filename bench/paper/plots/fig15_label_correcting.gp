# Fig. 15: label correcting against FWP, and the priority queue against both.
set terminal pngcairo size 1100,640 font "DejaVu Sans,10"
set output out."/fig15_label_correcting.png"
set style data histogram
set style histogram clustered gap 1
set style fill solid border rgb "white"
set boxwidth 0.9
set yrange [0:*]
set key outside top center horizontal
set ylabel "relative to the heap"
set multiplot layout 2,2 columnsfirst \
    title "Label correcting and FWP against a binary heap (Fig. 15)"
# A row per mesh: its name, then a field of each of the three algorithms over
# that of the first.
relative(family, field) = sprintf( \
    "< awk -F'\\t' 'NR > 1 { if (!seen[$1]++) order[++n] = $1; ".\
    "cell[$1, $4] = $%d } END { split(\"%s\", a, \" \"); ".\
    "for (i = 1; i <= n; ++i) { m = order[i]; printf \"%%s\", m; ".\
    "for (j = 1; j <= 3; ++j) printf \"\\t%%s\", ".\
    "cell[m, a[j]] / cell[m, a[1]]; print \"\" } }' '%s/models.tsv'", \
    field, family, data)
set xtics rotate by -25 noenhanced
do for [family in "mmp_family ch_family"] {
  do for [field in "5 6"] {
    set title field eq "5" ? "time" : "windows"
    plot for [i = 1:3] relative(value(family), int(field)) \
        using (column(i + 1)):xtic(1) \
        lt style(word(value(family), i)) title word(value(family), i)
  }
}
unset multiplot
