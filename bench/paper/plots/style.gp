# What the figures share. `data` is the folder of the tables, `out` that of the
# pictures.
set datafile separator "\t"
set grid lc rgb "#dddddd"
set border lc rgb "#666666"
set key left top reverse Left samplen 2 spacing 1.1
set tics nomirror

# The rows of one mesh and one algorithm, columns 1 and `at`.
rows(table, mesh, at, algorithm) = sprintf( \
    "< awk -F'\\t' '$1 == \"%s\" && $%d == \"%s\"' '%s/%s.tsv'", \
    mesh, at, algorithm, data, table)
# The meshes of a table, in order, as words.
meshes(table) = system(sprintf( \
    "awk -F'\\t' 'NR > 1 && !seen[$1]++ { print $1 }' '%s/%s.tsv'", \
    data, table))

# A colour per rule and a mark per queue.
mmp_family = "mmp lc-mmp fwp-mmp"
ch_family = "ich lc-ch fwp-ch"
all = "mmp lc-mmp fwp-mmp ich lc-ch fwp-ch ch"
set linetype 1 lw 2 pt 4 ps 0.8 lc rgb "#9ecae1"
set linetype 2 lw 2 pt 8 ps 0.8 lc rgb "#4292c6"
set linetype 3 lw 2 pt 7 ps 0.8 lc rgb "#08306b"
set linetype 4 lw 2 pt 4 ps 0.8 lc rgb "#fdae6b"
set linetype 5 lw 2 pt 8 ps 0.8 lc rgb "#f16913"
set linetype 6 lw 2 pt 7 ps 0.8 lc rgb "#7f2704"
set linetype 7 lw 2 pt 2 ps 0.8 lc rgb "#777777"
# The linetype of an algorithm, by its place in `all`.
style(algorithm) = sum [i = 1:words(all)] (word(all, i) eq algorithm ? i : 0)
