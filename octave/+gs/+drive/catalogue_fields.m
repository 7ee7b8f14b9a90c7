## table = gs.drive.catalogue_fields (kind)
## The columns of a catalogue of that KIND, a row each: name, SI unit, default (NaN: it must be
## there), range ("positive", "nonnegative", "efficiency"), meaning.  A default may be the name of
## another column.

function table = catalogue_fields (kind)
  common = {"mass", "kg", NaN, "nonnegative", "mass"
            "cost", "1", 0, "nonnegative", "cost, in whatever counts it"};
  switch (kind)
    case "motors"
      table = {"R", "ohm", NaN, "positive", "resistance of the winding, warm"
               "L", "H", 0, "nonnegative", "inductance"
               "Kt", "N*m/A", NaN, "positive", "torque constant"
               "Kb", "V*s/rad", "Kt", "positive", "constant of the induced voltage"
               "Jm", "kg*m^2", NaN, "nonnegative", "inertia of the rotor"
               "bm", "N*m*s/rad", 0, "nonnegative", "viscous friction"
               "Tc", "N*m", 0, "nonnegative", "dry friction"
               "T_cont", "N*m", NaN, "positive", "continuous torque (rms)"
               "T_peak", "N*m", NaN, "positive", "peak torque"
               "omega_max", "rad/s", NaN, "positive", "largest speed"
               "V_max", "V", NaN, "positive", "largest voltage"
               "Rth", "K/W", 0, "nonnegative", "thermal resistance, winding to ambient"
               "dT_max", "K", 100, "positive", "rise of the winding's temperature"};
    case "gears"
      table = {"ratio", "1", NaN, "positive", "turns of the motor in one of the load"
               "eta", "1", NaN, "efficiency", "efficiency, the motor drives"
               "eta_back", "1", "eta", "back", "efficiency, the load drives"
               "J_in", "kg*m^2", 0, "nonnegative", "inertia at the input"
               "T_cont", "N*m", NaN, "positive", "torque at the output (rms)"
               "T_peak", "N*m", NaN, "positive", "peak torque at the output"
               "omega_in_max", "rad/s", NaN, "positive", "largest speed of the input"};
    case "screws"
      table = {"lead", "m", NaN, "positive", "way in one turn"
               "eta", "1", NaN, "efficiency", "efficiency, the motor drives"
               "eta_back", "1", "eta", "back", "efficiency, the load drives"
               "J", "kg*m^2", 0, "nonnegative", "inertia of the screw"
               "F_cont", "N", NaN, "positive", "force of the load (rms)"
               "F_peak", "N", NaN, "positive", "peak force of the load"
               "omega_max", "rad/s", NaN, "positive", "largest speed of the screw"
               "d_root", "m", Inf, "positive", "root diameter (infinite: not known)"};
    case "amplifiers"
      table = {"V_max", "V", NaN, "positive", "largest voltage at the motor"
               "i_cont", "A", NaN, "positive", "continuous current (rms)"
               "i_peak", "A", NaN, "positive", "peak current"};
    case "cylinders"
      table = {"D", "m", NaN, "positive", "diameter of the piston"
               "d", "m", NaN, "nonnegative", "diameter of the rod"
               "stroke", "m", NaN, "positive", "stroke"
               "p_max", "Pa", NaN, "positive", "largest pressure"
               "v_max", "m/s", Inf, "positive", "largest speed"};
  endswitch
  table = [table; common];
endfunction
