# Shared by the figures. Run a figure from the top of the repository:
#   gnuplot -e "data='build/figures'; kind='png'" figures/figure2.gp
# It reads the tables in `data` and writes the picture, png, pdf or svg, beside them. With the kind
# table it writes the points of every curve as text instead: the tests read these.
if (!exists("data")) data = 'build/figures'
if (!exists("kind")) kind = 'png'

set encoding utf8
set datafile separator comma

# eval page('figure2', rows, columns) opens a page for so many panels; all sizes and fonts are those
# of the PNG, a hundred pixels of which make a centimetre of the PDF.
font = "font 'Liberation Serif,22'"
terminal(width, height) = kind eq 'png' ? \
  sprintf("pngcairo size %d,%d %s linewidth 2 dashlength 1.2", width, height, font) : kind eq 'svg' ? \
  sprintf("svg size %d,%d %s linewidth 2", width, height, font) : \
  sprintf("pdfcairo size %gcm,%gcm %s fontscale 0.45 pointscale 0.4", 0.01 * width, 0.01 * height, font)
opened(name, width, height) = sprintf("set terminal %s; set output '%s/%s.%s'", \
                                      terminal(width, height), data, name, kind)
canvas(name, rows) = opened(name, 1400, 100 + 560 * rows)
page(name, rows, columns) = kind eq 'table' ? sprintf("set table '%s/%s.table'", data, name) : \
  canvas(name, rows).sprintf("; set multiplot layout %d,%d", rows, columns)

set linetype 1 linecolor rgb '#12355b' linewidth 1.4 dashtype solid    # mass 1
set linetype 2 linecolor rgb '#c8442c' linewidth 1.4 dashtype (9, 5)   # mass 2
set linetype 3 linecolor rgb '#404040' linewidth 0.6 dashtype (2, 5)   # stops, zero line
set linetype 4 linecolor rgb '#9a9a9a' linewidth 0.6 dashtype solid    # border orbit
set linetype 5 linecolor rgb '#0f5f40' linewidth 1.2 dashtype (3, 3)   # multi-sliding
set linetype 6 linecolor rgb '#6a4c93' linewidth 1.2 dashtype solid    # a sixth curve

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
