# The atlas of settled motions from rest: their period (left), who sticks (middle) and which pairs of
# Table I occur (right). atlas.png: the planes of frequency and restitution, and of frequency and
# amplitude, in which no pair occurs. atlas_stops.png: the planes of the positions of both stops.
load 'figures/style.gp'
load 'figures/beyond/classes.gp'

scenes = data.'/atlas_scenes.csv'
marked_in(plane, value) = strcol('plane') eq plane ? value : NaN

of_sticks(one, two, dual) = dual > 0 ? 5 : one > 0 && two > 0 ? 4 : two > 0 ? 3 : one > 0 ? 2 : 1

of_pairs(pairs) = strstrt(pairs, 'DI') > 0 ? 4 : strstrt(pairs, 'DS') > 0 ? 3 : strstrt(pairs, 'SI') > 0 ? 2 : 1

array meaning[16] = ['period 1', '2', '3', '4', '5 to 8', 'none, λ ≤ 0 or uncertain', 'none, λ > 0', \
  'no mass sticks', 'mass 1', 'mass 2', 'both in turn', 'both at once', 'no pair', 'SI', 'DS and SI', 'DI too']

array plane[5] = ['omega_r', 'omega_A1', '5a', '5b', '5c']
array abscissa[5] = ['omega', 'omega', 'stop1', 'stop1', 'stop1']
array ordinate[5] = ['restitution', 'amplitude1', 'stop2', 'stop2', 'stop2']
array x_name[5] = ['Ω', 'Ω', '{/:Italic s}_1', '{/:Italic s}_1', '{/:Italic s}_1']
array y_name[5] = ['{/:Italic r}', '{/:Italic A}_1', '{/:Italic s}_2', '{/:Italic s}_2', '{/:Italic s}_2']
array where[5] = ['', '', ' at the frequency of Figure 5(a)', ' at the frequency of Figure 5(b)', ' at the frequency of Figure 5(c)']
letters = 'abcdefghijklm'
array highest[5] = [0.98, 1.2, 0.6, 0.6, 0.6]

first_of(part) = int(word('1 8 13', part))
last_of(part) = int(word('7 12 16', part))
class_of(part) = part == 1 ? of_period(column('period'), column('lyapunov')) : \
  part == 2 ? 7 + of_sticks(column('sticks1'), column('sticks2'), column('dual_sticking')) : \
  12 + of_pairs(strcol('pairs'))

# The classes that occur in a panel, for its key; not that of the header, which stats looks at too.
noted(c) = (strcol('period') eq 'period' || strstrt(seen, sprintf(' %d ', c)) > 0 ? 0 : (seen = seen.sprintf(' %d ', c)), c)
in_key(c) = strstrt(seen, sprintf(' %d ', c)) > 0
violet = '#cc79a7'
set style textbox opaque fillcolor rgb '#ffffff' noborder margins 0.3, 0.1

do for [picture in 'atlas atlas_stops'] {
  first = picture eq 'atlas' ? 1 : 3
  last = picture eq 'atlas' ? 2 : 5
  rows = last - first + 1.0
  columns = picture eq 'atlas' ? 2.0 : 3.0
  eval opened(picture, 1700, 600 * rows)
  set multiplot
  do for [k = first:last] {
    do for [part = 1:int(columns)] {
      n = (k - first) * int(columns) + part
      set lmargin at screen (part - 1 + 0.07 * columns) / columns; set rmargin at screen (part - 0.05) / columns
      set tmargin at screen 1 - (k - first + 0.22) / rows; set bmargin at screen 1 - (k - first + 0.84) / rows
      set key at graph 1.0, graph 1.33 right top samplen 0.7 width 0 maxrows (columns > 2 && part == 1 ? 4 : 3) font ',17'
      set label 1 '('.letters[n:n].')' at graph -0.16, graph 1.07
      set xlabel x_name[k].'{/*0.8 '.where[k].'}'; set ylabel y_name[k] offset 1
      set xtics 0.1
      table = data.'/atlas_'.plane[k].'.csv'
      curves = data.'/atlas_curves'.(k == 2 ? '_omega_A1' : '').'.csv'  # of `make curves`
      curve_y = k == 2 ? 'amplitude1' : 'restitution'
      with_curves = k < 3 && part == 2 && system("test -e '".curves."' && echo 1") eq '1' ? 'yes' : ''
      seen = ''
      set autoscale xy
      stats table using (noted(class_of(part))) nooutput
      set xrange [k < 3 ? 0.2 : 0 : k < 3 ? 0.8 : 0.6]; set yrange [0 : highest[k]]
      plot table using abscissa[k]:ordinate[k]:(class_of(part)) with image notitle, \
        for [unused in with_curves] curves using 'omega':curve_y with points pt 7 ps 0.25 lc rgb '#000000' notitle, \
        for [unused in with_curves] NaN with points pt 7 ps 0.6 lc rgb '#000000' title 'curves of bifurcations', \
        '+' using (k < 3 ? 0.25 + 0.45 * column(0) / 99 : NaN):(k == 1 ? 0.7 : 0.5) with lines dt (6, 4) lw 1.6 lc rgb violet title (k < 3 ? 'Figure 3' : ''), \
        scenes using (marked_in(plane[k], column('x'))):'y' with points pt 6 ps 1.6 lw 2 lc rgb '#202020' notitle, \
        scenes using (strcol('figure') eq '4' ? marked_in(plane[k], column('x')) : NaN):'y':'figure' with labels boxed offset -1, -0.9 right notitle, \
        scenes using (strcol('figure') eq '4' ? NaN : marked_in(plane[k], column('x'))):'y':'figure' with labels boxed offset 1, -0.9 left notitle, \
        for [c = first_of(part):last_of(part)] NaN with points pt 5 ps 2.4 lc rgb colour[c] title (in_key(c) ? meaning[c] : '')
    }
  }
  unset multiplot
  unset output
}
