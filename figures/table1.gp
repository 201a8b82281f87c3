# Table I: a motion for each pair of events. Dots: the two masses at the event; band: both stuck.
load 'figures/style.gp'
set xlabel 'Time'
set ylabel 'Displacement' offset 0.8, 0
set key at graph 0.97, graph 0.95
set lmargin 8.5
set rmargin 4.5
set tmargin 2
set autoscale xfix

array pair[6] = ['DG', 'DS', 'DI', 'GS', 'GI', 'SI']
array meaning[6] = ['dual grazing', 'dual sticking', 'double impact', 'grazing-sticking', \
  'grazing-impact', 'sticking-impact']
array lowest[6] = [-1.8, 0.1, -0.05, -1, -0.55, -0.05]
array highest[6] = [1.0, 0.32, 0.6, 0.6, 0.5, 0.35]
array step[6] = [0.4, 0.05, 0.1, 0.4, 0.2, 0.1]
array every[6] = [2, 2, 1, 2, 1, 2]

pairs = data.'/table1_pairs.csv'
array s1[6]; array s2[6]
do for [n = 1:6] {
  stats pairs using (strcol('pair') eq pair[n] ? (s1[n] = column('s1'), s2[n] = column('s2')) : NaN) nooutput
}
stats pairs using (strcol('pair') eq 'DS' ? column('t') : NaN) nooutput name 'stuck'
stats pairs using (strcol('pair') eq 'DS' ? column('until') : NaN) nooutput name 'released'
in_panel(n, value) = strcol('pair') eq pair[n] ? value : NaN
symbol(n) = sprintf('{/*0.8 {/:Italic s}_%d}', n)

eval page('table1', 3, 2)
do for [n = 1:6] {
  unset object 1
  if (pair[n] eq 'DS') { set object 1 rectangle from stuck_min, graph 0 to released_min, graph 1 behind fillcolor rgb '#ececec' fillstyle solid noborder }
  set title '{/:Bold '.pair[n].'}  '.meaning[n] offset 0, -0.5
  set xtics 0.0 + every[n]
  set yrange [lowest[n]:highest[n]]; set ytics 0.0 + step[n]
  set label 1 symbol(1).(s1[n] == s2[n] ? '='.symbol(2) : '') at graph 1.015, first s1[n]
  set label 2 s1[n] == s2[n] ? '' : symbol(2) at graph 1.015, first s2[n]
  plot s1[n] lt 3, s2[n] lt 3, \
    data.'/table1_'.pair[n].'.csv' using 't':'x1' with lines lt 1 title (n == 1 ? 'mass 1' : ''), \
    '' using 't':'x2' with lines lt 2 title (n == 1 ? 'mass 2' : ''), \
    for [mass = 1:2] pairs using (in_panel(n, column('t'))):'x'.mass with points pt 7 ps (pair[n] eq 'DS' ? 0 : 1) lt mass
}
