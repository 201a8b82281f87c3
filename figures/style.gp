# Shared by the figures. Run a figure from the top of the repository:
#   gnuplot -e "data='build/figures'" figures/figure2.gp
# It reads the tables in `data` and writes the PNG and the PDF beside them.
if (!exists("data")) data = 'build/figures'

set encoding utf8
set datafile separator comma

# eval canvas('png', 'figure2', rows) opens a page for `rows` panels, one below the other.
png(rows) = sprintf("pngcairo size 1400,%d font 'Liberation Serif,22' linewidth 2 dashlength 1.2", \
                    100 + 560 * rows)
pdf(rows) = sprintf("pdfcairo size 14cm,%.2fcm font 'Liberation Serif,10'", 1.0 + 5.6 * rows)
canvas(kind, figure, rows) = sprintf("set terminal %s; set output '%s/%s.%s'", \
                                     kind eq 'png' ? png(rows) : pdf(rows), data, figure, kind)

set linetype 1 linecolor rgb '#12355b' linewidth 1.4 dashtype solid    # mass 1
set linetype 2 linecolor rgb '#c8442c' linewidth 1.4 dashtype (9, 5)   # mass 2
set linetype 3 linecolor rgb '#404040' linewidth 0.6 dashtype (2, 5)   # stops, zero line

set border linewidth 0.7 linecolor rgb '#202020'
set tics nomirror out scale 0.6
set lmargin 11
set rmargin 3
set tmargin 0.8
set bmargin 3.2
set xlabel offset 0, 0.3
set key samplen 4 spacing 1.2 noautotitle

# eval panel('a') names the panel.
panel(letter) = sprintf("set label 1 '(%s)' at character 1.2, graph 0.985", letter)
