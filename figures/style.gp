# Shared by the figures. Run a figure from the top of the repository:
#   gnuplot -e "data='build/figures'; kind='png'" figures/figure2.gp
# It reads the tables in `data` and writes the picture, png, pdf or svg, beside them; figure1.gp also
# has the kind gif.
if (!exists("data")) { data = 'build/figures' }
if (!exists("kind")) { kind = 'png' }

set encoding utf8
set minussign
set datafile separator comma

# eval page('figure2', rows, columns) opens a page for so many panels; all sizes and fonts are those
# of the PNG, a hundred pixels of which make a centimetre of the PDF.
font = "font 'Liberation Serif,22'"
terminal(width, height) = kind ne 'pdf' ? \
  sprintf("%s size %d,%d %s linewidth 2 dashlength 1.2", kind eq 'png' ? 'pngcairo' : 'svg', \
          width, height, font) : \
  sprintf("pdfcairo size %gcm,%gcm %s fontscale 0.45 pointscale 0.4", 0.01 * width, 0.01 * height, font)
opened(name, width, height) = sprintf("set terminal %s; set output '%s/%s.%s'", \
                                      terminal(width, height), data, name, kind)
canvas(name, rows) = opened(name, 1400, 100 + 560 * rows)
page(name, rows, columns) = canvas(name, rows).sprintf("; set multiplot layout %d,%d", rows, columns)

set linetype 1 linecolor rgb '#12355b' linewidth 1.4 dashtype solid    # mass 1
set linetype 2 linecolor rgb '#c8442c' linewidth 1.4 dashtype (9, 5)   # mass 2
set linetype 3 linecolor rgb '#404040' linewidth 0.6 dashtype (2, 5)   # stops, zero line
set linetype 4 linecolor rgb '#9a9a9a' linewidth 0.6 dashtype solid    # border orbit
set linetype 5 linecolor rgb '#0f5f40' linewidth 1.2 dashtype (3, 3)   # multi-sliding
set linetype 6 linecolor rgb '#6a4c93' linewidth 1.2 dashtype solid    # a sixth curve
set linetype 7 linecolor rgb '#e0a030' linewidth 4 dashtype solid      # where a mass sticks

set border linewidth 0.7 linecolor rgb '#202020'
set tics nomirror out scale 0.6
set lmargin 11
set rmargin 3
set tmargin 0.8
set bmargin 3.2
set xlabel offset 0, 0.3
set key samplen 3 spacing 1.2 noautotitle reverse Left

# The abscissa of a motion.
time = 'Time (non-dimensional)'

# eval axes('figure2a') sets the printed ranges and ticks of a panel, and the variables named here.
printed = 'reference/tables/panels.csv'
axes(name) = sprintf("stats [*:*] [*:*] '%s' using (strcol('panel') eq '%s' ? ", printed, name). \
  "(axis_from = column('from'), axis_to = column('to'), lowest = column('lowest'), ". \
  "highest = column('highest'), across = column('tick_across'), up = column('tick')) : NaN) nooutput; ". \
  "set xrange [axis_from:axis_to]; set xtics across; set yrange [lowest:highest]; set ytics up"

# The windows of Figure 3 in which the paper finds the chatter of mass 1 incomplete (Section 3.2).
array window_from[2] = [0.3, 0.37]
array window_to[2] = [0.35, 0.4]

# eval panel('a') names the panel.
panel(letter) = sprintf("set label 1 '(%s)' at character 1.2, graph 0.985", letter)

# eval read(table, 'omega') makes an array of the column of that name.
read(table, name) = sprintf("array %s[99]; stats [*:*] [*:*] '%s' using (%s[$0 + 1] = column('%s')) nooutput; ", \
                            name, table, name, name)
# eval scenes('figure2') reads the parameters of the scenes in the panels of a figure.
scenes(name) = scene_columns(data.'/'.name.'_scenes.csv')
scene_columns(table) = read(table, 'omega').read(table, 'r').read(table, 's1').read(table, 's2')
# A number and a symbol in a text: with a minus sign, and slanted but for Greek letters.
number(format, x) = (x < 0 ? '−' : '').sprintf(format, abs(x))
slanted(name) = name eq 'Ω' ? name : '{/:Italic '.name[1:1].'}'.name[2:*]
# The parameters of scene n in words. The paper does not give those named in `inferred`.
given(name, inferred) = strstrt(inferred, name) ? ' (inferred)' : ''
known(name, x, inferred) = slanted(name).' = '.number('%g', x).given(name, inferred)
stops(n, inferred) = s1[n] == s2[n] ? slanted('s_1').' = '.known('s_2', s1[n], inferred) : \
  known('s_1', s1[n], inferred).',  '.known('s_2', s2[n], inferred)
parameters(n, inferred) = \
  known('Ω', omega[n], inferred).',  '.known('r', r[n], '').',  '.stops(n, inferred)
# eval scene(n, inferred) writes the parameters above a panel, and the names of the stops at their lines.
scene(n, inferred) = heading(parameters(n, inferred)).'; '.stop_lines(n)
heading(text) = sprintf("set label 4 '%s' at graph 0, graph 1 offset 0, 0.9", text)
# A key on the line of the headings, in a row.
key_beside_heading = 'set key horizontal maxrows 1 samplen 2 width -2 at graph 1, graph 1.125 right'
stop_lines(n) = sprintf("set label 2 '%s' at graph 1.01, first %g; ", \
    slanted('s_1').(s1[n] == s2[n] ? ' = '.slanted('s_2') : ''), s1[n]). \
  sprintf("set label 3 '%s' at graph 1.01, first %g", s1[n] == s2[n] ? '' : slanted('s_2'), s2[n])
# A mass sticks where it stands exactly on its stop.
stuck(x, stop) = x == stop ? x : NaN
# eval inset(n, rows, low, high) places the next plot inside panel n, between these heights of it.
inset(n, rows, low, high) = "unset label; unset xlabel; set xtics font ',20'; set ytics font ',20'; ". \
  sprintf('set bmargin at screen %g; set tmargin at screen %g', height(n, rows, low), height(n, rows, high))
height(n, rows, part) = (rows - n + part) / (1.0 * rows)
