# Table I: a motion for each pair of events. Open circles: a mass grazes. Dots: a mass impacts. Bars: a
# mass sticks.
load 'figures/style.gp'
set xlabel time
set ylabel 'Displacement' offset 0.8, 0
set key at graph 0.97, graph 0.95 samplen 2
set lmargin 8.5
set rmargin 6.5
set tmargin 3.2
set autoscale xfix
set offsets 0, 0, graph 0.06, graph 0.06

array pair[6] = ['DG', 'DS', 'DI', 'GS', 'GI', 'SI']
array meaning[6] = ['dual grazing', 'dual sticking', 'double impact', 'grazing-sticking', \
  'grazing-impact', 'sticking-impact']

pairs = data.'/table1_pairs.csv'
stats pairs using (strcol('pair') eq 'DS' ? column('t') : NaN) nooutput name 'stuck'
stats pairs using (strcol('pair') eq 'DS' ? column('until') : NaN) nooutput name 'released'
in_panel(n, value) = strcol('pair') eq pair[n] ? value : NaN
of_event(mass, letter) = strcol('event'.mass) eq letter ? column('t') : NaN
table(n) = data.'/table1_'.pair[n].'.csv'

eval scenes('table1')
eval page('table1', 3, 2)
do for [n = 1:6] {
  unset object 1
  if (pair[n] eq 'DS') { set object 1 rectangle from stuck_min, graph 0 to released_min, graph 1 behind fillcolor rgb '#ececec' fillstyle solid noborder }
  stats [*:*] [*:*] pairs using (in_panel(n, column('at_rest'))) nooutput name 'start'
  start = start_max == 1 ? 'from rest' : 'from near the steady state'
  set title '{/:Bold '.pair[n].'}  '.meaning[n].',  '.start."\n{/*0.9 Ω = ".sprintf('%.6g,  ', omega[n]).known('r', r[n], '').',  '. \
    slanted('s_1').' = '.(s1[n] == s2[n] ? '' : number('%.5g', s1[n]).',  ').slanted('s_2').' = '. \
    number('%.5g', s2[n]).'}' offset 0, -0.5
  eval stop_lines(n)
  set label 1 pair[n] eq 'DS' ? 'both stick' : '' at 0.5 * (stuck_min + released_min), 0.13 center
  set label 5 pair[n] eq 'DS' ? 'bars: a mass sticks' : '' at graph 0.5, graph 0.1 center
  plot s1[n] lt 3, s2[n] lt 3, \
    table(n) using 't':(stuck(column('x1'), s1[n])) with lines lt 7, \
    '' using 't':(stuck(column('x2'), s2[n])) with lines lt 7, \
    '' using 't':'x1' with lines lt 1 title (n == 1 ? 'mass 1' : ''), \
    '' using 't':'x2' with lines lt 2 title (n == 1 ? 'mass 2' : ''), \
    for [mass = 1:2] pairs using (in_panel(n, of_event(mass, 'G'))):'x'.mass \
      with points pt 6 ps 1.6 lt mass title (n == 5 && mass == 1 ? 'graze' : ''), \
    for [mass = 1:2] pairs using (in_panel(n, of_event(mass, 'I'))):'x'.mass \
      with points pt 7 ps 1.1 lt mass title (n == 3 && mass == 2 ? 'impact' : '')
}
