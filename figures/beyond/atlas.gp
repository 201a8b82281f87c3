# The atlas of settled motions from rest, two pictures: the planes of frequency and restitution and of
# frequency and amplitude, with the period (left) and who sticks (right); and the planes of the
# positions of both stops, with the pairs of Table I that occur besides (in the former none does).
load 'figures/style.gp'

scenes = data.'/atlas_scenes.csv'
curves = data.'/atlas_curves.csv'  # of `make curves`
curves_drawn = system("test -e '".curves."' && echo 1") eq '1'
marked_in(plane, value) = strcol('plane') eq plane ? value : NaN

# The period, and what motions without one are: chaotic where the Lyapunov exponent is positive.
of_period(p, lambda) = p > 4 ? 5 : p > 0 ? p : lambda > 0 ? 7 : 6
of_sticks(one, two, dual) = dual > 0 ? 5 : one > 0 && two > 0 ? 4 : two > 0 ? 3 : one > 0 ? 2 : 1

# The colours of Okabe and Ito, which the colour-blind tell apart, and greys.
of_pairs(pairs) = strstrt(pairs, 'DI') > 0 ? 4 : strstrt(pairs, 'DS') > 0 ? 3 : strstrt(pairs, 'SI') > 0 ? 2 : 1

array colour[16]
colour[1] = '#e6e6e6'; colour[2] = '#56b4e9'; colour[3] = '#009e73'; colour[4] = '#f0e442'
colour[5] = '#e69f00'; colour[6] = '#8c8c8c'; colour[7] = '#000000'
colour[8] = '#e6e6e6'; colour[9] = '#e69f00'; colour[10] = '#56b4e9'; colour[11] = '#009e73'
colour[12] = '#0072b2'; colour[13] = '#e6e6e6'; colour[14] = '#56b4e9'; colour[15] = '#0072b2'
colour[16] = '#d55e00'
array meaning[16]
meaning[1] = 'period 1'; meaning[2] = '2'; meaning[3] = '3'; meaning[4] = '4'; meaning[5] = '5 to 8'
meaning[6] = 'none, λ < 0'; meaning[7] = 'none, λ > 0'
meaning[8] = 'no mass sticks'; meaning[9] = 'mass 1'; meaning[10] = 'mass 2'
meaning[11] = 'both in turn'; meaning[12] = 'both at once'
meaning[13] = 'no pair'; meaning[14] = 'SI'; meaning[15] = 'DS and SI'; meaning[16] = 'DI too'
# Classes that the pictures have: 16 occurs at one point of them, too small to be seen.
set palette defined (1 colour[1], 2 colour[2], 3 colour[3], 4 colour[4], 5 colour[5], 6 colour[6], \
  7 colour[7], 8 colour[8], 9 colour[9], 10 colour[10], 11 colour[11], 12 colour[12], 13 colour[13], 14 colour[14], 15 colour[15], 16 colour[16]) maxcolors 16
set cbrange [0.5:16.5]
unset colorbox

array plane[5] = ['omega_r', 'omega_A1', '5a', '5b', '5c']
array abscissa[5] = ['omega', 'omega', 'stop1', 'stop1', 'stop1']
array ordinate[5] = ['restitution', 'amplitude1', 'stop2', 'stop2', 'stop2']
array x_name[5] = ['Ω', 'Ω', '{/:Italic s}_1', '{/:Italic s}_1', '{/:Italic s}_1']
array y_name[5] = ['{/:Italic r}', '{/:Italic A}_1', '{/:Italic s}_2', '{/:Italic s}_2', '{/:Italic s}_2']
array where[5] = ['', '', ' at the frequency of Figure 5(a)', ' at the frequency of Figure 5(b)', ' at the frequency of Figure 5(c)']
letters = 'abcdefghijklm'
array highest[5] = [0.98, 1.2, 0.6, 0.6, 0.6]

