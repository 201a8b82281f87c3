# Figure 5: sticking-impact (a), grazing-sticking (b), close to dual sticking (c). Bars: mass 1
# sticks. Dots: impacts of mass 2 in (a). Insets: what is smaller than a line.
load 'figures/style.gp'
set xlabel time
set ylabel 'Displacement'
set tmargin 2
set rmargin 7
eval key_beside_heading

eval scenes('figure5')
array inferred[3] = ['Ω', 'Ω', 's_1 s_2']
eval page('figure5', 3, 1)
table(n) = data.'/figure5'.'abc'[n:n].'.csv'
impacts(n) = data.'/figure5'.'aac'[n:n].'_impacts.csv'  # those in (b) are not drawn
of_mass_2(value) = column('mass') == 2 ? value : NaN
array bar_time[3] = [958.7, 923.2, 944]
array bar_height[3] = [0.325, 0.345, 0.306]
do for [n = 1:3] {
  eval panel('abc'[n:n])
  eval scene(n, inferred[n])
  eval axes('figure5'.'abc'[n:n])
  set label 5 'mass 1 sticks' at bar_time[n], bar_height[n] center
  set label 6 n == 1 ? 'dots: impacts of mass 2' : '' at 953.9, 0.325 center
  plot for [stop = 1:(s1[n] == s2[n] ? 1 : 2)] (stop == 1 ? s1[n] : s2[n]) lt 3, \
    table(n) using 't':(stuck(column('x1'), s1[n])) with lines lt 7 title (n == 1 ? 'sticking' : ''), \
    '' using 't':'x1' with lines lt 1 title (n == 1 ? 'mass 1' : ''), \
    '' using 't':'x2' with lines lt 2 title (n == 1 ? 'mass 2' : ''), \
    impacts(n) using (n == 1 ? of_mass_2(column('t')) : NaN):(s2[n]) with points lt 2 pt 7 ps 0.9
}

set lmargin at screen 0.45; set rmargin at screen 0.76
# The last impact of mass 2 while mass 1 sticks, and the release of mass 1.
stats [*:*] [*:*] table(1) using (column('x1') == s1[1] ? column('t') : NaN) nooutput name 'held'
stats [*:*] [*:*] impacts(1) using (column('t') < held_max ? of_mass_2(column('t')) : NaN) nooutput name 'hit'
eval inset(1, 3, 0.27, 0.6)
set ylabel '10^4 ({/:Italic x} − {/:Italic s}_1)' font ',20'
set xrange [hit_max - 0.006:hit_max + 0.012]; set xtics 0.005
set yrange [-2:2]; set ytics 1
set arrow 1 from hit_max, 0.6 to held_max, 0.6 heads size 0.0006, 20
set label 1 sprintf('mass 2 hits %.4f before the release', held_max - hit_max) at graph 0.5, first 1.3 center font ',20'
plot 0 lt 3, table(1) using 't':(column('x1') == s1[1] ? 0 : NaN) with lines lt 7, \
  for [mass = 1:2] '' using 't':(1e4 * (column('x'.mass) - s1[1])) with lines lt mass, \
  impacts(1) using (of_mass_2(column('t'))):(0) with points lt 2 pt 7 ps 0.9
unset arrow

stats [*:*] [*:*] table(2) using 't':(column('x2') - s2[2]) nooutput name 'graze'
eval inset(2, 3, 0.3, 0.6)
set ylabel '10^5 ({/:Italic x}_2 − {/:Italic s}_2)' font ',20'
set xrange [graze_pos_max_y - 0.05:graze_pos_max_y + 0.05]; set xtics 0.02
set yrange [-25:5]; set ytics 10
set label 1 'nearest: '.number('%.1f', 1e5 * graze_max_y) at graph 0.5, graph 0.3 center font ',20'
plot 0 lt 3, table(2) using 't':(1e5 * (column('x2') - s2[2])) with lines lt 2

eval inset(3, 3, 0.3, 0.78)
set ylabel 'speed of impacts' font ',20'
eval axes('figure5c')
set logscale y; set yrange [1e-10:1]; set mytics 1
set ytics ('10^{−10}' 1e-10, '10^{−7}' 1e-7, '10^{−4}' 1e-4, '10^{−1}' 1e-1)
set label 1 'mass 2 bounces, and never sticks' at graph 0.96, graph 0.91 right font ',20'
set label 2 'mass 1 sticks' at 902, 1e-9 font ',20'
plot table(3) using 't':(column('x1') == s1[3] ? 2e-10 : NaN) with lines lt 7, \
  impacts(3) using (of_mass_2(column('t'))):'speed' with points lt 2 pt 7 ps 0.6
