# Error against run time of this library and of what one would otherwise pick: all five problems, and as
# error_vs_runtime_two the first two.
load 'figures/style.gp'
table = data.'/error_vs_runtime.csv'
array problem[5] = ['figure2', 'figure4', 'flight', 'chatter', 'sticking']
array name[5] = ['ten forcing periods of Figure 2', 'ten forcing periods of Figure 4(a)', 'one flight of Figure 2', \
  'one chatter sequence of Figure 2', 'one sticking phase of Figure 2']

# Methods differ in colour, point and dash.
array method[8] = ['this library', 'this library (every impact)', 'by hand', 'plain event-driven', 'DOP853', \
  'odeint runge_kutta_dopri5', 'odeint runge_kutta_fehlberg78', 'stiff spring (dopri5)']
array short[8] = ['this library', 'every impact', 'by hand', 'plain', 'DOP853', 'dopri5', 'fehlberg78', 'stiff spring']
array colour[8] = ['#12355b', '#12355b', '#56b4e9', '#606060', '#a04090', '#d55e00', '#b08000', '#000000']
array mark[8] = [7, 6, 4, 5, 11, 9, 15, 2]
# The place of the name of a method, in characters from its last run; 'plain' would lie on other lines.
array across[8] = [-9.6, 0, -7.6, 0, -5.2, 0, 0, 0]
array up[8] = [-0.4, 0, 0.2, 0, -0.5, 0, 0, 0]
array dash[8] = [1, 1, 2, 3, 2, 1, 2, 3]
note = "Points: fastest of ten repeats; bars: slowest.%sAbove the line: the run misses an event.%s". \
  "Errors below 10^{−15} are drawn at 10^{−15}."

shown(error) = error < 1e-15 ? 1e-15 : error
row(p, m, ok) = strcol('problem') eq problem[p] && strcol('method') eq method[m] && (strlen(strcol('failure')) == 0) == ok
good(p, m) = row(p, m, 1) ? shown(column('error_time')) : NaN
# A method of which a run fails in a problem has a row of its own above this line.
edge = 3
array failures[8]  # the number of the row of each method, from 1; 0: no run fails
count_failures(p, m) = sprintf('count = 0; stats [*:*] [*:*] table using (row(%d, %d, 0) ? (count = count + 1) : 0) nooutput; ', p, m). \
  sprintf('failures[%d] = count > 0 ? (rows_of_failures = rows_of_failures + 1) : 0', m)
bad(p, m) = row(p, m, 0) ? edge * 10 ** (1.5 * failures[m] - 0.4) : NaN
# The end of the line of a method: the row of its last good run.
array last_time[8]; array last_error[8]
read_end(p, m) = sprintf('last_time[%d] = 0; stats [*:*] [*:*] table using (row(%d, %d, 1) ? ', m, p, m). \
  sprintf("(last_time[%d] = column('slowest_us'), last_error[%d] = good(%d, %d)) : 0) nooutput", m, m, p, m)

do for [picture in '5 2'] {
  reset
  load 'figures/style.gp'
  problems = int(picture)
  rows = problems == 5 ? 3.0 : 1.45
  eval opened('error_vs_runtime'.(problems == 5 ? '' : '_two'), 1400, 460 * rows)
  set multiplot
  set size 0.5, 1 / rows
  set lmargin 10; set rmargin 2; set tmargin 2
  set logscale xy; set format '10^{%T}'
  set grid xtics ytics linetype 4 linewidth 0.2
  do for [p = 1:problems] {
    unset label
    rows_of_failures = 0
    do for [m = 1:8] { eval read_end(p, m); eval count_failures(p, m) }
    set origin 0.5 * ((p - 1) % 2), 1 - ((p + 1) / 2) / rows
    eval heading(name[p])
    set xlabel p > 2 ? 'µs per run' : 'µs per forcing period'
    set ylabel 'error of the event times'
    set xrange [0.5:2e5]; set xtics 10; set yrange [5e-16:edge * 10 ** (1.5 * rows_of_failures + 0.6)]; set mytics 1
    set ytics ('10^{−15}' 1e-15, '10^{−12}' 1e-12, '10^{−9}' 1e-9, '10^{−6}' 1e-6, '10^{−3}' 1e-3, '1' 1)
    if (rows_of_failures > 0) { set label 5 'misses an event' at graph 0.985, first edge * 8 right font ',17' }
    do for [m = 1:8] {
      if (p > 2 || m == 4 || last_time[m] == 0) { continue }
      set label short[m] at last_time[m] * 1.3, last_error[m] offset across[m], up[m] font ',17'
    }
    plot rows_of_failures > 0 ? edge : NaN lt 4 notitle, for [m = 1:8] table using 'fastest_us':(good(p, m)):'fastest_us':'slowest_us' with xerrorbars lc rgb colour[m] pt 0 lw 1.2 dt 1, \
      for [m = 1:8] '' using 'fastest_us':(good(p, m)) with linespoints lc rgb colour[m] pt mark[m] dt dash[m] ps 1.2 lw 1.2, \
      for [m = 1:8] '' using 'fastest_us':(bad(p, m)) with points lc rgb colour[m] pt mark[m] ps 1.2 lw 1.2
  }
  do for [m = 1:8] { eval read_end(1, m) }  # every method ends in Figure 2
  # The key fills the sixth cell, or the strip below two.
  unset label; unset xlabel; unset ylabel; unset tics; unset border; unset grid; set tmargin 0; set bmargin 0
  if (problems == 5) { set origin 0.5, 0 } else { set size 1, 1 - 1 / rows; set origin 0, 0 }
  set key at graph 0, graph 1 left maxrows (problems == 5 ? 8 : 3) spacing 1.1 samplen 3 font ',18'
  set label 1 sprintf(note, problems == 5 ? "\n" : "  ", "\n") at graph 0.02, graph (problems == 5 ? 0.2 : 0.3) font ',20'
  plot for [m = 1:8] NaN with linespoints lc rgb colour[m] pt mark[m] dt dash[m] ps 1.2 lw 1.2 \
    title (last_time[m] > 0 ? method[m] : '') noenhanced
  unset multiplot
}
unset output
