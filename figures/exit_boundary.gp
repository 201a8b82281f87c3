# The exit boundaries in the Figure 2 scene: (a) of mass 2, in the plane of mass 1, with the motion from
# rest; (b) of mass 1, in the plane of mass 2, moving with the forcing.
load 'figures/style.gp'
set tmargin 2

second = data.'/exit_boundary2.csv'
first = data.'/exit_boundary1.csv'
stats data.'/exit_boundary.csv' using (omega = column('omega'), rate = column('rate'), forcing = column('forcing'), s1 = column('s1'), s2 = column('s2'), periods = column('periods')) nooutput
# Hold force zero (Eqs. 23 and 20), with k / c, A1 / c and the stops.
boundary2(x) = -rate * (x - s2)
boundary1(x, t) = -rate * (x - 2 * s1) - forcing * cos(omega * t)
of_kind(name, value) = strcol('kind') eq name ? value : NaN

# The settled sticking phase of mass 1, from its stick to its release, and the boundary at five
# times of it.
stats [*:*] [*:*] first using (strcol('kind') eq 'release' ? column('phase') : NaN) nooutput name 'first'
settled = first_max
stats [*:*] [*:*] second using (strcol('kind') eq 'release' ? column('phase') : NaN) nooutput name 'second'
stats first using (column('phase') == settled && strcol('kind') eq 'stick' ? column('t') : NaN) nooutput name 'stuck'
stats first using (column('phase') == settled && strcol('kind') eq 'release' ? column('t') : NaN) nooutput name 'left'
instant(n) = stuck_min + (n - 1) * (left_min - stuck_min) / 4
# The orbit's sample nearest to that time.
near(n, value) = column('phase') == settled && abs(column('t') - instant(n)) <= 0.0025 ? value : NaN
# One of the samples near that time; the first and the last one are events.
at_dot(n, value) = n == 1 ? of_kind('stick', near(n, value)) : n == 5 ? of_kind('release', near(n, value)) : \
  of_kind('orbit', near(n, value))
# The place of the time beside its dot.
array right[5] = [0.005, 0.006, -0.006, 0.006, 0.005]
array up[5] = [0.008, -0.01, -0.02, 0, 0.004]
time_text(n) = sprintf('{/*0.8 %s%.2f}', n == 1 ? '{/:Italic t} = ' : '', instant(n))
array shade[5] = ['#b9cfc4', '#90b5a2', '#659a80', '#3b7d5f', '#0f5f40']  # the last is that of line type 5

eval page('exit_boundary', 2, 1)

eval panel('a')
eval heading(sprintf('mass 2 sticks: the plane of mass 1,  %s,  from rest, %d forcing periods', known('Ω', omega, 'Ω'), periods))
set xlabel '{/:Italic x}_1'; set ylabel '{/:Italic ẋ}_1'
set xrange [0.06:0.34]; set xtics 0.04
set yrange [-0.2:0.25]; set ytics 0.1
set label 2 '{/:Italic S}' at 0.2, 0.1 center front
set label 3 sprintf("{/:Italic ∂S}:  {/:Italic ẋ}_1 = %s {/:Italic x}_1 + %g", number('%g', -rate), rate * s2) at 0.09, 0.16 left front
set label 5 sprintf('(%g, 0)', s2) at s2 - 0.002, -0.02 right front
set key at graph 0.97, graph 0.97
plot '+' using 1:(boundary2($1)):(1) with filledcurves lc rgb '#e9f0ec', \
  boundary2(x) with lines lt 5 dt solid lw 1.8, 0 lt 3, \
  second using (of_kind('orbit', column('x'))):'v' with lines lt 1 lw 0.8 lc rgb '#8fa3bd' title 'mass 1 while mass 2 sticks', \
  '' using (column('phase') == second_max ? of_kind('orbit', column('x')) : NaN):'v' with lines lt 1 lw 2.5 title 'the last time', \
  '' using (of_kind('stick', column('x'))):'v' with points lt 1 pt 7 ps 0.9 title 'mass 2 begins to stick', \
  '' using (of_kind('release', column('x'))):'v' with points lt 1 pt 6 ps 1.1 title 'mass 2 is released', \
  '+' using (s2):(0) every ::::0 with points pt 2 ps 1.1 lc rgb '#202020'
unset label 5

eval panel('b')
eval heading('mass 1 sticks for the last time: the plane of mass 2,  '.known('Ω', omega, 'Ω').',  {/:Italic t} in the period')
set xlabel '{/:Italic x}_2'; set ylabel '{/:Italic ẋ}_2'
set xrange [-0.44:-0.08]; set xtics 0.04
set yrange [-0.15:0.2]; set ytics 0.05
set label 2 '{/:Italic S} at the release' at -0.39, 0.15 center front
set label 3 '{/:Italic ∂S} at the times of the dots' at -0.295, -0.135 left front
plot '+' using 1:(boundary1($1, instant(5))):(-0.15) with filledcurves lc rgb '#e9f0ec', \
  for [n = 1:5] boundary1(x, instant(n)) with lines dt solid lw 1.8 lc rgb shade[n], \
  first using (column('phase') == settled ? column('x') : NaN):'v' with lines lt 2 dt solid, \
  for [n = 1:5] first using (near(n, column('x'))):'v' with points pt 7 ps 1.1 lc rgb shade[n], \
  for [n = 1:5] first using (at_dot(n, column('x') + right[n])):(column('v') + up[n]):(time_text(n)) with labels left
