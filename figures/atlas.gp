# The atlas of settled motions from rest: their period (left) and who sticks (right), in the planes
# of frequency and restitution, of frequency and amplitude, and of the positions of both stops.
load 'figures/style.gp'

scenes = data.'/atlas_scenes.csv'
curves = data.'/atlas_curves.csv'  # of `make curves`
curves_drawn = system("test -e '".curves."' && echo 1") eq '1'
marked_in(plane, value) = strcol('plane') eq plane ? value : NaN

# The period, and what motions without one are: chaotic where the Lyapunov exponent is positive.
of_period(p, lambda) = p > 4 ? 5 : p > 0 ? p : lambda > 0 ? 7 : 6
of_sticks(one, two, dual) = dual > 0 ? 5 : one > 0 && two > 0 ? 4 : two > 0 ? 3 : one > 0 ? 2 : 1

# The colours of Okabe and Ito, which the colour-blind tell apart, and greys.
array colour[12]
colour[1] = '#e6e6e6'; colour[2] = '#56b4e9'; colour[3] = '#009e73'; colour[4] = '#f0e442'
colour[5] = '#e69f00'; colour[6] = '#8c8c8c'; colour[7] = '#000000'
colour[8] = '#e6e6e6'; colour[9] = '#e69f00'; colour[10] = '#56b4e9'; colour[11] = '#009e73'
colour[12] = '#0072b2'
array meaning[12]
meaning[1] = 'period 1'; meaning[2] = '2'; meaning[3] = '3'; meaning[4] = '4'; meaning[5] = '5 to 8'
meaning[6] = 'none, λ < 0'; meaning[7] = 'none, λ > 0'
meaning[8] = 'no mass sticks'; meaning[9] = 'mass 1'; meaning[10] = 'mass 2'
meaning[11] = 'both in turn'; meaning[12] = 'both at once'
set palette defined (1 colour[1], 2 colour[2], 3 colour[3], 4 colour[4], 5 colour[5], 6 colour[6], \
  7 colour[7], 8 colour[8], 9 colour[9], 10 colour[10], 11 colour[11], 12 colour[12]) maxcolors 12
set cbrange [0.5:12.5]
unset colorbox

array plane[5] = ['omega_r', 'omega_A1', '5a', '5b', '5c']
array abscissa[5] = ['omega', 'omega', 'stop1', 'stop1', 'stop1']
array ordinate[5] = ['restitution', 'amplitude1', 'stop2', 'stop2', 'stop2']
array x_name[5] = ['Ω', 'Ω', '{/:Italic s}_1', '{/:Italic s}_1', '{/:Italic s}_1']
array y_name[5] = ['{/:Italic r}', '{/:Italic A}_1', '{/:Italic s}_2', '{/:Italic s}_2', '{/:Italic s}_2']
array where[5] = ['', '', ' at the frequency of Figure 5(a)', ' at the frequency of Figure 5(b)', ' at the frequency of Figure 5(c)']
letters = 'abcdefghij'

do for [kind in 'png pdf'] {
  eval canvas(kind, 'atlas', 5)
  set samples 100
  set multiplot layout 5,2
  set lmargin 8; set rmargin 2; set tmargin 3.4; set bmargin 3
  set xtics autofreq; set ytics autofreq
  set key above left samplen 1 width 1 maxrows 2 font kind eq 'png' ? ',16' : ',7'
  do for [k = 1:5] {
    do for [part = 0:1] {
      set label 1 '('.letters[2 * k - 1 + part : 2 * k - 1 + part].')' at graph -0.21, graph 1.12
      set xlabel x_name[k].'{/*0.8 '.where[k].'}'; set ylabel y_name[k]
      table = data.'/atlas_'.plane[k].'.csv'
      first_colour = part == 0 ? 1 : 8
      last_colour = part == 0 ? 7 : 12
      line_of_figure3 = k == 1 ? 0.7 : k == 2 ? 0.5 : NaN
      set xrange [*:*]; set yrange [*:*]; set autoscale xfix; set autoscale yfix; set cbrange [0.5:12.5]
      plot table using abscissa[k]:ordinate[k]:(part == 0 ? of_period(column('period'), column('lyapunov')) : 7 + of_sticks(column('sticks1'), column('sticks2'), column('dual_sticking'))) with image notitle, \
        for [unused in k == 1 && part == 1 && curves_drawn ? 'yes' : ''] curves using 'omega':'restitution' with points pt 7 ps 0.25 lc rgb '#000000' notitle, \
        '+' using (k < 3 ? 0.25 + 0.45 * column(0) / 99 : NaN):(line_of_figure3) with lines dt (6, 4) lw 1.4 lc rgb '#d55e00' title (k < 3 ? 'Figure 3' : ''), \
        scenes using (marked_in(plane[k], column('x'))):'y' with points pt 6 ps 1.6 lw 2 lc rgb '#202020' notitle, \
        scenes using (marked_in(plane[k], column('x'))):'y':'figure' with labels offset char 1.1, 0.7 left textcolor rgb '#202020' font (kind eq 'png' ? ',18' : ',8') notitle, \
        for [c = first_colour:last_colour] NaN with points pt 5 ps (kind eq 'png' ? 2.4 : 1) lc rgb colour[c] title meaning[c]
    }
  }
  unset multiplot
  unset output
}
