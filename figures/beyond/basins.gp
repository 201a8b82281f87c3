# Basins of attraction in the plane of the initial displacements, both masses at rest. Every motion
# met has its own number of impacts per forcing period. Any other motion would be black.
load 'figures/style.gp'

# The colours of Okabe and Ito, which the colour-blind tell apart; they also differ in grey.
array colour[7] = ['#000000', '#56b4e9', '#f0e442', '#009e73', '#b04000', '#56b4e9', '#f0e442']
array sticks[7] = ['', '', '', ', mass 1 sticks', ', mass 1 sticks', '', '']
array impacts[7] = [NaN, 9.5, 9, 5, 4.5, 0.5, 0]
set palette defined (1 colour[1], 2 colour[2], 3 colour[3], 4 colour[4], 5 colour[5], 6 colour[6], 7 colour[7]) maxcolors 7
set cbrange [0.5:7.5]
unset colorbox
array place[2] = ['(a)  stops of Figure 2, Ω = 0.625, {/:Italic r} = 0.7', '(b)  Figure 5(b), Ω = 0.299518, {/:Italic r} = 0.001']
array first[2] = [2, 6]
array last[2] = [5, 7]
class(n, i) = 1 + (sum [c = first[n]:last[n]] (i == impacts[c] ? c - 1 : 0))
table(n) = data.'/basins'.n.'.csv'
# The share of the starts that lead to each motion, in percent.
array share[7]
do for [n = 1:2] {
  do for [c = first[n]:last[n]] {
    stats table(n) using (column('impacts1') + column('impacts2') == impacts[c] ? 100 : 0) nooutput
    share[c] = STATS_mean
  }
}

eval canvas('basins', 1.2).'; set multiplot layout 1,2'
set tmargin 1.8
set rmargin 2
set bmargin 10.5
set autoscale xfix; set autoscale yfix
set xlabel '{/:Italic x}_1(0)'; set ylabel '{/:Italic x}_2(0)'
set xtics 0.2; set ytics 0.2
set key at graph 0, graph -0.28 left samplen 0.3 maxrows 5
do for [n = 1:2] {
  set title place[n] offset 0, -0.5
  set label 1 n == 2 ? '(a) and (b): 100 × 100 starts, masses at rest' : '' at graph 0.03, graph -0.58
  plot table(n) using 'displacement1':'displacement2':(class(n, column('impacts1') + column('impacts2'))) with @image notitle, \
    for [c = first[n]:last[n]] NaN with points pt 5 ps 2.4 lc rgb colour[c] \
      title sprintf('%g impacts per period%s: %.0f%%', impacts[c], sticks[c], share[c]), \
    '+' using (0):(n == 1 ? 0 : NaN) every ::::0 with points pt 2 ps 2 lw 2 lc rgb '#000000' title (n == 1 ? 'start of Figure 3, at rest' : '')
}