first_of(part) = int(word('1 8 13', part))
last_of(part) = int(word('7 12 15', part))
class_of(part) = part == 1 ? of_period(column('period'), column('lyapunov')) : \
  part == 2 ? 7 + of_sticks(column('sticks1'), column('sticks2'), column('dual_sticking')) : \
  12 + of_pairs(strcol('pairs'))

# Names that would stand on one another are drawn apart.
label_of(figure) = figure eq '4' ? '4    ' : figure eq '2' ? '   2' : figure
pictures = 'atlas atlas_stops'
# The key of a panel has the classes that occur in it.
array occurring[15]
do for [k = 1:5] {
  do for [part = 1:(k < 3 ? 2 : 3)] {
    occurring[3 * k + part - 3] = ''
    do for [c = first_of(part):last_of(part)] {
      stats data.'/atlas_'.plane[k].'.csv' using (class_of(part) == c ? 1 : 0) nooutput
      if (STATS_sum > 0) { occurring[3 * k + part - 3] = occurring[3 * k + part - 3].sprintf('%d ', c) }
    }
  }
}
set samples 100

do for [kind in 'png pdf'] {
  do for [p = 1:2] {
    planes = p == 1 ? 2 : 3
    panels = p == 1 ? 2 : 3  # side by side
    eval canvas(kind, word(pictures, p), 5)
    if (kind eq 'png') { set terminal pngcairo size 2000, (p == 1 ? 1500 : 1950) } else { set terminal pdfcairo size 20cm, (p == 1 ? 15 : 19.5)cm }
    set multiplot
    do for [j = 1:planes] {
      k = p == 1 ? j : j + 2
      do for [part = 1:panels] {
        letter = (j - 1) * panels + part
        set lmargin at screen (part - 1.0) / panels + 0.06; set rmargin at screen 1.0 * part / panels - 0.015
        set tmargin at screen 1 - (j - 1.0) / planes - (p == 1 ? 0.075 : 0.085); set bmargin at screen 1 - 1.0 * j / planes + 0.065
        set xtics autofreq; set ytics autofreq
        set key at graph 1.0, graph 1.0 + (p == 1 ? 0.2 : 0.32) right top samplen 1 width -1 maxrows (p == 1 ? 2 : 3) font kind eq 'png' ? ',16' : ',7'
        set label 1 '('.letters[letter:letter].')' at graph 0.0, graph 1.06 left
        set xlabel x_name[k].'{/*0.8 '.where[k].'}'; set ylabel y_name[k] offset 0.5
        table = data.'/atlas_'.plane[k].'.csv'
        set xrange [p == 1 ? 0.2 : 0 : p == 1 ? 0.8 : 0.6]; set yrange [0 : highest[k]]
        with_curves = k == 1 && part == 2 && curves_drawn
        plot table using abscissa[k]:ordinate[k]:(class_of(part)) with image notitle, \
          for [unused in with_curves ? 'yes' : ''] curves using 'omega':'restitution' with points pt 7 ps 0.25 lc rgb '#000000' notitle, \
          for [unused in with_curves ? 'yes' : ''] NaN with lines lw 2 lc rgb '#000000' title 'curves', \
          for [unused in p == 1 ? 'yes' : ''] '+' using (0.25 + 0.45 * column(0) / 99):(k == 1 ? 0.7 : 0.5) with lines dt (6, 4) lw 2 lc rgb '#d6006e' title 'Figure 3', \
          scenes using (marked_in(plane[k], column('x'))):'y' with points pt 6 ps 1.6 lw 2 lc rgb '#202020' notitle, \
          scenes using (marked_in(plane[k], column('x'))):(column('y')):(label_of(strcol('figure'))) with labels offset char (p == 1 ? 0 : 1.2), (p == 1 ? 1.1 : 0.7) textcolor rgb '#202020' font (kind eq 'png' ? ',18' : ',8') notitle, \
          for [c in occurring[3 * k + part - 3]] NaN with points pt 5 ps (kind eq 'png' ? 2.4 : 1) lc rgb colour[int(c)] title meaning[int(c)]
      }
    }
    unset multiplot
    unset output
  }
}
