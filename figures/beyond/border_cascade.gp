# Beyond the border orbits: impacts added one by one, the ratio of the distances at which they are
# added, how it comes to its limit, and the attractors beyond the border orbit at 0.36782.
load 'figures/style.gp'

impacts = data.'/border_cascade.csv'
factors = data.'/border_cascade_factors.csv'
attractors = data.'/border_cascade_attractors.csv'
names = system("awk -F, 'NR > 1 {print $1}' '".factors."'")
set datafile missing ''

predicted = real(system("awk -F, 'NR == 2 {printf \"%.15g\", $7}' '".factors."'"))
correction = real(system("awk -F, 'NR == 2 {printf \"%.15g\", $8}' '".factors."'"))
exponent = log(correction) / log(predicted)

near(d) = -log10(d)
of(name, value) = strcol('orbit') eq name ? value : NaN
mass(name) = strstrt(name, 'mass_1') > 0 ? 1 : 2
color(name) = mass(name) == 1 ? '#12355b' : '#c8442c'
mark(k) = word('7 5 9 11 13 6 4 8 10 12 2', k) + 0
omega(name) = real(system("awk -F, '$1 == \"".name."\" {print $2}' '".factors."'"))

do for [kind in 'png pdf'] {
  eval canvas(kind, 'border_cascade', 4)
  size = kind eq 'png' ? 0.7 : 0.25
  small = kind eq 'png' ? 0.3 : 0.1
  set multiplot layout 4,1
  set xlabel '-log_{10} |Ω - Ω_{border}|'
  set xrange [2:10.1]; set xtics 1

  eval panel('a')
  set ylabel 'impacts of the chatter'
  set yrange [0:65]; set ytics 10
  set key at graph 0.02, graph 0.95 left top maxrows 6 samplen 1 font kind eq 'png' ? ',17' : ',7'
  plot for [k = 1:words(names)] impacts using (of(word(names, k), near(column('distance')))):'impact' \
    with points pt mark(k) ps size lc rgb color(word(names, k)) title sprintf('%.5f', omega(word(names, k))), \
    (x - 5.5) / -log10(predicted) with lines lw 1.4 lc rgb '#0f5f40' title 'slope predicted'

  eval panel('b')
  set ylabel 'ratio of distances'
  set yrange [0.695:0.705]; set ytics 0.002
  set format y '%.3f'
  set key at graph 0.36, graph 0.93 left top maxrows 5
  plot predicted with lines lw 1.4 lc rgb '#0f5f40' title sprintf('predicted, %.10f', predicted), \
    for [k = 1:words(names)] impacts using (of(word(names, k), near(column('distance')))):'ratio' \
    with points pt mark(k) ps size lc rgb color(word(names, k))

  eval panel('c')
  set ylabel 'relative'
  set logscale y
  set yrange [1e-7:1]; set ytics 10
  set format y '10^{%T}'
  set key at graph 0.02, graph 0.05 left bottom maxrows 4
  plot for [k = 1:words(names)] impacts using (of(word(names, k), near(column('distance')))):(abs(column('ratio') / predicted - 1)) \
    with points pt mark(k) ps 0.6 * size lc rgb color(word(names, k)), \
    for [k = 1:words(names)] impacts using (of(word(names, k), near(column('distance')))):'beyond' \
    with linespoints dt 3 pt mark(k) ps size lc rgb '#c9952c', \
    0.02 * 10 ** (-exponent * x) with lines lw 1.4 lc rgb '#0f5f40' title '∝ κ^n', \
    4 * 10 ** (-2 * exponent * x) with lines dt (6, 4) lw 1.4 lc rgb '#0f5f40' title '∝ κ^{2n}', \
    NaN with points pt 7 ps size lc rgb '#606060' title 'ratio / predicted - 1', \
    NaN with points pt 7 ps size lc rgb '#c9952c' title 'orbits coexist so far beyond'

  eval panel('d')
  unset logscale y
  set format y '%g'
  set ylabel 'impacts of a chatter'
  set yrange [8:68]; set ytics 10
  set key at graph 0.02, graph 0.95 left top maxrows 5
  shown(is) = is ? (column('complete') > 0 ? 65 : column('impacts')) : NaN
  set label 2 '{/*0.8 complete}' at graph 0.8, first 61.5
  period(p) = column('period') == p
  plot attractors using (near(column('distance'))):(shown(period(1))) with points pt 7 ps small lc rgb '#12355b' title 'period 1', \
    '' using (near(column('distance'))):(shown(period(2))) with points pt 7 ps small lc rgb '#c8442c' title 'period 2', \
    '' using (near(column('distance'))):(shown(column('period') > 2)) with points pt 7 ps 2 * small lc rgb '#0f7f60' title 'period 3 to 8', \
    '' using (near(column('distance'))):(shown(period(0))) with points pt 7 ps 1.5 * small lc rgb '#c9952c' title 'none up to 8'
  unset label 2
  unset multiplot
  unset output
}
