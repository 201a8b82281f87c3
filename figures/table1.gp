# Table I: a motion for each pair of events. Dots: the two masses at the event; band: both stuck.
load 'figures/style.gp'
set xlabel 'Time'
set ylabel 'Displacement' offset 0.8, 0
set key at graph 0.97, graph 0.95
set lmargin 8.5
set rmargin 4.5
set tmargin 2
set autoscale xfix

pair_name(kind) = kind eq 'DG' ? 'dual grazing' : kind eq 'DS' ? 'dual sticking' : \
  kind eq 'DI' ? 'double impact' : kind eq 'GS' ? 'grazing-sticking' : \
  kind eq 'GI' ? 'grazing-impact' : 'sticking-impact'

# The stops of a panel, s1 and s2, and its window.
scenes = data.'/table1_scenes.csv'
pairs = data.'/table1_pairs.csv'
array lowest[6] = [-1.8, 0.1, -0.05, -1, -0.55, -0.05]
array highest[6] = [1.0, 0.32, 0.6, 0.6, 0.5, 0.35]
array step[6] = [0.4, 0.05, 0.1, 0.4, 0.2, 0.1]
array every[6] = [2, 2, 1, 2, 1, 2]

shown(kind, value) = strcol('pair') eq kind && strcol('shown') eq kind ? value : NaN

eval page('table1', 3, 2)
do for [n = 1:6] {
  pair = word('DG DS DI GS GI SI', n)
  set xrange [*:*]; set yrange [*:*]  # stats sees only what lies within them
  stats scenes using (strcol('pair') eq pair ? column('s1') : NaN) nooutput name 'stop1'
  stats scenes using (strcol('pair') eq pair ? column('s2') : NaN) nooutput name 'stop2'
  unset object 1
  if (pair eq 'DS') {
    stats pairs using (shown(pair, column('t'))) nooutput name 'stuck'
    stats pairs using (shown(pair, column('until'))) nooutput name 'released'
    set object 1 rectangle from stuck_min, graph 0 to released_min, graph 1 behind fillcolor rgb '#ececec' fillstyle solid noborder
  }
  set title '{/:Bold '.pair.'}  '.pair_name(pair) offset 0, -0.5
  set xtics 0.0 + every[n]
  set yrange [lowest[n]:highest[n]]; set ytics 0.0 + step[n]
  same = stop1_min == stop2_min
  set label 1 (same ? '{/*0.8 {/:Italic s}_1={/:Italic s}_2}' : '{/*0.8 {/:Italic s}_1}') at graph 1.015, first stop1_min
  set label 2 (same ? '' : '{/*0.8 {/:Italic s}_2}') at graph 1.015, first stop2_min
  dot = pair eq 'DS' ? 0 : 1
  plot stop1_min lt 3, stop2_min lt 3, \
    data.'/table1_'.pair.'.csv' using 't':'x1' with lines lt 1 title (n == 1 ? 'mass 1' : ''), \
    '' using 't':'x2' with lines lt 2 title (n == 1 ? 'mass 2' : ''), \
    pairs using (shown(pair, column('t'))):'x1' with points pt 7 ps dot lc rgb '#12355b', \
    pairs using (shown(pair, column('t'))):'x2' with points pt 7 ps dot lc rgb '#c8442c'
}
