# Basins of attraction in the plane of the initial displacements, both masses at rest. Every motion
# met has its own number of impacts per forcing period. Any other motion would be black.
load 'figures/style.gp'

# The colours of Okabe and Ito, which the colour-blind tell apart.
array colour[7] = ['#000000', '#56b4e9', '#e69f00', '#009e73', '#f0e442', '#56b4e9', '#e69f00']
array impacts[7] = [NaN, 9.5, 9, 5, 4.5, 0.5, 0]
set palette defined (1 colour[1], 2 colour[2], 3 colour[3], 4 colour[4], 5 colour[5], 6 colour[6], 7 colour[7]) maxcolors 7
set cbrange [0.5:7.5]
unset colorbox
array place[2] = ['(a)  stops of Figure 2, Ω = 0.625', '(b)  Figure 5(b), Ω = 0.299518']
array first[2] = [2, 6]
array last[2] = [5, 7]
class(n, i) = 1 + (sum [c = first[n]:last[n]] (i == impacts[c] ? c - 1 : 0))

eval page('basins', 1, 2)
set tmargin 2
set rmargin 9
set autoscale xfix; set autoscale yfix
set xlabel '{/:Italic x}_1'; set ylabel '{/:Italic x}_2'
set xtics 0.5; set ytics 0.5
set key outside right top samplen 0.5 title 'impacts'
do for [n = 1:2] {
  set title place[n]
  plot data.'/basins'.n.'.csv' using 'displacement1':'displacement2':(class(n, column('impacts1') + column('impacts2'))) with image notitle, \
    for [c = first[n]:last[n]] NaN with points pt 5 ps 2.4 lc rgb colour[c] title sprintf('%g', impacts[c])
}
